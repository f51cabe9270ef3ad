"""A command whose help shows its examples first and its options in sections."""

from typing import Any

import click

SECTION_OF_OUTPUT = (
    "number",
    "format_",
    "json_",
    "precision",
    "color",
    "quiet",
    "steps",
    "help",
)


class SectionedCommand(click.Command):
    """Options are listed under the sections named in `sections`, the rest under Output."""

    def __init__(
        self, *args: Any, sections: dict[str, tuple[str, ...]] | None = None, **kwargs: Any
    ) -> None:
        """Take the sections: title, then the names of its parameters."""
        super().__init__(*args, **kwargs)
        self.sections = sections or {}

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write one list of options a section."""
        records = {
            "help" if "--help" in p.opts else p.name: p.get_help_record(ctx)
            for p in self.get_params(ctx)
        }
        for title, names in {**self.sections, "Output": SECTION_OF_OUTPUT}.items():
            listed = [record for name in names if (record := records.get(name))]
            if listed:
                with formatter.section(title):
                    formatter.write_dl(listed)

"""A command whose help shows its examples first and its options in sections."""

from typing import Any

import click

from radcalc.errors import UsageError, quote

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

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Refuse an option that is given twice: the first would be ignored silently."""
        several = {o for p in self.params if getattr(p, "multiple", False) for o in p.opts}
        seen: set[str] = set()
        for word in args[: args.index("--")] if "--" in args else args:
            name = word.partition("=")[0]
            if word.startswith("--") and name in seen - several:
                raise UsageError(f"{quote(name)} is given twice", "it once, or a list of values")
            seen.add(name)
        rest = super().parse_args(ctx, args)
        for parameter in self.params:
            value = ctx.params.get(parameter.name or "")
            if value == "" or (
                isinstance(value, tuple) and "" in value and parameter.opts[0][0] == "-"
            ):
                raise UsageError(f"{parameter.opts[0]} is empty", "a value, or without the option")
        return rest

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

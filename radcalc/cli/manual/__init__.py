r"""Generated parts of the manual pages in man/: lists and help, from the commands and tables.

`python -m radcalc.cli.manual man` rewrites the text between these marks (WHAT: see `WRITERS`):

    .\" generated: WHAT of NAME
    .\" end of generated
"""

import re
from collections.abc import Callable, Iterable, Mapping

from radcalc.cli.manual import commands, phrases, reference, tasks

MARKED = re.compile(
    r'^(\.\\" generated: (\w+)(?: of (.+))?\n)(?:.*\n)*?(\.\\" end of generated\n)', re.MULTILINE
)
WRITERS: Mapping[str, Callable[[str], Iterable[str]]] = {
    "name": commands.name,
    "help": commands.help_text,
    "options": commands.options,
    "results": commands.results,
    "laws": commands.laws,
    "list": commands.listed,
    "tasks": tasks.tasks,
    "phrases": phrases.phrases,
    "fillers": phrases.fillers,
    "frames": phrases.frames,
    "quantities": reference.quantities,
    "conditions": reference.conditions,
    "units": reference.units,
    "prefixes": reference.prefixes,
    "scales": reference.scales,
}


def rewritten(page: str) -> str:
    """Return the page with its generated parts made anew."""

    def write(match: re.Match[str]) -> str:
        lines = WRITERS[match[2]](match[3] or "")
        return match[1] + "".join(f"{line}\n" for line in lines) + match[4]

    return MARKED.sub(write, page)

"""Requests of a command, besides its inputs."""

from collections.abc import Callable
from typing import Any

from radcalc.answer import Answer
from radcalc.calculators.page import Page
from radcalc.calculators.task import requesting
from radcalc.cli import check, line_options
from radcalc.errors import UsageError, one_of
from radcalc.tuples import NamedTuple


class Request(NamedTuple):
    """The requested results, derivation, check and picture.

    `lines` are the options for lines of standard input; `plot` is the place of the picture.
    """

    wanted: tuple[str, ...] = ()
    steps: bool = False
    check: str | None = None
    tolerance: str | None = None
    lines: line_options.LineOptions | None = None
    plot: str = ""

    @classmethod
    def of(cls, values: dict[str, Any], takes_lines: bool) -> "Request":
        """Take the request out of a command's values; refuse --check and --get together."""
        lines = None
        if takes_lines:
            line_values = [values.pop(name) for name in line_options.LineOptions._fields]
            lines = line_options.LineOptions(*line_values)
        from radcalc.calculators.results import listed_in

        wanted, steps = listed_in(values.pop("wanted")), values.pop("steps")
        checked, tolerance = values.pop("check"), values.pop("tolerance")
        request = cls(wanted, steps, checked, tolerance, lines, values.pop("plot", None) or "")
        check.refuse_idle(request.check, request.tolerance)
        if request.check is not None and request.wanted:
            raise UsageError("--check cannot be used with --get", one_of("check", "get"))
        return request

    def wants(self, name: str) -> bool:
        """Return whether a result is requested, by its name or a spelling of it: R9, R_f,h1."""
        from radcalc.calculators.results import name_of

        names = [*self.wanted, (self.check or "").replace("=", ":")]
        return _letters(name) in [_letters(name_of(text)) for text in names]

    def narrowed(self, function: Callable[..., Answer], page: Page) -> Callable[..., Answer]:
        """Return the function of a page that also calculates the requested results."""
        return requesting(function, tuple(filter(self.wants, page.on_request)))


def _letters(name: str) -> str:
    return "".join(filter(str.isalnum, name.lower()))


TO_TERMINAL = "-"  # --plot without a file

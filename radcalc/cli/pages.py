"""Commands that are made of the pages of calculators."""

from collections.abc import Sequence
from functools import cache
from importlib import import_module
from typing import Any

from radcalc.calculators.page import words_of
from radcalc.calculators.task import Task
from radcalc.cli import options
from radcalc.cli.command import SectionedCommand, define
from radcalc.errors import UsageError, command


@cache
def of_page(name: str) -> SectionedCommand:
    """Make a command of a calculator's page.

    The calculation is the function of the command's name, or the task that the function `task` of
    the same module makes of the words of a call.
    """
    module = import_module(f"radcalc.calculators.{name.replace('-', '_')}")
    page = module.PAGE

    def calculate(
        typed: dict[str, Any], request: Any, output: options.Output, words: Sequence[str] = ()
    ) -> int:
        from radcalc.cli.calculator import run
        from radcalc.cli.cases import at_points, cases

        all_cases = cases(typed, intervals=page.intervals, bare=page.bare)
        if hasattr(module, "task"):
            return run(all_cases, module.task(words, request.wants), request, output)
        if page.operand and not words:
            example, _ = words_of(page.examples[0])
            raise UsageError(f"a {page.operand.name} is missing", command(name, *example))
        if page.operand:
            all_cases = at_points(all_cases, page.operand.name, words)
        return run(all_cases, Task(name, getattr(module, name.replace("-", "_"))), request, output)

    return define(name, page)(calculate)

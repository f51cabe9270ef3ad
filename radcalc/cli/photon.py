"""`radcalc photon WAVELENGTH|FREQUENCY|WAVENUMBER|ENERGY`."""

from collections.abc import Callable
from typing import TypeVar

from radcalc.calculators.photon import named, photon
from radcalc.calculators.solved import Task
from radcalc.cli.calculator import run
from radcalc.cli.cases import Case, cases
from radcalc.cli.output import Output
from radcalc.cli.request import Request
from radcalc.cli.spelling import Shell
from radcalc.errors import RadcalcError, UsageError, call, mentioned, spell

T = TypeVar("T")


def answer(
    typed: dict[str, str], request: Request, output: Output, words: tuple[str, ...] = ()
) -> int:
    """Answer for a wavelength, or a quantity given instead."""
    if not words:
        raise UsageError("a wavelength is missing", call("photon", "555nm"))
    all_cases = _as_operand(lambda: cases({"wavelength": " ".join(words), **typed}))
    all_cases = [_named(case) for case in all_cases]
    task = Task("photon", photon)
    if all_cases[0].stream:
        return _as_operand(lambda: run(all_cases, task, request, output))
    return run(all_cases, task, request, output)


def _as_operand(read: Callable[[], T]) -> T:
    """Read the operand; an error shows the wavelength as typed, since it is not an option here."""
    try:
        return read()
    except RadcalcError as error:
        calls = [
            call("photon", value, remark="" if mentioned(proposal.remark) else proposal.remark)
            for proposal in error.tries
            for _, value in proposal.inputs
        ]
        hint = calls or spell(error.hint, Command)
        raise error.reworded(spell(error.message, Operand), hint) from None


def _named(case: Case) -> Case:
    if case.stream:
        read = case.stream.read
        stream = case.stream._replace(read=lambda text: named(_as_operand(lambda: read(text))))
        return case._replace(stream=stream)
    wave = named(case.given["wavelength"])
    given = {**case.given, "wavelength": wave}
    names = {"wavelength": wave.name}
    varied = tuple(entry._replace(name=names.get(entry.name, entry.name)) for entry in case.varied)
    return case._replace(given=given, varied=varied)


class Operand(Shell):
    """The spelling of the wavelength in a message: as typed."""

    @staticmethod
    def option(name: str, value: str) -> str:
        return f"photon {value}".rstrip()


class Command(Shell):
    """The spelling of the wavelength in a hint."""

    @staticmethod
    def option(name: str, value: str) -> str:
        return f"radcalc photon {value}".rstrip()

"""The functions that answer calculators; those of `photon`, `integrate` and `sky` are here."""

from collections.abc import Callable
from functools import partial
from typing import TypeVar

from radcalc.answer import texts_of
from radcalc.calculators.solved import Task
from radcalc.cli.calculator import calculate, run
from radcalc.cli.cases import Case, cases
from radcalc.cli.output import Output
from radcalc.cli.request import Request
from radcalc.cli.spelling import Shell, own_module
from radcalc.errors import RadcalcError, UsageError, call, mentioned, quote, spell
from radcalc.inputs.given import shown_inputs

T = TypeVar("T")


def answer_photon(
    typed: dict[str, str], request: Request, output: Output, words: tuple[str, ...] = ()
) -> int:
    """Answer for a wavelength, or a quantity given instead."""
    from radcalc.calculators.photon import photon

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
    from radcalc.calculators.photon import named

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


def answer_integral(
    typed: dict[str, str],
    request: Request,
    output: Output,
    words: tuple[str, ...] = (),
    unit: str | None = None,
) -> int:
    """Answer for an expression, with or without a unit."""
    from radcalc.calculators.integrate import BARE, PAGE, integrand, integrate

    if not words:
        raise UsageError("an expression is missing", call("integrate", "cos(theta)", hemisphere=""))
    all_cases = cases(typed, arrays=False, intervals=PAGE.intervals)
    text = " ".join(words)
    of = integrand(unit) if unit else BARE
    operands = texts_of({"expression": text, "unit": unit or ""})
    drawn = text, unit or ""
    task = Task("integrate", lambda given: integrate(text, given, of), operands, drawn=drawn)
    return run(all_cases, task, request, output)


def answer_sky(
    typed: dict[str, str],
    request: Request,
    output: Output,
    words: tuple[str, ...] = (),
    save: str | None = None,
) -> int:
    """Answer for a sky, or write its map."""
    from radcalc.calculators.sky import OPERAND, sky, sky_map

    word, *others = words or [OPERAND.default]
    if others:
        raise UsageError(f"unexpected argument '{quote(others[0])}'", "one type of sky")
    name = word.lower()
    if save:
        from radcalc.cli.plot import one_case, write_map

        given = one_case(typed, request)
        inputs = (*texts_of({"type": name, "save": save}), *shown_inputs(given))
        return write_map(
            save, "map", lambda progress: sky_map(name, given), request, output, inputs
        )
    if "size" in typed:
        raise UsageError("--size does not apply without --save", "--save FILE with it")
    all_cases = cases(typed)
    is_drawn = bool(request.plot)
    task = Task(
        "sky",
        lambda given: sky(name, given, is_drawn),
        texts_of({"type": name}),
        name,
        drawn=name,
    )
    return run(all_cases, task, request, output)


def answerer(name: str) -> Callable[..., int] | None:
    """Return the function that answers a calculator; None if only its Click command does.

    The function has the parameters of `calculate` after the name, and those of other options.
    """
    own = {"photon": answer_photon, "integrate": answer_integral, "sky": answer_sky}
    if name in own:
        return own[name]
    return None if own_module(name) else partial(calculate, name)

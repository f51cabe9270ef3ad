"""`radcalc photon WAVELENGTH|FREQUENCY|WAVENUMBER|ENERGY`."""

from collections.abc import Callable
from typing import TypeVar

from radcalc.calculators.photon import named, photon
from radcalc.cli.calculator import Asked, run
from radcalc.cli.cases import Case, cases
from radcalc.cli.command import define
from radcalc.cli.options import Output
from radcalc.cli.spelling import Shell
from radcalc.errors import RadcalcError, UsageError, spell
from radcalc.quantities.symbols import QUANTITY

T = TypeVar("T")


@define(
    "photon",
    {"Light": ("observer",)},
    words="WAVELENGTH|FREQUENCY|WAVENUMBER|ENERGY",
    operands=(QUANTITY, ("wavelength",)),
    draws=True,
)
def command(words: tuple[str, ...], typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Give the wavelength, frequency, wavenumber and energy of a photon, and what is seen of it.

    \b
    Examples:
      radcalc photon 555nm
      radcalc photon 2.33eV
      radcalc photon 540THz
      radcalc photon 18000cm-1
      radcalc photon 400nm:780nm:1nm -g luminous-efficacy --plot
      radcalc photon 400nm:700nm:50nm -g wavelength:nm -g luminous-efficacy:lm/W

    The wavelength, frequency, wavenumber and energy are those in vacuum.  A length is looked up
    in the eye's tables as it is; the others are first turned into a wavelength in standard air.
    """
    if not words:
        raise UsageError("a wavelength is missing", "radcalc photon 555nm")
    each = _as_operand(lambda: cases({"wavelength": " ".join(words), **typed}))
    each = [_named(case) for case in each]
    if each[0].stream:
        return _as_operand(lambda: run(each, photon, asked, shown, "photon"))
    return run(each, photon, asked, shown, "photon")


def _as_operand(read: Callable[[], T]) -> T:
    """What is read; a refusal says the wavelength as it was typed, which is no option here."""
    try:
        return read()
    except RadcalcError as error:
        error.message = spell(error.message, Operand)
        error.hint = spell(error.hint, Command)
        raise


def _named(case: Case) -> Case:
    """A case in which what is given for the wavelength is called what it is."""
    if case.stream:
        read = case.stream.read
        stream = case.stream._replace(read=lambda text: named(_as_operand(lambda: read(text))))
        return case._replace(stream=stream)
    wave = named(case.given["wavelength"])
    given = {**case.given, "wavelength": wave}
    names = {"wavelength": wave.name}
    varied = tuple(one._replace(name=names.get(one.name, one.name)) for one in case.varied)
    return case._replace(given=given, varied=varied)


class Operand(Shell):
    """How a message says what was typed for the wavelength."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """`photon 555`."""
        return f"photon {value}".rstrip()


class Command(Shell):
    """How a hint says what to type."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """`radcalc photon 555nm`."""
        return f"radcalc photon {value}".rstrip()

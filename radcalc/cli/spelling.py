"""The shell's spelling of symbols and commands in messages, and names of commands."""

from radcalc.errors import MINUS, UsageError, input_of, spell

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from types import ModuleType

# The groups of the help, in its order.  That of COMMANDS is the order of proposals.
GROUPS = {
    "Convert": ("convert",),
    "Lamps and files": ("point-source", "scene", "uberlight", "laser", "dose", "columns"),
    "Surfaces, sky and rooms": (
        "lambertian",
        "environment",
        "sky",
        "room",
        "screen",
        "refraction",
    ),
    "Light itself": (
        "photon",
        "spectrum",
        "mesopic",
        "solid-angle",
        "direction",
        "etendue",
        "integrate",
    ),
    "Cameras and detectors": ("ev", "sensor", "calorimeter"),
    "Homework": ("mark",),
    "Tables and help": ("units", "quantities", "typical", "examples", "manual", "help", "prompt"),
}
HELP_NAMES = SHORT_HELP, COMPLETE_HELP = "-h", "--help"
EXPLAIN = "--explain"


def own_module(name: str) -> "ModuleType | None":
    """Import the module of a command; None for a calculator that its page describes alone."""
    from importlib import import_module
    from importlib.util import find_spec

    module_name = f"radcalc.cli.{name.replace('-', '_')}"
    return import_module(module_name) if find_spec(module_name) else None


LONGEST = 10_000  # characters of a typed line
NEED_QUOTES = set(" ()<>;&|")  # at a shell
SAFE = dict.fromkeys(map(ord, "%+,-./:=@_^µΩ°²³·"))  # at a shell, without quotes


class Shell:
    """The spelling as typed at a shell: options begin with two dashes."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """Return `--height 6m`."""
        text = f"'{value}'" if "'" not in value and NEED_QUOTES.intersection(value) else value
        return f"{'-g' if name == 'get' else f'--{name}'} {text}".rstrip()

    @staticmethod
    def command(*words: str) -> str:
        """Return `radcalc solid-angle cone --half-angle 30deg`; a word with = is an option."""
        typed = []
        for name, text in map(input_of, words):
            quoted = f"'{text}'" if NEED_QUOTES.intersection(text) else text
            typed.append(Shell.option(name, text) if name else quoted)
        return " ".join(["radcalc", *typed])

    @staticmethod
    def manual(name: str) -> str:
        return f"radcalc {name} --help"

    @staticmethod
    def measured(unit: str) -> str:
        """Return `illuminance (lx)`."""
        from radcalc.quantities.light import describe
        from radcalc.units.table import resolve

        return describe(resolve(unit))


def refuse_long(line: str) -> None:
    """Refuse a line that is too long to be typed."""
    if len(line) > LONGEST:
        problem = f"a line of {len(line)} characters is too long"
        raise UsageError(problem, f"at most {LONGEST}")


def split(line: str) -> list[str]:
    """Split a line into words, with quotes as at a shell; `radcalc` may be the first of them."""
    import shlex  # slow, and rarely needed

    try:
        words = shlex.split(line)
    except ValueError as error:
        mark = "\\" if "escaped" in str(error) else '"' if line.count('"') % 2 else "'"
        missing = "nothing after it" if mark == "\\" else "no second one"
        raise UsageError(f"the {mark} has {missing}", f"the line without {mark}") from None
    return words[1:] if words[:1] == ["radcalc"] else words


def pasted(words: "Sequence[str]") -> str:
    """Return a call as it can be pasted at a shell."""
    return " ".join(["radcalc", *map(quoted, words)])


def quoted(word: str) -> str:
    """Return a word as typed at a shell; < is a redirection."""
    others = word.translate(SAFE)
    if word == "<" or (word and (others.isalnum() or not others)):
        return word
    import shlex  # slow, and rarely needed

    return shlex.quote(word)


def spelled(text: str) -> str:
    """Return a text with its mentions spelled as at a shell."""
    return spell(text, Shell)


def typed(words: "Sequence[str]") -> "Iterator[str]":
    """Yield the words of a mention as they are typed: NAME=VALUE is an option."""
    for name, value in map(input_of, words):
        if not name:
            yield value
            continue
        yield "-g" if name == "get" else f"--{name}"
        if value:
            yield value.replace(MINUS, "-")

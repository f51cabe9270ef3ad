"""What is said of a wrong command line: loaded when one is met."""

from itertools import pairwise

import click

from radcalc.cli import COMMANDS, commands, context
from radcalc.errors import MINUS, MissingUnit, RadcalcError, nearest, option, quote
from radcalc.errors import command as call_of
from radcalc.errors import manual as help_of
from radcalc.render.formats import FORMATS
from radcalc.units.numbers import is_sentence

# What people call what a command is about, whose own name is not like it.
MEANT = {
    "ev": "camera aperture f-number iso shutter exposure meter lightmeter photography lens",
    "point-source": "point lamp led bulb spot spotlight beam inverse-square cosine candela",
    "scene": "room lights luminaires layout isolux uniformity",
    "lambertian": "diffuse diffuser reflector panel wall surface luminaire reflectance",
    "spectrum": "blackbody illuminant cct cri colour color spectra daylight",
    "photon": "wavelength frequency wavenumber laser",
    "mesopic": "scotopic photopic purkinje",
    "direction": "vector angle angles spherical azimuth elevation",
    "integrate": "integral",
    "calorimeter": "heat thermometer",
    "units": "unit",
    "screen": "projector cinema",
    "solid-angle": "steradian steradians omega",
    "uberlight": "cinematography renderman barzel superellipse barndoor falloff",
}

# What people call an option; those of the command are mentioned.
MEANT_OPTIONS = {
    "f-number": "aperture f-stop fstop stop",
    "time": "shutter shutter-speed exposure-time duration",
    "iso": "asa sensitivity film-speed",
    "luminous-flux": "lumen lumens",
    "radiant-flux": "watt watts power",
    "illuminance": "lux illumination footcandles",
    "luminous-intensity": "candela candelas candlepower",
    "luminance": "nit nits brightness",
    "half-angle": "angle beam cone",
    "apex-angle": "angle cone",
    "beam-angle": "angle beam spread",
    "off-axis-angle": "field-angle off-axis angle",
    "reflectance": "albedo reflectivity",
    "wavelength": "lambda color colour",
    "spectrum": "illuminant lamp",
    "precision": "digits decimals",
    "format": "output",
    "steps": "derivation explain verbose",
    "quiet": "silent",
}


def meant(args: list[str]) -> str:
    """What to type in place of a word that is no command."""
    word = args[0].lower()
    if near := nearest(word, COMMANDS, 1, 0.75):
        return f"{near[0]} (see radcalc --help)"
    from radcalc.calculators.solid_angle import NAMES

    if word in NAMES:
        return f"{call_of('solid-angle', word)} (see {help_of('solid-angle')})"
    names = [name for name, others in MEANT.items() if word in others.split()]
    if names:
        return f"{names[0]} (see {help_of(names[0])})"
    return _looked_up(args[0]) or _looked_up(" ".join(args)) or "radcalc --help"


def _looked_up(word: str) -> str:
    """The call that tells of a word that is a unit, a quantity or a spectrum; '' of any other."""
    from radcalc.quantities.targets import is_name
    from radcalc.spectra.sources import find_named
    from radcalc.units.scales import find
    from radcalc.units.table import unit_of

    if unit_of(word) or find(word):
        return call_of("units", quote(word))
    if is_name(word):
        return call_of("quantities", quote(word))
    return call_of("spectrum", quote(word)) if find_named(word) else ""


def join_unit(error: MissingUnit, words: list[str]) -> None:
    """Say to write `--distance 2 ft`, which the shell cuts, as one word."""
    from radcalc.quantities.symbols import SYMBOLS
    from radcalc.units.table import resolve

    flag = f"--{error.symbol}"
    behind = words[words.index(flag) + 2 :][:1] if flag in words else []
    if ":" in error.text:  # an interval, each end of which has its unit
        return
    symbol = SYMBOLS.get(error.symbol)
    called = next((word for word in words if word in COMMANDS), "")
    if symbol and called in symbol.narrower:  # a shutter's time is no 2h
        usual, own = [_unit_of(text) for text in (symbol.example, symbol.shown_in(called)[0])]
        if usual and own and error.hint == option(error.symbol, f"{error.text}{usual}"):
            error.hint = option(error.symbol, f"{error.text}{own}")
    try:
        if behind and symbol and resolve(behind[0]).dimension in symbol.dimensions:
            error.hint = option(error.symbol, f"{error.text}{quote(behind[0])}")
    except RadcalcError:
        pass
    error.hint += " (one word, no blank)"


def _unit_of(example: str) -> str:
    """The unit of an example of a symbol."""
    return example.lstrip("0123456789./")


def of_click(error: click.UsageError, words: list[str]) -> RadcalcError:
    """Click's complaint of a wrong option or command, with the nearest right ones."""
    called = next((word for word in words if word in COMMANDS), "")
    called = "convert" if is_sentence(words) else called
    help_ = f"{f'radcalc {called}'.strip()} --help"
    if isinstance(error, click.NoSuchOption):
        from radcalc.cli.command import GET

        if behind := options_behind(words):
            said = f"options go behind the command, and '{quote(words[0])}' is before it"
            return RadcalcError(said, behind)
        if called == "convert" and error.option_name in GET.opts:
            said = f"a conversion has one result, and no {quote(error.option_name)}"
            return RadcalcError(said, "-n, for its bare number")
        if error.option_name[2:] in FORMATS:
            said = f"there is no option '{quote(error.option_name)}'"
            return RadcalcError(said, f"--format {error.option_name[2:]}")
        known = [o for p in _parameters(called) for o in p.opts if o.startswith("--")]
        near = [o for o in known if o.startswith(error.option_name)]
        is_named = called and not near and error.option_name.startswith("--")
        name = error.option_name.removeprefix("--").lower()
        also = [f"--{one}" for one, others in MEANT_OPTIONS.items() if name in others.split()]
        meant_here = [one for one in also if one in known]
        others = _takers(error.option_name) if is_named and not meant_here else []
        if others:
            said = f"there is no option '{quote(error.option_name)}' in {called}"
            return RadcalcError(said, f"{help_of(others[0])}; it is of {', '.join(others)}")
        near = near or meant_here
        near = near or nearest(f"--{name}", known, cutoff=0.7)
        hint = f"{', '.join(near)} (see {help_})" if near else help_
        return RadcalcError(f"there is no option '{quote(error.option_name)}'", hint)
    message = one_line(error.format_message().replace(MINUS, "-"))  # as it was typed
    message = message.replace("a valid integer range", "a whole number in its range")
    if "unexpected extra argument" in message:
        word = message.partition("(")[2].rstrip(")")
        hint = "a value and its unit are one word, as in --distance 2m"
        if ("--plot", word) in pairwise(words):
            hint = "--plot FILE.svg or --plot FILE.png, or --plot without a file"
        return RadcalcError(f"there is a word too many: '{word}'", hint)
    return RadcalcError(message[:1].lower() + message[1:].rstrip("."), help_)


def options_behind(words: list[str]) -> str:
    """Mention the call with the options that stand before the command behind it.

    '' where there are none, or something else is wrong besides.
    """
    implied = "convert" if any(is_sentence([word]) for word in words) else ""
    called = next((word for word in words if word in COMMANDS), implied)
    if not called:
        return ""
    known = {spelling: p for p in _parameters(called) for spelling in p.opts}
    at = 0
    while words[at : at + 1] and words[at].startswith("-") and not is_sentence(words[at:]):
        name, equals, _ = words[at].partition("=")
        if name not in known:
            return ""
        is_flag = getattr(known[name], "is_flag", False)
        at += 1 if is_flag or equals else 2
    call = [*words[at:], *words[:at]]
    if not at or not (words[at:] and (words[at] == called or is_sentence(words[at:]))):
        return ""
    if any(quote(word) != word for word in call):
        return help_of(called)
    return call_of(*_with_values(call))


def _with_values(words: list[str]) -> list[str]:
    """The words of a call as a mention has them: an option whose value has a = is one word."""
    mentioned: list[str] = []
    for word in words:
        if "=" in word and mentioned and mentioned[-1].startswith("--"):
            mentioned[-1] = f"{mentioned[-1][2:]}={word}"
        else:
            mentioned.append(word[2:] if word.startswith("--") and "=" in word else word)
    return mentioned


def _takers(name: str) -> list[str]:
    """The commands that have an option."""
    return [c for c in COMMANDS if any(name in p.opts for p in _parameters(c))]


def _parameters(called: str) -> list[click.Parameter]:
    top = context()
    return (commands.get_command(top, called) or commands).get_params(top)


def one_line(text: str) -> str:
    """One printable line of bounded length."""
    text = " ".join(text.split())
    return quote(text) if not text.isprintable() or len(text) > 300 else text

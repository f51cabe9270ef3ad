"""The readings of a sentence: the symbols that its facts may fill, and what tells calls apart."""

from collections.abc import Sequence

from radcalc.calculators.page import Page
from radcalc.calculators.pages import page_of
from radcalc.errors import MOST, Try, input_of, mention
from radcalc.quantities.symbols import SYMBOLS, generic_name
from radcalc.sentences.facts import OF_DIMENSION, VALUE, Facts, is_light, light_of, meant
from radcalc.sentences.frames import is_solid_angle, taken_by
from radcalc.sentences.phrases import BESIDE
from radcalc.sentences.reader import Fact, Sentence
from radcalc.sentences.words import Amount
from radcalc.units.dimensions import ANGLE, LENGTH
from radcalc.units.unit import NUMBER


def readings_of(sentence: Sentence) -> list[Facts]:
    """Return the facts by their symbols, for every choice among the symbols of each phrase."""
    readings: list[Facts] = [{}]
    for fact in sentence.facts:
        names = _choices(fact, sentence)
        readings = [
            {**given, name: fact} for given in readings for name in names if name not in given
        ]
    return readings


def _choices(fact: Fact, sentence: Sentence) -> tuple[str, ...]:
    """Return the symbols that a fact may fill in a sentence."""
    is_alone = [one.symbols for one in sentence.facts].count(("incidence",)) == 1
    is_plain = fact.symbols == ("incidence",) and "incidence" not in fact.typed
    if is_plain and is_alone and _has_beam(sentence):
        return ("incidence", "toward")  # of the receiver, or off the axis of the beam
    if len(fact.symbols) < 2:
        return fact.symbols or _places(fact.amount, sentence)
    others = {name: other.text for other in sentence.facts for name in other.symbols}
    left_out = [
        name
        for name, (beside, value) in BESIDE.items()
        if name in fact.symbols and others.get(beside, value) == value
    ]
    return tuple([name for name in fact.symbols if name not in left_out])


def _has_beam(sentence: Sentence) -> bool:
    beams = {"beam-angle", "exponent", "half-angle", "apex-angle"}
    return any(beams & {*fact.symbols} for fact in sentence.facts)


def _places(amount: Amount | None, sentence: Sentence) -> tuple[str, ...]:
    """Return the symbols that an amount alone may fill."""
    assert amount is not None
    if light_of(amount):
        return meant(amount)
    wanted = {name for goal in sentence.goals for name in goal.names}
    if amount.dimension == ANGLE and wanted & {"hazard-distance", "spot-diameter"}:
        return ("divergence",)
    if amount.dimension == ANGLE and wanted & {"beam-diameter", "diameter"}:
        return OF_DIMENSION[ANGLE]
    if amount.dimension == ANGLE and any(map(is_solid_angle, sentence.goals)):
        return ("apex-angle", "half-angle")
    first = next(fact.amount for fact in sentence.facts if not fact.symbols)
    others = {name for fact in sentence.facts for name in fact.symbols}
    is_converted = first is amount and others <= taken_by(page_of("convert"))
    if is_converted and not any(map(is_light, sentence.facts)):
        return (VALUE,)
    if others & {"iso", "f-number"} and amount.dimension == NUMBER and amount.text[:2] == "1/":
        return ("time",)  # of a shutter
    if "aspect" in others and amount.dimension == LENGTH and not amount.is_wavelength:
        return ("diagonal",)  # of a screen
    return meant(amount)


def explained(calls: Sequence[tuple[str, ...]]) -> list[Try]:
    """Propose the calls of several readings, each with the meaning of what only it has."""
    in_all = set.intersection(*[{input_of(word)[0] for word in call[1:]} for call in calls])
    tries = []
    for command, *words in calls[:MOST]:
        page, pairs = page_of(command), [input_of(word) for word in words]
        own = [name for name, _ in pairs if name and name not in in_all]
        if not own:  # another command, or another result
            own = [text.partition(":")[0] for name, text in pairs if name == "get"]
        texts = [_meaning(page, name) for name in own if name in SYMBOLS]
        tries.append(Try(words=(command, *words), remark="; ".join(texts)))
    return tries


def _meaning(page: Page, name: str) -> str:
    """Return the first clause of the help of an input or a result, or its label."""
    symbol = page.symbol(name if name in page.texts else generic_name(name))
    text = symbol.help.partition("; ")[0].partition(". ")[0].rstrip(".")
    return mention(text[:1].lower() + text[1:]) if text else SYMBOLS[name].label

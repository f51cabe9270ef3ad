"""The light quantities of a calculator: inputs in any kind, results in every linked kind.

A generic name (`flux`) takes any kind, depending on the unit; a specific name (`luminous-flux`)
takes one kind.
"""

from contextlib import suppress
from functools import reduce
from typing import TYPE_CHECKING, Any

from radcalc import errors
from radcalc.answer import Remark, Step, Value, format_number, format_value, letter_of
from radcalc.calculators.results import LINKS_HINT, MISSING_LINK, value
from radcalc.errors import option, options
from radcalc.inputs import Input, Inputs
from radcalc.inputs.quantities import as_seen
from radcalc.laws import Law, law, same
from radcalc.laws.solver import Disagreement, Known, solve
from radcalc.maths import is_lost, larger
from radcalc.quantities import (
    KIND_NAMES,
    KINDS,
    LUMINOUS,
    RADIANT,
    base_of,
    kind_of_observer,
    of_kind,
    place_of,
    ratio,
    ratio_unit,
    symbols,
)
from radcalc.quantities.symbols import SYMBOLS
from radcalc.tuples import NamedTuple
from radcalc.units import Dimension
from radcalc.units.compiled import WEIGHTS
from radcalc.units.table import resolve


def dimension(name: str, kind: str) -> Dimension:
    """Return the dimension of a light quantity (generic name) in a kind."""
    if kind in KINDS:  # the usual call
        return SYMBOLS[name].dimensions[KINDS.index(kind)]
    return of_kind(SYMBOLS[name].dimensions[KINDS.index(base_of(kind))], kind)


def kind_of(given: Input) -> str:
    """Return the kind of a light quantity as given."""
    place = place_of(given.dimension)
    assert place is not None
    return place[0]


if TYPE_CHECKING:
    from radcalc.conversion.geometric import Factor


class LightInputs(NamedTuple):
    """Light inputs: quantities of one kind [SI], and links to other kinds.

    `given_in_two_kinds` has, by generic name, values in a second kind; their ratio is a link.
    `mixed` are the kinds given, if there are several and none is preferred: a result then has the
    name as typed, or that of its kind, whatever the order of the inputs.  `kinds` are those of the
    results: watts, the lumens of the observer, photons, and the weight.
    """

    kind: str
    values: Inputs
    amounts: dict[str, Any]
    links: Inputs
    assumptions: tuple[str, ...]
    notes: tuple[str, ...]
    steps: tuple[Step, ...]
    given_in_two_kinds: Inputs
    mixed: tuple[str, ...] = ()
    kinds: tuple[str, ...] = KINDS

    @property
    def lumens(self) -> str:
        """The kind of the lumens of the call: those of its observer."""
        return next(kind for kind in self.kinds if base_of(kind) == LUMINOUS)

    @property
    def linked(self) -> list[str]:
        """What a link touches: the other kinds, and quantities given in them."""
        names = [name for name, item in self.values.items() if kind_of(item) != self.kind]
        return [*names, *(kind for kind in self.kinds if kind != self.kind)]


NO_LIGHT = LightInputs(RADIANT, {}, {}, {}, (), (), (), {})


def read_light(typed: Inputs, links: Inputs, preferred: str = "") -> LightInputs:
    """Return light quantities by generic names, converted to one kind.

    The kind is that of the first, or the preferred one if they are linked.  Other kinds need a
    wavelength, a spectrum or an efficacy, or one quantity in both kinds.
    """
    typed, links, wanted = _in_kinds(typed, links)
    weights = {*wanted, *map(kind_of, typed.values())} & WEIGHTS.keys()
    if "dark-outside" in links and not weights:
        raise errors.Unused(["dark-outside"], "without a weight")
    given, given_in_two_kinds, notes = _by_generic_names(typed)
    links, further, steps = _links(links, given, given_in_two_kinds)
    notes += further
    first = next(iter(given), "")
    kind = kind_of(given[first]) if first else preferred or RADIANT
    if preferred not in ("", kind) and linking_factor(links, preferred, kind):
        kind = preferred
    kinds_given = {kind_of(item) for item in typed.values()} if len(typed) > 1 else ()
    assumptions: list[str] = []
    amounts = {}
    for name, item in given.items():
        of_kind = kind_of(item)
        amounts[name] = item.value
        if of_kind != kind:
            factor = linking_factor(links, kind, of_kind)
            if factor is None:
                raise _unlinked(item, given[first], kind)
            amounts[name] = item.value * factor.value
            if factor.assumption:
                assumptions.append(Remark(factor.assumption, [name]))
            notes += [Remark(note, [name]) for note in factor.notes]
            steps += factor.steps
    remarks = tuple(assumptions), tuple(notes), tuple(steps)
    mixed = tuple(kinds_given) if len(kinds_given) > 1 else ()
    return LightInputs(kind, given, amounts, links, *remarks, given_in_two_kinds, mixed, wanted)


def _in_kinds(typed: Inputs, links: Inputs) -> tuple[Inputs, Inputs, tuple[str, ...]]:
    """Return inputs and links in the kinds of an observer, the other links, and the kinds wanted.

    The lumens of a call are those of its observer.
    """
    if "filter" in links:
        from radcalc.conversion.spectral import behind_filter

        links = behind_filter(links)
    wanted, refined = list(KINDS), {"observer", "weight"} & links.keys()
    if not refined:
        return typed, links, KINDS
    _refuse_idle_refinements(links)
    others = {name: item for name, item in links.items() if name not in refined}
    if "observer" in links:
        kind = kind_of_observer(links["observer"].value)
        wanted[KINDS.index(LUMINOUS)] = kind
        typed = {name: as_seen(item, kind) for name, item in typed.items()}
        others = {name: as_seen(item, kind) for name, item in others.items()}
    if "weight" in links:
        wanted.append(links["weight"].value)
    return typed, others, tuple(dict.fromkeys(wanted))


def _by_generic_names(typed: Inputs) -> tuple[Inputs, Inputs, list[str]]:
    """Return light quantities, those that are given again in another kind, and notes."""
    given: Inputs = {}
    given_in_two_kinds: Inputs = {}
    notes: list[str] = []
    for item in typed.values():
        generic = item.symbol.generic
        known = [of for of in (given, given_in_two_kinds) if generic in of]
        same_kind = [of for of in known if kind_of(of[generic]) == kind_of(item)]
        if not known:
            given[generic] = item
        elif same_kind:
            (of,) = same_kind
            if item.name != generic:  # the more specific name, whatever the order
                of[generic], item = item, of[generic]
            notes += _compare(of[generic], item)
        elif given_in_two_kinds:
            raise errors.Exclusive((given[generic].name, item.name), "they are the same quantity")
        else:
            given_in_two_kinds[generic] = item
    return given, given_in_two_kinds, notes


def _links(
    links: Inputs, given: Inputs, given_in_two_kinds: Inputs
) -> tuple[Inputs, list[str], list[Step]]:
    """Return the links between kinds, with that of a quantity in two kinds, notes and steps."""
    notes: list[str] = []
    steps: list[Step] = []
    if "efficacy" in links:
        from radcalc.conversion.agreement import without_efficacy

        links, agreed = without_efficacy(links)
        notes += agreed
    linking = [name for name in links if name in symbols.LINKS]
    if len(linking) > 1:
        raise errors.Exclusive(linking[:2], "both link radiant, luminous and photon quantities")
    for name, twin in given_in_two_kinds.items():
        ratio = Ratio.of(given[name], twin)
        if linking:
            notes += ratio.compare(links)
            continue
        links = {**links, "efficacy": ratio.link()}
        steps.append(ratio.step())
        _refuse_impossible(ratio, links)
    _refuse_idle_refinements(links)
    return links, notes, steps


def _unlinked(item: Input, first: Input, kind: str) -> errors.MissingInput:
    """Return the error for a light quantity that no link converts to the kind of the first."""
    return errors.MissingInput(
        f"{option(item.name)} is {KIND_NAMES[kind_of(item)]}, "
        f"{option(first.name)} {KIND_NAMES[kind]}: {MISSING_LINK}",
        LINKS_HINT,
        [errors.add("wavelength"), errors.add("spectrum"), errors.leave_out(item.name)],
    )


def _compare(first: Input, second: Input) -> list[str]:
    """Refuse two values of one quantity that differ by more than their digits; return a note."""
    texts = [option(item.name, errors.quote(item.text)) for item in (first, second)]
    known = {
        name: Known(item.value, item.rounding * abs(item.value))
        for name, item in (("first", first), ("second", second))
    }
    try:
        solution = solve([same("first", "second")], known)
    except Disagreement:
        problem = "{} contradicts {}: they are the same quantity".format(*texts)
        hint = options((first.name, second.name), ", ")
        raise errors.Contradiction(
            problem, f"leave out one of {hint}", first.symbol.generic, first.value, second.value
        ) from None
    note = "{} is used; {} agrees to the digits typed".format(*texts)
    return [note] if solution.agreed else []


class Ratio(NamedTuple):
    """The ratio of one quantity in two kinds, which links them: numerator and denominator."""

    name: str
    over: Input
    under: Input

    @classmethod
    def of(cls, first: Input, second: Input) -> "Ratio":
        """Return the ratio of two inputs of different kinds."""
        of_bases = {base_of(kind_of(given)): given for given in (first, second)}
        for name, over, under in symbols.EFFICACIES:
            if {over, under} == of_bases.keys():
                return cls(name, of_bases[over], of_bases[under])
        is_weight = kind_of(first) in WEIGHTS
        return cls("efficacy", *((first, second) if is_weight else (second, first)))

    @property
    def value(self) -> Any:
        return self.over.value / self.under.value

    def link(self) -> Input:
        unit = resolve(f"({ratio_unit(kind_of(self.over), kind_of(self.under))})")
        if unit.dimension == SYMBOLS[self.name].dimensions[0]:
            unit = resolve(SYMBOLS[self.name].unit)
        number = self.value / float(unit.factor)
        text = f"{format_number(number)} {unit.text} ({self.over.text} over {self.under.text})"
        return Input(
            SYMBOLS["efficacy"], text, self.value, unit.dimension, number, unit, is_exact=True
        )

    def compare(self, links: Inputs) -> tuple[str, ...]:
        """Compare the ratio with that of a link; return notes."""
        from radcalc.conversion.agreement import Said, compare_ratio

        said = Said([self.over, self.under], lambda given: given[0].value / given[1].value)
        return compare_ratio(said, links, kind_of(self.over), kind_of(self.under))

    @property
    def law(self) -> Law:
        over, under = (
            symbols.specific_name(quantity.symbol.generic, kind_of(quantity))
            for quantity in self[1:]
        )
        label = f"{SYMBOLS[self.name].label} of the light"
        return law(label, f"{{{over}}} = {{{self.name}}} {{{under}}}")

    def step(self) -> Step:
        generic, pair = self.over.symbol.generic, (kind_of(self.over), kind_of(self.under))
        over, under = (
            format_value(
                quantity.value, symbols.light_unit(generic, kind_of(quantity), coherent=True)
            )
            for quantity in self[1:]
        )
        letter = letter_of(self.name)
        ratio_text = f"{format_number(self.value)} {ratio_unit(*pair)}"
        return self.law.formula.with_numbers(
            f"({over}) = {letter} ({under}), so {letter} = {ratio_text}"
        )


def rounding(lit: LightInputs, name: str) -> Any:
    """Return the rounding error of a light quantity [SI], from its digits and those of the link."""
    given, amount = lit.values[name], abs(lit.amounts[name])
    off = given.rounding * amount
    kind = kind_of(given)
    if kind != lit.kind:
        for quantity, twin in lit.given_in_two_kinds.items():
            off += (lit.values[quantity].rounding + twin.rounding) * amount
        for key, link in lit.links.items():
            if link.symbol.form == symbols.QUANTITY and link.rounding:
                parts = (1 + link.rounding, 1 - link.rounding)
                moved = ({**lit.links, key: link._replace(value=link.value * p)} for p in parts)
                factors = [
                    factor for links in moved if (factor := linking_factor(links, lit.kind, kind))
                ]
                off += reduce(larger, [abs(abs(given.value * f.value) - amount) for f in factors])
    return off


def _refuse_impossible(ratio: Ratio, links: Inputs) -> None:
    kinds = (kind_of(quantity) for quantity in ratio[1:])
    try:
        linking_factor(links, *kinds)
    except errors.Impossible as error:
        quantities = " and ".join(
            option(quantity.name, errors.quote(quantity.text)) for quantity in ratio[1:]
        )
        raise errors.ConditionError(
            f"{quantities} contradict each other: {error.because}",
            f"less of the one or more of the other: {error.limit}",
            [errors.leave_out(quantity.name) for quantity in ratio[1:]],
        ) from None


def _refuse_idle_refinements(links: Inputs) -> None:
    for name in symbols.REFINEMENTS:
        is_of_any = name in ("observer", "weight")
        useful = symbols.LINKS if is_of_any else ("spectrum",)
        if name in links and not set(useful) & set(links):
            raise errors.ConditionError(
                f"{option(name)} does not apply without {options(useful)}",
                f"add {options(useful)}, or use neither",
            )


def linking_factor(links: Inputs, over: str, under: str) -> "Factor | None":
    """Return the ratio of two kinds from the conditions; None if they do not link them."""
    if not links:
        return None
    from radcalc.conversion import spectral  # loads the tables of the observers

    try:
        return spectral.linked(links, over, under)
    except (errors.Impossible, errors.TooNarrow):
        raise
    except errors.ConditionError as error:
        raise error.reworded(
            tries=error.tries or [errors.leave_out(name) for name in links]
        ) from None


def _multiple(name: str, amount: Any, factor: Any) -> Any:
    """Return an amount in another kind; refuse one that is too small for a number."""
    product = amount * factor
    if is_lost(product, amount, factor):
        raise errors.NumberError(f"{name} is too small for a number", "less extreme values")
    return product


class LightResults(NamedTuple):
    """Light quantities as results, with the assumptions of their kinds."""

    values: dict[str, list[Value]]
    assumptions: tuple[str, ...]
    notes: tuple[str, ...]
    steps: tuple[Step, ...]


def show_light(lit: LightInputs, amounts: dict[str, Any]) -> LightResults:
    """Return light quantities [SI, by generic name] as results in every linked kind."""
    factors: dict[str, Factor] = {}
    refused: dict[str, errors.TooNarrow] = {}
    for kind in lit.kinds:
        try:
            factor = linking_factor(lit.links, kind, lit.kind) if kind != lit.kind else None
        except errors.TooNarrow as error:
            refused[kind] = error
        else:
            if factor:
                factors[kind] = factor
    values: dict[str, list[Value]] = {}
    for name, amount in amounts.items():
        reach = {
            dimension(name, kind): _multiple(name, amount, factor.value)
            for kind, factor in factors.items()
        }
        values[name] = [_value(lit, name, lit.kind, amount, reach)]
        for kind in factors:
            linked = {dimension(name, lit.kind): amount, **reach} if kind in lit.mixed else {}
            other = reach[dimension(name, kind)]
            values[name].append(_value(lit, name, kind, other, linked))
        values[name] += [
            _value(lit, name, kind, 0.0, {})._replace(units=(), because=error)
            for kind, error in refused.items()
        ]
    return LightResults(
        values,
        tuple([Remark(f.assumption, [kind]) for kind, f in factors.items() if f.assumption]),
        (
            *[Remark(note, [kind]) for kind, factor in factors.items() for note in factor.notes],
            *[
                Remark(f"no {KIND_NAMES[kind]} results: {error.message}", [kind])
                for kind, error in refused.items()
            ],
        ),
        tuple([step for factor in factors.values() for step in factor.steps]),
    )


def _value(
    lit: LightInputs, name: str, kind: str, amount: Any, reach: dict[Dimension, Any]
) -> Value:
    """Return a light quantity in a kind; as given if it was given in that kind."""
    candidates = (lit.values.get(name), lit.given_in_two_kinds.get(name))
    given = next(
        (candidate for candidate in candidates if candidate and kind_of(candidate) == kind), None
    )
    letter = SYMBOLS[name].letter
    also = specific = symbols.specific_name(name, kind)
    own_name = specific if specific != name else f"radiant-{name}"
    if kind in lit.mixed:
        typed = given.name if given else own_name
        own_name, also = typed, own_name if typed == name else name
    elif kind == lit.kind:
        own_name = name
    elif base_of(kind) == LUMINOUS:
        also = symbols.specific_name(name, LUMINOUS)  # of the observer of the call
    return Value(
        own_name,
        specific.replace("-", " "),
        letter if "_" in letter else f"{letter}_{kind}",
        given.value if given else amount,
        (dimension(name, kind),),
        (given.unit_text if given else symbols.light_unit(name, kind),),
        reach,
        given.number if given else None,
        also,
    )


def efficacies(lit: LightInputs) -> list[Value]:
    """Return the ratios of kinds to show [SI]: lm/W if linked, and ratios of inputs."""
    ratio_names = {
        Ratio.of(lit.values[name], twin).name for name, twin in lit.given_in_two_kinds.items()
    }
    ratios = []
    for name, *bases in symbols.EFFICACIES:
        if name in ratio_names or tuple(bases) == (LUMINOUS, RADIANT):
            over, under = (lit.kinds[KINDS.index(base)] for base in bases)
            with suppress(errors.TooNarrow):  # results that need the ratio report it
                if factor := linking_factor(lit.links, over, under):
                    ratios.append(of_kinds(value(name, factor.value), over, under))
    return ratios


def of_kinds(result: Value, over: str, under: str) -> Value:
    """Return a ratio of watts, lumens or photons as one of other kinds: lm_scot/W."""
    if over not in WEIGHTS and under not in WEIGHTS:
        return result
    return result._replace(
        dimensions=(ratio(over, under),), units=(ratio_unit(over, under).replace(" ", "."),)
    )

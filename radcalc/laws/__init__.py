"""Laws as data, a module for each subject, and the solver that uses them.

A `Law` is a monomial, result = constant * product of symbols to their powers, which can be solved
for any of its symbols; `law` reads it from its formula.  A `Relation` is any other law, with a
function for each symbol that it can be solved for.  All values are in coherent SI units, floats or
arrays; radians, steradians, cycles and photons count as units, and Omega0 is 1 sr.

This module also has the laws that several subjects share: energy over a time, heat, sizes, cones,
incidence.  Energy and exposure are those of light that is constant over a time (ISO 80000-7).
Lengths [m] and areas [m2] are those of flat sources and receivers, and offsets [m] those of
receivers.

Half angles [rad] of a circular cone are at most pi; its projected solid angle [sr] is about the
normal of the lit surface, pi Omega0 for half angles above pi/2, and gives half angles of at most
pi/2.

The heat is that of light in a body that loses no heat, with a constant specific heat capacity, flux
and irradiance.  Watts and joules only: the heat of lumens and photons depends on their spectrum.
"""

import math
from collections.abc import Callable, Container
from typing import Any

from radcalc import geometry
from radcalc.answer import Formula, format_number
from radcalc.errors import ConditionError
from radcalc.maths import acos, any_true, is_array, piecewise, power, sqrt, square
from radcalc.tuples import NamedTuple

At = Callable[[str], Any]  # returns the value of a symbol


class Law(NamedTuple):
    """A monomial law: the first of its symbols is a constant times a product of powers.

    Attributes
    ----------
    name : str
        Its name in a derivation.
    template : str
        The formula, with the names of symbols in braces.
    names : tuple of str
        Its symbols, that on the left first.
    powers : tuple of (str, float)
        The symbols on the right, with their powers.
    constant : float [unit]
        Factor of the product.
    unit : str
        Unit of the constant, with sr, photon and cycle written out.
    reference : str
        Source of the law.

    Examples
    --------
    >>> isotropic = law("isotropic source", "{flux} = 4 pi Omega0 {intensity}")
    >>> isotropic.names, round(isotropic.constant, 4), isotropic.unit
    (('flux', 'intensity'), 12.5664, 'sr')
    """

    name: str
    template: str
    names: tuple[str, ...]
    powers: tuple[tuple[str, float], ...]
    constant: float = 1.0
    unit: str = "1"
    reference: str = ""

    @property
    def result(self) -> str:
        """Return the symbol on the left."""
        return self.names[0]

    @property
    def targets(self) -> tuple[str, ...]:
        """Return the symbols that it can be solved for."""
        return self.names

    @property
    def formula(self) -> Formula:
        """Return its form in a derivation."""
        return Formula(self.name, self.template, self.reference)

    def solve(self, target: str, at: At) -> Any:
        """Solve the law for one of its symbols.

        Parameters
        ----------
        target : str
            The wanted symbol.
        at : callable
            Returns the value of every other symbol by its name [SI].

        Returns
        -------
        float or ndarray [SI]
            The target; the positive one of several roots.

        Raises
        ------
        ConditionError
            If it would be divided by 0: no light arrives.

        Examples
        --------
        >>> square = law("inverse square law", "{irradiance} = {intensity} Omega0 / {distance}^2")
        >>> square.solve("distance", {"irradiance": 25.0, "intensity": 100.0}.get)
        2.0
        """
        product, root = self.constant, 1.0
        for name, exponent in self.powers:
            if name == target:
                root = exponent
            elif exponent == 1:
                product = product * at(name)
            elif exponent == -1:
                product = product / at(name)
            else:
                product = product * power(at(name), exponent)
        if target == self.names[0]:
            return product
        result = at(self.names[0])
        is_dark = product == 0
        if (is_dark is not False and any_true(is_dark)) or (root < 0 and any_true(result == 0)):
            raise ConditionError(
                f"no light arrives, so the {target.replace('-', ' ')} cannot be calculated",
                "a receiver in the light",
            )
        quotient = result / product
        return quotient if root == 1 else power(quotient, 1 / root)


def law(
    name: str, template: str, reference: str = "", constant: float = 1.0, unit: str = "1"
) -> Law:
    """Read a monomial law from its formula.

    Parameters
    ----------
    name : str
        Its name in a derivation.
    template : str
        The formula: factors separated by blanks, a power after ^; a solidus divides by the next
        factor or bracket.  Numbers, pi and Omega0 (1 sr) are read.
    reference : str
        Source of the law.
    constant : float [unit]
        Value of the other letters of the formula, such as c.
    unit : str
        The unit of `constant`.

    Returns
    -------
    Law
        With the powers and the constant of the formula.

    Examples
    --------
    >>> law("etendue of a cone", "{etendue} = pi Omega0 {area} / (4 {f-number}^2)").powers
    (('area', 1.0), ('f-number', -2.0))
    >>> frequency = law("frequency", "{frequency} = c / {wavelength}", "", 299792458.0, "m cycle/s")
    >>> round(frequency.solve("frequency", {"wavelength": 555e-9}.get) / 1e12, 3)
    540.167
    """
    result, _, right = template.partition(" = ")
    powers: list[tuple[str, float]] = []
    steradians, sign, is_in_bracket = 0, 1, False
    for word in right.replace("(", "( ").replace(")", " )").split():
        factor, _, power = word.partition("^")
        exponent = sign * float(power or 1)
        if factor.startswith("{"):
            powers.append((factor.strip("{}"), exponent))
        elif factor == "Omega0":
            steradians += sign
        elif factor == "pi" or factor[0].isdigit():
            constant *= (math.pi if factor == "pi" else float(factor)) ** exponent
        is_in_bracket = word == "(" or (is_in_bracket and word != ")")
        sign = -1 if word == "/" or (sign < 0 and is_in_bracket) else 1
    if steradians:
        unit = "sr" if steradians > 0 else "1/sr"
    names = (result.strip("{}"), *(symbol for symbol, _ in powers))
    return Law(name, template, names, tuple(powers), constant, unit, reference)


SAME = "the same quantity"


def same(first: str, second: str) -> Law:
    """Make the law that two symbols have one value.

    Parameters
    ----------
    first, second : str
        The symbols.

    Returns
    -------
    Law
        It compares values of one quantity that are given or found in two ways.

    Examples
    --------
    >>> same("polar", "polar#1").solve("polar", {"polar#1": 0.5}.get)
    0.5
    """
    return law(SAME, f"{{{first}}} = {{{second}}}")


class Several(tuple[float, ...]):
    """Values of a symbol [SI] that fit a law equally well, if there is more than one.

    Parameters
    ----------
    iterable : iterable of float [SI]
        The values.

    Examples
    --------
    >>> Several((1.0, 4.0))[1]
    4.0
    """


def refuse_arrays(what: str, *values: Any) -> None:
    """Refuse arrays if there may be `Several` values, which are found one by one.

    Parameters
    ----------
    what : str
        Plural noun for the values, for the message.
    values : float or ndarray
        The values from which they are found.

    Raises
    ------
    ConditionError
        If one of the values is an array.

    Examples
    --------
    >>> refuse_arrays("heights", 1.0, 2.0)
    """
    if any(map(is_array, values)):
        raise ConditionError(
            f"several {what} may fit, which are found for one set of values at a time",
            "a list of at most 1000 values",
        )


class Relation(NamedTuple):
    """A law that is not a monomial: a function of the other values for each target.

    Attributes
    ----------
    name : str
        Its name in a derivation.
    template : str
        The formula, with the names of symbols in braces.
    names : tuple of str
        Its symbols, that on the left first.
    solvers : dict of str to callable
        For each symbol it can be solved for, a function that takes `at` (which returns the value of
        every other symbol by its name) and returns that symbol's value [SI], or `Several` of them.
    reference : str
        Source of the law.
    has_limit : bool
        Whether values that are impossible only by their rounding mean the limit: the f-numbers
        of a lens focused far away, the area and the diagonal of a square.

    Examples
    --------
    >>> from radcalc.laws import CONE
    >>> CONE.targets
    ('solid-angle', 'half-angle')
    """

    name: str
    template: str
    names: tuple[str, ...]
    solvers: dict[str, Callable[[At], Any]]
    reference: str = ""
    has_limit: bool = False

    @property
    def targets(self) -> tuple[str, ...]:
        """Return the symbols that it can be solved for."""
        return tuple(self.solvers)

    @property
    def formula(self) -> Formula:
        """Return its form in a derivation."""
        return Formula(self.name, self.template, self.reference)

    def solve(self, target: str, at: At) -> Any:
        """Solve the relation for one of its targets.

        Parameters
        ----------
        target : str
            The wanted symbol, one of `targets`.
        at : callable
            Returns the value of every other symbol by its name [SI].

        Returns
        -------
        float, ndarray or Several [SI]
            The target.

        Examples
        --------
        >>> from radcalc.laws import CONE
        >>> round(CONE.solve("half-angle", {"solid-angle": 1.0}.get), 6)
        0.571954
        """
        return self.solvers[target](at)


def relation(
    name: str, template: str, solvers: dict[str, Callable[[At], Any]], reference: str = ""
) -> Relation:
    """Make a relation of the symbols of a formula.

    Parameters
    ----------
    name : str
        Its name in a derivation.
    template : str
        The formula, with the names of symbols in braces.
    solvers : dict of str to callable
        For each symbol that it can be solved for, a function of the others; its argument is a
        function that returns the value [coherent SI] of a symbol by its name.
    reference : str
        Source of the relation.

    Returns
    -------
    Relation
        With the symbols of the formula.

    Examples
    --------
    >>> solvers = {"diameter": lambda at: 2 * at("radius")}
    >>> double = relation("diameter", "{diameter} = 2 {radius}", solvers)
    >>> double.names, double.solve("diameter", {"radius": 3.0}.get)
    (('diameter', 'radius'), 6.0)
    """
    names = [part.partition("}")[0] for part in template.split("{")[1:]]
    return Relation(name, template, tuple(dict.fromkeys(names)), solvers, reference)


AnyLaw = Law | Relation
HOWELL = "J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors"


ENERGY = law("energy", "{energy} = {flux} {time}")
EXPOSURE = law("exposure", "{exposure} = {irradiance} {time}")
RECTANGLE = law("area of a rectangle", "{area} = {width} {length}")
CIRCLE = law("area of a circle", "{area} = pi {radius}^2")
DIAMETER = law("diameter", "{diameter} = 2 {radius}")
OFFSET = law("offset", "{offset} = {lateral}")


def _aspect(ratio: Any) -> Any:
    """Return the aspect a >= 1 with a + 1/a equal to a ratio."""
    geometry.refuse(
        ratio < 2, "the diagonal is too short for that area", "more diagonal, or less area"
    )
    return (ratio + sqrt((ratio - 2) * (ratio + 2))) / 2


ASPECT = relation(
    "aspect of a rectangle, by its area and diagonal",
    "{diagonal}^2 = {area} ({aspect} + 1 / {aspect})",
    {"aspect": lambda at: _aspect(square(at("diagonal")) / at("area"))},
)._replace(has_limit=True)


def round_sizes(given: Container[str]) -> list[AnyLaw]:
    """Choose the laws of a round shape in addition to those of its radius.

    Parameters
    ----------
    given : container of str
        The given symbols.

    Returns
    -------
    list of Law
        The law of the diameter if that is given; otherwise the answer has no diameter.

    Examples
    --------
    >>> [law.template for law in round_sizes(["diameter"])], round_sizes(["radius"])
    (['{diameter} = 2 {radius}'], [])
    """
    return [DIAMETER] if "diameter" in given else []


def _half_angle_of(solid_angle: Any) -> Any:
    geometry.refuse(
        solid_angle > geometry.FULL * (1 + 1e-9),
        f"no cone has a solid angle of {format_number(solid_angle)} sr: a sphere has 4 pi sr",
        "less flux, or more intensity",
    )
    return geometry.cone_of(solid_angle)


CONE = relation(
    "solid angle of a cone",
    "{solid-angle} = 4 pi Omega0 sin^2({half-angle}/2)",
    {
        "solid-angle": lambda at: geometry.cone(at("half-angle")),
        "half-angle": lambda at: _half_angle_of(at("solid-angle")),
    },
    "ISO 80000-3, solid angle",
)
PROJECTED_CONE = relation(
    "projected solid angle of a cone",
    "{projected-solid-angle} = pi Omega0 sin^2({half-angle})",
    {
        "projected-solid-angle": lambda at: geometry.projected_cone(at("half-angle")),
        "half-angle": lambda at: geometry.projected_cone_of(at("projected-solid-angle")),
    },
    "ISO 80000-7, radiance and irradiance",
)
APEX = law("apex angle", "{apex-angle} = 2 {half-angle}")
CONFIGURATION_FACTOR = law(
    "configuration factor", "{configuration-factor} = {projected-solid-angle} / (pi Omega0)"
)


def _incidence_of(cosine: Any) -> Any:
    geometry.refuse(
        cosine > 1 + 1e-9,
        f"more light than that intensity sends to that distance (the cosine of the incidence "
        f"would be {format_number(cosine)})",
        "another irradiance, intensity or distance",
    )
    return acos(piecewise(cosine > 1, lambda c: 1.0 + 0 * c, lambda c: c, cosine))


COSINE = relation(
    "cosine of the incidence",
    "{cosine} = cos({incidence})",
    {
        "cosine": lambda at: geometry.facing(at("incidence")),
        "incidence": lambda at: _incidence_of(at("cosine")),
    },
)
HEAT_LAWS: list[AnyLaw] = [
    law("heat of a body", "{heat} = {mass} {specific-heat} {temperature-rise}"),
    law("absorbed light", "{heat} = {absorptance} {energy}", "ISO 80000-7, absorptance"),
    ENERGY,
    law("flux on a receiver", "{flux} = {irradiance} {receiver-area}"),
]

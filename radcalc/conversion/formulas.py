"""Formulas of textbooks, typed as expressions without the steradian: I / d^2, Phi / (4 pi)."""

import re

from radcalc.conversion.ways import FLUX, INTENSITY, IRRADIANCE, RADIANCE
from radcalc.errors import ConversionError, quote
from radcalc.quantities.light import read
from radcalc.units.table import resolve
from radcalc.units.unit import Unit

SQUARE = r"\(\s*[\d.]+\s*[a-zµ]+\s*\)\s*(?:\^\s*2|\*\*\s*2|²)"  # of a length
PI = r"(?:pi|π)"
# The quantity of the expression and that of the target; what the expression has; the law.
FORMS = (
    (RADIANCE, IRRADIANCE, rf"/\s*{SQUARE}", "E = I Omega0 / d^2"),
    (FLUX, INTENSITY, rf"\*\s*{SQUARE}|{SQUARE}\s*\*", "I = E d^2 / Omega0"),
    (FLUX, INTENSITY, rf"/\s*\(\s*4\s*\*?\s*{PI}\s*\)", "I = Phi / (4 pi Omega0)"),
    (IRRADIANCE, RADIANCE, rf"/\s*{PI}(?!\w)", "L = rho E / (pi Omega0)"),
    (RADIANCE, IRRADIANCE, rf"(?:^|[*\s(]){PI}\s*\*|\*\s*{PI}(?!\w)", "M = pi Omega0 L"),
)


def as_law(text: str, source: Unit, target: Unit) -> Unit:
    """Return the unit of an expression with the steradian of its law, which a note names.

    The unit is unchanged if the expression is not one of `FORMS`.
    Raises ConversionError if it is a product that lacks the steradian of one of them.
    """
    start, end = read(source), read(target)
    if start is None or end is None or (start.kind, start.time) != (end.kind, end.time):
        return source
    forms = [form for form in FORMS if (start.geometry[1:], end.geometry[1:]) == form[:2]]
    for here, _, pattern, law in forms:
        if re.search(pattern, text):
            power = "/sr" if here in (FLUX, IRRADIANCE) else ".sr"
            complete = resolve(f"({source.text}){power}")
            return complete.of_class(Unit, f"sr read into the formula: {law}")
    if forms and any(sign in text.replace(source.text, "") for sign in "/*"):
        laws = " or ".join(law for *_, law in forms)
        raise ConversionError(
            f"'{quote(text)}' is in {source.text}, and {target.text} differs by a steradian",
            f"{laws}, with the distance in brackets as in (10 m)^2 and pi as pi; or sr where it "
            "belongs",
        )
    return source

"""Check of an answer, with the likely mistake."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from radcalc.answer import Row, Value
from radcalc.api.arguments import as_text
from radcalc.api.keywords import Scalar
from radcalc.api.refusals import in_python
from radcalc.api.result import Result, question_of
from radcalc.api.spelling import in_words, keyword
from radcalc.errors import ConditionError
from radcalc.homework.verdict import Verdict as Judged
from radcalc.quantities.symbols import article
from radcalc.render.formats import Judgement, Style
from radcalc.render.plain import verdict as words_of


class Verdict(Judged):
    """The judgement of an answer; true if it is right.

    Examples
    --------
    >>> import radcalc
    >>> verdict = check(radcalc.explain("500 lx", "cd/m2", reflectance=0.8), "400")
    >>> bool(verdict), verdict.diagnoses[0].done
    (False, 'pi was forgotten')
    """

    __slots__ = ()

    def __bool__(self) -> bool:
        """Return whether the answer is right."""
        return self.right

    def __repr__(self) -> str:
        """Return the judgement and the likely mistakes as text."""
        row = Row(self.name, "", self.value, self.unit)
        return words_of(Judgement(self, row, (), (), ()), Style()).rstrip()


@in_python
def check(result: Result, claim: Scalar, tolerance: Scalar | None = None) -> Verdict:
    """Check an answer against a result, and name the mistakes that lead to it.

    Parameters
    ----------
    result : Result
        The result of a calculator, or of `explain` for a conversion.
    claim : str, Quantity or float
        The answer: ``"16 lx"``, ``"illuminance=16 lx"`` for a certain result, or a bare number
        if it is unambiguous.  A name may have hyphens or underscores.
    tolerance : str, Quantity or float, optional
        ``"1%"`` (the default), ``"0.5 lx"``, or ``"3sf"`` (3 significant digits); a bare number
        is a fraction of the right value.

    Returns
    -------
    Verdict
        True or false (also `right`), with the right `value` in its `unit`, the `ratio` of the
        answer to it, and the `diagnoses`: each has a `mistake` that reproduces the number, what
        was `done`, the `right` rule, and in `yours` the first wrong step in your numbers.

    Raises
    ------
    radcalc.RadcalcError
        If the answer is invalid or ambiguous, or the result has arrays.

    Examples
    --------
    >>> import radcalc
    >>> cone = radcalc.solid_angle("cone", half_angle="30 deg")
    >>> check(cone, "0.842 sr")
    right (within 1%): solid-angle is 0.841787214477 sr
    """
    from radcalc.homework import check as judge

    if not isinstance(result, Result):
        problem = f"{article(type(result).__name__)} is not a result to check"
        raise ConditionError(problem, "radcalc.explain, or a calculator's function")
    allowed = None if tolerance is None else as_text(tolerance)
    question = question_of(result)
    judgement = judge(question, _as_named(as_text(claim), question.answer.values), allowed)
    return Verdict(*judgement._replace(diagnoses=tuple(map(_in_python, judgement.diagnoses))))


def _as_named(claim: str, values: Sequence[Value]) -> str:
    name, equals, claimed = claim.partition("=")
    names = {keyword(known): known for value in values for known in (value.name, value.also)}
    return f"{names.get(keyword(name.strip()), name)}{equals}{claimed}" if equals else claim


def _in_python(diagnosis: Any) -> Any:
    return diagnosis._replace(done=in_words(diagnosis.done), right=in_words(diagnosis.right))

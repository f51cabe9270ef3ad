"""Sentences in Python."""

from __future__ import annotations

from radcalc.api.arguments import Quantity, require_texts
from radcalc.api.refusals import call_function, in_python
from radcalc.api.result import Result
from radcalc.errors import UsageError, input_of
from radcalc.sentences.calls import call_of
from radcalc.sentences.reader import read
from radcalc.units.reading import read_operands


@in_python
def ask(sentence: str) -> Result | Quantity:
    """Answer a sentence, such as ``"20000 cd at 8 m to lx"``.

    Parameters
    ----------
    sentence : str
        Amounts, their places and a target, as at a shell (radcalc-sentences(7)).

    Returns
    -------
    Result or Quantity
        The result that the sentence asks for; without a target, all results.

    Raises
    ------
    radcalc.RadcalcError
        If words are not understood, if the sentence has several readings, or as in the function
        that it means.

    Examples
    --------
    >>> print(ask("20000 cd at 8 m to lx"))
    312.5 lux
    """
    require_texts(sentence=sentence)
    found = read([sentence])
    command, *words = call_of(found)
    if command == "convert":
        operands = [text for name, text in map(input_of, words) if not name]
        amount, target = read_operands(operands)
        unit = amount.unit.text if amount.unit else "1"
        words = [amount.text, target or unit, *words[len(operands) :]]
    try:
        answer: Result | Quantity = call_function((command, *words), in_core=False)
    except (LookupError, TypeError) as error:  # no function, or one that needs more
        problem = str(error) or f"{command} is not a function of Python"
        raise UsageError(problem, "the same sentence at a shell") from None
    return answer

"""Checks of a learner's answer: right or wrong, and the likeliest mistake.

A `Question` holds the right answer and its derivation; `check` judges an answer to it.
"""

from radcalc.homework.answer import Diagnosis
from radcalc.homework.question import Question
from radcalc.homework.verdict import Verdict, check

__all__ = ["Diagnosis", "Question", "Verdict", "check"]

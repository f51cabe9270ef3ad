"""Checks of a learner's answer: right or wrong, and the likeliest mistake."""

from radcalc.homework.answer import Diagnosis
from radcalc.homework.question import Question
from radcalc.homework.verdict import Verdict, check

__all__ = ["Diagnosis", "Question", "Verdict", "check"]

"""Checks of a learner's answer: right or wrong, and the likeliest mistake."""

from radcalc.homework.question import Diagnosis, Question
from radcalc.homework.verdict import Verdict, check

__all__ = ["Diagnosis", "Question", "Verdict", "check"]

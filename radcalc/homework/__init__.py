"""Checking an answer: whether it is right, and if not, what most likely went wrong.

It needs no command line: a `Question` holds the right answer and how it was worked out, and
`check` judges what somebody answered to it.
"""

from radcalc.homework.answer import Diagnosis
from radcalc.homework.question import Question
from radcalc.homework.verdict import Verdict, check

__all__ = ["Diagnosis", "Question", "Verdict", "check"]

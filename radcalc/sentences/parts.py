"""The parts of a call that the phrases of a sentence become."""

from collections.abc import Iterator, Sequence

from radcalc.errors import input_of
from radcalc.sentences.frames import one_word
from radcalc.sentences.reader import Fact, Sentence


def parts_of(sentence: Sentence, call: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield each phrase with the part of the call that it becomes: operands or NAME=VALUE."""
    words = list(call[1:])
    for fact in sentence.facts:
        part = _part(fact, words)
        if input_of(part)[0]:
            words.remove(part)
        yield fact.typed, part
    for path in sentence.files:
        yield path, next(word for word in words if path in word)
    results = [word for word in words if input_of(word)[0] == "get"]
    operands = [word for word in words if not input_of(word)[0]]
    for goal in sentence.goals:
        yield goal.text, (*results, *operands[::-1])[0]


def _part(fact: Fact, words: Sequence[str]) -> str:
    """Return what a fact becomes: its option, the operand with its text, or several operands."""
    texts = (fact.text, one_word(fact))
    for word in words:
        name, value = input_of(word)
        if name and value in texts and (value or name in fact.symbols):
            return word
    return next((word for word in words if fact.text in word), fact.text)

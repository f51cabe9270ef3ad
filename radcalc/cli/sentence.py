"""Words that begin with a value: `100 lx fc` is `convert 100 lx fc`."""

from radcalc.errors import MINUS

VALUE = "0123456789.(±+" + MINUS


def is_sentence(words: list[str]) -> bool:
    """Whether the words begin with a number or a bracket, and not with a command or an option."""
    first = words[0] if words else ""
    if first[:1] == "-":
        return first[1:2].isdigit() or first[1:2] in (".", "(")
    return first[:1] in VALUE and bool(first)

"""Types of the public names; `python -m radcalc.api.stub` writes them to `radcalc/__init__.pyi`."""

import inspect
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import radcalc
from radcalc.api import MODULES, keywords

PATH = Path(radcalc.__file__).with_suffix(".pyi")
HEAD = '"""The public names; written by `python -m radcalc.api.stub`, do not edit."""\n'
STANDARD = {"collections.abc": ("Iterable", "Mapping", "Sequence"), "typing": ("Any", "Literal")}


def text() -> str:
    """Return the stub: imports, public names and signatures, as the formatter lays them out."""
    public = {name: getattr(radcalc, name) for name in radcalc.__all__}
    functions = {name: value for name, value in public.items() if inspect.isfunction(value)}
    signatures = "".join(map(_signature, functions.values()))
    words = {*re.findall(r"\w+", signatures)}
    standard = {module: words.intersection(names) for module, names in STANDARD.items()}
    types = words & vars(keywords).keys() - public.keys()
    own_names = {
        "radcalc._version": ("__version__",),
        "radcalc.api.keywords": types.difference(*standard.values()),
        **{module: {*names} - functions.keys() for module, names in MODULES.items()},
    }
    parts = [
        HEAD,
        _imports(standard),
        _imports(own_names),
        _lines("__all__ = [", "]", map(repr, public)),
    ]
    return "\n".join([*parts, signatures])


def _imports(names: Mapping[str, Iterable[str]]) -> str:
    return "".join(
        _lines(f"from {module} import (", ")", sorted(names[module]))
        for module in sorted(names)
        if names[module]
    )


def _signature(function: Any) -> str:
    lines: list[str] = []
    signature = inspect.signature(function)
    for parameter in signature.parameters.values():
        stars = "*" * (parameter.kind == parameter.VAR_POSITIONAL)
        if parameter.kind == parameter.KEYWORD_ONLY and not any(line[0] == "*" for line in lines):
            lines.append("*")
        default = "" if parameter.default is parameter.empty else f" = {parameter.default!r}"
        lines.append(f"{stars}{parameter.name}: {parameter.annotation}{default}")
    return _lines(f"def {function.__name__}(", f") -> {signature.return_annotation}: ...", lines)


def _lines(head: str, tail: str, entries: Iterable[str]) -> str:
    listed = "".join(f"    {entry},\n" for entry in entries)
    return f"{head}\n{listed}{tail}\n".replace("'", '"')


if __name__ == "__main__":
    PATH.write_text(text(), encoding="utf-8")

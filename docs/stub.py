"""The public names as texts, which `python docs/stub.py` writes.

Their types are in `radcalc/__init__.pyi`, and the list of functions in the docstring of `radcalc`.
"""

import inspect
import re
import textwrap
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, get_overloads

import radcalc
from radcalc.api import MODULES, columns
from radcalc.api.arguments import keyword
from radcalc.calculators import SUMMARIES

PACKAGE = Path(radcalc.__file__)
PATH = PACKAGE.with_suffix(".pyi")
LISTS = re.compile(r"(?<=^Functions\n---------\n)(?:.*\n)*?(?=\"\"\"\n)", re.MULTILINE)
CONVERT = "convert"
WIDTH = 76  # of the docstring, which help() indents
HEAD = '"""The public names; written by `python docs/stub.py`, do not edit."""\n'
STANDARD = {
    "collections.abc": ("Iterable", "Mapping", "Sequence"),
    "typing": ("Any", "Literal", "overload"),
}


def text() -> str:
    """Return the stub: imports, public names and signatures, as the formatter lays them out."""
    public = {name: getattr(radcalc, name) for name in radcalc.__all__}
    functions = {name: value for name, value in public.items() if inspect.isfunction(value)}
    signatures = "".join(map(_signature, functions.values()))
    words = {*re.findall(r"\w+", signatures)}
    standard = {module: words.intersection(names) for module, names in STANDARD.items()}
    types = words & vars(columns).keys() - public.keys()
    own_names = {
        "radcalc._version": ("__version__",),
        "radcalc.api.columns": types.difference(*standard.values()),
        **{module: {*names} - functions.keys() for module, names in MODULES.items()},
    }
    parts = [
        HEAD,
        _imports(standard),
        _imports(own_names),
        _lines("__all__ = [", "]", map(repr, public)),
    ]
    return "\n".join([*parts, signatures])


def with_lists(module: str) -> str:
    """Return the text of a module with the present lists of functions in its docstring."""
    functions = [name for name in radcalc.__all__ if inspect.isfunction(getattr(radcalc, name))]
    calculators = [name for name in map(keyword, SUMMARIES) if name != CONVERT]
    others = [CONVERT, *(name for name in functions if name not in (CONVERT, *calculators))]
    parts = [_summaries(names) for names in (others, calculators)]
    return LISTS.sub(lambda _: "\n".join(parts), module, count=1)


def _summaries(names: Iterable[str]) -> str:
    """Return the first lines of docstrings, each after the name of its function."""
    firsts = {name: (inspect.getdoc(getattr(radcalc, name)) or "").split("\n")[0] for name in names}
    return "".join(
        textwrap.fill(f"{name:14} {first}", WIDTH, subsequent_indent=" " * 15) + "\n"
        for name, first in firsts.items()
    )


def _imports(names: Mapping[str, Iterable[str]]) -> str:
    return "".join(
        _lines(f"from {module} import (", ")", sorted(names[module]))
        for module in sorted(names)
        if names[module]
    )


def _signature(function: Any) -> str:
    """Return a function with its types, or each of its overloads."""
    signature = inspect.signature(function)
    overloads = get_overloads(inspect.unwrap(function))
    changed = [inspect.signature(overload) for overload in overloads]
    texts = [_definition(function.__name__, _changed(signature, one)) for one in changed]
    return "".join(f"@overload\n{text}" for text in texts) or _definition(
        function.__name__, signature
    )


def _changed(signature: inspect.Signature, overload: inspect.Signature) -> inspect.Signature:
    """Return a signature with the parameters and the result of an overload."""
    parameters = [
        overload.parameters.get(name, parameter) for name, parameter in signature.parameters.items()
    ]
    return signature.replace(parameters=parameters, return_annotation=overload.return_annotation)


def _definition(name: str, signature: inspect.Signature) -> str:
    lines: list[str] = []
    for parameter in signature.parameters.values():
        stars = "*" * (parameter.kind == parameter.VAR_POSITIONAL)
        if parameter.kind == parameter.KEYWORD_ONLY and not any(line[0] == "*" for line in lines):
            lines.append("*")
        default = "" if parameter.default is parameter.empty else f" = {parameter.default!r}"
        lines.append(f"{stars}{parameter.name}: {parameter.annotation}{default}")
    return _lines(f"def {name}(", f") -> {signature.return_annotation}: ...", lines)


def _lines(head: str, tail: str, entries: Iterable[str]) -> str:
    listed = "".join(f"    {entry},\n" for entry in entries)
    return f"{head}\n{listed}{tail}\n".replace("'", '"')


if __name__ == "__main__":
    PATH.write_text(text(), encoding="utf-8")
    PACKAGE.write_text(with_lists(PACKAGE.read_text(encoding="utf-8")), encoding="utf-8")

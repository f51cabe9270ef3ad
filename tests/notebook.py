"""The outputs of `docs/radcalc.ipynb`, which `python tests/notebook.py` brings up to date.

Cells run one after the other in one namespace, as in Jupyter, which they do not need.
"""

import ast
import io
import json
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

PATH = Path(__file__).parent.parent / "docs" / "radcalc.ipynb"
RAISES = "raises-exception"  # Jupyter's tag for a cell whose error is wanted


def text() -> str:
    """Return the text of the notebook with the outputs of a new run."""
    notebook = json.loads(PATH.read_text(encoding="utf-8"))
    names: dict[str, Any] = {"__name__": "__main__"}
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            cell |= {"execution_count": None, "outputs": _outputs(cell, names)}
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"


def _outputs(cell: dict[str, Any], names: dict[str, Any]) -> list[dict[str, Any]]:
    """Run a cell, and return what it prints, then its last expression or its error."""
    statements = ast.parse("".join(cell["source"])).body
    last = statements.pop() if isinstance(statements[-1], ast.Expr) else None
    printed, shown = io.TextIOWrapper(io.BytesIO(), encoding="utf-8"), []
    try:
        with redirect_stdout(printed):
            exec(compile(ast.Module(statements, []), "<cell>", "exec"), names)
            if last:
                value = eval(compile(ast.Expression(last.value), "<cell>", "eval"), names)
                shown = [] if value is None else [_result(value)]
    except Exception as error:
        if RAISES not in cell["metadata"].get("tags", []):
            raise
        raised = f"{type(error).__module__}.{type(error).__name__}"
        texts = {"ename": raised, "evalue": str(error), "traceback": [f"{raised}: {error}"]}
        shown = [{"output_type": "error", **texts}]
    printed.seek(0)
    lines = printed.readlines()
    if lines:
        shown.insert(0, {"output_type": "stream", "name": "stdout", "text": lines})
    return shown


def _result(value: Any) -> dict[str, Any]:
    """Return how Jupyter shows a value: HTML alone if it has it, as the text differs by Pint."""
    if hasattr(value, "_repr_html_"):
        data = {"text/html": _lines(value._repr_html_())}
    else:
        data = {"text/plain": _lines(repr(value))}
    return {
        "output_type": "execute_result", "execution_count": None, "metadata": {}, "data": data
    }  # fmt: skip


def _lines(text: str) -> list[str]:
    return text.splitlines(keepends=True)


if __name__ == "__main__":
    PATH.write_text(text(), encoding="utf-8")

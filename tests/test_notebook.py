"""The notebook of the documentation: a new run has its outputs, and it names no machine."""

import json
import re

from conftest import ROOT, python
from notebook import PATH

CELLS = json.loads(PATH.read_text(encoding="utf-8"))["cells"]


def test_the_outputs_are_those_of_a_new_run():
    """Run `python tests/notebook.py` if they are outdated."""
    code = "import sys; sys.path.insert(0, sys.argv[1]); import notebook; print(notebook.text())"
    done = python(code, str(ROOT / "tests"))
    assert done.stdout.rstrip("\n") + "\n" == PATH.read_text(encoding="utf-8"), done.stderr


def test_it_shows_a_result_of_each_kind():
    kinds = [output["output_type"] for cell in CELLS for output in cell.get("outputs", ())]
    assert {*kinds} == {"stream", "execute_result", "error"}
    assert kinds.count("error") == 1
    assert kinds.count("execute_result") > 5
    assert len({cell["id"] for cell in CELLS}) == len(CELLS)


def test_it_has_no_paths_and_no_addresses_of_objects():
    text = PATH.read_text(encoding="utf-8")
    assert not re.search(r"/home/|/tmp/|/usr/|site-packages| at 0x", text)

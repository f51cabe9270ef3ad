"""The pictures of the README show the outputs of its commands."""

import os
import re
import runpy
from pathlib import Path
from xml.etree import ElementTree

import pytest
from conftest import ROOT, entry_point

SVG = "{http://www.w3.org/2000/svg}"
PICTURES = runpy.run_path(str(ROOT / "docs" / "pictures.py"))


def shown(path):
    """Return the lines of a picture of a terminal, without blank ones, which depend on rich."""
    lines = {}
    for text in ElementTree.parse(path).iter(f"{SVG}text"):
        y = float(text.get("y", "nan"))
        lines[y] = lines.get(y, "") + (text.text or "")
    plain = [line.replace("\xa0", " ").strip() for _, line in sorted(lines.items())]
    return [line for line in plain if line]


@pytest.fixture
def _own_radcalc(monkeypatch):
    folder = str(Path(entry_point()).parent)
    monkeypatch.setenv("PATH", folder + os.pathsep + os.environ["PATH"])


@pytest.mark.usefixtures("_own_radcalc")
def test_the_session_shows_the_outputs_of_the_commands(tmp_path):
    PICTURES["session"](tmp_path / "session.svg")
    assert shown(ROOT / "docs" / "session.svg") == shown(tmp_path / "session.svg")
    assert "$ radcalc 800 lm cd" in shown(tmp_path / "session.svg")


@pytest.mark.usefixtures("_own_radcalc")
def test_the_picture_of_the_downlight_is_up_to_date(tmp_path):
    """Compare the texts, which are in comments: the digits depend on Matplotlib's version."""
    PICTURES["main"](tmp_path)
    drawn, kept = (
        re.findall("<!-- (.*) -->", (folder / "downlight.svg").read_text(encoding="utf-8"))
        for folder in (tmp_path, ROOT / "docs")
    )
    assert drawn == kept
    assert {"oval downlight", "C0-C180", "C90-C270", "400"} <= set(kept)

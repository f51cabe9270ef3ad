"""The README and the pages of docs/: length, links, blocks that tests run, pictures of commands."""

import os
import re
import runpy
from pathlib import Path
from xml.etree import ElementTree

import pytest
from conftest import DOCS, ROOT, entry_point

SVG = "{http://www.w3.org/2000/svg}"
PICTURES = runpy.run_path(str(ROOT / "docs" / "pictures.py"))
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
LINK = re.compile(r"\]\(([^()\s]+)\)")
RUN_ELSEWHERE = {
    "README.md": ["sh", "sh", "sh"],  # the set-up and the tests: .ci/run; the last is for others
    "prompt.md": ["text"],  # cli/test_session.py
    "python.md": ["python", "python", "python", "sh"],  # test_engines.py
}


def read(path):
    return path.read_text(encoding="utf-8")


def anchors(path):
    """Return the anchors that GitHub gives to the headings of a page."""
    headings = re.findall(r"^#+ (.*)$", BLOCK.sub("", read(path)), re.M)
    return {re.sub(r"[^\w -]", "", text).lower().replace(" ", "-") for text in headings}


def links(path):
    """Return the files and anchors that a page links to."""
    found = LINK.findall(BLOCK.sub("", read(path)))
    inside = [link for link in found if not link.startswith("https://")]
    return [link.partition("#")[::2] for link in inside]


def test_the_readme_is_short():
    assert len(read(ROOT / "README.md").splitlines()) <= 220


@pytest.mark.parametrize("page", sorted({*ROOT.glob("*.md"), *DOCS}), ids=lambda page: page.name)
def test_the_links_lead_somewhere(page):
    for name, anchor in links(page):
        target = page.parent / name if name else page
        assert target.exists(), name
        assert not anchor or anchor in anchors(target), f"{name}#{anchor}"


def test_the_readme_links_every_page():
    linked = {(ROOT / name).resolve() for name, _ in links(ROOT / "README.md")}
    assert linked >= {path.resolve() for path in DOCS[1:]}


@pytest.mark.parametrize("page", DOCS, ids=lambda page: page.name)
def test_every_block_is_run(page):
    """Transcripts run in test_cases.py, sessions of Python in test_api.py."""
    others = [
        kind for kind, text in BLOCK.findall(read(page)) if kind != "console" and ">>> " not in text
    ]
    assert others == RUN_ELSEWHERE.get(page.name, [])


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
@pytest.mark.parametrize("name", PICTURES["SESSIONS"])
def test_a_session_shows_the_outputs_of_its_commands(tmp_path, name):
    PICTURES["session"](name, tmp_path / "drawn.svg")
    assert shown(ROOT / "docs" / f"{name}.svg") == shown(tmp_path / "drawn.svg")
    first = PICTURES["SESSIONS"][name][0].partition("\n")[0]
    assert f"$ {first}" in shown(tmp_path / "drawn.svg")


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

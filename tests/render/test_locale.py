"""Only names in tables follow the locale."""

import pytest
from conftest import run

from radcalc.cli.output import decide


def test_only_tables_follow_the_locale(monkeypatch):
    monkeypatch.setenv("LC_ALL", "cs_CZ.UTF-8")
    spoken = [decide(f, False, False, None, "auto", False).style.language
              for f in ("table", "plain", "json", "csv")]  # fmt: skip
    assert spoken == ["cs", "en", "en", "en"]


TABLES = {
    ("convert", "100", "lx", "fc"): ("illuminance", "osvětlenost", "освещённость"),
    ("convert", "250", "cd/m2"): ("luminance", "jas", "яркость"),
    ("point-source", "--flux", "800lm", "--distance", "2m"): (
        "luminous intensity", "svítivost", "сила света",
    ),
    ("solid-angle", "cone", "--half-angle", "30deg"): (
        "solid angle", "prostorový úhel", "телесный угол",
    ),
    ("photon", "555nm"): ("wavelength", "vlnová délka", "длина волны"),
    ("units", "lambert"): ("luminance", "jas", "яркость"),
    ("typical", "candle", "away"): ("illuminance", "osvětlenost", "освещённость"),
}  # fmt: skip
LOCALES = {"C": 0, "en_GB.UTF-8": 0, "cs_CZ.UTF-8": 1, "ru_RU.UTF-8": 2}


@pytest.mark.parametrize("words", TABLES, ids=" ".join)
def test_only_names_in_tables_follow_the_locale(words, monkeypatch):
    english = {}
    for locale, place in LOCALES.items():
        monkeypatch.setenv("LC_ALL", locale)
        table = run(*words, "--format", "table")
        assert table.returncode == 0
        rows = table.stdout.split("assumed:")[0]
        assert TABLES[words][place] in rows
        assert all(name not in rows for name in TABLES[words] if name != TABLES[words][place])
        for form in ("plain", "json", "csv"):
            answer = run(*words, "--format", form)
            assert english.setdefault(form, answer.stdout) == answer.stdout
        if place == 0:
            assert english.setdefault("table", table.stdout) == table.stdout

"""Verdicts in the language of the locale, and the learner's own step."""

import ast
import string
from gettext import translation

import polib
import pytest
from conftest import ROOT, run
from homework.corpus import CORPUS
from homework.families import FAMILIES, ROUNDED
from homework.heldout import BLIND, HELD_OUT, THIRD
from homework.questions import CONE, POINT, claim_of, verdict

from radcalc.homework.wording import CATALOGUES, DOMAIN, USUAL, Translatable, in_language
from radcalc.quantities.language import ENGLISH, LANGUAGES

FORMULA = set("=^/")  # characters of a rule that may be a formula without words
ALL = (*CORPUS, *HELD_OUT, *BLIND, *THIRD, *FAMILIES, *ROUNDED)
OTHERS = [language for language in LANGUAGES if language != ENGLISH]
SOURCES = {
    language: polib.pofile(f"{CATALOGUES}/{language}/LC_MESSAGES/{DOMAIN}.po")
    for language in OTHERS
}
TRANSLATED = {entry.msgid for entry in SOURCES["cs"]}


def fields(template: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(template) if name is not None}


@pytest.mark.parametrize("language", OTHERS)
def test_catalogues_are_compiled(language):
    """An editable install compiles them; install it again after a change of a catalogue."""
    compiled = translation(DOMAIN, CATALOGUES, [language])
    for entry in SOURCES[language]:
        if entry.msgid_plural:
            found = {compiled.ngettext(entry.msgid, entry.msgid_plural, n) for n in range(100)}
            assert found == set(entry.msgstr_plural.values())
        else:
            assert compiled.gettext(entry.msgid) == entry.msgstr


@pytest.mark.parametrize("language", OTHERS)
def test_every_translation_has_known_fields(language):
    for entry in SOURCES[language]:
        for translated in entry.msgstr_plural.values() if entry.msgid_plural else [entry.msgstr]:
            assert translated, entry.msgid
            assert fields(translated) <= fields(entry.msgid), entry.msgid
        assert not entry.msgid_plural or fields(entry.msgid_plural) == fields(entry.msgid)


def test_catalogues_have_the_same_sentences_each_once():
    for source in SOURCES.values():
        assert not source.fuzzy_entries()
        assert not source.obsolete_entries()
        assert len(source) == len(TRANSLATED)
        assert {entry.msgid for entry in source} == TRANSLATED


def test_every_translated_sentence_is_in_the_code():
    files = [*(ROOT / "radcalc" / "homework").glob("*.py"), ROOT / "radcalc/render/plain.py"]
    nodes = [node for file in files for node in ast.walk(ast.parse(file.read_text("utf-8")))]
    texts = {node.value for node in nodes if isinstance(node, ast.Constant)}
    assert texts >= TRANSLATED


@pytest.mark.parametrize(
    ("language", "forms"),
    [  # https://doc.qt.io/qt-6.4/i18n-plural-rules.html, numbers below 100
        ("cs", {0: 2, 1: 0, 2: 1, 4: 1, 5: 2, 11: 2, 12: 2, 21: 2, 22: 2}),
        ("ru", {0: 2, 1: 0, 2: 1, 4: 1, 5: 2, 11: 2, 12: 2, 14: 2, 21: 0, 22: 1, 25: 2, 91: 0}),
    ],
)
def test_a_number_has_the_form_of_its_word(language, forms):
    template, plural = "to {0} digit", "to {0} digits"
    written = SOURCES[language].find(template).msgstr_plural
    for number, form in forms.items():
        sentence = Translatable(template, number, plural=plural)
        assert in_language(sentence, language) == written[form].format(number)


def test_the_sentences_of_the_usual_mistakes_are_translated():
    for name, (_, done, right) in USUAL.items():
        assert not done or done in TRANSLATED, name
        words = [word for word in right.split() if word.isalpha() and len(word) > 5]
        assert not words or right in TRANSLATED or FORMULA & set(right), (name, right)


def templates(text: str) -> set[str]:
    """Return the templates in a sentence, with those of its fields."""
    if not isinstance(text, Translatable):
        return set()
    return {text.template}.union(*(templates(f) for f in text.fields if isinstance(f, str)))


def test_every_template_that_is_used_is_translated():
    used = set()
    for k, wrong in enumerate(ALL):
        claim = claim_of(wrong.name, wrong.number, 3 + k % 2, wrong.unit)
        for diagnosis in verdict(wrong.question, claim).diagnoses:
            used |= templates(diagnosis.done) | templates(diagnosis.right)
    assert len(used) > 20
    assert used <= {*TRANSLATED, "{0}; {1}", "{0}, {1}"}


@pytest.mark.parametrize(
    ("language", "words"), [("cs", "chybí druhá mocnina"), ("ru", "не возведено в квадрат")]
)
def test_a_mistake_is_said_in_another_language(language, words):
    done = verdict(POINT, "illuminance=56.5lx").diagnoses[0].done
    assert done == "the distance was not squared"
    assert in_language(done, language).startswith(words)
    assert in_language(done, "en") == done


@pytest.mark.parametrize(
    ("language", "verdict"),
    [  # 500 lx on 54 m2 of 3600 lm and 0.6: 12.5
        ("en", "right (to the 2 digits given): luminaires is 12.5"),
        ("cs", "správně (na 2 uvedené číslice): počet svítidel je 12.5"),
        ("ru", "верно (до 2 указанных цифр): число светильников = 12.5"),
    ],
)
def test_numbers_of_digits_and_results_are_in_the_language(monkeypatch, language, verdict):
    monkeypatch.setenv("LC_ALL", language)
    room = "room --width 6m --length 9m --illuminance 500lx --flux 3600lm --utilance 0.6"
    words = f"{room} --check luminaires=13 -q --format table"
    assert run(*words.split()).stdout.startswith(verdict)


def test_a_formula_is_not_translated():
    assert in_language("E = (130 cd) (1) sr / 2.3 m = 56.5 lx", "ru").startswith("E = (130 cd)")


@pytest.mark.parametrize(
    ("language", "begins"),
    [("cs_CZ.UTF-8", "špatně"), ("ru_RU.UTF-8", "неверно"), ("de_DE.UTF-8", "wrong")],
)
def test_a_table_is_in_the_language_of_the_locale(monkeypatch, language, begins):
    monkeypatch.setenv("LC_ALL", language)
    words = [*POINT.split(), "--check", "illuminance=56.5lx", "-q", "--format"]
    assert run(*words, "table").stdout.startswith(begins)
    assert run(*words, "plain").stdout.startswith("wrong (within 1%): illuminance is 24.57")


STEPS = [
    # 2 pi (1 - cos 12.5 deg) sr = 0.148937 sr
    (CONE, "solid-angle=0.1489sr", "Omega = 4 pi sr sin^2(12.5 deg/2) = 0.148937 sr"),
    # 130 / 2.3 lx = 56.5217 lx
    (POINT, "illuminance=56.5lx", "E = (130 cd) 1 Omega0 / (2.3 m) = 56.5217 lx"),
    ("convert 130 cd lx --distance 2.3m", "56.5lx", "E = (130 cd) sr / 2.3 m = 56.5217 lx"),
    # 0.8 * 500 cd/m2 = 400 cd/m2
    ("convert 500 lx cd/m2 --reflectance 0.8", "400", "L = (0.8) (500 lx) / sr = 400 cd/m2"),
    # 5.670374e-8 * 300^3 W/m2 = 1.531 W/m2
    ("convert 300 K W/m2", "1.531", "M = 1 sigma (300 K)^3 = 1.531 W/m2"),
]


@pytest.mark.parametrize(("words", "claim", "step"), STEPS)
def test_the_wrong_step_is_in_the_learners_numbers(words, claim, step):
    assert verdict(words, claim).diagnoses[0].yours == step


def test_the_wrong_step_stands_where_the_ways_part():
    found = run(*CONE.split(), "--check", "solid-angle=0.1489sr", "--steps", "-q")
    lines = (found.stdout + found.stderr).splitlines()
    names = [line.partition(":")[0] for line in lines if not line.startswith(" ")]
    right = names.index("solid angle of a cone")
    assert names[right : right + 3] == [
        "solid angle of a cone",
        "likely mistake",
        "projected solid angle of a cone",
    ]


@pytest.mark.parametrize("claim", ["0.7OD", "0.699OD", "0.7"])
def test_a_reading_on_the_scale_of_the_conversion_is_right(claim):
    assert verdict("convert 20 % OD", claim).right  # -lg 0.2 = 0.69897

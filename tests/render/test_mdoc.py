"""Pages of the manual as text: words as mandoc sets them, and the layout."""

import re

import pytest
from cli.test_manual import SOURCES, rendered
from helpers import for_each

from radcalc.render.mdoc import MARKED, typeset

WIDTHS = 30, 80, 500
IN_ASCII = str.maketrans("‘’“”–•", "''\"\"-*")  # of what macros add


@for_each(SOURCES)
def test_a_page_has_the_words_that_mandoc_sets(name):
    body = "\n".join(rendered(name).splitlines()[1:-1]).translate(IN_ASCII)  # no head, no foot
    assert body.startswith("\nNAME\n") or body.startswith("NAME\n")
    for width in WIDTHS:
        assert typeset(SOURCES[name], width).split() == body.split()


@for_each(SOURCES)
def test_text_is_folded(name):
    """Displays are not, and a word is not broken."""
    text = re.sub(r"^\.Bd.*?^\.Ed\n|^\.Dl .*\n", "", SOURCES[name], flags=re.M | re.S)
    for line in typeset(text, 60).splitlines():
        assert len(line) <= 60 or len(line.split()) == 1


@for_each(SOURCES)
def test_colour_changes_no_character(name):
    assert MARKED.sub("", typeset(SOURCES[name], 80, True)) == typeset(SOURCES[name], 80)


PAGE = r"""
.\" a comment
.Dd January 1, 2026
.Dt RADCALC-LAMP 1
.Sh NAME
.Nm radcalc-lamp
.Nd a lamp
.Sh SYNOPSIS
.Nm radcalc
.Cm lamp
.Op Fl q
.Op Ar file
.Sh LIST
Text
.Pq Fl a , b ,
with
.Fl g Ar NAME Ns Oo : Ns Ar UNIT Oc .
.Bl -tag -width Ds
.It Fl a
Short.
.It Fl -longer
A text that is folded.
.El
.Bl -enum -compact
.It
One.
.It
Two.
.El
.Bd -literal -offset 2n
$ radcalc \(aqa  b\(aq
.Ed
.Ss More
.Ar
"""
# as mandoc 1.14.6 sets it, but for the quotes, the dash and the indents of Ss and lists
TEXT = """
NAME
     radcalc-lamp - a lamp

SYNOPSIS
     radcalc lamp [-q] [file]

LIST
     Text (-a, -b), with -g
     NAME[:UNIT].

     -a      Short.

     --longer
             A text that is
             folded.
     1. One.
     2. Two.

       $ radcalc 'a  b'

  More
     file ...
"""


def test_the_layout():
    assert typeset(PAGE.strip(), 30) == TEXT.strip()


def test_flags_are_bold_and_arguments_underlined():
    assert typeset(".Fl a Ar x ,", 80, True) == "     \033[1m-a\033[0m \033[4mx\033[0m,"


def test_a_macro_that_is_not_known_is_an_error():
    with pytest.raises(KeyError):
        typeset(".Zz text", 80)
    with pytest.raises(KeyError):
        typeset(r"a \(zz", 80)

import os

from conftest import process


def test_a_pipe_gets_plain_text():
    done = process("convert", "800", "lm", "cd", "--isotropic")
    assert done.stdout == "63.6619772368\tcd\n"
    assert done.stderr == "assumed: uniform over 4 pi sr (isotropic)\n"


def test_an_answer_that_the_encoding_lacks_is_refused():
    done = process(
        "convert", "100", "лк", "lx", "--format", "table",
        env=os.environ | {"PYTHONIOENCODING": "ascii"},
    )  # fmt: skip
    assert done.returncode == 0
    assert "100" in done.stdout
    done = process("convert", "1", "lx", "лк", env=os.environ | {"PYTHONIOENCODING": "ascii"})
    assert (done.returncode, done.stdout) == (2, "")
    assert "the encoding ascii lacks" in done.stderr

import os

from conftest import process, run


def test_the_command_exits_2_if_nothing_is_found():
    done = run("quantities", "luminanse")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.splitlines()[1] == "try: radcalc quantities luminance"
    done = run("quantities", "-n")
    assert done.returncode == 2
    assert "-n does not apply to quantities" in done.stderr


def test_the_command_puts_the_names_of_one_language_first():
    env = os.environ | {"LC_ALL": "cs_CZ.UTF-8", "PYTHONIOENCODING": "utf-8"}
    assert process("quantities", "lx", env=env).stdout.startswith("osvětlenost\tE_v\tlx\t")
    assert process("quantities", "lx", "--lang", "ru", env=env).stdout.startswith("освещённость\t")
    assert process("quantities", "lx", "--lang", "en", env=env).stdout.startswith("illuminance\t")
    done = run("quantities", "M_p", "--lang", "ru")
    assert done.stdout.startswith("photon exitance\t")

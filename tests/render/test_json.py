"""JSON is strict whatever a name has in it, and whatever the encoding of the output lacks."""

import json
import os

import pytest
from conftest import process, run

SPECTRUM = "nm,W/m2/nm\n400,1\n500,2\n700,1\n"


@pytest.mark.parametrize("name", [b"tab\there.csv", b"\x1b[31m\xff.csv", b"line\nend.csv"])
def test_the_name_of_a_file_is_read_back_as_it_is(tmp_path, name):
    path = os.fsdecode(os.fsencode(tmp_path) + b"/" + name)
    try:
        with open(path, "w", encoding="utf-8") as file:
            file.write(SPECTRUM)
    except OSError:
        pytest.skip("the file system takes no such name")
    out = run("spectrum", path, "--json").stdout
    assert out[:-1].isprintable()
    assert json.loads(out)["inputs"]["spectrum"]["text"] == path


@pytest.mark.parametrize("encoding", ["ascii", "latin-1"])
def test_what_an_encoding_lacks_is_escaped_as_json_has_it(encoding):
    words = ("quantities", "jas", "--json")
    told = json.loads(run(*words).stdout)
    env = os.environ | {"PYTHONIOENCODING": encoding}
    assert json.loads(process(*words, env=env, encoding=encoding).stdout) == told
    assert "яркость" in told["records"][0]["ru"]

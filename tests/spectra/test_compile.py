from radcalc.spectra.compile import HERE, compile_observers, compile_sources


def test_the_committed_tables_are_colour_sciences():
    for file, text in (
        ("observers.py", compile_observers()),
        ("sources.py", compile_sources()),
    ):
        assert (HERE / file).read_text(encoding="utf-8") == text

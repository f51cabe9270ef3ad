import pytest

from radcalc.geometry import numerics


@pytest.fixture
def _few_integrals(monkeypatch: pytest.MonkeyPatch) -> None:
    """Limit a test to 150 000 integrals by one rule; it needs 40 000 at most."""
    left = 150_000
    gauss = numerics.gauss

    def counted(n: int) -> numerics.Rule:
        nonlocal left
        left -= 1
        assert left >= 0, "an integral that is halved without end"
        return gauss(n)

    monkeypatch.setattr(numerics, "gauss", counted)

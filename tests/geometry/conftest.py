from collections.abc import Iterator

import pytest
from helpers import at_most


@pytest.fixture
def _few_calls() -> Iterator[None]:
    """A test calls three million functions at the most; ten million have lost their way."""
    with at_most(10_000_000):
        yield

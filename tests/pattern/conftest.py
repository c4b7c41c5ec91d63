import pytest

import bodymeasure as bm


@pytest.fixture(scope="session")
def bodice() -> bm.Pattern:
    """One pattern for all tests that only read it."""
    return bm.make_pattern(bm.load_sample("female_average"), "bodice")

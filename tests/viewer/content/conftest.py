"""Bodies as the page's answers know them."""

import pytest
from bodymeasure.viewer.content.bodies import Bodies
from bodymeasure.viewer.content.shown import ShownBody

from bodymeasure import load_sample


@pytest.fixture(scope="session")
def female() -> ShownBody:
    return ShownBody("0", load_sample("female_average"), "Average")


@pytest.fixture(scope="session")
def bodies(female: ShownBody) -> Bodies:
    found = Bodies()
    found.put(female)
    found.put(ShownBody("1", load_sample("male_average"), "Man"))
    found.put(ShownBody("2", load_sample("paraboloid"), "Bowl"))
    return found

"""One server for the tests that leave it as it is."""

from collections.abc import Iterator

import pytest
from helpers.viewer_server import Viewer, viewer


@pytest.fixture(scope="module")
def server() -> Iterator[Viewer]:
    with viewer("female_average") as found:
        yield found

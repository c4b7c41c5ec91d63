"""What is said where pygeodesic is missing, with wheels for the running Python and without."""

import sys

import numpy as np
import pytest

from bodymeasure.errors import MissingExtraError
from bodymeasure.mesh.arrays import TriangleMesh
from bodymeasure.mesh.exact import exact_path


@pytest.mark.parametrize(
    ("version", "remedy"),
    [
        ((3, 13, 1), r"not installed; install it with: pip install 'bodymeasure\[routes\]'$"),
        ((3, 14, 0), r"no wheels for Python 3\.14 and later: .*: pip install pygeodesic, or use"),
    ],
)
def test_the_remedy_helps_on_the_running_python(
    version: tuple[int, ...], remedy: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pygeodesic.geodesic", None)
    monkeypatch.setattr(sys, "version_info", version)
    with pytest.raises(MissingExtraError, match=remedy):
        exact_path(TriangleMesh(np.eye(3), np.array([[0, 1, 2]])), 0, 1)

import subprocess
import sys

import numpy as np
import pytest
from helpers.surfaces.surfaces import ENNEPER, PARABOLOID

from bodymeasure import (
    Atlas,
    RBFCollocation,
    boundary_lengths,
    check_atlas,
    diagonals,
    measure_atlas,
)

ATLAS = Atlas.from_control_points(np.stack([ENNEPER, PARABOLOID]), "mm")


def test_a_survey_holds_what_was_measured_and_how() -> None:
    method = RBFCollocation(functions=12)
    survey = measure_atlas(ATLAS, method=method, compare=False)
    assert survey.atlas is ATLAS
    np.testing.assert_array_equal(survey.diagonals.length, diagonals(ATLAS, method=method).length)
    assert (survey.diagonals.functions == 12).all()
    np.testing.assert_array_equal(survey.boundary.length, boundary_lengths(ATLAS).length)
    assert survey.findings == check_atlas(ATLAS)
    assert survey.cross_check is None
    assert "12" in survey.settings["method"]
    assert "cross-check" not in survey.settings
    assert {"Python", "bodymeasure", "numpy", "scipy"} <= set(survey.versions)
    assert set(survey.seconds) == {"check of the atlas", "diagonals", "boundary curves"}
    assert all(0.0 <= seconds < np.inf for seconds in survey.seconds.values())


def test_a_survey_with_comparison() -> None:
    pytest.importorskip("igl")
    seen: list[int] = []
    survey = measure_atlas(ATLAS, progress=seen.append)
    assert survey.cross_check is not None
    assert survey.cross_check.exact.shape == (2, 2)
    assert "libigl" in survey.settings["cross-check"]
    assert "libigl" in survey.versions
    assert "cross-check" in survey.seconds
    assert seen[-1] == 4


def test_without_comparison_libigl_is_not_loaded() -> None:
    program = (
        "import sys, bodymeasure as bm; "
        "s = bm.measure_atlas(bm.load_sample('enneper'), compare=False); "
        "assert s.cross_check is None; "
        "print(sorted({'igl', 'vtk', 'trimesh', 'matplotlib', 'jinja2'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True, timeout=120
    )
    assert done.stdout.strip() == "[]"

"""What the approximation of a mesh makes of lengths, and how it is shown."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from helpers.files.format_atlases import ONE_PATCH_A_QUAD, read
from helpers.surfaces.solids import CUBE, blob, obj_text

from bodymeasure import (
    Atlas,
    Chart,
    Definitions,
    Plane,
    approximation_error,
    geodesics_between,
    measure_atlas,
    measure_chart,
    plane_girth,
    taut_tape,
)
from bodymeasure._typing import Array
from bodymeasure.atlas.approximation import extent
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.chart.kinds import ChordMeasure, FormulaMeasure, PathMeasure
from bodymeasure.report import survey_document, to_csv
from bodymeasure.report.body import chart_document, chart_to_csv
from bodymeasure.subdivision import PolygonMesh, loop_schaefer, refined

ENDS = np.array([[0.2, 0.3, 0.8], [0.9, 0.5, 0.5], [0.3, 0.2, 0.2]])


def body() -> Atlas:
    """Six patches of a cube with landmarks."""
    atlas = read(obj_text(CUBE).encode(), "obj", ONE_PATCH_A_QUAD)
    points, _ = closest_points(atlas, ENDS)
    return replace(atlas, landmarks=dict(zip("abc", points, strict=True)), name="cube")


def measured(atlas: Atlas) -> Chart:
    ways = [
        PathMeasure(key="ab", name="a to b", through=("a", "b")),
        PathMeasure(key="taut", name="a to c", through=("a", "c"), tape="both"),
        ChordMeasure(key="chord", name="chord", start="a", end="b"),
        FormulaMeasure(key="sum", name="sum", formula="2 * ab - chord"),
        FormulaMeasure(key="angle", name="angle", formula="asin(chord / (2 * ab))", angle=True),
    ]
    return measure_chart(atlas, Definitions(name="few", measurement=tuple(ways)))


@cache
def chart() -> Chart:
    return measured(body())


def test_every_measurement_says_what_the_approximation_costs() -> None:
    approximation = chart().atlas.approximation
    assert approximation is not None
    path, chord = chart()["ab"], chart()["chord"]
    assert path.approximation_error == pytest.approx(approximation.stretch[0] * path.value, 1e-2)
    assert path.mesh_difference == approximation.mesh_lengths * path.value
    size = extent(chart().atlas.points)
    assert chord.approximation_error == pytest.approx(2.0 * size * approximation.distance[0])
    assert chord.mesh_difference == 2.0 * size * approximation.mesh_rms
    total, costs = chart()["sum"], (path.approximation_error, chord.approximation_error)
    assert total.approximation_error == pytest.approx(2.0 * (costs[0] or 0) + (costs[1] or 0))
    assert total.mesh_difference == pytest.approx(
        2.0 * (path.mesh_difference or 0.0) - chord.mesh_difference
    )
    assert "error" in repr(path)
    assert "approximation 0.0" in repr(path)
    assert all(item.approximation_error for item in chart().measured)


def test_a_chart_without_an_approximation_says_nothing_of_it() -> None:
    exact = measured(replace(chart().atlas, approximation=None))
    assert all(item.approximation_error is None for item in exact.measured)
    assert [item.value for item in exact.measured] == [item.value for item in chart().measured]
    document = chart_document(exact, "cm")
    assert b"approximation" not in chart_to_csv(document)
    assert not document.approximation


def test_records_hold_it() -> None:
    document = chart_document(chart(), "mm")
    path, angle = document.measurements[0], document.measurements[-1]
    assert path.approximation_error == pytest.approx(
        10.0 * (chart()["ab"].approximation_error or 0)
    )
    assert angle.approximation_error == chart()["angle"].approximation_error
    assert document.approximation
    assert "0.086 mm" in document.approximation[0]
    assert b",approximation_error,mesh_difference," in chart_to_csv(document)
    survey = survey_document(measure_atlas(chart().atlas, compare=False), "cm")
    assert b",approximation_error,mesh_difference," in to_csv(survey.measurements)
    approximation = chart().atlas.approximation
    assert approximation is not None
    for record in survey.measurements:
        assert record.length
        stretch = approximation.stretch[record.patch_number]
        assert record.approximation_error == pytest.approx(stretch * record.length)


def test_girths_and_tapes_in_python_have_it() -> None:
    fine, plane = read(obj_text(CUBE).encode(), "obj"), Plane(ENDS[0], np.array([1.0, 0.2, 0.1]))
    girth, true = (plane_girth(atlas, plane, ENDS[0]) for atlas in (chart().atlas, fine))
    error = abs(girth.contact - true.contact)
    assert girth.error_estimate < error < girth.approximation_error
    curve = np.concatenate([girth.loop.positions, girth.loop.positions[:1]])
    bound = approximation_error(chart().atlas, curve)
    assert girth.approximation_error == pytest.approx(bound, rel=0.1)
    exact = replace(chart().atlas, approximation=None)
    assert plane_girth(exact, plane, ENDS[0]).approximation_error == 0.0
    tape = taut_tape(chart().atlas, "a", "b")
    assert tape.approximation_error == pytest.approx(chart()["ab"].approximation_error, rel=0.05)


def limits(mesh: PolygonMesh, count: int, rng: np.random.Generator) -> Array:
    """Points of the Catmull-Clark surface of a mesh."""
    for _ in range(3):
        mesh = refined(mesh)
    points = loop_schaefer(mesh).points[: len(mesh.vertices)]
    return points[rng.choice(len(points), count, replace=False)]


def outside(mesh: PolygonMesh, pairs: int, rng: np.random.Generator) -> int:
    """How many lengths between points of the surface are further off than they say."""
    coarse = read(obj_text(mesh).encode(), "obj", ONE_PATCH_A_QUAD)
    # Two and three steps finer, the deviation is a fortieth or less.
    fine = read(obj_text(mesh).encode(), "obj")
    ends = limits(mesh, 2 * pairs, rng)
    lengths = []
    for atlas in (coarse, fine):
        points, _ = closest_points(atlas, ends)
        lengths.append(geodesics_between(atlas, points[:pairs], points[pairs:]))
    found, beyond_estimate = 0, 0
    for one, other in zip(*lengths, strict=True):
        error = abs(one.length - other.length) - other.approximation_error
        found += error > one.approximation_error + one.error_estimate
        beyond_estimate += error > one.error_estimate
        curve = one.position(np.linspace(0.0, 1.0, 400))
        # A sample beside a seam may be counted for the other patch, which may be stretched more.
        along = approximation_error(coarse, curve) / one.approximation_error
        assert 0.8 <= along <= 1.5
    # The estimate of the computation alone does not tell of it.
    assert beyond_estimate > 0.8 * pairs
    return found


def test_lengths_on_a_cube_are_as_far_off_as_they_say(rng: np.random.Generator) -> None:
    assert outside(CUBE, 2, rng) == 0


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_lengths_on_blobs_are_as_far_off_as_they_say(seed: int, rng: np.random.Generator) -> None:
    assert outside(blob(seed), 25, rng) == 0

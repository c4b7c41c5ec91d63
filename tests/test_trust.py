"""The rule that no length is called converged whose error may be a notable part of it."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.height_fields import bent_plane

import bodymeasure as bm
from bodymeasure import trust
from bodymeasure.chart import Outcome

pytest.importorskip("igl")

BENT = bm.load_sample("paraboloid")
ENDS = (bm.AtlasPoint(0, 0.1, 0.2), bm.AtlasPoint(0, 0.9, 0.7))


def body() -> bm.Atlas:
    """A body of which nothing is remembered."""
    return replace(bm.load_sample("female_average"), name="another")


def chart_of(*keys: str) -> bool:
    measured = bm.measure_chart(body(), only=keys).measured
    outcomes = {item.outcome for item in measured if np.isfinite(item.value) or item.status}
    assert outcomes <= {Outcome.MEASURED, Outcome.NOT_CONVERGED}
    return Outcome.MEASURED in outcomes


def on_edge() -> bool:
    # The edge bulges into the patch, so that the path runs along it.
    found = bm.solve_geodesic(bent_plane(), (0.0, 0.0), (0.3, 1.0), on_failure="status")
    assert found.status in (bm.Status.ON_BOUNDARY, bm.Status.INACCURATE)
    return bool(found.converged)


KINDS: dict[str, Callable[[], bool]] = {
    "in a patch": lambda: bool(
        bm.solve_geodesic(
            BENT.control_points[0], (0.1, 0.2), (0.9, 0.7), on_failure="status"
        ).converged
    ),
    "along an edge": on_edge,
    "across patches": lambda: (
        bm.geodesic_between(
            body(), "back neck point", "bust point left", on_failure="status"
        ).converged
    ),
    "in a direction": lambda: (
        bm.geodesic_from(BENT, ENDS[0], (1.0, 0.2, 0.0), 0.3, on_failure="status").converged
    ),
    "closed": lambda: (
        bm.closed_geodesic(body(), "side waist point left", on_failure="status").converged
    ),
    "taut": lambda: (
        bm.taut_tape(BENT, *ENDS, outside="along normals", on_failure="status").converged
    ),
    "girth": lambda: bm.body_girth(body(), "side waist point left").converged,
    "drop": lambda: bm.vertical_drop(body(), "bust point left", "side waist point left").converged,
    "sides": lambda: bool(bm.boundary_lengths(BENT).converged.all()),
    "path in a chart": lambda: chart_of("back_neck_to_waist"),
    "girth in a chart": lambda: chart_of("waist_girth"),
}
SLOW = ("closed", "path in a chart", "across patches")


@pytest.mark.parametrize(
    "kind", [pytest.param(kind, marks=pytest.mark.slow) if kind in SLOW else kind for kind in KINDS]
)
def test_no_length_is_converged_whose_error_is_beyond_the_rule(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert KINDS[kind]()
    # Every estimate is at least rounding, and so beyond this.
    monkeypatch.setattr(trust, "LARGEST_ERROR", 1e-300)
    assert not KINDS[kind]()


def test_a_coarse_mesh_is_not_converged() -> None:
    angle = np.linspace(0.0, 2.0 * np.pi, 7)[:-1]
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    vertices = np.concatenate([np.c_[ring, np.zeros(6)], np.c_[ring, np.ones(6)]])
    nexts = np.roll(np.arange(6), -1)
    faces = [(k, n, k + 6) for k, n in enumerate(nexts.tolist())]
    faces += [(n, n + 6, k + 6) for k, n in enumerate(nexts.tolist())]
    path = bm.measure_mesh((vertices, faces), 0, 2, unit="m")
    assert path.error_estimate > 1e-3
    assert not path.converged
    flat = bm.measure_mesh(([(0, 0, 0), (1, 0, 0), (1, 1, 0)], [(0, 1, 2)]), 0, 2, unit="m")
    assert flat.converged


def test_a_wide_estimate_leaves_the_length_with_an_honest_status(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    tape = bm.taut_tape(BENT, *ENDS, outside="along normals")
    monkeypatch.setattr(trust, "LARGEST_ERROR", 1e-300)
    wide = bm.taut_tape(BENT, *ENDS, outside="along normals", on_failure="status")
    assert wide.status is bm.TautStatus.INACCURATE
    assert np.isnan(wide.length)
    assert wide.raw_length == pytest.approx(tape.length, abs=tape.error_estimate)
    path = bm.geodesic_between(BENT, *ENDS, on_failure="status")
    assert path.status is bm.Status.INACCURATE
    assert np.isnan(path.length)
    assert 0.0 < path.error_estimate < 1e-6 * path.raw_length
    with pytest.raises(bm.ConvergenceError, match="more than 1e-4 of it"):
        bm.geodesic_between(BENT, *ENDS)


@pytest.mark.parametrize(
    ("length", "error", "size", "known"),
    [
        (1.0, 1e-5, 1.0, True),
        (1.0, 2e-4, 1.0, False),
        (0.0, 1e-15, 1.0, True),
        (1e-12, 1e-12, 1.0, True),
        (1e-5, 1e-8, 1.0, False),
        (np.nan, 0.0, 1.0, False),
        (1.0, np.nan, 1.0, False),
        (1.0, np.inf, 1.0, False),
    ],
)
def test_the_rule(length: float, error: float, size: float, *, known: bool) -> None:
    assert bool(trust.is_known(length, error, size)) is known

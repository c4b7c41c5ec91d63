"""Tapes have the library's lengths to the last digit, and say so where they have none."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from bodymeasure.viewer.content.answers import answer
from bodymeasure.viewer.content.bodies import Bodies
from bodymeasure.viewer.content.requests import MeasureClosed, MeasureGirth, MeasurePath
from bodymeasure.viewer.content.shown import ShownBody
from helpers.charts.scanned import scanned
from msgspec import json

import bodymeasure as bm
from bodymeasure.errors import InputError


def asked(bodies: Bodies, request: Any) -> dict[str, Any]:
    found = answer(bodies, request)
    assert isinstance(found, dict)
    # What the page gets is JSON, whose numbers keep all their digits.
    decoded: dict[str, Any] = json.decode(json.encode(found))
    return decoded


@pytest.mark.parametrize("name", ["0", pytest.param("1", marks=pytest.mark.slow), "2"])
def test_lengths_are_the_librarys(bodies: Bodies, rng: np.random.Generator, name: str) -> None:
    atlas = bodies[name].atlas
    for _ in range(5):
        ends = [
            (int(rng.integers(len(atlas))), float(rng.random()), float(rng.random()))
            for _ in range(2)
        ]
        found = asked(bodies, MeasurePath(body=name, locations=tuple(ends)))
        points = [bm.AtlasPoint(*end) for end in ends]
        path = bm.geodesic_between(atlas, points[0], points[1], on_failure="status")
        meters = atlas.unit.meters
        assert found["length"] == (path.length * meters if path.converged else None)
        assert (found["status"], found["words"]) == (path.status.name.lower(), path.status.sentence)
        chord = np.linalg.norm(atlas.position(points[0]) - atlas.position(points[1]))
        assert found["straight"] == pytest.approx(chord * meters, rel=1e-14)


def test_a_tape_is_drawn_from_point_to_point(bodies: Bodies) -> None:
    names = ("back neck point", "side neck point left", "bust point left")
    found = asked(bodies, MeasurePath(locations=names))
    body = bodies["0"]
    points = np.array(found["points"])
    marks = np.array([body.point(body.atlas.landmarks[name])[0] for name in names])
    np.testing.assert_allclose(points[[0, -1]], marks[[0, 2]], atol=1e-7)
    # The point on the way is one of the tape's, not cut off by a chord.
    assert np.linalg.norm(points - marks[1], axis=1).min() < 1e-6
    drawn = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    assert drawn == pytest.approx(found["length"], rel=1e-3)
    assert drawn < found["length"]
    np.testing.assert_allclose(np.linalg.norm(found["normals"], axis=1), 1.0, atol=1e-3)
    legs = np.linalg.norm(np.diff(marks, axis=0), axis=1).sum()
    assert found["straight"] == pytest.approx(legs)


def test_a_taut_tape_is_shorter_by_the_gap(bodies: Bodies) -> None:
    ends = ("front neck point", "bust point left")
    found = asked(bodies, MeasurePath(locations=ends, kind="taut"))
    tape = bm.taut_tape(bodies["0"].atlas, *ends)
    assert found["length"] == tape.length
    assert found["contact"] == tape.contact.length
    assert found["gap"] == tape.gap > 0.0
    assert found["straight"] < found["length"] < found["contact"]


@pytest.mark.parametrize("drawn", [True, False], ids=["with a path", "without a path"])
def test_a_pair_without_a_length_says_so(
    bodies: Bodies, monkeypatch: pytest.MonkeyPatch, drawn: bool
) -> None:
    ends = ("back neck point", "bust point left")
    path = bm.geodesic_between(bodies["0"].atlas, *ends)
    nan = float("nan")
    failed = replace(path, length=nan, error_estimate=np.inf, status=bm.Status.NOT_CONVERGED)
    if not drawn:
        failed = replace(failed, pieces=(), leg_ends=(), raw_length=nan)
    place = "bodymeasure.viewer.content.tapes.geodesic_between"
    monkeypatch.setattr(place, lambda *_, **__: failed)
    found = asked(bodies, MeasurePath(locations=ends))
    assert (found["length"], found["error_estimate"]) == (None, None)
    assert found["status"] == "not_converged"
    assert found["words"] == bm.Status.NOT_CONVERGED.sentence
    assert found["straight"] > 0.0
    assert bool(found["points"]) is drawn


def test_parts_that_do_not_meet_are_told() -> None:
    apart = np.stack([np.zeros((4, 4, 3)), np.zeros((4, 4, 3))])
    grid = np.stack(np.meshgrid(range(4), range(4), indexing="ij"), axis=-1)
    apart[0, ..., :2], apart[1, ..., :2] = grid, grid + 10.0
    bodies = Bodies()
    bodies.put(ShownBody("0", bm.Atlas.from_control_points(apart, "cm"), "Apart"))
    with pytest.raises(InputError, match="part"):
        answer(bodies, MeasurePath(locations=((0, 0.5, 0.5), (1, 0.5, 0.5))))


def test_a_point_off_the_body_is_told(bodies: Bodies) -> None:
    with pytest.raises(InputError, match="point 2 is on patch 999, but the patches are numbered"):
        answer(bodies, MeasurePath(locations=((0, 0.5, 0.5), (999, 0.5, 0.5))))
    with pytest.raises(InputError, match="did you mean 'back neck point'"):
        answer(bodies, MeasurePath(locations=((0, 0.5, 0.5), "bak neck point")))


@pytest.mark.parametrize("kind", ["contact", "taut"])
def test_a_girth_is_level_and_has_the_librarys_length(bodies: Bodies, kind: Any) -> None:
    found = asked(bodies, MeasureGirth(location="front waist point", kind=kind))
    girth = bm.body_girth(bodies["0"].atlas, "front waist point")
    assert found["length"] == getattr(girth, kind)
    assert (found["contact"], found["gap"]) == (girth.contact, girth.gap)
    points = np.array(found["points"])
    assert np.ptp(points[:, 1]) < 1e-6
    assert found["closed"]
    np.testing.assert_array_equal(points[0], points[-1])
    assert found["words"].endswith("its length holds to the stated error.")


def test_a_girth_that_merges_the_arms_is_told(bodies: Bodies) -> None:
    with pytest.raises(InputError, match="the loop merges the trunk and the"):
        answer(bodies, MeasureGirth(location=(27, 0.5, 0.5)))


@pytest.mark.slow
def test_a_closed_geodesic_has_the_librarys_length(bodies: Bodies) -> None:
    found = asked(bodies, MeasureClosed(location="front waist point"))
    loop = bm.closed_geodesic(bodies["0"].atlas, "front waist point")
    assert found["length"] == loop.length
    points = np.array(found["points"])
    np.testing.assert_allclose(points[0], points[-1], atol=1e-6)
    assert found["closed"]


@pytest.mark.parametrize("kind", ["path", "taut", "girth", "closed"])
def test_on_a_scan_its_distance_counts_as_the_error(kind: str) -> None:
    bodies = Bodies()
    atlas = bm.load_sample("female_average")
    requests = {
        "path": MeasurePath(locations=("bust point left", "back neck point")),
        "taut": MeasurePath(locations=("bust point left", "back neck point"), kind="taut"),
        "girth": MeasureGirth(location="crotch point"),
        "closed": MeasureClosed(location="front waist point"),
    }
    bodies.put(ShownBody("0", atlas, "Model"))
    known = asked(bodies, requests[kind])
    assert "uncertainty" not in known
    bodies.put(ShownBody("0", scanned(atlas), "Scan", version=2))
    found = asked(bodies, requests[kind])
    assert found["length"] == known["length"]
    # Of a surface that is off by 0.6 mm, far more than the computation's nanometers.
    assert 1e-4 < found["uncertainty"] < 2e-3
    assert "fitted to a scan" in found["words"]


def test_the_error_of_a_chart_on_a_scan_is_that_of_the_same_tape() -> None:
    atlas = scanned(bm.load_sample("female_average"), landmarks=0.0)
    chart = bm.measure_chart(atlas, only=("bust_girth",))
    bodies = Bodies()
    bodies.put(ShownBody("0", atlas, "Scan"))
    found = asked(bodies, MeasureGirth(location="bust point left"))
    surface = chart.measured[0].surface_uncertainty
    assert found["uncertainty"] == pytest.approx(surface, rel=0.05)


def test_what_the_scan_does_not_show_has_no_length() -> None:
    atlas = bm.load_sample("female_average")
    ends = ("bust point left", "bust point right")
    patch = atlas.landmarks[ends[0]].patch
    bodies = Bodies()
    bodies.put(ShownBody("0", scanned(atlas, [patch]), "Scan"))
    found = asked(bodies, MeasurePath(locations=ends))
    assert found["length"] is None
    assert found["points"]
    assert found["words"].startswith("The tape crosses 1 patch of which the scan shows less")

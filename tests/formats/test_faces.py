"""Faces of files and their own parameters, beside B-splines that SciPy evaluates."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import NdBSpline

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.errors import ReadWarning

# Four spans of different lengths in s, one knot of them double, and two in t.
KNOTS_S = np.array([2.0, 2, 2, 2, 3, 3.5, 3.5, 7, 7, 7, 7])
KNOTS_T = np.array([-1.0, -1, -1, 0.25, 4, 4, 4])


def nets(rng: np.random.Generator) -> tuple[Array, Array]:
    points = np.stack(np.meshgrid(np.arange(7.0), np.arange(4.0), indexing="ij"), axis=-1)
    points = np.concatenate([points, rng.normal(size=(7, 4, 1))], axis=-1)
    return points, rng.uniform(0.5, 2.0, size=(7, 4))


def geomdl(path: Path, surfaces: list[dict[str, Any]]) -> Path:
    path.write_text(json.dumps({"shape": {"type": "surface", "data": surfaces}}))
    return path


def record(points: Array, weights: Array, **more: Any) -> dict[str, Any]:
    return {
        "degree_u": 3,
        "degree_v": 2,
        "knotvector_u": KNOTS_S.tolist(),
        "knotvector_v": KNOTS_T.tolist(),
        "size_u": 7,
        "size_v": 4,
        "rational": True,
        "control_points": {
            "points": points.reshape(-1, 3).tolist(),
            "weights": weights.ravel().tolist(),
        },
    } | more


def obj(path: Path, points: Array, weights: Array, ranges: str) -> Path:
    lines = [
        "v " + " ".join(map(repr, [*point, weight]))
        for point, weight in zip(
            points.transpose(1, 0, 2).reshape(-1, 3).tolist(),
            weights.T.ravel().tolist(),
            strict=True,
        )
    ]
    numbers = " ".join(map(str, range(1, 29)))
    lines += ["cstype rat bspline", "deg 3 2", f"surf {ranges} {numbers}"]
    for direction, knots in (("u", KNOTS_S), ("v", KNOTS_T)):
        lines.append(f"parm {direction} " + " ".join(map(repr, knots.tolist())))
    path.write_text("\n".join([*lines, "end", ""]))
    return path


def expected(points: Array, weights: Array, places: Array) -> Array:
    net = np.concatenate([points * weights[..., None], weights[..., None]], axis=-1)
    found = NdBSpline((KNOTS_S, KNOTS_T), net, (3, 2))(places)
    return np.asarray(found[:, :3] / found[:, 3:])


def at(atlas: bm.Atlas, face: str, places: Array) -> Array:
    return np.array([atlas.position(atlas.parameters(face, *place)) for place in places.tolist()])


def grid(start: tuple[float, float], end: tuple[float, float], rng: np.random.Generator) -> Array:
    """Places inside, on the borders, and on all knots."""
    s = np.concatenate([rng.uniform(start[0], end[0], 5), np.unique(KNOTS_S), [start[0], end[0]]])
    t = np.concatenate([rng.uniform(start[1], end[1], 5), np.unique(KNOTS_T), [start[1], end[1]]])
    s, t = (
        np.unique(np.clip(v, a, b)) for v, a, b in ((s, start[0], end[0]), (t, start[1], end[1]))
    )
    return np.stack(np.meshgrid(s, t, indexing="ij"), axis=-1).reshape(-1, 2)


def test_parameters_of_rational_surfaces_are_those_of_their_knots(
    tmp_path: Path, rng: np.random.Generator
) -> None:
    points, weights = nets(rng)
    other = points + np.array([0.0, 0.0, 5.0])
    file = geomdl(
        tmp_path / "a.json", [record(points, weights), record(other, weights, name="top")]
    )
    atlas = bm.read_atlas(file, unit="cm")
    assert len(atlas) == 12
    places = grid((2.0, -1.0), (7.0, 4.0), rng)
    for face, net in (("surface 0", points), ("surface 1 ('top')", other)):
        np.testing.assert_allclose(
            at(atlas, face, places), expected(net, weights, places), atol=1e-12
        )

    for ending in (".atlas", ".npz"):
        bm.write_atlas(atlas, tmp_path / f"b{ending}")
        again = bm.read_atlas(tmp_path / f"b{ending}")
        assert atlas.faces is not None
        assert atlas.faces.is_same(again.faces)
    moved = replace(atlas.converted("m"), points=atlas.points + 1.0)
    np.testing.assert_allclose(at(moved, face, places), at(atlas, face, places) + 1.0)


def test_a_part_of_a_surface_keeps_the_parameters_of_all(
    tmp_path: Path, rng: np.random.Generator
) -> None:
    points, weights = nets(rng)
    atlas = bm.read_atlas(obj(tmp_path / "a.obj", points, weights, "2.25 3.25 -0.5 4"), unit="m")
    places = grid((2.25, -0.5), (3.25, 4.0), rng)
    found = at(atlas, "line 31", places)
    np.testing.assert_allclose(found, expected(points, weights, places), atol=1e-12)
    with pytest.raises(bm.InputError, match=r"on which s runs from 2.25 to 3.25 and t from -0.5"):
        atlas.parameters("line 31", 5.0, 0.0)


def test_quads_of_a_mesh_have_the_parameters_of_its_spline(
    tmp_path: Path, rng: np.random.Generator
) -> None:
    """The surface of a grid is the uniform B-spline, two faces away from its border."""
    heights = rng.normal(size=(7, 6))
    number = np.arange(42).reshape(7, 6) + 1
    lines = [f"v {i} {j} {float(heights[i, j])!r}" for i, j in np.ndindex(7, 6)]
    cells = list(np.ndindex(6, 5))
    for i, j in cells:
        around = [number[i, j], number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]]
        lines.append("f " + " ".join(map(str, np.roll(around, -(i + j)).tolist())))
    net = np.array([[[i, j, heights[i, j]] for j in range(6)] for i in range(7)], dtype=float)
    knots = np.arange(11.0) - 2.0, np.arange(10.0) - 2.0
    spline = NdBSpline(knots, net, 3)

    def check(file_lines: list[str]) -> bm.Atlas:
        (tmp_path / "a.obj").write_text("\n".join(file_lines))
        atlas = bm.read_atlas(tmp_path / "a.obj", unit="m")
        for face, (i, j) in enumerate(cells, 1):
            if 1 <= i <= 3 and 1 <= j <= 2:
                s, t = rng.uniform(size=2)
                # The first vertex is another corner of the cell each time.
                turned = [(s, t), (1 - t, s), (1 - s, 1 - t), (t, 1 - s)][(i + j) % 4]
                found = atlas.position(atlas.parameters(f"face {face}", s, t))
                np.testing.assert_allclose(found, spline([[i + turned[0], j + turned[1]]])[0])
        return atlas

    assert len(check(lines)) == 30
    # With a triangle and a pentagon beside, all faces are refined.
    base = ["v 10 0 0", "v 11 0 0", "v 11 1 0", "v 10 1 0", "v 9 0.5 0", "v 12 0 1"]
    atlas = check([*lines, *base, "f 43 44 45 46 47", "f 44 48 45"])
    assert len(atlas) == 4 * 30 + 5 + 3
    with pytest.raises(bm.InputError, match="face 31 has no parameters: it has 5 corners"):
        atlas.parameters("face 31", 0.5, 0.5)
    middles = [
        atlas.position(atlas.parameters(f"face 31 corner {k}", 1.0, 1.0)) for k in range(1, 6)
    ]
    np.testing.assert_allclose(middles, np.broadcast_to(middles[0], (5, 3)), atol=1e-12)
    beside = (
        atlas.parameters("face 31 corner 1", 1.0, 0.3),
        atlas.parameters("face 31 corner 2", 0.3, 1.0),
    )
    here, there = (atlas.position(point) for point in beside)
    np.testing.assert_allclose(here, there, atol=1e-12)
    corner = atlas.position(atlas.parameters("face 31 corner 2", 0.0, 0.0))
    assert np.linalg.norm(corner - [11.0, 0.0, 0.0]) < 0.5


def test_faces_without_parameters_say_why(tmp_path: Path, rng: np.random.Generator) -> None:
    points, weights = nets(rng)
    steep = record(points, weights, degree_u=10)
    file = geomdl(tmp_path / "a.json", [record(points, weights), steep])
    with pytest.warns(ReadWarning, match="it is left out"):
        atlas = bm.read_atlas(file, unit="cm")
    for ending in (".atlas", ".npz"):
        bm.write_atlas(atlas, tmp_path / f"b{ending}")
        again = bm.read_atlas(tmp_path / f"b{ending}")
        with pytest.raises(bm.InputError, match="surface 1 has no parameters: it is left out"):
            again.parameters("surface 1", 3.0, 0.0)
    with pytest.raises(bm.InputError, match=r"no face 'surface 2'.*surface 0"):
        atlas.parameters("surface 2", 3.0, 0.0)
    with pytest.raises(bm.InputError, match="expected two numbers"):
        atlas.parameters("surface 0", "a", 0.0)  # type: ignore[arg-type]
    with pytest.raises(bm.InputError, match="is not on surface 0"):
        atlas.parameters("surface 0", float("nan"), 0.0)
    with pytest.raises(bm.InputError, match="no faces with parameters of their own"):
        bm.load_sample("paraboloid").parameters("face 1", 0.5, 0.5)


def test_groups_keep_their_faces(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n"
        "g left\nf 1 2 3 4\ng right\nf 2 5 6 3\n"
    )
    whole = bm.read_atlas(tmp_path / "a.obj", unit="m")
    right = bm.read_atlas(tmp_path / "a.obj", unit="m", group="right")
    place = whole.position(whole.parameters("face 2", 0.2, 0.7))
    np.testing.assert_array_equal(right.position(right.parameters("face 2", 0.2, 0.7)), place)
    with pytest.raises(bm.InputError, match="face 1 has no parameters: it is not among the groups"):
        right.parameters("face 1", 0.2, 0.7)


@pytest.mark.parametrize(
    ("names", "corners", "message"),
    [
        (["a"], np.zeros((1, 3, 2)), "span an area"),
        (["a"], np.full((1, 3, 2), np.nan), "span an area"),
        (["a", "b"], np.zeros((1, 3, 2)), "expected \\(2, 3, 2\\)"),
        (["a"], "x", "no numbers"),
    ],
)
def test_damaged_faces_are_refused(names: list[str], corners: Any, message: str) -> None:
    with pytest.raises(bm.InputError, match=message):
        bm.FileFaces(tuple(names), corners)

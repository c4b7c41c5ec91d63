import json

import numpy as np
import pytest
from helpers.files.format_atlases import UNIT, body_like, read, write
from scipy.interpolate import BSpline

from bodymeasure import Atlas, InputError
from bodymeasure._typing import Array
from bodymeasure.atlas import edge_table
from bodymeasure.bezier import evaluate
from bodymeasure.errors import ReadWarning

PLAIN = write(body_like(1, 2), "obj").decode()


def vertices(points: Array) -> str:
    """The lines of the vertices, in the order of the format, in which u runs fastest."""
    rows = points.swapaxes(0, 1).reshape(-1, points.shape[-1]).tolist()
    return "".join("v " + " ".join(map(repr, row)) + "\n" for row in rows)


def surface(
    points: Array,
    degrees: tuple[int, int],
    kind: str,
    parameters: tuple[Array, Array],
    **how: str,
) -> str:
    numbers = range(1, points.shape[0] * points.shape[1] + 1)
    u, v = (" ".join(map(repr, np.asarray(each).tolist())) for each in parameters)
    return (
        vertices(points)
        + f"cstype {kind}\ndeg {degrees[0]} {degrees[1]}\n"
        + f"surf {how.get('ranges', '0 1 0 1')} {' '.join(map(str, numbers))}\n"
        + f"parm u {u}\nparm v {v}\nend\n"
    )


def on_grid(atlas: Atlas, patch: int, places: Array) -> Array:
    return evaluate(
        atlas.control_points[patch], np.stack(np.meshgrid(places, places, indexing="ij"), -1)
    )


def test_indices_may_count_back_and_carry_texture_and_normals() -> None:
    lines = PLAIN.splitlines()
    for number, line in enumerate(lines):
        if line.startswith("surf"):
            words = line.split()
            changed = [
                f"{int(w) - 29}/7/-3" if k % 2 else f"{w}//2" for k, w in enumerate(words[5:])
            ]
            lines[number] = " ".join(words[:5] + changed)
    assert sum(line.count("/") for line in lines) == 2 * (8 * 2 + 8 * 2)
    assert read("\n".join(lines).encode(), "obj").digest == body_like(1, 2).digest


def test_a_backslash_continues_a_line() -> None:
    broken = PLAIN.replace(" 1 0 1 ", " 1 0 \\\n  1 ").replace(" 7 ", " \\ \r\n 7 ")
    assert broken.count("\\") == 3
    assert read(broken.encode(), "obj").digest == body_like(1, 2).digest
    with pytest.raises(InputError, match=r"^file, line 6: 'x' is not a finite number"):
        read(
            broken.replace("v 0.0 0.0 0.0", "v 0.0 \\\n 0.0 0.0")
            .replace("v 0.0 1.0", "v x 1.0", 1)
            .encode(),
            "obj",
        )


def test_what_has_no_bearing_on_the_shape_is_passed_over() -> None:
    extra = "mtllib a.mtl\nvt 0 0\nvn 0 0 1\nvp 0.1 0.2\ns off\nusemtl skin\nl 1 2\np 3\n"
    curve = "cstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 1 1\nend\n"
    curve += curve.replace("curv 0 1", "curv2") + "cstype bezier\ndeg 3 3\n"
    content = PLAIN.replace("cstype", extra + "cstype", 1).replace("o patch 0", curve + "o patch 0")
    assert read(content.encode(), "obj").digest == body_like(1, 2).digest


def test_several_bezier_patches_in_one_surface() -> None:
    atlas = body_like(2, 3)
    lattice = np.empty((7, 10, 3))
    for number, net in enumerate(atlas.control_points):
        i, j = divmod(number, 3)
        lattice[3 * i : 3 * i + 4, 3 * j : 3 * j + 4] = net
    text = surface(
        lattice,
        (3, 3),
        "bezier",
        (np.array([0, 0.5, 2.0]), np.array([1.0, 2, 3, 7])),
        ranges="0 2 1 7",
    )
    back = read(text.encode(), "obj")
    assert back.digest == atlas.digest
    assert len(back.points) == len(atlas.points)


@pytest.mark.parametrize("degrees", [(3, 3), (2, 3), (1, 2), (4, 2)])
def test_a_b_spline_surface_is_cut_at_its_knots(
    degrees: tuple[int, int], rng: np.random.Generator
) -> None:
    inner = [0.2, 0.5, 0.5, 0.9]
    knots = [np.array([0.0] * (d + 1) + inner + [1.0] * (d + 1)) for d in degrees]
    points = rng.normal(size=(len(knots[0]) - degrees[0] - 1, len(knots[1]) - degrees[1] - 1, 3))
    back = read(surface(points, degrees, "bspline", (knots[0], knots[1])).encode(), "obj")
    assert len(back) == 16
    ends = np.array([0.0, 0.2, 0.5, 0.9, 1.0])
    places = np.linspace(0.0, 1.0, 5)
    for patch in range(16):
        i, j = divmod(patch, 4)
        u = ends[i] + places * (ends[i + 1] - ends[i])
        v = ends[j] + places * (ends[j + 1] - ends[j])
        rows = BSpline.design_matrix(u, knots[0], degrees[0]).toarray()
        columns = BSpline.design_matrix(v, knots[1], degrees[1]).toarray()
        expected = np.einsum("ai,bj,ijc->abc", rows, columns, points)
        # Between the knots, where a spline of degree 1 may jump, scipy takes the upper piece.
        inside = slice(0, 4) if min(degrees) == 1 else slice(None)
        np.testing.assert_allclose(
            on_grid(back, patch, places)[inside, inside],
            expected[inside, inside],
            rtol=0,
            atol=1e-14,
        )
    if min(degrees) > 1:
        assert (edge_table(back.index).sides == 2).sum() == 24


def test_a_periodic_surface_closes() -> None:
    ring = np.array([[np.cos(a), np.sin(a)] for a in 2 * np.pi * np.arange(8) / 8])
    tube = np.stack([np.column_stack([ring, np.full(8, z)]) for z in range(4)], axis=1)
    points = np.concatenate([tube, tube[:3]])
    knots = np.arange(-3.0, 12.0), np.array([0.0] * 4 + [1.0] * 4)
    back = read(surface(points, (3, 3), "bspline", knots, ranges="0 8 0 1").encode(), "obj")
    assert len(back) == 8
    sides = edge_table(back.index).sides
    assert ((sides == 2).sum(), (sides == 1).sum()) == (8, 16)


def test_a_part_of_a_surface() -> None:
    whole = body_like(1, 1)
    parameters = np.array([0.0, 1.0]), np.array([0.0, 1.0])
    text = surface(whole.control_points[0], (3, 3), "bezier", parameters, ranges="0.25 1 0 0.5")
    back = read(text.encode(), "obj")
    places = np.linspace(0.0, 1.0, 4)
    there = np.stack(np.meshgrid(0.25 + 0.75 * places, 0.5 * places, indexing="ij"), axis=-1)
    expected = evaluate(whole.control_points[0], there)
    np.testing.assert_allclose(on_grid(back, 0, places), expected, rtol=0, atol=1e-15)


def test_a_rational_cylinder_is_round() -> None:
    half = np.sqrt(0.5)
    arc = np.array([[1, 0, 1], [1, 1, half], [0, 1, 1.0]])
    points = np.stack([np.insert(arc, 2, z, axis=1) for z in (0.0, 2.0)], axis=1)
    parameters = np.array([0.0, 1.0]), np.array([0.0, 1.0])
    back = read(surface(points, (2, 1), "rat bezier", parameters).encode(), "obj")
    assert back.is_rational
    found = on_grid(back, 0, np.linspace(0.0, 1.0, 9))
    np.testing.assert_allclose(np.hypot(found[..., 0], found[..., 1]), 1.0, rtol=0, atol=3e-16)
    np.testing.assert_allclose(found[:, -1, 2], 2.0)
    # Without `rat` weights are ignored.
    flat = read(surface(points, (2, 1), "bezier", parameters).encode(), "obj")
    assert not flat.is_rational


def test_objects_name_patches_and_groups_are_regions() -> None:
    content = PLAIN.replace("o patch 0", "o left arm\ng arm upper").replace("o patch 1\n", "")
    atlas = read(content.encode(), "obj")
    assert atlas.patch_names == ("left arm 0", "left arm 1")
    assert atlas.regions == ("arm upper", "arm upper")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "cstype bezier",
            "cstype cardinal",
            "line 30: cstype 'cardinal' is not read; expected bez",
        ),
        ("cstype bezier", "", r"line 33: surf without cstype and deg before it"),
        ("deg 3 3", "deg 3 3 3", "line 31: 3 degrees; expected deg and one or two"),
        ("deg 3 3", "deg 0", "line 31: a degree of 0"),
        ("deg 3 3", "deg 2 3", r"line 33: 16 control points; expected 3 x 4"),
        ("deg 3 3", "deg 1000000000", r"line 33: 2 parameters in u at degree 1000000000 for 16"),
        ("surf 0 1 0 1", "surf 0 1 0", "line 33: 15 control points; expected 4 x 4"),
        ("surf 0 1 0 1", "surf 0 1 0 2", "line 33: in v: the range from 0 to 2 is not inside"),
        ("surf 0 1 0 1", "surf 1 0 0 1", "line 33: in u: the range from 1 to 0 is not inside"),
        ("surf 0 1 0 1", "surf nan 1 0 1", "line 33: 'nan' is not a finite number"),
        ("surf 0 1 0 1 1 ", "surf 0 1 0 1 0 ", "line 33: refers to vertex '0'; expected 1 to 28"),
        ("surf 0 1 0 1 1 ", "surf 0 1 0 1 29 ", "line 33: refers to vertex '29'"),
        ("surf 0 1 0 1 1 ", "surf 0 1 0 1 -29 ", "line 33: refers to vertex '-29'"),
        ("surf 0 1 0 1 1 ", "surf 0 1 0 1 1_0 ", "line 33: '1_0' is not a whole number"),
        ("surf 0 1 0 1 1 ", f"surf 0 1 0 1 {10**30} ", "line 33: refers to vertex '10000"),
        ("parm u 0 1", "parm u 0", "line 33: parm u of a Bezier surface has 1 numbers"),
        ("parm u 0 1", "parm u 1 0", "line 33: parm u of a Bezier surface has 2 numbers; expected"),
        ("parm u 0 1", "parm w 0 1", "line 34: expected parm u or parm v, once each"),
        ("parm u 0 1", "parm v 0 1", "line 35: expected parm u or parm v, once each"),
        ("parm u 0 1", "", "line 33: surf without parm u"),
        ("parm u 0 1", "trim 0 1 1", "line 34: trim trims the surface of line 33; only whole surf"),
        ("end\n", "", "line 37: surf inside the surf of line 33; expected parm or end"),
        ("end\no patch 1", "end\nend\no patch 1", "line 37: end without a surf before it"),
        ("cstype bezier", "bzp 1 2 3", "line 30: bzp is not read; expected Bezier"),
        ("cstype bezier", "call other.obj", "line 30: call is not read"),
        ("cstype bezier", "cstpye bezier", "line 30: begins with 'cstpye', which is no statement"),
        ("v 0.0 0.0 0.0", "v 0.0 0.0", "line 2: a vertex of 2 numbers; expected v x y z"),
        ("v 0.0 0.0 0.0", "v 0.0 zero 0.0", "line 2: 'zero' is not a finite number"),
    ],
)
def test_faults_are_told_with_their_line(old: str, new: str, message: str) -> None:
    assert old in PLAIN
    with pytest.raises(InputError, match=f"^file, ({message})"):
        read(PLAIN.replace(old, new, 1).encode(), "obj")


def test_a_surface_that_is_cut_off_is_told() -> None:
    with pytest.raises(InputError, match=r"^file, line 38: the surf has no end; the file may have"):
        read(PLAIN.rstrip()[: -len("end")].encode(), "obj")


def test_a_file_with_neither_or_both_is_refused() -> None:
    with pytest.raises(InputError, match=r"^file: holds neither surfaces \(surf\) nor faces"):
        read(b"v 0 0 0\n", "obj")
    both = PLAIN + "f 1 2 4 3\n"
    with pytest.raises(InputError, match="holds free-form surfaces and faces; say which to take"):
        read(both.encode(), "obj")
    assert read(both.encode(), "obj-surfaces").digest == body_like(1, 2).digest
    assert read(both.encode(), "obj-mesh").unit == UNIT


def test_a_huge_degree_is_refused_at_once() -> None:
    # Cutting it at its knots would take hours.
    lines = ["v 0 0 0"] * 2000 + ["cstype bspline", "deg 998 1"]
    lines.append("surf 0 1 0 1 " + " ".join(map(str, range(1, 2001))))
    lines += ["parm u " + "0 " * 999 + "0.5 " + "1 " * 999, "parm v 0 0 1 1", "end"]
    with pytest.raises(InputError, match=r"^file, line 2003: has the degrees 998 and 1; only"):
        read("\n".join(lines).encode(), "obj")


@pytest.mark.parametrize("form", ["obj", "geomdl"])
def test_a_surface_of_too_high_a_degree_is_left_out_beside_others(
    form: str, rng: np.random.Generator
) -> None:
    high = rng.normal(size=(13, 2, 3))
    if form == "obj":
        ends = np.array([0.0, 1.0]), np.array([0.0, 1.0])
        text = surface(high, (12, 1), "bezier", ends)
        shifted = (text + PLAIN).splitlines()
        for number, line in enumerate(shifted[len(text.splitlines()) :], len(text.splitlines())):
            if line.startswith("surf"):
                words = line.split()
                shifted[number] = " ".join(words[:5] + [str(int(w) + 26) for w in words[5:]])
        content, alone = "\n".join(shifted), text
    else:
        document = json.loads(write(body_like(1, 2), "geomdl"))
        extra = json.loads(write(body_like(1, 2), "geomdl"))["shape"]["data"][0]
        extra |= {"degree_u": 12, "degree_v": 1, "size_u": 13, "size_v": 2}
        extra |= {"knotvector_u": [0.0] * 13 + [1.0] * 13, "knotvector_v": [0, 0, 1, 1]}
        extra["control_points"] = {"points": high.reshape(-1, 3).tolist()}
        document["shape"]["data"].insert(0, extra)
        document["shape"]["count"] = 3
        content = json.dumps(document)
        alone = json.dumps({"shape": {"type": "surface", "data": [extra]}})
    with pytest.warns(ReadWarning, match=r"has the degrees 12 and 1; only .* it is left out"):
        assert len(read(content.encode(), form)) == 2
    with pytest.raises(InputError, match=r"^file, .*: has the degrees 12 and 1; only"):
        read(alone.encode(), form)

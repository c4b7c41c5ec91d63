from pathlib import Path

import numpy as np
import pytest
from helpers.bodies import BODIES
from helpers.files.format_atlases import ONE_PATCH_A_QUAD, UNIT, read
from helpers.surfaces.quad_grids import grid_mesh, hilly_net, spline_atlas

from bodymeasure import Axes, InputError, Unit, check_atlas
from bodymeasure.atlas import FindingKind, edge_table
from bodymeasure.formats.options import ReadOptions
from bodymeasure.subdivision import QuadMesh

SAMPLES = Path(__file__).parents[2] / "sample_patches" / "quad_meshes.npz"
POINTS = hilly_net(6, 5)
MESH = grid_mesh(POINTS)


def text(mesh: QuadMesh, suffix: str = "") -> str:
    lines = ["v " + " ".join(map(repr, point)) for point in mesh.vertices.tolist()]
    lines += ["f " + " ".join(f"{k + 1}{suffix}" for k in quad) for quad in mesh.quads.tolist()]
    return "\n".join(lines) + "\n"


PLAIN = text(MESH)


def test_a_quad_mesh_becomes_the_spline_surface_that_it_stands_for() -> None:
    atlas = read(PLAIN.encode(), "obj", ReadOptions(unit=Unit.MM, axes=Axes("+y", "+z")))
    assert (len(atlas), atlas.unit, atlas.axes.up) == (20, Unit.MM, "+y")
    inner = atlas.control_points.reshape(5, 4, 4, 4, 3)[1:-1, 1:-1].reshape(-1, 4, 4, 3)
    expected = spline_atlas(POINTS, margin=1).control_points
    np.testing.assert_allclose(inner, expected, rtol=0, atol=1e-14)
    assert atlas.patch_names[:2] == ("face 01", "face 02")
    assert check_atlas(atlas) == ()


@pytest.mark.parametrize(
    "body", [BODIES[0], *(pytest.param(body, marks=pytest.mark.slow) for body in BODIES[1:])]
)
def test_seams_of_the_sample_bodies_are_shared(body: str) -> None:
    with np.load(SAMPLES) as file:
        mesh = QuadMesh(1e-6 * file[body], file["quads"].astype(np.int64))
    atlas = read(text(mesh, "/1/2").encode(), "obj")
    assert len(atlas) == 4700
    sides = edge_table(atlas.index).sides
    boundary = mesh.edges.boundary
    assert (sides == 1).sum() == boundary.sum()
    assert (sides == 2).sum() == (~boundary).sum()
    kinds = {finding.kind for finding in check_atlas(atlas)}
    assert kinds <= {FindingKind.KINKED_SEAM, FindingKind.SINGULAR_CORNER}


def grouped() -> bytes:
    lines = PLAIN.splitlines()
    first = next(number for number, line in enumerate(lines) if line.startswith("f"))
    lines.insert(first, "o body\ng skin dress_form")
    lines.insert(first + 13, "g skin\nusemtl a")
    return "\n".join(lines).encode()


def test_groups_are_regions_and_can_be_chosen() -> None:
    atlas = read(grouped(), "obj")
    assert atlas.regions == ("skin dress_form",) * 12 + ("skin",) * 8
    assert atlas.patch_names[0] == "body face 01"
    part = read(grouped(), "obj", ReadOptions(unit=UNIT, groups=("dress_form",)))
    # The surface is that of the whole mesh, and not of a mesh that ends there.
    np.testing.assert_array_equal(part.control_points, atlas.control_points[:12])
    assert len(part.points) == 13 * 10


def test_indices_may_count_back() -> None:
    lines = PLAIN.splitlines()
    for number, line in enumerate(lines):
        if line.startswith("f"):
            lines[number] = "f " + " ".join(f"{int(word) - 31}//1" for word in line.split()[1:])
    back = read("\n".join(lines).encode(), "obj")
    assert back.digest == read(PLAIN.encode(), "obj").digest


def test_triangles_and_polygons_become_quads() -> None:
    # A prism over a pentagon has five quads and two pentagons.
    angle = 2.0 * np.pi * np.arange(5) / 5
    rings = [np.column_stack([np.cos(angle), np.sin(angle), 0.0 * angle + z]) for z in (0.0, 1.0)]
    points = "".join(f"v {x} {y} {z}\n" for x, y, z in np.concatenate(rings).tolist())
    sides = "".join(f"f {k + 1} {(k + 1) % 5 + 1} {(k + 1) % 5 + 6} {k + 6}\n" for k in range(5))
    atlas = read(
        f"{points}{sides}g cap\nf 5 4 3 2 1\ng\nf 6 7 8 9 10\n".encode(), "obj", ONE_PATCH_A_QUAD
    )
    assert len(atlas) == 4 * 5 + 2 * 5
    assert atlas.patch_names[:2] == ("face 1 0", "face 1 1")
    assert atlas.regions.count("cap") == 5
    assert (edge_table(atlas.index).sides == 2).all()


def crease(sharpness: str) -> bytes:
    row = 2 * 5
    tags = "".join(f"t crease 2/1/0 {row + k} {row + k + 1} {sharpness}\n" for k in range(4))
    return (PLAIN + "t interpolateboundary 1/0/0 1\n" + tags).encode()


def test_creases_stay_sharp() -> None:
    # The surface is as if the mesh ended there on both sides.
    halves = [read(text(grid_mesh(half)).encode(), "obj") for half in (POINTS[:3], POINTS[2:])]
    expected = np.concatenate([half.control_points for half in halves])
    found = read(crease("10"), "obj").control_points
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-15)
    assert read(crease("0"), "obj").digest == read(PLAIN.encode(), "obj").digest
    with pytest.raises(InputError, match=r"^file, line 52: a crease of sharpness '3'; only those"):
        read(crease("3"), "obj")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("f 1 6 7 2", "f 1 6 7", None),
        ("f 1 6 7 2", "f 1 6", r": face 1 \(line 31\): 2 corners; expected at least 3"),
        ("f 1 6 7 2", "f", r": face 1 \(line 31\): 0 corners"),
        ("f 1 6 7 2", "f 1 6 6 2", r": face 1 \(line 31\): a vertex occurs twice"),
        ("f 1 6 7 2", "f 1 2 7 6", r": face 1 \(line 31\), face [25] \(line 3[25]\) face opposite"),
        ("f 1 6 7 2", "f 1 6 7 2\nf 1 6 7 2", r": face 1 .line 31., face 2 .line 32., face 3"),
        ("f 1 6 7 2", "f 1 6 7 2\nf 2 7 30", r": face 1 .*, face 2 .*, face 3 .* share one edge"),
        ("f 1 6 7 2", "f 1 6 7 0", ", line 31: refers to vertex '0'; expected 1 to 30"),
        ("f 1 6 7 2", "f 1 6 7 31", ", line 31: refers to vertex '31'"),
        ("f 1 6 7 2", "f 1 6 7 two", ", line 31: 'two' is not a whole number; expected the number"),
        ("f 1 6 7 2", "f 1 6 7 2_0", ", line 31: '2_0' is not a whole number"),
        ("f 1 6 7 2", f"f 1 6 7 {10**25}", ", line 31: refers to vertex '1000"),
        ("f 1 6 7 2", "t crease 2/1/0 1 99 10", ": a crease runs|: a crease refers to vertex 99"),
        ("f 1 6 7 2", "t crease 2/1/0 0 6 10", ": a crease runs from vertex 1 to 7, where no edge"),
        ("f 1 6 7 2", "t crease 1/1/0 0 6 10", ", line 31: expected t crease 2/1/0, two vertices"),
        ("f 1 6 7 2", "t crease 2/1/0 0 0 10", ", line 31: a crease from 0 to 0"),
    ],
)
def test_faults_are_told_with_their_faces(old: str, new: str, message: str | None) -> None:
    content = PLAIN.replace(old, new, 1).encode()
    if message is None:
        assert len(read(content, "obj", ONE_PATCH_A_QUAD)) == 3 + 4 * 19
        return
    with pytest.raises(InputError, match=f"^file({message})"):
        read(content, "obj")


def test_a_mesh_of_an_impossible_size_is_refused() -> None:
    content = "v 1e200 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n"
    with pytest.raises(InputError, match=r"^file: the atlas extends over 1e\+200"):
        read(content.encode(), "obj")
    # A vertex without a face does not matter.
    far = (PLAIN + "v 1e200 0 0\n").encode()
    assert read(far, "obj").digest == read(PLAIN.encode(), "obj").digest


def test_a_mesh_has_no_loose_patches() -> None:
    with pytest.raises(InputError, match=r"^file: is a mesh, joined by the vertices of its faces"):
        read(PLAIN.encode(), "obj", ReadOptions(unit=UNIT, tolerance=0.1))

"""The tags of subdivision surfaces in Wavefront OBJ files, by the rules of OpenSubdiv."""

import numpy as np
import pytest
from helpers.files.format_atlases import ONE_PATCH_A_QUAD, read
from helpers.surfaces.quad_grids import grid_mesh, hilly_net

from bodymeasure import Atlas, InputError

POINTS = hilly_net(5, 5)
MESH = grid_mesh(POINTS)
PLAIN = "".join(
    ["v " + " ".join(map(repr, point)) + "\n" for point in MESH.vertices.tolist()]
    + ["f " + " ".join(str(k + 1) for k in quad) + "\n" for quad in MESH.quads.tolist()]
)


def tagged(*tags: str) -> Atlas:
    return read((PLAIN + "".join(f"t {tag}\n" for tag in tags)).encode(), "obj", ONE_PATCH_A_QUAD)


def holds(atlas: Atlas, vertex: int) -> bool:
    """Whether a vertex of the mesh is a corner of a patch."""
    corners = atlas.control_points[:, ::3, ::3].reshape(-1, 3)
    return bool((np.abs(corners - MESH.vertices[vertex]).max(axis=1) == 0.0).any())


@pytest.mark.parametrize(
    "tag", ["corner 1/1/0 12 10.0", "corner 2/1/0 12 6 10", "corner 2/2/0 12 6 10 0"]
)
def test_sharp_vertices_are_interpolated(tag: str) -> None:
    assert not holds(tagged(), 12)
    assert holds(tagged(tag), 12)
    assert holds(tagged(tag), 6) == ("2/1/0" in tag)
    assert tagged("corner 1/1/0 12 0").digest == tagged().digest


def test_holes_carry_no_surface_but_hold_up_their_neighbors() -> None:
    whole, part = tagged(), tagged("hole 2/0/0 3 7", "hole 1/0/0 0")
    kept = np.delete(np.arange(16), [0, 3, 7])
    np.testing.assert_array_equal(part.control_points, whole.control_points[kept])
    assert part.patch_names == tuple(whole.patch_names[number] for number in kept)
    # A triangle makes three quads.
    first = PLAIN.index("f ")
    content = PLAIN[:first] + "f 1 6 7\nf 1 7 2\n" + PLAIN[first:].split("\n", 1)[1]
    assert len(read((content + "t hole 1/0/0 1\n").encode(), "obj", ONE_PATCH_A_QUAD)) == 3 + 4 * 15


def test_the_rules_for_the_boundary() -> None:
    corners, edges = tagged("interpolateboundary 1/0/0 1"), tagged("interpolateboundary 1/0/0 2")
    assert corners.digest == tagged().digest
    assert holds(corners, 0)
    assert not holds(edges, 0)
    np.testing.assert_array_equal(
        edges.control_points.reshape(4, 4, 4, 4, 3)[1:3, 1:3],
        corners.control_points.reshape(4, 4, 4, 4, 3)[1:3, 1:3],
    )
    none = tagged("interpolateboundary 1/0/0 0")
    inner = corners.control_points.reshape(4, 4, 4, 4, 3)[1:3, 1:3].reshape(-1, 4, 4, 3)
    np.testing.assert_array_equal(none.control_points, inner)
    # Where all edges of the boundary at a face's vertices are creases, the face has its surface.
    row = [f"crease 2/1/0 {k} {k + 1} 10" for k in range(4)]
    assert len(tagged("interpolateboundary 1/0/0 0", *row)) == 4 + 2


def test_what_has_no_bearing_on_the_shape_is_passed_over() -> None:
    tags = ("facevaryinginterpolateboundary 1/0/0 3", "facevaryingpropagatecorners 1/0/0 1")
    methods = (
        "creasemethod 0/0/1 chaikin",
        "creasemethod 0/0/1 normal",
        "smoothtriangles 0/0/1 catmark",
    )
    assert tagged(*tags, *methods).digest == tagged().digest


@pytest.mark.parametrize(
    ("tag", "message"),
    [
        ("corner 1/1/0 12 3", "a corner of sharpness '3'; only those of 0 and of 10 and more"),
        ("corner 1/1/0 25 10", "refers to 25; expected t corner 1/1/0, a vertex .* 0 to 24"),
        ("corner 1/1/0 -1 10", "refers to -1; expected t corner"),
        ("corner 1/0/0 12", "expected t corner 1/1/0"),
        ("corner 1/1/0 12", "expected t corner 1/1/0"),
        ("corner 1/1/0 1.5 10", "'1.5' is not a whole number; expected t corner"),
        ("hole 1/0/0 16", "refers to 16; expected t hole, n/0/0 and n faces, .* 0 to 15"),
        ("hole 0/0/0", "expected t hole"),
        ("hole", "'' is not a whole number; expected t hole"),
        ("interpolateboundary 1/0/0 3", r"refers to 3; expected .* 1 \(edges and corners\)"),
        ("creasemethod 0/0/1 other", "t creasemethod is not read but with normal or chaikin"),
        ("smoothtriangles 0/0/1 smooth", "t smoothtriangles is not read but with catmark"),
        ("vertexedit 2/3/2 0 0 1 1 1 set P", "t vertexedit is not read, and the surface depends"),
        ("edgeedit 2/1/1 0 0 1 sharpness", "t edgeedit is not read.*remove the line to have the"),
        ("faceedit 1/0/1 0 hole", "t faceedit is not read"),
        ("", "t  is not read"),
    ],
)
def test_other_tags_are_refused_with_their_line(tag: str, message: str) -> None:
    with pytest.raises(InputError, match=f"^file, line 42: {message}"):
        tagged(tag)


def test_a_mesh_of_holes_alone_is_refused() -> None:
    with pytest.raises(InputError, match=r"^file: the tags make every face a hole; expected"):
        tagged("hole 16/0/0 " + " ".join(map(str, range(16))))

"""Head, hands and feet of bodies of the model."""

from functools import cache

import numpy as np
import pytest
import scipy
import trimesh

from bodymeasure.atlas import GivenLength
from bodymeasure.errors import InputError
from bodymeasure.extremities import extremity_lengths
from bodymeasure.extremities.places import GLABELLA, HEAD, Region, places
from bodymeasure.fit.model import body_model, shaped
from bodymeasure.samples import load_sample
from bodymeasure.subdivision import QuadMesh, limit_positions, subdivide, triangles

SHAPE = np.random.default_rng(4).standard_normal(40)
BODY = shaped(SHAPE)
QUADS = body_model().quads
SIDED: tuple[str, ...] = (
    "hand_length",
    "palm_length",
    "hand_breadth",
    "hand_girth",
    "foot_length",
    "foot_breadth",
)
SIDED += ("foot_girth", "instep_girth", "heel_girth")
KEYS = {"stature", "head_girth", "head_length", "head_breadth", "head_height"}
KEYS |= {f"{key}_{side}" for key in SIDED for side in ("left", "right")}


@cache
def lengths() -> dict[str, GivenLength]:
    return extremity_lengths(BODY, QUADS)


@cache
def fine() -> trimesh.Trimesh:
    """The limit surface as triangles, four to a quad's side."""
    mesh = subdivide(subdivide(QuadMesh(BODY, QUADS)))
    return trimesh.Trimesh(limit_positions(mesh), triangles(mesh.quads), process=False)


def test_all_are_found_and_are_those_of_a_grown_up() -> None:
    found = lengths()
    assert set(found) == KEYS
    for key, length in found.items():
        assert length.uncertainty == 0.0
        assert length.error_estimate < 5e-4, key
    value = {key: length.value for key, length in found.items()}
    assert 1.4 < value["stature"] < 2.0
    assert 0.105 < value["hand_length_left"] / value["stature"] < 0.125
    assert 0.13 < value["foot_length_left"] / value["stature"] < 0.17
    assert 0.5 < value["palm_length_left"] / value["hand_length_left"] < 0.65
    assert value["head_girth"] > np.pi * value["head_breadth"]
    assert value["head_girth"] < np.pi * value["head_length"]


def test_stature_is_that_of_another_program() -> None:
    # A chord of the finest triangles lies below the surface by this much at most.
    assert fine().bounds[1, 2] == pytest.approx(lengths()["stature"].value, abs=1e-4)


def test_the_head_girth_is_that_of_another_program() -> None:
    limit = limit_positions(QuadMesh(BODY, QUADS))
    skull = limit[places().region == Region.SKULL]
    brow = limit[GLABELLA]
    back = skull[np.argmax(np.linalg.norm(skull - brow, axis=1))]
    left, right = limit[list(places().landmarks["ear"])]
    normal = np.cross(back - brow, left - right)
    section = fine().section(plane_origin=brow, plane_normal=normal)
    assert section is not None
    # The plane passes above the ears of this body, and below the head lies nothing.
    flat = section.vertices @ np.linalg.svd(normal[None])[2][1:].T
    girth = scipy.spatial.ConvexHull(flat).area
    assert girth == pytest.approx(lengths()["head_girth"].value, abs=1e-3)
    assert np.isin(places().region, HEAD).sum() > 3000


def test_turning_and_scaling_change_nothing_else() -> None:
    turn = 0.7
    rotation = np.array(
        [[np.cos(turn), -np.sin(turn), 0.0], [np.sin(turn), np.cos(turn), 0.0], [0.0, 0.0, 1.0]]
    )
    moved = extremity_lengths(1000.0 * (BODY @ rotation.T + [0.3, -2.0, 0.0]), QUADS)
    for key, length in lengths().items():
        # Where the palm is the widest is looked for at a few places.
        assert moved[key].value == pytest.approx(1000.0 * length.value, rel=1e-5), key


@pytest.mark.slow
def test_both_sides_of_a_mirrored_body_change_places() -> None:
    mean = body_model().mean
    found = extremity_lengths(mean, QUADS)
    for key in SIDED:
        left, right = (found[f"{key}_{side}"].value for side in ("left", "right"))
        # The model's mean is symmetric to 0.3 mm.
        assert left == pytest.approx(right, abs=1e-3), key


def test_what_the_scan_does_not_show_has_no_length() -> None:
    region = places().region
    distance = np.full(len(BODY), 0.002)
    distance[region == Region.LEFT_HAND] = np.nan
    found = extremity_lengths(BODY, QUADS, distance=distance)
    assert KEYS - set(found) == {f"{key}_left" for key in SIDED if "hand" in key or "palm" in key}
    assert found["stature"].uncertainty == pytest.approx(0.002, rel=1e-12)
    assert found["head_girth"].uncertainty > found["head_length"].uncertainty > 0.002
    assert found["stature"].value == lengths()["stature"].value


def test_a_length_needs_its_ends() -> None:
    """A scan that ends at the forehead, or above the ankles, shows most of head and legs."""
    limit = limit_positions(QuadMesh(BODY, QUADS))
    distance = np.full(len(BODY), 0.002)
    crown = distance.copy()
    crown[limit[:, 2] > limit[:, 2].max() - 0.05] = np.nan
    found = extremity_lengths(BODY, QUADS, distance=crown)
    assert KEYS - set(found) == {"stature", "head_height"}
    feet = distance.copy()
    feet[limit[:, 2] < 0.1] = np.nan
    found = extremity_lengths(BODY, QUADS, distance=feet)
    assert "stature" not in found
    assert "foot_length_left" not in found
    assert "head_height" in found


def test_another_mesh_is_refused() -> None:
    with pytest.raises(InputError, match=r"vertices of shape \(10, 3\); expected \(13380, 3\)"):
        extremity_lengths(np.zeros((10, 3)), QUADS)


@pytest.mark.parametrize(
    ("name", "stature"), [("female_average", 1.605), ("male_average", 1.748), ("female_old", 1.594)]
)
def test_samples_have_their_stature(name: str, stature: float) -> None:
    # Their titles give the height of the control mesh, which lies outside by a millimeter or so.
    given = load_sample(name).given
    assert set(given) == KEYS
    assert given["stature"].value == pytest.approx(stature, abs=2e-3)

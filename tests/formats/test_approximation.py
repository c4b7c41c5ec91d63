"""What the patches of a mesh approximate, kept by the atlas and its files."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.files.format_atlases import ONE_PATCH_A_QUAD, UNIT, read, write
from helpers.surfaces.solids import CUBE, NO_CREASES, blob, icosphere, obj_text

from bodymeasure import (
    Approximation,
    ApproximationKind,
    Atlas,
    InputError,
    Plane,
    Unit,
    approximation_error,
    body_girth,
    load_sample,
    plane_girth,
    tessellate,
)
from bodymeasure.atlas import approximation_sentences
from bodymeasure.atlas.approximation import extent
from bodymeasure.formats.npz import read_bodies, write_bodies
from bodymeasure.formats.options import ReadOptions
from bodymeasure.formats.registry import FORMATS, decode
from bodymeasure.subdivision import PolygonMesh

TEXT = obj_text(CUBE)
ATLAS = read(TEXT.encode(), "obj", ONE_PATCH_A_QUAD)


def approximation(atlas: Atlas) -> Approximation:
    assert atlas.approximation is not None
    return atlas.approximation


def largest(atlas: Atlas) -> float:
    return float(extent(atlas.points) * approximation(atlas).distance.max())


def test_a_small_mesh_is_refined_to_a_part_of_its_edge() -> None:
    atlas = read(TEXT.encode(), "obj")
    assert (len(ATLAS), len(atlas)) == (6, 6 * 4**3)
    assert largest(atlas) < 1e-4 < 0.008 < largest(ATLAS)
    # With 24 quads of more curvature, 500 patches are not enough.
    assert len(read(obj_text(blob(1)).encode(), "obj")) == 24 * 4**2


def test_a_mesh_is_refined_to_a_given_deviation() -> None:
    fine = read(TEXT.encode(), "obj", ReadOptions(unit=UNIT, deviation=1e-5))
    assert len(fine) == 6 * 4**4
    assert largest(fine) < 1e-5
    with pytest.raises(InputError, match=r"^file: 6144 patches still deviate by 5.3e-07 from"):
        read(TEXT.encode(), "obj", ReadOptions(unit=UNIT, deviation=1e-9))
    patches = write(ATLAS, "bpt")
    with pytest.raises(InputError, match=r"^file: holds patches and no mesh; leave the deviation"):
        read(patches, "bpt", ReadOptions(unit=UNIT, deviation=1.0))


@pytest.mark.parametrize("form", ["atlas", "npz"])
def test_files_of_our_own_keep_it(form: str) -> None:
    for atlas in (ATLAS, read(TEXT.encode(), "obj")):
        assert approximation(read(write(atlas, form), form)).is_same(atlas.approximation)
    exact = replace(ATLAS, approximation=None)
    assert read(write(exact, form), form).approximation is None
    assert b"approximation" not in write(exact, form)


def test_it_stays_true_under_motion_scale_and_unit() -> None:
    sentences = approximation_sentences(ATLAS)
    assert "within 0.0086 cm of it" in sentences[0]
    assert sentences[1].startswith("The mesh itself lies within 0.43 cm of the patches")
    assert "within 0.086 mm of it" in approximation_sentences(ATLAS, "mm")[0]
    assert "within 0.086 mm of it" in approximation_sentences(ATLAS.converted("mm"))[0]
    turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    moved = replace(ATLAS, points=100.0 * ATLAS.points @ turn + 50.0)
    assert "within 0.86 cm of it" in approximation_sentences(moved)[0]
    assert approximation_sentences(load_sample("paraboloid")) == ()


def test_a_part_keeps_its_own() -> None:
    rows = TEXT.split("f ", 1)
    text = f"{rows[0]}g first\nf {rows[1]}".replace("f 1 3 7 5", "g rest\nf 1 3 7 5").encode()
    whole = read(text, "obj", ONE_PATCH_A_QUAD)
    options = ReadOptions(unit=UNIT, groups=("first",), deviation=np.inf)
    part = read(text, "obj", options)
    assert 0 < len(part) < len(whole)
    assert largest(part) == pytest.approx(largest(whole), rel=1e-12)


def test_bodies_of_one_file_share_it() -> None:
    taller = replace(ATLAS, points=1.1 * ATLAS.points, name="taller")
    found = read_bodies(write_bodies([ATLAS, taller]), "file")
    assert all(approximation(each).is_same(ATLAS.approximation) for each in found)
    assert largest(found[1]) == pytest.approx(1.1 * largest(found[0]), rel=1e-12)
    with pytest.raises(InputError, match="approximates its surface in another way than the first"):
        write_bodies([ATLAS, replace(ATLAS, approximation=None)])


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('"distance": ', '"distance": -', "a distance that is negative or not finite"),
        ('"smoothed mesh"', '"mesh"', "Invalid enum value 'mesh'"),
        ('"mesh_rms"', '"rms"', "Object missing required field|unknown field `rms`"),
        ('"approximation": {', '"provenance": {"a": "b"}, "no": {', "unknown field `no`"),
    ],
)
def test_a_damaged_one_is_refused(old: str, new: str, message: str) -> None:
    content = write(ATLAS, "atlas").decode().replace(old, new)
    with pytest.raises(InputError, match=message):
        read(content.encode(), "atlas")


def test_numbers_without_their_kind_are_refused() -> None:
    lines = write(ATLAS, "atlas").decode().splitlines()
    content = "\n".join(line for line in lines if "approximation" not in line)
    with pytest.raises(InputError, match="has the distance or the stretch of an approximation"):
        read(content.encode(), "atlas")
    two = approximation(ATLAS).part(np.array([0, 1]), 1.0)
    with pytest.raises(InputError, match="has 2 numbers for 6 patches; expected one each"):
        replace(ATLAS, approximation=two)
    with pytest.raises(InputError, match="has 1 distances and 2 stretches"):
        Approximation(ApproximationKind.SMOOTHED, np.ones(1), np.ones(2), 0.0, 0.0, 0.0)


def test_a_length_differs_by_the_stretch_of_the_patches_below_it() -> None:
    patches = approximation(ATLAS)
    curve = np.array([[0.5, 0.5, 0.9], [0.5, 0.6, 0.9], [0.5, 0.6, 0.92]])
    top = int(np.argmax(ATLAS.control_points[..., 2].mean(axis=(1, 2))))
    expected = patches.stretch[top] * 0.12
    assert approximation_error(ATLAS, curve) == pytest.approx(expected, rel=1e-12)
    assert approximation_error(replace(ATLAS, approximation=None), curve) == 0.0
    assert approximation_error(ATLAS, curve[:1]) == 0.0
    with pytest.raises(InputError, match=r"positions have shape \(3,\); expected \(k, 3\)"):
        approximation_error(ATLAS, curve[0])


def girth(atlas: Atlas) -> float:
    plane = Plane(np.array([0.0, 0.0, 0.1]), np.array([0.3, 0.2, 1.0]))
    return plane_girth(atlas, plane, np.array([1.0, 0.0, 0.0])).contact


def test_a_sphere_of_triangles_has_its_girth_if_interpolated() -> None:
    text = obj_text(icosphere(2)).encode()
    smoothed, interpolated = (
        read(text, "obj", ReadOptions(unit=UNIT, interpolate=each, quads=True))
        for each in (False, True)
    )
    # It has too many patches to be refined.
    assert len(smoothed) == 3 * 320
    assert approximation(smoothed).mesh_lengths == pytest.approx(0.0098, abs=1e-4)
    height = 0.1 / np.linalg.norm([0.3, 0.2, 1.0])
    circle = 2.0 * np.pi * np.sqrt(1.0 - height**2)
    # A plane section of the triangles is 0.65 % short.
    assert girth(smoothed) / circle - 1.0 == pytest.approx(-0.019, abs=1e-3)
    assert abs(girth(interpolated) / circle - 1.0) < 5e-4
    found = approximation(interpolated)
    assert found.kind is ApproximationKind.INTERPOLATED
    assert found.mesh_lengths == pytest.approx(-0.0095, abs=1e-4)
    assert "through the vertices of a mesh" in approximation_sentences(interpolated)[0]
    assert "are about 0.95 % shorter" in approximation_sentences(interpolated)[1]


def test_a_surface_that_would_overshoot_is_refused(rng: np.random.Generator) -> None:
    through = ReadOptions(unit=UNIT, interpolate=True, quads=True)
    noisy = icosphere(3)
    radii = 1.0 + 0.2 * rng.normal(size=(len(noisy.vertices), 1))
    text = obj_text(noisy.with_vertices(radii * noisy.vertices))
    with pytest.raises(
        InputError, match=r"^file: a smooth surface .* overshoots: it lies .* from face \d+ \(line"
    ):
        read(text.encode(), "obj", through)
    with pytest.raises(InputError, match="holds patches and no mesh; leave the interpolation out"):
        read(write(ATLAS, "bpt"), "bpt", through)


@pytest.mark.slow
def test_a_body_of_triangles_has_its_girths_if_interpolated() -> None:
    body = load_sample("female_average")
    mesh = tessellate(body, 3)
    corners, sizes = mesh.faces.ravel(), np.full(len(mesh.faces), 3)
    text = obj_text(PolygonMesh(mesh.vertices, corners, sizes, NO_CREASES)).encode()
    for interpolate, low, high in ((False, -7e-3, -6e-3), (True, 0.0, 4e-4)):
        options = ReadOptions(unit=Unit.M, axes=body.axes, interpolate=interpolate, quads=True)
        atlas = decode(text, "file", FORMATS["obj"], options)
        hip = body.position(body.landmarks["side hip point left"])
        change = body_girth(atlas, hip).contact - body_girth(body, "side hip point left").contact
        assert low < change < high

"""The message of a body: the smooth surface at the vertices, in meters, left, up and front."""

from dataclasses import replace

import numpy as np
import pytest
from bodymeasure.viewer.content.answers import answer
from bodymeasure.viewer.content.bodies import Bodies
from bodymeasure.viewer.content.body import body_message, layout_of
from bodymeasure.viewer.content.requests import ShowBody
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.content.wire import unpacked
from helpers.surfaces.grids import grid_atlas

from bodymeasure import Atlas, AtlasPoint, Axes, Unit, boundary_lengths, load_sample
from bodymeasure.errors import InputError


def test_a_vertex_is_where_its_number_says(female: ShownBody, rng: np.random.Generator) -> None:
    header, arrays = unpacked(body_message(female))
    steps = header["segments"] + 1
    flat = arrays["positions"].reshape(-1, 3)
    assert len(flat) == header["patches"] * steps**2
    for _ in range(20):
        patch, row, column = rng.integers([len(female.atlas), steps, steps]).tolist()
        place = AtlasPoint(patch, row / header["segments"], column / header["segments"])
        x, y, z = female.atlas.position(place)
        # The sample's axes are x to the left, -y to the front and z up.
        found = flat[patch * steps**2 + row * steps + column]
        np.testing.assert_allclose(found, (x, z, -y), atol=1e-7)
    low, high = np.array(header["bounds"])
    np.testing.assert_allclose(low, flat.min(axis=0), atol=1e-7)
    np.testing.assert_allclose(high, flat.max(axis=0), atol=1e-7)


def test_normals_point_out_of_the_body(female: ShownBody) -> None:
    _, arrays = unpacked(body_message(female))
    normals, positions = arrays["normals"].reshape(-1, 3), arrays["positions"].reshape(-1, 3)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-6)
    # The flux of the position through a closed surface is three times its volume, and positive.
    assert (normals * (positions - positions.mean(axis=0))).sum(axis=1).mean() > 0.05
    turned = replace(female, atlas=replace(female.atlas, index=female.atlas.index[:, ::-1].copy()))
    _, others = unpacked(body_message(turned))
    np.testing.assert_allclose(others["normals"][:, ::-1], arrays["normals"], atol=1e-6)


@pytest.mark.parametrize("unit", ["m", "cm", "mm", "inch"])
def test_positions_are_in_meters_whatever_the_unit(unit: str) -> None:
    atlas = grid_atlas(1, 2)
    header, arrays = unpacked(body_message(ShownBody("0", replace(atlas, unit=Unit(unit)), "Grid")))
    meters = replace(atlas, unit=Unit(unit)).unit.meters
    expected = np.ptp(atlas.points, axis=0) * meters
    extent = np.ptp(arrays["positions"].reshape(-1, 3), axis=0)
    np.testing.assert_allclose(sorted(extent), sorted(expected), rtol=1e-6, atol=1e-9)
    assert header["unit"] == unit


def test_the_axes_of_the_file_become_left_up_and_front() -> None:
    points = np.zeros((16, 3))
    grid = np.stack(np.meshgrid(range(4), range(4), indexing="ij"), axis=-1).reshape(-1, 2)
    # A sheet that spans one unit to the left and two upwards, with up along -y and front along +x.
    points[:, 2], points[:, 1] = grid[:, 0] / 3.0, -grid[:, 1] * 2.0 / 3.0
    atlas = Atlas(points, np.arange(16).reshape(1, 4, 4), Unit.M, axes=Axes("-y", "+x"))
    _, arrays = unpacked(body_message(ShownBody("0", atlas, "Sheet")))
    extent = np.ptp(arrays["positions"].reshape(-1, 3), axis=0)
    np.testing.assert_allclose(extent, [1.0, 2.0, 0.0], atol=1e-7)
    assert arrays["positions"][..., 1].min() == 0.0


def test_seams_run_along_the_edges_of_the_triangles(female: ShownBody) -> None:
    _, arrays = unpacked(body_message(female))
    vertices = {tuple(place) for place in arrays["positions"].reshape(-1, 3).tolist()}
    seams = arrays["seams"]
    on_vertices = [tuple(place) in vertices for place in seams.reshape(-1, 3).tolist()]
    assert np.mean(on_vertices) > 0.999
    # Each edge once: two sides of patches share one, but for the boundary.
    lengths = np.linalg.norm(np.diff(seams, axis=1), axis=-1).sum(axis=1)
    sides = boundary_lengths(female.atlas).length
    assert sides.sum() / 2.0 < lengths.sum() < sides.sum()


def test_the_header_says_what_is_known(bodies: Bodies) -> None:
    message = answer(bodies, ShowBody())
    assert isinstance(message, bytes)
    header, _ = unpacked(message)
    atlas = bodies["0"].atlas
    assert header["patch_names"] == list(atlas.patch_names)
    regions = [header["regions"][number] for number in header["patch_region"]]
    assert regions == list(atlas.regions)
    marks = {mark["name"]: mark for mark in header["landmarks"]}
    assert list(marks) == list(atlas.landmarks)
    nape = marks["back neck point"]
    assert nape["location"] == list(atlas.landmarks["back neck point"])
    x, y, z = atlas.position(atlas.landmarks["back neck point"])
    np.testing.assert_allclose(nape["position"], (x, z, -y), rtol=1e-15)
    lacking = {one["name"]: one["text"] for one in header["lacking"]}
    assert lacking["top of head"] == "the highest point of the head"
    assert not set(lacking) & set(atlas.landmarks)
    assert [one["key"] for one in header["sets"]][:2] == ["default", "core"]
    assert header["can"]["save_atlas"] is False


def test_many_patches_are_drawn_more_coarsely() -> None:
    assert ShownBody("0", grid_atlas(2, 2), "Few").segments == 16
    assert ShownBody("0", grid_atlas(40, 30), "Many").segments == 8


def test_bodies_on_one_layout_have_one_hash() -> None:
    female, male = load_sample("female_average"), load_sample("male_average")
    assert layout_of(female) == layout_of(male)
    assert layout_of(female) != layout_of(replace(female, index=female.index[:, ::-1].copy()))
    assert layout_of(grid_atlas(1, 2)) != layout_of(grid_atlas(2, 1))


def test_a_body_that_is_not_open_is_told(bodies: Bodies) -> None:
    with pytest.raises(InputError, match="no body is open as '7' any more; open its file again"):
        answer(bodies, ShowBody(body="7"))

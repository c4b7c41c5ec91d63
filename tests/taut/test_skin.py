import numpy as np
import pytest
from helpers.surfaces.extruded_surfaces import HILL, RIDGE, row_of

import bodymeasure as bm
from bodymeasure._typing import Ints
from bodymeasure.atlas import edge_table, weld
from bodymeasure.atlas.queries.closest import closest_points
from bodymeasure.atlas.queries.outside import _caps, outward_signs
from bodymeasure.bezier import derivatives, elevate, evaluate
from bodymeasure.bezier.power_form import jets, power_coefficients
from bodymeasure.taut.skin import Skin, skin_of

SIDE = np.linspace(0.0, 1.0, 5)
GRID = np.stack(np.meshgrid(SIDE, SIDE, indexing="ij"), axis=-1)


def turned(atlas: bm.Atlas, patches: Ints) -> bm.Atlas:
    """The same surface with u and v swapped on some patches, so that these face the other way."""
    index = atlas.index.copy()
    index[patches] = index[patches].transpose(0, 2, 1)
    return bm.Atlas(atlas.points, index, atlas.unit)


@pytest.mark.parametrize(("degree", "coordinates"), [(3, 3), (3, 4), (5, 3), (9, 3), (9, 4)])
def test_jets_are_the_derivatives(degree: int, coordinates: int, rng: np.random.Generator) -> None:
    nets, x = rng.normal(size=(7, degree + 1, degree + 1, coordinates)), rng.random((7, 2))
    if coordinates == 4:
        nets[..., 3] = rng.uniform(0.5, 2.0, nets.shape[:-1])
    found = jets(power_coefficients(nets), x)
    expected = derivatives(nets, x, order=2)
    # The terms of high powers cancel one another.
    cancelled = 1e-11 * 10.0 ** (degree - 3)
    np.testing.assert_allclose(found, expected, atol=cancelled * np.abs(expected).max())


@pytest.mark.parametrize("degree", [5, 9])
def test_the_outside_of_open_parts_does_not_depend_on_the_degree(degree: int) -> None:
    body = bm.load_sample("female_average")
    nets = elevate(body.control_points, degree, degree)
    points, index = weld(nets)
    raised = bm.Atlas(points, index, body.unit)
    swapped = np.arange(0, len(body), 3)
    for atlas in (body, raised):
        atlas = turned(atlas, swapped)
        samples = evaluate(atlas.control_points, np.broadcast_to(GRID, (len(atlas), *GRID.shape)))
        signs = outward_signs(atlas, samples, edge_table(atlas.index), "determined")
        assert (signs[swapped] == -1.0).all()
        assert (np.delete(signs, swapped) == 1.0).all()
        area, volume = _caps(samples, edge_table(atlas.index), signs, np.zeros(len(atlas), int))
        if atlas.degree == 3:
            known = area, volume
    np.testing.assert_allclose((area, volume), known, rtol=1e-9)


@pytest.mark.parametrize("name", ["female_average", "male_average"])
def test_feet_are_the_closest_points_of_a_body(name: str, rng: np.random.Generator) -> None:
    body = bm.load_sample(name)
    near = body.points[rng.integers(len(body.points), size=300)]
    positions = near + 0.03 * rng.normal(size=near.shape)
    feet = skin_of(body, "determined").feet(positions)
    _, distances = closest_points(body, positions)
    found = np.linalg.norm(positions - feet.position, axis=1)
    # Far from the skin, feet on another part of it may be nearer by less than the samples tell.
    np.testing.assert_allclose(found, distances, rtol=1e-3, atol=1e-12)
    assert np.count_nonzero(found <= distances * (1.0 + 1e-9) + 1e-12) >= 295


def test_gaps_are_signed_distances(rng: np.random.Generator) -> None:
    body = bm.load_sample("female_average")
    skin = skin_of(body, "determined")
    patch, x = rng.integers(len(body), size=100), rng.uniform(0.2, 0.8, (100, 2))
    s = derivatives(body.control_points[patch], x, order=1)
    normal = np.cross(s[:, 1, 0], s[:, 0, 1])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    # The samples face outwards, as `tests/test_samples.py` checks.
    for far in (-1e-3, 1e-3):
        feet = skin.feet(s[:, 0, 0] + far * normal)
        np.testing.assert_allclose(feet.gap, far, rtol=1e-9)
        np.testing.assert_allclose(feet.normal, normal, atol=1e-9)
        np.testing.assert_allclose(feet.depth, max(0.0, -far), rtol=1e-9, atol=1e-15)


def test_the_bend_is_the_derivative_of_the_normal(rng: np.random.Generator) -> None:
    ridge = row_of(RIDGE)
    skin = Skin(ridge, "along normals")
    positions = np.stack(
        [rng.uniform(-0.8, 0.8, 20), rng.uniform(0.5, 2.5, 20), np.zeros(20)], axis=1
    )
    positions[:, 2] = -(positions[:, 0] ** 2)
    bend, step = skin.feet(positions).bend, 1e-5
    for axis in range(3):
        move = step * np.eye(3)[axis]
        ahead, behind = (skin.feet(positions + sign * move).normal for sign in (1.0, -1.0))
        np.testing.assert_allclose((ahead - behind) / (2.0 * step), bend[:, axis], atol=1e-8)


@pytest.mark.parametrize("some", [slice(0, 0), slice(None), slice(0, None, 2), slice(5, 9)])
def test_the_outside_is_told_however_patches_face(some: slice) -> None:
    body = bm.load_sample("female_average")
    patches = np.arange(len(body))[some]
    signs = Skin(turned(body, patches), "determined").signs
    expected = np.ones(len(body))
    expected[patches] = -1.0
    np.testing.assert_array_equal(signs, expected)


def test_the_outside_of_a_part_is_told_where_it_is_cut_off() -> None:
    body = bm.load_sample("female_average")
    chosen = [i for i, region in enumerate(body.regions) if "arm" in region or "elbow" in region]
    arms = bm.Atlas(body.points, body.index[chosen], body.unit)
    np.testing.assert_array_equal(Skin(arms, "determined").signs, 1.0)
    np.testing.assert_array_equal(
        Skin(turned(arms, np.arange(len(arms))), "determined").signs, -1.0
    )


def test_an_open_sheet_has_no_outside_but_the_one_that_is_said() -> None:
    hill = row_of(*HILL)
    with pytest.raises(
        bm.InputError, match="outside of patch 'patch 0' and 2 more cannot be determined"
    ):
        Skin(hill, "determined")
    above, below = Skin(hill, "along normals"), Skin(hill, "against normals")
    np.testing.assert_array_equal(above.signs, -below.signs)
    assert above.feet(np.array([[0.1, 1.5, 2.5]])).gap[0] > 0.4
    assert below.feet(np.array([[0.1, 1.5, 2.5]])).gap[0] < -0.4


def test_a_strip_with_one_side_is_refused() -> None:
    band = 12
    angle = np.linspace(0.0, 2.0 * np.pi, band * 3, endpoint=False)
    across = np.linspace(-0.5, 0.5, 4)
    radius = 3.0 + across * np.cos(0.5 * angle)[:, None]
    height = across * np.sin(0.5 * angle)[:, None]
    rows = np.stack(
        [radius * np.cos(angle)[:, None], radius * np.sin(angle)[:, None], height], axis=-1
    )
    number = np.arange(band * 12).reshape(-1, 4)
    # After one turn the two edges have changed places.
    number = np.concatenate([number, number[:1, ::-1]])
    index = np.array([number[3 * i : 3 * i + 4] for i in range(band)])
    with pytest.raises(bm.InputError, match="only one side, like a Moebius band"):
        Skin(bm.Atlas(rows.reshape(-1, 3), index, bm.Unit.CM), "determined")

"""Paths between points on seams and corners and beside them, held to each other."""

from functools import cache

import numpy as np
import pytest
from helpers.many_patches import SURFACES
from helpers.oracles.free import contradictions, moved
from helpers.surfaces.near_boundaries import Triple, near_triples, on_both_sides
from hypothesis import HealthCheck, given, settings

import bodymeasure as bm

# Surfaces without poles, with the number of triples of points that are tried on each.
EXAMPLES = {"torus": 8, "random 1": 12, "random 2": 12, "female_average": 4, "male_average": 4}
TURNED = cache(moved)


@pytest.mark.slow
@pytest.mark.parametrize("name", EXAMPLES)
def test_paths_between_points_near_boundaries_agree(name: str) -> None:
    atlas = SURFACES[name]()

    @settings(max_examples=EXAMPLES[name], deadline=None, suppress_health_check=list(HealthCheck))
    @given(near_triples(atlas))
    def agree(points: Triple) -> None:
        assert not list(contradictions(atlas, points, TURNED(atlas, 1)))

    agree()


@pytest.mark.parametrize("exponents", [(-11.0, -9.6), (-15.0, -7.0)])
@pytest.mark.parametrize(("patch", "side", "along"), [(5, 0, 0.189), (9, 3, 1e-9)])
def test_points_beside_one_another_on_both_sides_of_a_seam_are_measured(
    patch: int, side: int, along: float, exponents: tuple[float, float]
) -> None:
    torus = SURFACES["torus"]()
    start, end = on_both_sides(torus, patch, side, along, exponents)
    apart = np.linalg.norm(torus.position(start) - torus.position(end))
    for ends in ((start, end), (end, start)):
        path = bm.geodesic_between(torus, *ends)
        assert abs(path.length - apart) <= path.error_estimate + 1e-6 * apart + 1e-15


# Newton's method does not come to rest here: of such parameters near 1, seven digits count.
@pytest.mark.parametrize(
    "ends",
    [
        ((223, 9.533013478487178e-08, 1.0), (225, 2.4966522134831804e-08, 0.0)),
        ((322, 0.29583606205699475, 0.9999999926305327), (372, 6.139e-07, 0.7041639379430052)),
    ],
)
def test_points_that_differ_in_their_last_digits_are_measured(
    ends: tuple[tuple[int, float, float], tuple[int, float, float]],
) -> None:
    body = bm.load_sample("female_average")
    start, end = (bm.AtlasPoint(*point) for point in ends)
    apart = np.linalg.norm(body.position(start) - body.position(end))
    path = bm.geodesic_between(body, start, end)
    # The seams are nearly smooth.
    assert apart - path.error_estimate <= path.length <= (1.0 + 1e-3) * apart


# Triples that contradicted each other: pieces of a billionth of the path were held in a corner, a
# route round a corner was not tried again from a better start, and on the sphere a path turned back
# at a line about the pole.
CONTRADICTED = (
    (
        "female_average",
        (171, 8.272916236939028e-08, 5.86216732170168e-11),
        (172, 3.647100577391635e-08, 0.9999999999413783),
        (192, 1.0, 5.373270405991794e-07),
    ),
    ("female_heavy", (89, 1.0, 1.0), (241, 0.5532898410251491, 1.0), (89, 1.0, 0.9999999999999625)),
    ("male_average", (89, 1.0, 1.0), (241, 0.5532898410251491, 1.0), (89, 1.0, 0.9999999999999625)),
    (
        "random 2",
        (14, 2.1819276946335369e-10, 1.0629506279378549e-08),
        (10, 0.9999999999999784, 1.0629506279378549e-08),
        (4, 0.0, 1.0),
    ),
    (
        "sphere",
        (2, 6.266302972454985e-13, 0.2254689782279905),
        (1, 0.9999999808679201, 0.2254689782279905),
        (2, 0.0, 0.8433197150157207),
    ),
)


@pytest.mark.parametrize(
    ("name", "first", "second", "third"),
    [
        pytest.param(*each, marks=pytest.mark.slow if each[0] in bm.sample_names() else ())
        for each in CONTRADICTED
    ],
)
def test_paths_that_contradicted_each_other_agree(
    name: str,
    first: tuple[int, float, float],
    second: tuple[int, float, float],
    third: tuple[int, float, float],
) -> None:
    points = bm.AtlasPoint(*first), bm.AtlasPoint(*second), bm.AtlasPoint(*third)
    assert not list(contradictions(SURFACES[name](), points))

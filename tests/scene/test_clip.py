import numpy as np
from helpers.charts.straight_survey import straight_survey

from bodymeasure.atlas import Atlas
from bodymeasure.scene import Surface, body_scene
from bodymeasure.scene.clip import clipped


def area(surface: Surface) -> float:
    a, b, c = np.moveaxis(surface.points[surface.triangles], 1, 0)
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=-1).sum() / 2)


def test_a_plane_cuts_a_square_exactly(square: Atlas) -> None:
    surface = body_scene(straight_survey(square), segments=3).surface
    part = clipped(surface, surface.points @ [1.0, 0.0, 0.5] - 0.07)
    # Of the square of side 0.1, what lies below x + z / 2 = 0.07: a trapezium.
    np.testing.assert_allclose(area(part), 0.1 * (0.07 + 0.02) / 2, rtol=1e-12)
    used = part.points[part.triangles]
    assert (used @ [1.0, 0.0, 0.5]).max() <= 0.07 + 1e-15


def test_both_sides_of_a_cut_make_the_whole(body: Atlas) -> None:
    surface = body_scene(straight_survey(body), segments=2).surface
    height = surface.points @ body.axes.up_vector - 0.9
    lower, upper = clipped(surface, height), clipped(surface, -height)
    np.testing.assert_allclose(area(lower) + area(upper), area(surface), rtol=1e-12)
    for part in (lower, upper):
        assert len(part.patch) == len(part.triangles)
        np.testing.assert_array_equal(len(part.faded), len(part.points))


def test_nothing_is_cut_off_what_lies_below(square: Atlas) -> None:
    surface = body_scene(straight_survey(square)).surface
    part = clipped(surface, np.full(len(surface.points), -1.0))
    np.testing.assert_array_equal(part.triangles, surface.triangles)

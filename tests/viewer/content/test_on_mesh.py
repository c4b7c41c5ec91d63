"""Lengths over triangles come near those over patches, and are not made from them."""

import numpy as np
import pytest
from bodymeasure.viewer.content.on_mesh import mesh_answer
from bodymeasure.viewer.content.requests import MeasureOnMesh
from bodymeasure.viewer.content.shown import ShownBody

import bodymeasure as bm


@pytest.mark.slow
def test_paths_over_triangles_are_as_long_as_over_patches() -> None:
    body = ShownBody("0", bm.load_sample("female_average"), "Average")
    names = (
        ("side neck point left", "bust point left"),
        ("front waist point", "crotch point", "back waist point"),
    )
    tapes = tuple(tuple(tuple(body.atlas.landmarks[name]) for name in each) for each in names)
    told: list[tuple[int, int]] = []
    found = mesh_answer(body, MeasureOnMesh(tapes=tapes), lambda *done: told.append(done))
    assert told == [(1, 2), (2, 2)]
    for length, (start, *via, end) in zip(found["lengths"], names, strict=True):
        smooth = bm.geodesic_between(body.atlas, start, end, via).length
        assert length == pytest.approx(smooth, rel=3e-4)
        # Were it the same number, it would prove nothing.
        assert abs(length / smooth - 1.0) > 1e-9


def test_what_has_no_length_on_a_mesh_has_none() -> None:
    body = bm.load_sample("female_average")
    used, index = np.unique(body.index[[15, 173]], return_inverse=True)
    apart = bm.Atlas(body.points[used], index.reshape(-1, 4, 4), body.unit, axes=body.axes)
    request = MeasureOnMesh(tapes=(((0, 0.5, 0.5), (1, 0.5, 0.5)), ((0, 0.5, 0.5), (0, 0.9, 0.5))))
    lengths = mesh_answer(ShownBody("0", apart, "Apart"), request)["lengths"]
    assert lengths[0] is None
    assert lengths[1] > 0.0

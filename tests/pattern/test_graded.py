"""Patterns in several sizes."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.panels import cylinder, four_geodesics, interpolated

import bodymeasure as bm


def test_each_size_is_cut_on_its_own_body() -> None:
    body = interpolated(cylinder)
    bodies = {"S": body, "L": replace(body, points=1.2 * body.points)}
    seen: list[tuple[int, int]] = []
    graded = bm.grade_pattern(
        bodies, four_geodesics(), progress=lambda done, all_: seen.append((done, all_))
    )
    assert graded.sizes == ("S", "L")
    assert seen == [(1, 2), (2, 2)]
    small, large = (graded[size].pieces[0] for size in graded.sizes)
    for edge in small.edges:
        assert large.edge(edge.name).length == pytest.approx(1.2 * edge.length, rel=1e-9)
    assert graded.is_sound
    assert graded.warnings == ()
    assert repr(graded) == "<GradedPattern 'panel': 1 piece in 2 sizes>"


def test_what_is_wrong_names_the_size() -> None:
    body = interpolated(cylinder)
    bare = bm.Atlas(body.points, body.index, body.unit)
    with pytest.raises(bm.InputError, match="size 'L': panel 'panel' needs the landmark"):
        bm.grade_pattern({"S": body, "L": bare}, four_geodesics())
    for wrong, words in (({}, "is empty"), ([body], "mapping"), ({"S": np.zeros(3)}, "atlas")):
        with pytest.raises(bm.InputError, match=words):
            bm.grade_pattern(wrong, four_geodesics())  # type: ignore[arg-type]

"""All files of a pattern, and of one in several sizes, written at once."""

import json
from dataclasses import replace
from pathlib import Path

import pytest
import shapely
from helpers.panels import cylinder, four_geodesics, interpolated

import bodymeasure as bm
from bodymeasure.errors import InputError
from bodymeasure.pattern import PieceEdge, pattern_json
from bodymeasure.pattern.files.layout import sheet_of


def graded(pattern: bm.Pattern, *sizes: str) -> bm.GradedPattern:
    return bm.GradedPattern(pattern.definitions, dict.fromkeys(sizes, pattern))


def test_all_files_are_written(bodice: bm.Pattern, tmp_path: Path) -> None:
    files = bm.write_pattern(bodice, tmp_path / "out", pictures=False)
    assert len(files) == 7
    assert set((tmp_path / "out").iterdir()) == set(files)
    assert all(file.stat().st_size > 1000 for file in files)


def test_the_report_says_for_which_ease_pieces_are() -> None:
    definitions, body = four_geodesics(), interpolated(cylinder)
    made = bm.make_pattern(body, definitions, ease={"m": 0.04}, bridge=True)
    content = json.loads(pattern_json(made))
    assert content["ease"] == {"m": 40.0}
    assert content["bridge"] is True
    plain = json.loads(pattern_json(bm.make_pattern(body, definitions)))
    assert (plain["ease"], plain["bridge"]) == ({}, False)


@pytest.mark.slow
def test_sizes_have_folders_beside_what_holds_all(bodice: bm.Pattern, tmp_path: Path) -> None:
    both = graded(bodice, "S", "L")
    files = bm.write_pattern(both, tmp_path, formats=("dxf", "svg", "json"))
    names = [str(file.relative_to(tmp_path)) for file in files]
    each = ["pattern.svg", "pattern.dxf", "pattern.json"]
    assert names == [*each[:2], *(f"{size}/{name}" for size in "SL" for name in each)]


@pytest.mark.parametrize(
    ("members", "words"),
    [
        ({"formats": ("svg", "png")}, "no format is named 'png'"),
        ({"paper": "b4"}, "no paper is named 'b4'"),
        ({"allowance": -1.0}, "allowance is -1.0; expected millimeters"),
    ],
)
def test_what_is_wrong_leaves_nothing(
    bodice: bm.Pattern, members: dict[str, object], words: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=words):
        bm.write_pattern(bodice, tmp_path / "out", **members)  # type: ignore[arg-type]
    assert not (tmp_path / "out").exists()


def test_sizes_that_lead_elsewhere_are_refused(bodice: bm.Pattern, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot name a folder"):
        bm.write_pattern(graded(bodice, "S", "../L"), tmp_path / "out")
    assert [*tmp_path.iterdir()] == []


def test_pieces_of_all_sizes_lie_at_one_point_and_do_not_meet_others(bodice: bm.Pattern) -> None:
    sheet = sheet_of(graded(bodice, "S", "L"), 10.0)
    areas = []
    for nest in sheet.nests:
        small, large = nest.pieces
        assert small.cut.tolist() == large.cut.tolist()
        (fold,) = (edge for edge in small.edges if edge.is_fold)
        lowest = min((fold.parts[0][0], fold.parts[-1][-1]), key=lambda point: float(point[1]))
        assert lowest.tolist() == pytest.approx([0.0, 0.0], abs=1e-9)
        areas.append(shapely.polygons(nest.on_sheet(small.cut)))
        words = shapely.box(*nest.marks.label.box)
        assert small.inner.contains(words)
        assert "sizes S, L" in nest.marks.label.lines
    assert shapely.distance(*areas) > 10.0


def test_each_size_says_its_name_where_it_is_alone(bodice: bm.Pattern) -> None:
    larger = tuple(
        replace(piece, edges=tuple(widened(edge) for edge in piece.edges), darts=())
        for piece in bodice.pieces
    )
    sizes = {"S": bodice, "L": replace(bodice, pieces=larger)}
    for nest in sheet_of(bm.GradedPattern(bodice.definitions, sizes), 10.0).nests:
        for number, place in enumerate(nest.size_places):
            own, other = nest.pieces[number].cut, nest.pieces[1 - number].cut
            assert shapely.distance(shapely.linearrings(own), shapely.points(place)) < 1e-9
            assert shapely.distance(shapely.linearrings(other), shapely.points(place)) > 5.0


def widened(edge: PieceEdge) -> PieceEdge:
    return replace(edge, parts=tuple(1.1 * part for part in edge.parts))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["female_full_bust", "male_average"])
@pytest.mark.parametrize("key", ["bodice", "princess", "skirt", "sleeve", "trousers"])
def test_marks_stay_inside_on_other_bodies(name: str, key: str) -> None:
    """Words, grain and fold inside each piece, notches in the allowance, no piece over another."""
    sheet = sheet_of(bm.make_pattern(bm.load_sample(name), key), 10.0)
    cuts = []
    for nest in sheet.nests:
        (piece,) = nest.pieces
        cut, inner, marks = shapely.polygons(piece.cut), piece.inner, nest.marks
        assert cut.is_valid
        assert inner.contains(shapely.box(*marks.label.box))
        assert marks.grain is not None
        assert inner.contains(shapely.linestrings(marks.grain))
        if marks.fold is not None:
            assert inner.buffer(1e-6).contains(shapely.linestrings(marks.fold))
        for notch in piece.notches:
            assert shapely.distance(cut.exterior, shapely.points(notch.line[0])) < 1e-6
            assert shapely.distance(inner, shapely.linestrings(notch.line)) > 1.0
        cuts.append(shapely.polygons(nest.on_sheet(piece.cut)))
    for number, one in enumerate(cuts):
        for other in cuts[:number]:
            assert shapely.distance(one, other) > 10.0

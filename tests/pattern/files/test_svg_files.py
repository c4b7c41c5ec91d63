"""The files of a pattern, read back."""

import json
from dataclasses import replace
from pathlib import Path

import msgspec
import numpy as np
import pytest
import shapely
from svgelements import SVG, Rect, Text
from svgelements import Path as DrawnPath

import bodymeasure as bm
from bodymeasure._typing import Complex
from bodymeasure.pattern import path_id, pattern_json, pattern_svg, strain_svg

# svgelements takes 96 pixels for an inch.
PIXELS = 96.0 / 25.4


def read(text: str, folder: Path) -> SVG:
    path = folder / "pattern.svg"
    path.write_text(text)
    return SVG.parse(str(path))


def points_of(path: DrawnPath) -> list[Complex]:
    result: list[list[complex]] = []
    for segment in path:
        if type(segment).__name__ == "Move":
            result.append([])
        if type(segment).__name__ in ("Move", "Line"):
            result[-1].append(complex(segment.end.x, segment.end.y) / PIXELS)
    return [np.array(chain) for chain in result]


def test_edges_have_their_lengths_on_the_skin(bodice: bm.Pattern, tmp_path: Path) -> None:
    pattern = bodice
    svg = read(pattern_svg(pattern), tmp_path)
    paths = {element.id: element for element in svg.elements() if isinstance(element, DrawnPath)}
    for piece in pattern.pieces:
        for edge in piece.edges:
            chains = points_of(paths[path_id(piece.name, "sew", edge.name)])
            length = sum(np.abs(np.diff(chain)).sum() for chain in chains)
            assert length == pytest.approx(1000.0 * edge.skin_length, abs=0.01)
        for dart in piece.darts:
            legs = points_of(paths[path_id(piece.name, "dart", dart.name)])
            for leg in legs:
                assert np.abs(np.diff(leg)).sum() == pytest.approx(1000.0 * dart.length, abs=0.01)
            assert abs(legs[0][0] - legs[1][0]) == pytest.approx(1000.0 * dart.intake, abs=0.01)
    squares = [e for e in svg.elements() if isinstance(e, Rect) and e.id == "test-square"]
    assert squares[0].width / PIXELS == pytest.approx(50.0, abs=1e-4)


@pytest.mark.parametrize("allowance", [0.0, 10.0])
def test_cut_lines_hold_the_sew_lines_and_the_words(
    bodice: bm.Pattern, allowance: float, tmp_path: Path
) -> None:
    pattern = bodice
    svg = read(pattern_svg(pattern, allowance=allowance), tmp_path)
    elements = [*svg.elements()]
    paths = {element.id: element for element in elements if isinstance(element, DrawnPath)}
    words = [element for element in elements if isinstance(element, Text)]
    for piece in pattern.pieces:
        (cut,) = points_of(paths[path_id(piece.name, "cut")])
        area = shapely.polygons(np.stack([cut.real, cut.imag], axis=1))
        assert shapely.is_valid(area)
        for edge in piece.edges:
            for chain in points_of(paths[path_id(piece.name, "sew", edge.name)]):
                sewn = shapely.points(chain.real, chain.imag)
                away = shapely.distance(shapely.boundary(area), sewn)
                assert shapely.dwithin(area, sewn, 1e-3).all()
                if edge.name == piece.panel.fold:
                    # The fold has no allowance.
                    assert away.max() < 1e-3
                else:
                    # Near the fold the cut line ends beside the sew line.
                    ends = np.abs(chain[:, None] - chain[[0, -1]]).min(axis=1)
                    assert away[ends > 16.0].min() >= allowance - 1e-3
        label = next(text for text in words if text.text == piece.name)
        assert area.contains(shapely.Point(label.x, label.y))


def test_the_report_says_what_the_pattern_holds(bodice: bm.Pattern) -> None:
    pattern = bodice
    content = json.loads(pattern_json(pattern))
    assert [piece["name"] for piece in content["pieces"]] == ["bodice front", "bodice back"]
    front = content["pieces"][0]
    assert front["rms_strain"] == pytest.approx(100.0 * pattern["bodice front"].rms_strain)
    assert front["rms_strain"] < front["strain_95"] < front["largest_strain"]
    assert {seam["name"] for seam in content["seams"]} == {"shoulder", "side"}
    assert all(abs(seam["difference"]) < 1e-6 for seam in content["seams"])
    for edge in front["edges"]:
        assert edge["length_in_piece"] == pytest.approx(edge["length_on_skin"], abs=1e-6)
    assert front["darts"][0]["intake"] == pytest.approx(77.0, abs=2.0)
    assert not content["warnings"]


def test_seams_of_unequal_edges_are_said(bodice: bm.Pattern) -> None:
    front, back = bodice.pieces
    edges = tuple(
        replace(edge, seam="side" if edge.name == "armscye" else "") for edge in back.edges
    )
    pattern = replace(bodice, pieces=(front, replace(back, edges=edges)))
    by = 1000.0 * (back.edge("armscye").length - front.edge("side").length)
    assert by < 0.0
    said = f"{-by:.1f} mm shorter than 'side' of 'bodice front'; let both lead"
    assert any(said in words for words in pattern.warnings)


def test_the_map_of_strains_colors_every_triangle(bodice: bm.Pattern) -> None:
    pattern = bodice
    text = strain_svg(pattern)
    triangles = sum(len(piece.flat.mesh.triangles) for piece in pattern.pieces)
    assert text.count("Z") == triangles


def test_names_from_files_are_escaped() -> None:
    definitions = bm.load_pattern("skirt")
    panel = msgspec.structs.replace(definitions.panel[1], name="<b>&\"'", cut="<i>")
    pattern = bm.make_pattern(
        bm.load_sample("female_average"),
        msgspec.structs.replace(definitions, panel=(panel,)),
        step=0.02,
    )
    for text in (pattern_svg(pattern), strain_svg(pattern)):
        assert "<b>" not in text
        assert "<i>" not in text

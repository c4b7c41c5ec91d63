"""The DXF file of a pattern, read back."""

import io

import numpy as np
import pytest
import shapely
from ezdxf.document import Drawing
from ezdxf.filemanagement import read as read_dxf

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.pattern import pattern_dxf


def read(content: bytes) -> Drawing:
    return read_dxf(io.StringIO(content.decode("cp1252").replace("\r\n", "\n")))


def lines(block: object, layer: str) -> list[Array]:
    found = block.query(f'POLYLINE[layer=="{layer}"]')  # type: ignore[attr-defined]
    return [np.array([(v.dxf.location.x, v.dxf.location.y) for v in one.vertices]) for one in found]


def points(block: object, layer: str) -> Array:
    found = block.query(f'POINT[layer=="{layer}"]')  # type: ignore[attr-defined]
    return np.array([(one.dxf.location.x, one.dxf.location.y) for one in found])


def length(chains: list[Array]) -> float:
    return float(sum(np.linalg.norm(np.diff(chain, axis=0), axis=1).sum() for chain in chains))


def test_each_piece_is_a_block_with_its_lengths(bodice: bm.Pattern) -> None:
    document = read(pattern_dxf(bodice))
    assert document.dxfversion == "AC1009"
    assert not document.audit().errors
    for piece, name in zip(bodice.pieces, ("BODICE_FRONT", "BODICE_BACK"), strict=True):
        block = document.blocks[name]
        skin = 1000.0 * sum(edge.skin_length for edge in piece.edges)
        assert length(lines(block, "14")) == pytest.approx(skin, abs=0.01)
        (cut,) = lines(block, "1")
        ring = shapely.linearrings(cut)
        for chain in lines(block, "14"):
            assert shapely.polygons(cut).buffer(1e-6).contains(shapely.linestrings(chain))
        # Each point of the cut line is a turn or a curve point, and notches lie on it.
        assert len(points(block, "2")) + len(points(block, "3")) == len(cut)
        assert len(points(block, "2")) >= 4
        assert shapely.distance(ring, shapely.points(points(block, "4"))).max() < 1e-6
        (fold,) = block.query('LINE[layer=="6"]')
        assert fold.dxf.start.distance(fold.dxf.end) == pytest.approx(
            1000.0 * piece.edge(piece.panel.fold).length, abs=0.01
        )
        assert len(block.query('LINE[layer=="7"]')) == 1
        texts = [text.dxf.text for text in block.query('TEXT[layer=="1"]')]
        assert texts == [f"PIECE NAME: {piece.name}", "SIZE: ONE", "QUANTITY: 1"]
        inside = shapely.polygons(cut)
        for text in block.query('TEXT[layer=="15"]'):
            assert inside.contains(shapely.Point(text.dxf.align_point.x, text.dxf.align_point.y))
    front = document.blocks["BODICE_FRONT"]
    assert len(lines(front, "8")) == 2
    assert len(points(front, "13")) == 1
    texts = [text.dxf.text for text in document.modelspace().query("TEXT")]
    assert texts == ["UNITS: METRIC", "STYLE NAME: Fitted bodice"]
    assert [one.dxf.name for one in document.modelspace().query("INSERT")] == [
        "BODICE_FRONT",
        "BODICE_BACK",
    ]


@pytest.mark.slow
def test_sizes_are_blocks_at_one_place(bodice: bm.Pattern) -> None:
    graded = bm.GradedPattern(bodice.definitions, {"S": bodice, "größer": bodice})
    document = read(pattern_dxf(graded))
    assert not document.audit().errors
    inserts = document.modelspace().query("INSERT")
    names = [one.dxf.name for one in inserts]
    assert names[:2] == ["BODICE_FRONT_S", "BODICE_FRONT_GROER"]
    assert inserts[0].dxf.insert == inserts[1].dxf.insert
    texts = [text.dxf.text for text in document.blocks[names[1]].query('TEXT[layer=="1"]')]
    assert "SIZE: größer" in texts

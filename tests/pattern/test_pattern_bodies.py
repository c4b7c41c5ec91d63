"""All sets on all sample bodies, against the figures of the page `patterns`."""

from pathlib import Path

import pytest

import bodymeasure as bm
from bodymeasure.pattern import SETS

SCANS = Path(__file__).parents[1] / "data" / "scans"
BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
# The most strain, in percent, in the root mean square.
MOST = {
    ("female_average", "bodice front"): 5.2,
    ("female_average", "bodice back"): 3.9,
    ("female_average", "skirt front"): 2.1,
    ("female_average", "skirt back"): 2.1,
    ("female_full_bust", "center front"): 10.0,
    ("female_full_bust", "side front"): 10.0,
}


@pytest.mark.slow
@pytest.mark.parametrize("key", SETS)
@pytest.mark.parametrize("name", BODIES)
def test_pieces_lie_flat_and_their_seams_match(name: str, key: str) -> None:
    pattern = bm.make_pattern(bm.load_sample(name), key)
    for piece in pattern.pieces:
        assert piece.flat.converged
        assert piece.flips == 0
        assert piece.is_simple
        assert 100.0 * piece.rms_strain <= MOST.get((name, piece.name), 12.0)
        for edge in piece.edges:
            assert edge.length == pytest.approx(edge.cloth_length, abs=1e-9)
        for dart in piece.darts:
            assert dart.angle > 0.0
    assert pattern.seams
    assert all(abs(seam.excess) < 1e-9 for seam in pattern.seams)
    remarks = ("left out", "has to give")
    assert all(any(remark in words for remark in remarks) for words in pattern.warnings)


@pytest.mark.slow
def test_a_body_from_a_scan_gives_sound_pieces() -> None:
    body = bm.fit_body(SCANS / "coarse.ply", file_unit="m").atlas
    for key in ("bodice", "skirt", "trousers"):
        pattern = bm.make_pattern(body, key)
        assert pattern.is_sound
        assert max(piece.rms_strain for piece in pattern.pieces) < 0.12
        assert pattern.seams
        assert all(abs(seam.excess) < 1e-9 for seam in pattern.seams)

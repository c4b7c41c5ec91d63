"""One leg of a taut tape: strings of more and more points, and the error of their length."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.taut.refine import divided, first_string, parts_of_segments, segment_lengths
from bodymeasure.taut.skin import Skin

# An error estimate below this part of the length needs no finer string.
TOLERANCE = 2e-6
# Strings that are tried: the first, one with more points where they count, and then twice as many
# each time.
LEVELS = 5
# A path shorter than this part of the atlas's size is one point.
NEGLIGIBLE = 1e-10
# Takeoffs fall on the points of a string by chance, so that two strings now and then agree better
# than either is right. The change from one to the next and the errors of the segments count so
# often; the errors of the string before, and this part of the length are added. On bodies that
# covers the changes to strings of four times as many points: `tests/benchmarks/bodies/taut.py`.
SAFETY = 3.0
CHANCE = 5e-8


class TautLeg(NamedTuple):
    """A leg drawn taut.

    Parameters
    ----------
    nodes : ndarray, shape (n, 3)
    normals : ndarray, shape (n, 3)
        Unit vectors out of the body where the leg touches it, ends included; 0 where it is free.
    length, error : float
    settled : bool
        Whether the string came to rest.
    """

    nodes: Array
    normals: Array
    length: float
    error: float
    settled: bool


def draw_taut(skin: Skin, nodes: Array) -> TautLeg:
    """Draw a leg taut.

    Parameters
    ----------
    skin : Skin
    nodes : ndarray, shape (n, 3)
        Evenly spaced points of a path outside the body or on its skin, from which it slides.
    """
    if np.ptp(nodes, axis=0).max() <= NEGLIGIBLE * skin.size:
        ends = nodes[[0, -1]]
        return TautLeg(ends, skin.feet(ends).normal, 0.0, 0.0, True)
    string = first_string(skin, nodes)
    now = segment_lengths(skin, string)
    length, error = float(now.length.sum()), np.inf
    for level in range(1, LEVELS):
        finer = divided(skin, string, now, parts_of_segments(string, now, min(level, 2)))
        if string.settled and not finer.settled and level > 1:
            # Over sharp kinks a fine string may not come to rest where a coarser one did.
            break
        before, error_before = length, float(now.error.sum())
        string, now = finer, segment_lengths(skin, finer)
        length = float(now.length.sum())
        change = abs(length - before) + float(now.error.sum())
        error = SAFETY * change + error_before + string.error + CHANCE * length
        if not string.settled or (level > 1 and error <= TOLERANCE * length):
            break
    ends = skin.feet(string.nodes[[0, -1]]).normal
    inner = np.where(string.touching[:, None], string.feet.normal, 0.0)
    normals = np.concatenate([ends[:1], inner, ends[1:]])
    return TautLeg(string.nodes, normals, length, error, string.settled)

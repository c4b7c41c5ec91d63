"""Patches that fold over: their normal turns round abruptly inside."""

from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.check.degeneracy import CORNERS, Degeneracy
from bodymeasure.atlas.check.finding import Finding, FindingKind, Severity
from bodymeasure.atlas.normals import normal_coefficients, normal_vectors
from bodymeasure.bezier import split

# Halvings of a patch down to the finest cells. These are sampled with half a cell around them: a
# fold may run along their border, where each by itself shows only half the turn.
FINEST_LEVEL = 6
_AROUND = 0.5
# A patch is folded if its normal turns by more than 90 degrees within a 32nd of its side. On a
# patch of 10 cm that is a bend of radius 2 mm. One that bends evenly turns by 6 degrees there if it
# is a half cylinder, by 11 if it closes to a tube.
_WITHIN = round(2**FINEST_LEVEL / (1 + 2 * _AROUND))
# Cosine of the largest angle to the mean normal in a cell without a fold: any two of its normals
# are then within 90 degrees.
_CONE = np.sqrt(0.5)
# Part of a patch's largest normal: rounding of coordinates leaves less, so that the direction of a
# smaller normal cannot be trusted.
NO_NORMAL = 1e-9
# Points along a side at which a cell without proof is sampled.
_SAMPLES = 5
# Patches treated at once, which bounds the memory: a patch has at most 4**6 cells of 864 bytes, or
# coefficients of its normal of 1 to 17 kB.
_BLOCK, _LARGE_BLOCK = 64, 4096


class NormalCones(NamedTuple):
    """The properties that the coefficients of the normal fields prove without splitting a patch.

    Parameters
    ----------
    largest : ndarray, shape (patches,)
        Lengths of the longest coefficients.
    whole : ndarray of bool, shape (patches,)
        Whether all coefficients lie in a narrow cone, so that the patch has no fold.
    """

    largest: Array
    whole: Bools


def normal_cones(control_points: Array) -> NormalCones:
    """Bound the normals of patches, shape (patches, m + 1, m + 1, 3 or 4)."""
    count = len(control_points)
    cones = NormalCones(np.empty(count), np.empty(count, bool))
    for first in range(0, count, _LARGE_BLOCK):
        block = slice(first, first + _LARGE_BLOCK)
        normals = normal_coefficients(control_points[block])
        cones.largest[block] = np.linalg.norm(normals, axis=-1).max(axis=(1, 2))
        cones.whole[block] = _regular(_scaled(normals, cones.largest[block]))
    return cones


def _scaled(normals: Array, largest: Array) -> Array:
    return normals / np.where(largest > 0.0, largest, 1.0)[:, None, None, None]


def fold_findings(atlas: Atlas, cones: NormalCones, degeneracy: Degeneracy) -> list[Finding]:
    """Return the findings on folded patches, and on points without a normal inside a patch.

    Parameters
    ----------
    atlas : Atlas
    cones : NormalCones
    degeneracy : Degeneracy
        What is known to collapse, and is not reported again.

    Notes
    -----
    The Bernstein coefficients of the normal field bound it. Where all of them lie in a narrow cone,
    the patch has no fold; otherwise it is split into four, and each cell is tested again. The few
    cells without proof at the finest level are sampled.
    """
    # Most patches are proven whole; only the rest is worth blocks and cells.
    unproven = np.flatnonzero(~degeneracy.patches & ~cones.whole)
    findings = []
    for first in range(0, len(unproven), _BLOCK):
        block = unproven[first : first + _BLOCK]
        normals = normal_coefficients(atlas.control_points[block])
        numbers, corners = _unproven_cells(_scaled(normals, cones.largest[block]))
        findings += _sampled_findings(atlas, block[numbers], corners, cones.largest, degeneracy)
    return findings


def _regular(coefficients: Array) -> Bools:
    """Return which cells have all coefficients in a cone round their mean, clear of zero."""
    mean = coefficients.mean(axis=(-3, -2))
    length = np.linalg.norm(mean, axis=-1, keepdims=True)
    direction = mean / np.where(length > 0.0, length, 1.0)
    heights = np.einsum("...ijc,...c->...ij", coefficients, direction)
    lengths = np.linalg.norm(coefficients, axis=-1)
    inside = (heights > NO_NORMAL) & (heights >= _CONE * lengths)
    return np.asarray(inside.all(axis=(-2, -1)))


def _unproven_cells(
    coefficients: Array,
) -> tuple[Ints, Array]:
    """Cells at the finest level without proof: each one's patch and its lowest (u, v)."""
    numbers = np.arange(len(coefficients))
    corners = np.zeros((len(coefficients), 2))
    quadrants = np.stack(np.meshgrid([0.0, 1.0], [0.0, 1.0], indexing="ij"), axis=-1)
    for level in range(1, FINEST_LEVEL + 1):
        parts = split(coefficients).reshape(-1, *coefficients.shape[1:])
        numbers = np.repeat(numbers, 4)
        corners = (corners[:, None, None] + quadrants * 0.5**level).reshape(-1, 2)
        unproven = ~_regular(parts)
        coefficients, numbers, corners = parts[unproven], numbers[unproven], corners[unproven]
    return numbers, corners


def _sampled_findings(
    atlas: Atlas,
    patches: Ints,
    corners: Array,
    largest: Array,
    degeneracy: Degeneracy,
) -> list[Finding]:
    """Return the findings from the normals that are sampled in each cell without proof."""
    width = 0.5**FINEST_LEVEL
    steps = np.linspace(-_AROUND, 1.0 + _AROUND, _SAMPLES) * width
    offsets = np.stack(np.meshgrid(steps, steps, indexing="ij"), axis=-1).reshape(-1, 2)
    nets = atlas.control_points[patches]
    places = np.clip(corners[:, None] + offsets, 0.0, 1.0)
    normals = normal_vectors(nets, places)
    lengths = np.linalg.norm(normals, axis=-1, keepdims=True)
    vanishing = lengths <= NO_NORMAL * largest[patches, None, None]
    directions = np.where(vanishing, 0.0, normals / np.where(vanishing, 1.0, lengths))
    # Normals that vanish have cosine 0 with every other, which is no reversal.
    cosine = (directions @ np.swapaxes(directions, -1, -2)).min(axis=(1, 2))
    # Where an edge or corner collapses except for rounding, the normal has any direction.
    explained = _near_known(patches, corners, width, degeneracy)
    cosine[explained] = 1.0

    findings = []
    for patch in np.unique(patches):
        mine = np.flatnonzero(patches == patch)
        worst = mine[np.argmin(cosine[mine])]
        if cosine[worst] < 0.0:
            findings.append(_folded(atlas, int(patch), corners[worst] + width / 2, cosine[worst]))
            continue
        singular = mine[vanishing[mine].any(axis=(1, 2)) & ~explained[mine]]
        if len(singular):
            findings.append(_singular(atlas, int(patch), corners[singular[0]] + width / 2))
    return findings


def _near_known(
    patches: Ints,
    corners: Array,
    width: float,
    degeneracy: Degeneracy,
) -> Bools:
    """Return whether a cell touches an edge or corner that is known to collapse."""
    near = np.zeros(len(patches), dtype=np.bool_)
    touches = np.concatenate([corners <= 0.0, corners + width >= 1.0], axis=1)
    # Columns of `touches` are u = 0, v = 0, u = 1, v = 1; EDGES has both of u first.
    for side, column in enumerate((0, 2, 1, 3)):
        near |= degeneracy.edges[patches, side] & touches[:, column]
    for number, (i, j) in enumerate(CORNERS):
        column_u, column_v = (0, 2)[i], (1, 3)[j]
        near |= degeneracy.corners[patches, number] & touches[:, column_u] & touches[:, column_v]
    return near


def _folded(atlas: Atlas, patch: int, place: Array, cosine: float) -> Finding:
    angle = np.degrees(np.arccos(max(cosine, -1.0)))
    return Finding(
        Severity.ERROR,
        FindingKind.FOLDED_PATCH,
        (patch,),
        f"patch {atlas.patch_names[patch]!r} folds over: its normal turns by {angle:.0f} degrees "
        f"within 1/{_WITHIN} of the patch near (u, v) = ({place[0]:.2f}, {place[1]:.2f}); "
        "expected a surface that bends gradually; spread the control points there, or fit the "
        "patch again with more fairness",
    )


def _singular(atlas: Atlas, patch: int, place: Array) -> Finding:
    return Finding(
        Severity.WARNING,
        FindingKind.SINGULAR_POINT,
        (patch,),
        f"patch {atlas.patch_names[patch]!r} has no normal near "
        f"(u, v) = ({place[0]:.2f}, {place[1]:.2f}), where its tangents vanish or are parallel; "
        "expected a regular surface; spread the control points there",
    )

"""Patches, edges and corners that collapse."""

from dataclasses import dataclass

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.check.finding import Finding, FindingKind, Severity
from bodymeasure.atlas.seams import EDGES, sides_of
from bodymeasure.atlas.size import patch_sizes
from bodymeasure.bezier import project

# Part of a patch's size: a tenth of a micrometer on a patch of 10 cm. It is less than a scan or a
# fit can mean, and more than the rounding of coordinates in single precision or with seven digits.
SAME_PLACE = 1e-6
# Part of a patch's squared size: rounding of coordinates leaves less, and on a patch of 10 cm it is
# a strip one tenth of a nanometer wide.
NO_AREA = 1e-9
# Sine of the angle between the tangents at a corner: half a degree. The surface still has a normal,
# but errors of the control points are amplified a hundredfold in it.
PARALLEL = 0.01

# (u, v) of each corner, and the sides, in the order of EDGES, that meet there: first the one on
# which u is fixed.
CORNERS = ((0, 0), (1, 0), (0, 1), (1, 1))
_CORNER_SIDES = ((0, 2), (1, 2), (0, 3), (1, 3))


@dataclass(frozen=True)
class Degeneracy:
    """The corners and sides that collapse in each patch.

    Parameters
    ----------
    patches : ndarray of bool, shape (patches,)
        The patch has no area.
    edges : ndarray of bool, shape (patches, 4)
        The side, in the order of `EDGES`, is a point; false for patches without area.
    corners : ndarray of bool, shape (patches, 4)
        The tangents at the corner, in the order of `CORNERS`, vanish or are parallel; false for the
        ends of a collapsed side and for patches without area.
    """

    patches: Bools
    edges: Bools
    corners: Bools


def collapsed_sides(control_points: Array) -> Bools:
    """Return which sides, in the order of `EDGES`, are points beside their patch (patches, 4)."""
    extent = np.linalg.norm(np.ptp(sides_of(control_points), axis=2), axis=-1)
    return np.asarray(extent <= SAME_PLACE * patch_sizes(control_points)[:, None])


def find_degeneracy(control_points: Array, largest: Array) -> Degeneracy:
    """Find what collapses in each patch.

    Parameters
    ----------
    control_points : ndarray, shape (patches, degree + 1, degree + 1, 3)
        Positions in space; those of rational patches come without their weights.
    largest : ndarray, shape (patches,)
        Lengths of the longest coefficients of the normal fields.
    """
    sizes = patch_sizes(control_points)
    # A patch that is a point is recognized by the size of a typical patch.
    points = sizes <= SAME_PLACE * np.median(sizes)
    patches = points | (largest <= NO_AREA * sizes**2)

    edges = collapsed_sides(control_points) & ~patches[:, None]

    corners = np.empty_like(edges)
    for number, ((i, j), (fixed_u, fixed_v)) in enumerate(zip(CORNERS, _CORNER_SIDES, strict=True)):
        # From the corner inwards.
        net = control_points[:, :: 1 - 2 * i, :: 1 - 2 * j]
        along_u, along_v = net[:, 1, 0] - net[:, 0, 0], net[:, 0, 1] - net[:, 0, 0]
        corners[:, number] = _parallel(along_u, along_v, sizes)
        corners[:, number] &= ~(edges[:, fixed_u] | edges[:, fixed_v] | patches)
    return Degeneracy(patches, edges, corners)


def _parallel(first: Array, second: Array, sizes: Array) -> Bools:
    lengths = np.linalg.norm(first, axis=-1), np.linalg.norm(second, axis=-1)
    vanishing = np.minimum(*lengths) <= SAME_PLACE * sizes
    sine = np.linalg.norm(np.cross(first, second), axis=-1)
    return np.asarray(vanishing | (sine <= PARALLEL * lengths[0] * lengths[1]))


def degeneracy_findings(atlas: Atlas, degeneracy: Degeneracy) -> list[Finding]:
    """Return the findings on what collapses."""
    sizes = patch_sizes(project(atlas.control_points))
    count = atlas.index[0].size
    findings = [
        Finding(
            Severity.ERROR,
            FindingKind.COLLAPSED_PATCH,
            (int(patch),),
            f"patch {atlas.patch_names[patch]!r} has no area: its {count} control points span "
            f"{sizes[patch]:.3g} {atlas.unit} and lie on one point or line; expected a surface; "
            "remove the patch or correct its control points",
        )
        for patch in np.flatnonzero(degeneracy.patches)
    ]
    findings += [
        Finding(
            Severity.WARNING,
            FindingKind.COLLAPSED_EDGE,
            (int(patch),),
            f"edge {EDGES[side].name} of patch {atlas.patch_names[patch]!r} is a single point; "
            "the surface has no normal there, and geodesics that end at it are ill-defined; "
            "legitimate at the tip of a lid or cap, else correct the control points",
        )
        for patch, side in zip(*np.nonzero(degeneracy.edges), strict=True)
    ]
    findings += [
        Finding(
            Severity.WARNING,
            FindingKind.SINGULAR_CORNER,
            (int(patch),),
            f"the edges of patch {atlas.patch_names[patch]!r} that meet at its corner "
            f"(u, v) = ({CORNERS[corner][0]}, {CORNERS[corner][1]}) have tangents there "
            "that vanish or are parallel, so the surface has no normal; expected an angle between "
            "0.6 and 179.4 degrees; move the control points next to the corner",
        )
        for patch, corner in zip(*np.nonzero(degeneracy.corners), strict=True)
    ]
    return findings

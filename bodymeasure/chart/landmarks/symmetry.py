"""A check that landmarks are mirror images of one another."""

from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
import scipy

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.bezier import evaluate
from bodymeasure.chart.landmarks.names import other_side, side_of
from bodymeasure.geodesic.across.routes.topology import extent
from bodymeasure.section import Plane

# Samples along a side of each patch, which are mirrored and compared with one another.
SAMPLES = 8
# The fraction of the samples that counts: those with the best partners. Arms are held unevenly.
TRUSTED = 0.8
# A round of the search moves a sample by one neighbor; a body is some hundred samples round.
ROUNDS = 100
# Decimals of distances by the atlas's size, so that rounding does not order those that are 0.
DIGITS = 9


class PairCheck(NamedTuple):
    """A landmark on the left and its partner.

    Parameters
    ----------
    left, right : str
    apart : float
        Distance of the mirrored left landmark from the right one.
    """

    left: str
    right: str
    apart: float


@dataclass(frozen=True, eq=False)
class SymmetryCheck:
    """The symmetry of an atlas's landmarks; lengths are in the atlas's unit.

    Parameters
    ----------
    plane : Plane
        The mirror; its normal points to the wearer's left.
    kind : {"fitted", "axes"}
    deviation : float
        Root mean square distance between the mirrored samples of the surface and the samples
        nearest to them, over the 80 % that fit best.
    pairs : tuple of PairCheck
        The worst pair comes first.
    unpaired : tuple of str
        Landmarks with a side whose partner is missing.
    median : tuple of (str, float)
        Landmarks without a side, with their distances from the plane, positive on the left; the
        farthest comes first.
    """

    plane: Plane
    kind: Literal["fitted", "axes"]
    deviation: float
    pairs: tuple[PairCheck, ...]
    unpaired: tuple[str, ...]
    median: tuple[tuple[str, float], ...]


def check_symmetry(atlas: Atlas, kind: Literal["fitted", "axes"] = "fitted") -> SymmetryCheck:
    """Mirror the left landmarks and measure how far from the right ones they fall.

    Parameters
    ----------
    atlas : Atlas
    kind : {"fitted", "axes"}
        Whether the mirror is the plane in which the surface is most nearly symmetric, or the plane
        along the atlas's axes, from front to back, in the middle of its median landmarks (of the
        whole atlas if it has none).
    """
    positions = {name: atlas.position(point) for name, point in atlas.landmarks.items()}
    size = extent(atlas)
    plane = _axes_plane(atlas, positions)
    samples = _samples(atlas)
    if kind == "fitted":
        plane = _fitted(samples, plane)
    pairs = [
        PairCheck(
            name,
            other_side(name),
            float(np.linalg.norm(_mirrored(at, plane) - positions[other_side(name)])),
        )
        for name, at in positions.items()
        if side_of(name) == "left" and other_side(name) in positions
    ]
    median = [
        (name, float(plane.distances(at))) for name, at in positions.items() if not side_of(name)
    ]
    return SymmetryCheck(
        plane,
        kind,
        _deviation(samples, plane),
        tuple(sorted(pairs, key=lambda pair: -round(pair.apart / size, DIGITS))),
        tuple(name for name in positions if side_of(name) and other_side(name) not in positions),
        tuple(sorted(median, key=lambda item: -round(abs(item[1]) / size, DIGITS))),
    )


def _axes_plane(atlas: Atlas, positions: dict[str, Array]) -> Plane:
    left = atlas.axes.left_vector
    median = [at for name, at in positions.items() if not side_of(name)]
    if median:
        return Plane(np.median(median, axis=0), left)
    return Plane(0.5 * (atlas.points.min(axis=0) + atlas.points.max(axis=0)), left)


def _samples(atlas: Atlas) -> Array:
    side = (np.arange(SAMPLES) + 0.5) / SAMPLES
    grid = np.stack(np.meshgrid(side, side, indexing="ij"), axis=-1)
    shape = (len(atlas), SAMPLES, SAMPLES, 2)
    return evaluate(atlas.control_points, np.broadcast_to(grid, shape)).reshape(-1, 3)


def _mirrored(positions: Array, plane: Plane) -> Array:
    return positions - 2.0 * plane.distances(positions)[..., None] * plane.normal


def _fitted(samples: Array, start: Plane) -> Plane:
    """Return the plane in which the samples are most nearly symmetric, searched from another.

    Notes
    -----
    In turn, samples are paired with those nearest to their mirror images, and the best mirror for
    these pairs is found, as P. Besl and N. McKay, IEEE PAMI 14 (1992) 239-256, do for motions. For
    pairs (p, q), the mirror's normal is the eigenvector to the smallest eigenvalue of the symmetric
    part of sum (p - mean p) (q - mean q)^T, and the mirror passes through the middle of the means.
    """
    tree = scipy.spatial.KDTree(samples)
    plane, previous = start, np.empty(0, dtype=np.int64)
    for _ in range(ROUNDS):
        apart, partner = tree.query(_mirrored(samples, plane))
        if np.array_equal(partner, previous):
            break
        previous = partner
        trusted = apart <= np.quantile(apart, TRUSTED)
        p, q = samples[trusted], samples[partner[trusted]]
        middle = 0.5 * (p.mean(axis=0) + q.mean(axis=0))
        together = (p - p.mean(axis=0)).T @ (q - q.mean(axis=0))
        normal = np.linalg.eigh(together + together.T)[1][:, 0]
        plane = Plane(middle, normal if normal @ start.normal >= 0.0 else -normal)
    return plane


def _deviation(samples: Array, plane: Plane) -> float:
    apart, _ = scipy.spatial.KDTree(samples).query(_mirrored(samples, plane))
    trusted = apart[apart <= np.quantile(apart, TRUSTED)]
    return float(np.sqrt(np.mean(trusted**2)))

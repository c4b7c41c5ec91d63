"""Patches that are moved, turned and scaled into the unit cube: the paper's section 2."""

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.geodesic.surfaces.control_points import prepared_control_points

# "The longest side of the patch", which is to lie along x, is that of the box around the control
# points, or the chord of one of the four sides of the patch.
Side = Literal["box", "chord"]
SIDES: tuple[Side, ...] = get_args(Side)

# Matrices that bring x, y or z to the first place. They are rotations, so that nothing is mirrored.
_CYCLES = np.stack([np.roll(np.eye(3), shift, axis=1) for shift in range(3)])
# Corners of a net, in order around it.
_ROUND = ((0, 0), (-1, 0), (-1, -1), (0, -1))


@dataclass(frozen=True, eq=False)
class Normalized:
    """Patches in the unit cube, and what takes them back.

    Parameters
    ----------
    control_points : ndarray, shape (*batch, m + 1, n + 1, 3)
        Points in [0, 1]; each coordinate is 0 somewhere, and the largest of all is 1.
    rotation : ndarray, shape (*batch, 3, 3)
        The rotation by which the original points were multiplied first.
    origin : ndarray, shape (*batch, 3)
        The point that was subtracted then: the paper's Min(p_i).
    scale : ndarray, shape (*batch)
        The size by which they were divided last: the paper's Max(P_i).
    """

    control_points: Array
    rotation: Array
    origin: Array
    scale: Array

    def original_points(self, points: ArrayLike) -> Array:
        """Return points (*batch, ..., 3) of the normalized patches as points of the original."""
        points = np.asarray(points, dtype=np.float64)
        axes = (1,) * (points.ndim - self.origin.ndim)
        origin = self.origin.reshape(*self.origin.shape[:-1], *axes, 3)
        rotation = self.rotation.reshape(*self.rotation.shape[:-2], *axes, 3, 3)
        turned = points * self.scale.reshape((*self.scale.shape, *axes, 1)) + origin
        return np.asarray((turned[..., None, :] @ rotation)[..., 0, :])

    def original_lengths(self, lengths: ArrayLike) -> Array:
        """Return lengths (*batch, ...) on the normalized patches as lengths on the original."""
        lengths = np.asarray(lengths, dtype=np.float64)
        return lengths * self.scale.reshape(
            self.scale.shape + (1,) * (lengths.ndim - self.scale.ndim)
        )


def normalize(control_points: ArrayLike, longest: Side = "box") -> Normalized:
    """Return patches moved into the unit cube, with their longest side along x.

    Parameters
    ----------
    control_points : array_like, shape (*batch, m + 1, n + 1, 3)
    longest : {"box", "chord"}
        The side that is meant. Box: a side of the box around the control points along the axes,
        which are permuted in a cycle. Chord: a straight line between neighboring corners; the
        patch is turned until that lies along x.

    Returns
    -------
    Normalized

    Raises
    ------
    InputError
        If a shape or value is wrong, a patch is collapsed to a point, or there is no such side.

    Notes
    -----
    Equations (3) and (4): ``P = p - Min(p)`` by ordinate, ``P / Max(P)`` with one maximum, so that
    lengths scale alike in all directions.
    """
    if longest not in SIDES:
        raise InputError(f"longest is {longest!r}; expected one of {', '.join(SIDES)}")
    found, sizes, batch = prepared_control_points(control_points)
    # The sizes are powers of 2, so that nothing is rounded.
    nets = np.asarray(found) * sizes[:, None, None, None]
    nets = nets.reshape(*batch, *nets.shape[1:])
    rotation = _along_box(nets) if longest == "box" else _along_chord(nets)
    turned = nets @ np.swapaxes(rotation, -1, -2)[..., None, :, :]
    origin = turned.min(axis=(-3, -2))
    moved = turned - origin[..., None, None, :]
    scale = np.asarray(moved.max(axis=(-3, -2, -1)))
    return Normalized(moved / scale[..., None, None, None], rotation, origin, scale)


def _along_box(nets: Array) -> Array:
    extent = np.ptp(nets, axis=(-3, -2))
    return np.asarray(_CYCLES[extent.argmax(axis=-1)])


def _along_chord(nets: Array) -> Array:
    """Return the rotations by the smallest angle that take the longest chord to x."""
    corners = np.stack([nets[..., i, j, :] for i, j in _ROUND], axis=-2)
    chords = np.roll(corners, -1, axis=-2) - corners
    lengths = np.linalg.norm(chords, axis=-1)
    which = lengths.argmax(axis=-1)[..., None]
    length = np.take_along_axis(lengths, which, axis=-1)
    chord = np.take_along_axis(chords, which[..., None], axis=-2)[..., 0, :]
    # Any direction will do for a patch whose corners are all one point.
    direction = np.where(length > 0.0, chord / np.where(length > 0.0, length, 1.0), [1.0, 0.0, 0.0])
    # A line has no sign; the nearer end of x is reached by the smaller turn.
    direction = direction * np.where(direction[..., :1] < 0.0, -1.0, 1.0)
    x, y, z = np.moveaxis(direction, -1, 0)
    rows = [[x, y, z], [-y, 1.0 - y * y / (1.0 + x), -y * z / (1.0 + x)]]
    rows.append([-z, -y * z / (1.0 + x), 1.0 - z * z / (1.0 + x)])
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))

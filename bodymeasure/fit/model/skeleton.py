"""The skeleton that poses bodies: joints that move with the shape, and the skin's weights."""

from dataclasses import dataclass
from functools import cache, cached_property

import numpy as np
from scipy.sparse import csr_matrix

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.fit.model.space import DATA


@dataclass(frozen=True, eq=False)
class Skeleton:
    """Joints in the order of their bones: each is carried by an earlier one, the first by none.

    Parameters
    ----------
    names : tuple of str
    parents : ndarray of int, shape (31,)
        The joint that carries each, -1 for the first.
    mean : ndarray, shape (31, 3)
        Joints of the mean body in the A-pose, meters.
    components : ndarray, shape (120, 31, 3)
        How one standard deviation of each component moves them.
    weights : csr_matrix, shape (13380, 31)
        Share of each bone in each vertex; a row adds up to 1.
    """

    names: tuple[str, ...]
    parents: Ints
    mean: Array
    components: Array
    weights: csr_matrix

    @cached_property
    def carries(self) -> Bools:
        """Whether joint i carries bone j, or is its own; shape (31, 31)."""
        carries = np.eye(len(self.names), dtype=bool)
        for joint, parent in enumerate(self.parents):
            if parent >= 0:
                carries[:, joint] |= carries[:, parent]
        return carries

    def joints_of(self, coefficients: Array) -> Array:
        """Return the joints of a body in the A-pose, shape (31, 3)."""
        moved = np.tensordot(coefficients, self.components[: len(coefficients)], 1)
        return np.asarray(self.mean + moved)

    def number(self, name: str) -> int:
        """Return the number of a joint."""
        return self.names.index(name)


@cache
def skeleton() -> Skeleton:
    """The skeleton, read once."""
    with np.load(DATA / "skeleton.npz") as data:
        weights = data["skin_weights"].astype(float)
        vertices = np.repeat(np.arange(len(weights)), weights.shape[1])
        bones = data["skin_bones"].ravel()
        shape = (len(weights), len(data["parents"]))
        # The weights are stored with half precision.
        weights /= weights.sum(axis=1, keepdims=True)
        return Skeleton(
            names=tuple(data["bone_names"].tolist()),
            parents=data["parents"].astype(np.int64),
            mean=data["joint_mean"].astype(float),
            components=data["joint_components"].astype(float),
            weights=csr_matrix((weights.ravel(), (vertices, bones)), shape=shape),
        )

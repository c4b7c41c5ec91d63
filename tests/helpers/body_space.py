"""Random bodies, beyond the samples: a mean body and its principal components.

`tests/data/README.md` says where the data come from.
"""

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.samples import load_sample

FILE = Path(__file__).parents[1] / "data" / "body_space.npz"
# The components are stored in steps of so many meters.
STEP = 5e-6
COMPONENTS = 60
# The standard deviation of the random coefficients; those of real bodies of the space have 1, with
# which one random body in twelve is folded somewhere.
SPREAD = 0.9
# The first word of the seed of every random body.
SEED = 2026


@cache
def _space() -> dict[str, Array]:
    with np.load(FILE) as data:
        arrays = {name: data[name] for name in data.files}
    # Differences from point to point, which compress better than the components themselves; both
    # are 16-bit numbers, in which a sum that leaves the range comes back.
    steps = np.cumsum(arrays.pop("differences"), axis=2, dtype=np.int16)
    return arrays | {"components": STEP * steps.swapaxes(1, 2)}


def body_of(coefficients: Array, name: str = "body of the space") -> Atlas:
    """The atlas of a body, in meters.

    Parameters
    ----------
    coefficients : ndarray, shape (k,)
        In standard deviations, for the first k of the 60 components.
    name : str
    """
    moved = np.tensordot(coefficients, _space()["components"][: len(coefficients)], 1)
    return _atlas(_space()["mean"] + moved, name)


def random_body(number: int) -> Atlas:
    """The random body of a number, the same on every machine."""
    rng = np.random.default_rng([SEED, number])
    return body_of(SPREAD * rng.standard_normal(COMPONENTS), f"random body {number}")


def held_out_body() -> Atlas:
    """A body of the same population that is not in the space."""
    return _atlas(_space()["held_out"], "held-out body")


def _atlas(points: Array, name: str) -> Atlas:
    space = _space()
    places = zip(space["landmark_patch"].tolist(), space["landmark_uv"].tolist(), strict=True)
    return replace(
        # Names of patches, regions, axes and unit are those of all bodies of this layout.
        load_sample("female_average"),
        points=points.astype(float),
        index=space["index"].astype(np.int64),
        landmarks={
            str(landmark): AtlasPoint(patch, u, v)
            for landmark, (patch, (u, v)) in zip(space["landmark_names"], places, strict=True)
        },
        name=name,
        provenance={},
        # Head, hands and feet of the sample are not those of another body.
        given={},
    )

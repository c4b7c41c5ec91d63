"""Patches as a file holds them, and how they become an atlas."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count

import numpy as np
from numpy.typing import NDArray

from bodymeasure.atlas import Atlas, Axes, Unit, weld
from bodymeasure.bezier import elevate
from bodymeasure.errors import InputError

# What the solver of an atlas takes so far.
DEGREE = 3

_Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class ReadPatches:
    """Bezier patches of any degrees, as read: not yet joined, without a unit.

    Parameters
    ----------
    nets : sequence of ndarray, each of shape (m + 1, n + 1, 3)
        Control points; the first axis runs with u.
    weights : sequence of ndarray, each of shape (m + 1, n + 1), optional
        Of rational patches, one for each net.
    names, groups : sequence of str, optional
        One for each net, empty where there is none. Patches of one name are numbered.
    places : sequence of str, optional
        Where in the file each begins, such as ``line 7``, for errors.
    """

    nets: Sequence[_Array]
    weights: Sequence[_Array] = ()
    names: Sequence[str] = ()
    groups: Sequence[str] = ()
    places: Sequence[str] = ()

    def place(self, number: int) -> str:
        """How an error calls a patch."""
        where = f", {self.places[number]}" if self.places else ""
        return f"{where}: patch {number}"


def assemble(
    patches: ReadPatches, source: str, *, unit: Unit, axes: Axes, tolerance: float | None = None
) -> Atlas:
    """An atlas of patches as read: elevated to bicubic ones, and welded.

    Parameters
    ----------
    patches : ReadPatches
    source : str
        Names the file in errors.
    unit : Unit
    axes : Axes
    tolerance : float, optional
        How far apart edges may be that are joined, in `unit`; see `weld`.

    Raises
    ------
    InputError
        If there is no patch, or one is rational, of a degree above 3 or not finite.
    """
    if not patches.nets:
        raise InputError(f"{source}: holds no patch; expected at least one")
    _refuse_rational(patches, source)
    control_points = _bicubic(patches, source)
    finite = np.isfinite(control_points).all(axis=(1, 2, 3))
    if not finite.all():
        bad = int(np.argmin(finite))
        raise InputError(
            f"{source}{patches.place(bad)} has control points that are not finite numbers"
        )
    try:
        points, index = weld(control_points, tolerance)
    except InputError as error:
        raise InputError(f"{source}: {error}") from None
    return Atlas(
        points,
        index,
        unit,
        patch_names=unique_names(patches.names),
        regions=tuple(patches.groups),
        axes=axes,
    )


def _refuse_rational(patches: ReadPatches, source: str) -> None:
    for number, weights in enumerate(patches.weights):
        # A common factor of the weights cancels.
        if not (weights == weights.flat[0]).all() or not weights.flat[0] > 0.0:
            raise InputError(
                f"{source}{patches.place(number)} is rational, with weights from "
                f"{weights.min():g} to {weights.max():g}; only patches whose weights are all "
                "equal and positive can be read; approximate it by polynomial patches where it "
                "was made"
            )


def _bicubic(patches: ReadPatches, source: str) -> _Array:
    """All nets elevated to degree 3, shape (patches, 4, 4, 3)."""
    by_shape: dict[tuple[int, ...], list[int]] = {}
    for number, net in enumerate(patches.nets):
        by_shape.setdefault(net.shape, []).append(number)
    control_points = np.empty((len(patches.nets), DEGREE + 1, DEGREE + 1, 3))
    for shape, numbers in by_shape.items():
        degrees = shape[0] - 1, shape[1] - 1
        if max(degrees) > DEGREE:
            raise InputError(
                f"{source}{patches.place(numbers[0])} has the degrees {degrees[0]} and "
                f"{degrees[1]}; only degrees up to {DEGREE} can be read; reduce the degree where "
                "it was made"
            )
        nets = np.stack([patches.nets[number] for number in numbers])
        with np.errstate(over="ignore", invalid="ignore"):
            control_points[numbers] = elevate(nets, DEGREE, DEGREE)
    return control_points


def unique_names(names: Sequence[str]) -> tuple[str, ...]:
    """Names with a number after those that occur more than once, and after empty ones."""
    occurrences = Counter(names)
    taken = {name for name, times in occurrences.items() if times == 1}
    numbers = {name: count() for name in occurrences}
    result = []
    for number, name in enumerate(names):
        if name.strip() and occurrences[name] == 1:
            result.append(name)
            continue
        base = name if name.strip() else "patch"
        candidates = (f"{base} {k}" for k in (numbers[name] if name.strip() else count(number)))
        chosen = next(candidate for candidate in candidates if candidate not in taken)
        taken.add(chosen)
        result.append(chosen)
    return tuple(result)

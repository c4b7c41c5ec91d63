"""Patches as a file holds them, and how they become an atlas."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import LARGEST_DEGREE, LEAST_DEGREE, Atlas, Axes, FileFaces, Unit, weld
from bodymeasure.bezier import elevate, homogeneous, project
from bodymeasure.errors import InputError


@dataclass(frozen=True, eq=False)
class ReadPatches:
    """Bezier patches of any degrees as they are read, not yet joined.

    Parameters
    ----------
    nets : sequence of ndarray, each of shape (m + 1, n + 1, 3)
        Control points; the first axis runs with u.
    weights : sequence of ndarray, each of shape (m + 1, n + 1), optional
        Weights of rational patches, one array for each net.
    names, groups : sequence of str, optional
        One for each net, empty where there is none. Patches of one name are numbered.
    places : sequence of str, optional
        Where in the file each begins, such as ``line 7``, for errors.
    unit : Unit, optional
        The unit, if the file has one.
    notes : sequence of str
        What a user should know about the reading, such as what was left out.
    faces : FileFaces, optional
        The parameters of the surfaces that the patches are cut from.
    """

    nets: Sequence[Array]
    weights: Sequence[Array] = ()
    names: Sequence[str] = ()
    groups: Sequence[str] = ()
    places: Sequence[str] = ()
    unit: Unit | None = None
    notes: Sequence[str] = ()
    faces: FileFaces | None = None

    def place(self, number: int) -> str:
        """The words by which an error names a patch."""
        where = f", {self.places[number]}" if self.places else ""
        return f"{where}: patch {number}"


def assemble(
    patches: ReadPatches, source: str, *, unit: Unit, axes: Axes, tolerance: float | None = None
) -> Atlas:
    """Return an atlas of patches as read: elevated to one degree, at least 3, and welded.

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
        If there is no patch, one has a degree above 9 or weights that are not positive, or one is
        not finite.
    """
    if not patches.nets:
        raise InputError(f"{source}: holds no patch; expected at least one")
    _check_weights(patches, source)
    nets, weights = _elevated(patches, source)
    finite = np.isfinite(nets).all(axis=(1, 2, 3))
    if not finite.all():
        bad = int(np.argmin(finite))
        raise InputError(
            f"{source}{patches.place(bad)} has control points that are not finite numbers"
        )
    try:
        points, index = weld(nets, tolerance, weights=weights)
        return Atlas(
            points,
            index,
            unit,
            patch_names=unique_names(patches.names),
            regions=tuple(patches.groups),
            axes=axes,
            weights=weights,
            faces=patches.faces,
        )
    except InputError as error:
        raise InputError(f"{source}: {error}") from None


def _check_weights(patches: ReadPatches, source: str) -> None:
    for number, weights in enumerate(patches.weights):
        if not ((weights > 0.0) & (weights < np.inf)).all():
            raise InputError(
                f"{source}{patches.place(number)} has weights from {weights.min():g} to "
                f"{weights.max():g}; expected positive ones, with which a patch has no poles"
            )


def _elevated(patches: ReadPatches, source: str) -> tuple[Array, Array | None]:
    """Return all nets with one degree, (patches, d + 1, d + 1, 3), and weights if some differ."""
    by_shape: dict[tuple[int, ...], list[int]] = {}
    for number, net in enumerate(patches.nets):
        by_shape.setdefault(net.shape, []).append(number)
    degree = max(LEAST_DEGREE, *(max(shape[:2]) - 1 for shape in by_shape))
    for shape, numbers in by_shape.items():
        if max(shape[:2]) - 1 > LARGEST_DEGREE:
            raise InputError(
                f"{source}{patches.place(numbers[0])} has the degrees {shape[0] - 1} and "
                f"{shape[1] - 1}; only degrees up to {LARGEST_DEGREE} can be read; reduce the "
                "degree where it was made"
            )
    # A common factor of a patch's weights cancels.
    is_rational = any(bool((w != w.flat[0]).any()) for w in patches.weights)
    side = degree + 1
    points = np.empty((len(patches.nets), side, side, 3))
    all_weights = np.ones(points.shape[:-1])
    for shape, numbers in by_shape.items():
        nets = np.stack([patches.nets[number] for number in numbers])
        with np.errstate(over="ignore", invalid="ignore"):
            if is_rational:
                weights = np.stack([patches.weights[number] for number in numbers])
                if shape != points.shape[1:]:
                    elevated = elevate(homogeneous(nets, weights), degree, degree)
                    nets, weights = project(elevated), elevated[..., 3]
                all_weights[numbers] = weights
            points[numbers] = elevate(nets, degree, degree)
    return points, all_weights if is_rational else None


def unique_names(names: Sequence[str]) -> tuple[str, ...]:
    """Return names with numbers after those that occur more than once, and after empty ones."""
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

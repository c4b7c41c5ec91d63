"""Lengths on an atlas beside those on the surface to which it was fitted, and the differences."""

from dataclasses import dataclass, fields
from functools import cached_property

import numpy as np

from bodymeasure._typing import Array, Bools
from bodymeasure.atlas import Unit, convert_length


@dataclass(frozen=True)
class Row:
    """One row of `Comparison`: its fields are the columns and properties of the same names."""

    name: str
    patch: str
    place: str
    calculated: float
    physical: float
    uncertainty: float
    relative_error: float
    of_fit: float
    of_path: float
    distance: float
    offset: float
    end_distance: float
    bend: float
    own_bend: float
    shorter_path: bool
    status: str


@dataclass(frozen=True, eq=False)
class Comparison:
    """Lengths on an atlas and on the physical surface, a row for each curve.

    Parameters
    ----------
    unit : Unit
        Unit of all lengths, which is that of the atlas.
    patch : tuple of str
    place : tuple of str
        ``diagonal 1``, ``diagonal 2``, or the side: ``side u = 0``, ...
    calculated : ndarray, shape (k,)
        Length on the atlas; NaN where there is none.
    physical : ndarray, shape (k,)
        Length on the surface: for a diagonal, the shortest distance between the points closest to
        its ends; for a boundary curve, the length of the curve laid on the surface.
    uncertainty : ndarray, shape (k,)
        Uncertainty of `physical`, as the meshes show it.
    laid : ndarray, shape (k,)
        Length of the atlas's curve laid on the surface, each point on the closest one.
    laid_uncertainty : ndarray, shape (k,)
    distance : ndarray, shape (k,)
        Largest distance of the curve from the surface.
    offset : ndarray, shape (k,)
        Mean distance along the curve, negative where the atlas lies inside the surface.
    end_distance : ndarray, shape (k,)
        Distance of the farther end from the surface.
    bend, own_bend : ndarray, shape (k,)
        Radii of the laid curve at its sharpest bend, and of the atlas's curve at the same point.
    status : tuple of str
        The status of the calculated length, in words.
    """

    unit: Unit
    patch: tuple[str, ...]
    place: tuple[str, ...]
    calculated: Array
    physical: Array
    uncertainty: Array
    laid: Array
    laid_uncertainty: Array
    distance: Array
    offset: Array
    end_distance: Array
    bend: Array
    own_bend: Array
    status: tuple[str, ...]

    def __len__(self) -> int:
        return len(self.patch)

    @cached_property
    def relative_error(self) -> Array:
        """Equation (17): (calculated - physical) / physical, with its sign.

        The published table prints the opposite sign in its first three rows, though not in the
        fourth.
        """
        return np.asarray((self.calculated - self.physical) / self.physical)

    @cached_property
    def of_fit(self) -> Array:
        """The part of `relative_error` that laying the same curve on the surface makes."""
        return np.asarray((self.calculated - self.laid) / self.physical)

    @cached_property
    def of_path(self) -> Array:
        """The rest: by how much the laid curve is longer than the shortest one on the surface."""
        return np.asarray((self.laid - self.physical) / self.physical)

    @cached_property
    def shorter_path(self) -> Bools:
        """Where the surface has a path shorter than the laid curve, beyond the uncertainties."""
        uncertainty = self.uncertainty + self.laid_uncertainty
        return np.asarray(self.laid - self.physical > uncertainty)

    @cached_property
    def name(self) -> tuple[str, ...]:
        """The patch and the place of each curve."""
        return tuple(
            f"{patch} {place}" for patch, place in zip(self.patch, self.place, strict=True)
        )

    def row(self, number: int) -> Row:
        """Return one row as plain numbers and words."""
        cells = {field.name: getattr(self, field.name)[number] for field in fields(Row)}
        return Row(
            **{
                name: cell.item() if isinstance(cell, np.generic) else cell
                for name, cell in cells.items()
            }
        )

    def rows(self) -> tuple[Row, ...]:
        """Return all rows."""
        return tuple(self.row(number) for number in range(len(self)))


@dataclass(frozen=True)
class Distribution:
    """The spread of relative errors (17).

    Parameters
    ----------
    count : int
        Number of rows.
    without_length : int
        Number of rows without a length on the atlas, which the other figures leave out.
    mean, mean_absolute, median_absolute, quantile_95 : float
        Figures of the error, and of its absolute value.
    largest : Row or None
        The row with the largest absolute error.
    explanation : str
        The origin of that error, in words.
    uncertainty : float
        Median of the physical lengths' relative uncertainty.
    """

    count: int
    without_length: int
    mean: float
    mean_absolute: float
    median_absolute: float
    quantile_95: float
    largest: Row | None
    explanation: str
    uncertainty: float


def distribution(comparison: Comparison) -> Distribution:
    """Return the spread of a comparison's errors."""
    error = comparison.relative_error
    known = np.flatnonzero(np.isfinite(error))
    without = len(error) - len(known)
    if not len(known):
        nothing = float("nan")
        return Distribution(
            len(error), without, *(nothing,) * 4, None, "No row has a length.", nothing
        )
    size = np.abs(error[known])
    largest = comparison.row(int(known[np.argmax(size)]))
    return Distribution(
        count=len(error),
        without_length=without,
        mean=float(error[known].mean()),
        mean_absolute=float(size.mean()),
        median_absolute=float(np.median(size)),
        quantile_95=float(np.quantile(size, 0.95)),
        largest=largest,
        explanation=explain(largest, comparison.unit),
        uncertainty=float(np.median((comparison.uncertainty / comparison.physical)[known])),
    )


def explain(row: Row, unit: Unit) -> str:
    """Return the origin of the error of one row, in words."""

    def millimeters(length: float, digits: int = 2) -> str:
        return f"{convert_length(length, unit, Unit.MM):.{digits}f} mm"

    side = "inside" if row.offset < 0 else "outside"
    words = (
        f"Of {row.relative_error:+.3%}, {row.of_fit:+.3%} is the fit: the atlas's curve lies up to "
        f"{millimeters(row.distance)} off the surface ({millimeters(abs(row.offset))} {side} on "
        f"average, {millimeters(row.end_distance)} at the farther end), and laid on it is "
        f"{'longer' if row.of_fit < 0 else 'shorter'} by that. Where it bends most there, its "
        f"radius is {millimeters(row.bend, 1)} on the surface and "
        f"{millimeters(row.own_bend, 1)} on the atlas."
    )
    if row.of_path == 0.0:  # a boundary curve, which is compared with itself
        return words
    words += f" {row.of_path:+.3%} is the path: "
    if row.shorter_path:
        return f"{words}the surface has a shorter one. On the atlas: {row.status}"
    return f"{words}the surface has none that is shorter, as far as the meshes can tell."

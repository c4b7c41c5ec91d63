"""The options of reading, in which a user adds what a file does not state itself."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from bodymeasure.atlas import Axes, Unit
from bodymeasure.errors import InputError, MissingUnitError


@dataclass(frozen=True)
class ReadOptions:
    """The options with which a file is read.

    Parameters
    ----------
    unit : Unit, optional
        Unit of its coordinates.
    axes : Axes, optional
        Which way is up and which way the body looks.
    groups : tuple of str
        The groups to take; all if empty.
    tolerance : float, optional
        How far apart edges may be that are joined, in the file's unit.
    deviation : float, optional
        How far the patches of a mesh may lie from its surface, in the file's unit.
    interpolate : bool
        Whether the surface of a mesh runs through its vertices.
    quads : bool
        Whether a mesh of triangles becomes patches, too, three for each triangle.
    """

    unit: Unit | None = None
    axes: Axes | None = None
    groups: tuple[str, ...] = ()
    tolerance: float | None = None
    deviation: float | None = None
    interpolate: bool = False
    quads: bool = False

    @classmethod
    def checked(
        cls,
        unit: Unit | str | None,
        up: str | None,
        front: str | None,
        groups: str | Sequence[str],
        tolerance: float | None,
        deviation: float | None,
        interpolate: bool,
        quads: bool,
    ) -> Self:
        """Return options as a user gives them.

        Raises
        ------
        InputError
            If a unit or direction is unknown, the directions are not perpendicular, or the
            tolerance or the deviation is negative.
        """
        if tolerance is not None and not 0.0 <= tolerance < math.inf:
            raise InputError(f"the tolerance is {tolerance}; expected a length of at least 0")
        if deviation is not None and not deviation > 0.0:
            raise InputError(f"the deviation is {deviation}; expected a length above 0")
        return cls(
            None if unit is None else Unit.parse(unit),
            _axes(up, front),
            (groups,) if isinstance(groups, str) else tuple(groups),
            tolerance,
            deviation,
            interpolate,
            quads,
        )

    def known_unit(self, source: str, title: str) -> Unit:
        """Return the unit.

        Raises
        ------
        MissingUnitError
            If none was given.
        """
        if self.unit is None:
            known = ", ".join(unit.value for unit in Unit)
            raise MissingUnitError(
                f"{source}: {title} says no unit, and none was given; say in which unit its "
                f"coordinates are (one of {known}): unit=... in Python, --file-unit on the "
                "command line; `bodymeasure convert` keeps it in a file"
            )
        return self.unit

    def require_none(self, source: str, unit: Unit, axes: Axes) -> None:
        """Refuse options that contradict a file with its own unit and axes, and a tolerance.

        Raises
        ------
        InputError
            If an option contradicts the file; the message names it.
        """
        self.require_unit(source, unit)
        if self.axes not in (None, axes):
            raise InputError(
                f"{source}: has up {axes.up} and front {axes.front}, but others were given; leave "
                "them out, or correct the file by `bodymeasure convert`"
            )
        if self.tolerance is not None:
            raise InputError(f"{source}: is joined already; leave the tolerance out")

    def require_no_mesh(self, source: str) -> None:
        """Refuse options for meshes, with a file that holds none.

        Raises
        ------
        InputError
            If one was given; the message names it.
        """
        for name, given in (
            ("deviation", self.deviation),
            ("interpolation", self.interpolate),
            ("quads", self.quads),
        ):
            if given:
                raise InputError(f"{source}: holds patches and no mesh; leave the {name} out")

    def require_unit(self, source: str, unit: Unit) -> None:
        """Refuse a unit other than the file's own.

        Raises
        ------
        InputError
            If another was given.
        """
        if self.unit not in (None, unit):
            raise InputError(
                f"{source}: is in {unit}, but the unit {self.unit} was given; leave it out, and "
                "convert afterwards"
            )


def _axes(up: str | None, front: str | None) -> Axes | None:
    if up is None and front is None:
        return None
    standard = Axes()
    try:
        return Axes(up or standard.up, front or standard.front)
    except InputError as error:
        if up is not None and front is not None:
            raise
        missing = "front" if front is None else "up"
        raise InputError(f"{error}; give {missing} too") from None

"""Definitions of body measurements, as they stand in a file that users read, copy and change."""

from typing import Any, Literal

import msgspec

from bodymeasure.chart.landmarks.rules import LandmarkRule

TapeWanted = Literal["contact", "taut", "both"]
"""Along the skin; drawn taut; or along the skin, with the taut length beside it."""


class Iso(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Name and clause in ISO 8559-1."""

    name: str
    clause: str = ""


class _Measurement(
    msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, tag_field="kind"
):
    """What all measurements have.

    Parameters
    ----------
    key : str
        By which formulas, tables and files name it: letters, digits and underscores. ``{side}`` in
        it, in its name, words and landmarks, stands for left and right in turn: two measurements.
    name : str
    words : str
        What is measured, and how the tape lies.
    group : str
        Heading in tables, such as "Girths".
    iso : Iso, optional
    seamly : tuple of str
        Names in Seamly2D's list of measurements.
    freesewing : str, optional
        Key in FreeSewing's list of measurements.
    """

    key: str
    name: str
    words: str = ""
    group: str = ""
    iso: Iso | None = None
    seamly: tuple[str, ...] = ()
    freesewing: str | None = None


class PathMeasure(_Measurement, frozen=True, kw_only=True, tag="path"):
    """Along the surface through landmarks in order."""

    through: tuple[str, ...]
    tape: TapeWanted = "contact"


class DropMeasure(_Measurement, frozen=True, kw_only=True, tag="drop"):
    """Along the surface in the vertical plane through a landmark, down or up to a level.

    The plane runs from front to back, or, with ``plane = "side"``, from left to right; the way
    starts at `start` and ends at the height of `level`.
    """

    start: str
    level: str
    plane: Literal["median", "side"] = "median"
    tape: TapeWanted = "contact"


class OverMeasure(_Measurement, frozen=True, kw_only=True, tag="over"):
    """Taut, in the vertical plane from front to back through a landmark, over a straight tape.

    As a `DropMeasure` from `start` to the height of `level`, but also over the middle of a straight
    line between the two landmarks `over`, such as the bust points.
    """

    start: str
    level: str
    over: tuple[str, str]


class GirthMeasure(_Measurement, frozen=True, kw_only=True, tag="girth"):
    """Horizontal girth of the trunk, or of whatever part the landmark lies on, at its height.

    `cut` names two landmarks (armpits) at whose vertical front-to-back planes a loop that merges
    trunk and arms is cut; the gaps are bridged straight. With `limb`, the loop has to go round one
    leg or arm alone.
    """

    at: str
    tape: TapeWanted = "taut"
    cut: tuple[str, str] | None = None
    limb: bool = False


class GirthArcMeasure(_Measurement, frozen=True, kw_only=True, tag="girth arc"):
    """The front or the back part of the horizontal girth at a landmark's height.

    It runs between the places of the girth's loop that are nearest to `start` and `end`, one at the
    left and one at the right. With one `tape`, both parts together are the girth; where a taut tape
    spans a hollow that the arc ends in, the arc ends on it square across from there. `cut` is as
    for a `GirthMeasure`.
    """

    at: str
    start: str
    end: str
    side: Literal["front", "back"]
    tape: TapeWanted = "taut"
    cut: tuple[str, str] | None = None


class TiltedGirthMeasure(_Measurement, frozen=True, kw_only=True, tag="tilted girth"):
    """Girth in the plane that holds two landmarks and runs level from left to right.

    For what leans forwards or backwards, such as the neck: `front` and `back` say how far.
    """

    front: str
    back: str
    tape: TapeWanted = "taut"


class LimbGirthMeasure(_Measurement, frozen=True, kw_only=True, tag="limb girth"):
    """Girth perpendicular to the line between two landmarks, at a fraction of it or a landmark."""

    start: str
    end: str
    at: float | str = 0.5
    tape: TapeWanted = "taut"


class ExtremeGirthMeasure(_Measurement, frozen=True, kw_only=True, tag="extreme girth"):
    """The largest or smallest girth between two landmarks, horizontal or, of limbs, across."""

    start: str
    end: str
    extreme: Literal["largest", "smallest"]
    limb: bool = False
    tape: TapeWanted = "taut"


class ClosedMeasure(_Measurement, frozen=True, kw_only=True, tag="closed"):
    """The closed geodesic that a loop round the body at a landmark's height contracts to.

    It follows the skin: there is no tape to be chosen.
    """

    at: str


class HeightMeasure(_Measurement, frozen=True, kw_only=True, tag="height"):
    """Vertical distance of a landmark from the floor, or from another landmark."""

    at: str
    above: str | None = None


class BreadthMeasure(_Measurement, frozen=True, kw_only=True, tag="breadth"):
    """Horizontal distance from left to right of the loop at a landmark's height."""

    at: str


class DepthMeasure(_Measurement, frozen=True, kw_only=True, tag="depth"):
    """Horizontal distance from front to back of the loop at a landmark's height."""

    at: str


class ChordMeasure(_Measurement, frozen=True, kw_only=True, tag="chord"):
    """Straight distance between two landmarks."""

    start: str
    end: str


class FormulaMeasure(_Measurement, frozen=True, kw_only=True, tag="formula"):
    """Arithmetic with the keys of other measurements: ``+ - * / ( )``, numbers, min and max.

    ``angle = true`` says that the result is in degrees, not a length (then atan, asin, acos may be
    used).
    """

    formula: str
    angle: bool = False


Measurement = (
    PathMeasure
    | DropMeasure
    | OverMeasure
    | GirthMeasure
    | GirthArcMeasure
    | TiltedGirthMeasure
    | LimbGirthMeasure
    | ExtremeGirthMeasure
    | ClosedMeasure
    | HeightMeasure
    | BreadthMeasure
    | DepthMeasure
    | ChordMeasure
    | FormulaMeasure
)


class Definitions(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A file of definitions.

    Parameters
    ----------
    format : str
        ``bodymeasure measurements``.
    version : int
        1.
    name : str
        Of the set, for titles.
    words : str
    extends : {"", "default"}
        With ``default``, the set is the default one with the changes that this file makes to it:
        what has a key (a rule: a name) that is there already takes its place, what has a new one
        follows at the end. Once read, the set stands for itself and this is empty.
    drop : tuple of str
        Keys of measurements and names of rules that are left out of what is extended.
    landmark : tuple of LandmarkRule
        Rules for landmarks that the atlas does not have; in any order. Those that it has win.
    measurement : tuple of Measurement
        In the order of the chart.
    """

    format: str
    version: int
    name: str
    words: str = ""
    extends: Literal["", "default"] = ""
    drop: tuple[str, ...] = ()
    landmark: tuple[LandmarkRule, ...] = ()
    measurement: tuple[Measurement, ...] = ()


def definitions_schema() -> dict[str, Any]:
    """JSON schema of a file of definitions, which TOML holds as well as JSON would."""
    return msgspec.json.schema(Definitions)

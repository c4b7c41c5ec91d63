"""The names of measurements in pattern programs, and the measurements that they stand for."""

import re
import unicodedata
from collections.abc import Callable, Iterable, Mapping

from bodymeasure.chart import Definitions, MeasurementDefinition
from bodymeasure.errors import InputError
from bodymeasure.report.body.records import BodyRecord
from bodymeasure.wording import hint

# All measurements of FreeSewing (its config/measurements.mjs), in alphabetical order.
# fmt: off
FREESEWING_KEYS = (
    "ankle", "biceps", "bustFront", "bustPointToUnderbust", "bustSpan", "chest", "crossSeam",
    "crossSeamFront", "crotchDepth", "head", "heel", "highBust", "highBustFront", "hips",
    "hpsToBust", "hpsToWaistBack", "hpsToWaistFront", "inseam", "knee", "neck", "seat", "seatBack",
    "shoulderSlope", "shoulderToElbow", "shoulderToShoulder", "shoulderToWrist", "underbust",
    "upperLeg", "waist", "waistBack", "waistToArmpit", "waistToFloor", "waistToHips", "waistToKnee",
    "waistToSeat", "waistToUnderbust", "waistToUpperLeg", "wrist",
)
# fmt: on
FREESEWING_DEGREES = ("shoulderSlope",)
# All measurements of a body file of GarmentCode (its assets/bodies/mean_all.yaml), in alphabetical
# order.
# fmt: off
GARMENTCODE_KEYS = (
    "arm_length", "arm_pose_angle", "armscye_depth", "back_width", "bum_points", "bust",
    "bust_line", "bust_points", "crotch_hip_diff", "head_l", "height", "hip_back_width",
    "hip_inclination", "hips", "hips_line", "leg_circ", "neck_w", "shoulder_incl", "shoulder_w",
    "underbust", "vert_bust_line", "waist", "waist_back_width", "waist_line",
    "waist_over_bust_line", "wrist",
)
# fmt: on
GARMENTCODE_DEGREES = ("arm_pose_angle", "hip_inclination", "shoulder_incl")

# Characters that no name in Seamly2D may hold (schema of its measurement files, type shortName).
# Spaces are excluded, too, and so are digits as the first character.
_SEAMLY_OPERATORS = frozenset('*/&|!<>^-()–+−=?:;"')  # noqa: RUF001  (the schema's own)
_RIGHT = re.compile(r"(?<![a-z])right(?![a-z])", re.IGNORECASE)


def check_codes(definitions: Definitions) -> None:
    """Refuse names that the pattern programs would not accept, before anything is measured.

    Raises
    ------
    InputError
        If there is such a name; the message names the measurement and what is wrong.
    """
    for definition in definitions.measurement:
        for name in definition.seamly:
            check_seamly_name(name, definition.key)
        for program, code, keys, degrees in (
            ("FreeSewing", definition.freesewing, FREESEWING_KEYS, FREESEWING_DEGREES),
            ("GarmentCode", definition.garmentcode, GARMENTCODE_KEYS, GARMENTCODE_DEGREES),
        ):
            if code is not None:
                _check_code(definition, program, code, keys, degrees)


def _check_code(
    definition: MeasurementDefinition,
    program: str,
    code: str,
    keys: tuple[str, ...],
    degrees: tuple[str, ...],
) -> None:
    """Refuse the key of a measurement in a program that does not have it, or not of that kind."""
    if code not in keys:
        raise InputError(
            f"measurement {definition.key!r}: {code!r} is no measurement of {program}; "
            f"{hint(code, keys)}"
        )
    angle = definition.in_degrees
    if angle != (code in degrees):
        expected, given = ("a length", "an angle") if angle else ("an angle", "a length")
        raise InputError(
            f"measurement {definition.key!r}: {program}'s {code!r} is {expected}, and this is "
            f"{given}"
        )


def check_seamly_name(name: str, key: str) -> None:
    """Refuse a name of a measurement that a file of Seamly2D must not hold.

    Raises
    ------
    InputError
        If it is such a name; the message gives the key of the measurement and what is expected.
    """
    if not _is_seamly_name(name):
        raise InputError(
            f"measurement {key!r}: {name!r} cannot be a name in Seamly2D; expected no spaces or "
            "operators, and no digit as the first character"
        )


def _is_seamly_name(name: str) -> bool:
    if not name or unicodedata.category(name[0]) == "Nd" or name[0] == "'":
        return False
    return not any(
        character in _SEAMLY_OPERATORS or unicodedata.category(character) == "Zs"
        for character in name
    )


def measured_by_code(
    records: Iterable[BodyRecord],
    codes: Callable[[BodyRecord], Iterable[str]],
) -> Mapping[str, BodyRecord]:
    """Return the measurement that stands for each name, in the order of the chart.

    Measurements without a value are left out. If several have the same name, the one of the
    wearer's right side is taken, or else the first.

    Parameters
    ----------
    records : iterable of BodyRecord
    codes : function
        Gives the names of a measurement in the program.
    """
    chosen: dict[str, BodyRecord] = {}
    for record in records:
        if record.value is None:
            continue
        for code in codes(record):
            if code not in chosen or (_is_right(record) and not _is_right(chosen[code])):
                chosen[code] = record
    return chosen


def _is_right(record: BodyRecord) -> bool:
    return bool(_RIGHT.search(record.key) or _RIGHT.search(record.name))

"""Findings on directions, sides and size that contradict the landmarks."""

from collections.abc import Iterator, Sequence

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.axes import DIRECTIONS
from bodymeasure.atlas.check.finding import Finding, FindingKind, Severity
from bodymeasure.atlas.check.posture import Posture, posture
from bodymeasure.atlas.units import Unit

# Degrees. Bodies lean and bend in scans, but one that lies across its way up has another way up.
TILT = 45.0
# Degrees about the vertical, beyond which the front is not where the axes have it.
TURN = 10.0
# Degrees within which a body stands along other axes; else its coordinates have to be turned.
_ALONG_AXES = 20.0
# Meters: the height of people, from the newborn to the tallest; and below the second number it is
# rather that of an adult whose inches are taken for centimeters.
SMALLEST, SMALL, LARGEST = 0.4, 0.8, 2.5
# Meters, among which the height in the likely unit is.
_LIKELY = (1.2, 2.1)
# Pairs of names; the first of each is to the left of, before or above the second.
_PAIRED = (
    *("side neck point", "shoulder point", "armpit point", "bust point", "underbust point"),
    *("side waist point", "side hip point"),
)
_SIDES = tuple((f"{name} left", f"{name} right") for name in _PAIRED)
_DEPTHS = tuple(
    (f"front {level} point", f"back {level} point") for level in ("neck", "waist", "hip")
)
_LEVELS = (
    ("neck", ("front neck point", "back neck point", *_SIDES[0])),
    ("waist", ("front waist point", "back waist point", *_SIDES[5])),
    ("hip", ("front hip point", "back hip point", *_SIDES[6])),
)
# A bust may hang low, and a knee of one who sits may be as high as the hip.
_BUST = ("bust", _SIDES[3])
_KNEE = ("knee", ("patella point left", "patella point right"))
_ORDERS = (
    (_LEVELS[0], _LEVELS[1]),
    (_LEVELS[0], _LEVELS[2]),
    (_LEVELS[1], _LEVELS[2]),
    (_LEVELS[0], _BUST),
    (_BUST, _LEVELS[2]),
    (_LEVELS[0], _KNEE),
    (_LEVELS[1], _KNEE),
)


def stance_findings(atlas: Atlas) -> list[Finding]:
    """Return what the landmarks contradict: the axes, the sides, the order or the size.

    Bent arms and legs, a lean of the body and missing landmarks are no fault; where fewer than
    three landmarks of the trunk and the legs are known, nothing is said.
    """
    found = posture(atlas)
    if found is None:
        return []
    findings = list(_direction_findings(atlas, found))
    if not findings:
        # Single names are compared only where all of them together are right.
        findings += _name_findings(atlas)
    return findings + list(_size_findings(atlas, found.stature))


def _error(kind: FindingKind, message: str) -> Finding:
    return Finding(Severity.ERROR, kind, (), message)


def _direction_findings(atlas: Atlas, found: Posture) -> Iterator[Finding]:
    left, front, up = found.directions
    axes = atlas.axes
    tilt = _degrees(up, axes.up_vector)
    if found.mirrored:
        yield _error(
            FindingKind.SIDES,
            "the landmarks are those of a body's mirror image: what is named left lies on the "
            "wearer's right; expected left as the wearer sees it; exchange left and right in the "
            "names, or, if the surface is mirrored too, change the sign of one coordinate",
        )
    if tilt > TILT:
        yield _error(
            FindingKind.DIRECTIONS,
            f"the landmarks lie as if up were {_along(up)} and the front {_along(front)}, but the "
            f"axes have up {axes.up} and front {axes.front}; {_remedy(up, front)}",
        )
        return
    if found.mirrored:
        return
    toward = _pointing_left(atlas, left)
    turn = float(np.degrees(np.arctan2(toward @ axes.front_vector, toward @ axes.left_vector)))
    if abs(turn) <= TURN:
        return
    if abs(turn) > 180.0 - _ALONG_AXES or abs(abs(turn) - 90.0) < _ALONG_AXES:
        yield _error(
            FindingKind.DIRECTIONS,
            f"the landmarks lie as if the body looked along {_along(front)}, turned by "
            f"{abs(turn):.0f} degrees about the vertical, but the axes have front {axes.front}; "
            f"{_remedy(up, front)}",
        )
        return
    # Left landmarks that lie to the front are those of one who has turned to the right.
    way, back = ("right", "left") if turn > 0.0 else ("left", "right")
    yield _error(
        FindingKind.TURNED,
        f"the body is turned by {abs(turn):.0f} degrees to its {way} about the vertical: "
        f"what is named left does not lie to the left of what is named right along the axes; "
        f"expected at most {TURN:.0f} degrees; turn the coordinates by {abs(turn):.0f} degrees "
        f"about the vertical, the body to its {back}",
    )


def _pointing_left(atlas: Atlas, otherwise: Array) -> Array:
    """Return the vector from right to left landmarks, which no shape of a body turns."""
    pairs = [
        atlas.position(atlas.landmarks[left]) - atlas.position(atlas.landmarks[right])
        for left, right in _SIDES
        if left in atlas.landmarks and right in atlas.landmarks
    ]
    return np.sum(pairs, axis=0) if pairs else otherwise


def _degrees(first: Array, second: Array) -> float:
    return float(np.degrees(np.arccos(np.clip(first @ second, -1.0, 1.0))))


def _along(direction: Array) -> str:
    axis = int(np.abs(direction).argmax())
    return DIRECTIONS[2 * axis + int(direction[axis] < 0.0)]


def _remedy(up: Array, front: Array) -> str:
    names = _along(up), _along(front)
    if names[0][1] == names[1][1]:
        return "turn the coordinates so that the body stands along the axes"
    return (
        f'give up {names[0]} and front {names[1]} (--up and --front, or "axes" in the file), or '
        "correct the names of the landmarks"
    )


def _name_findings(atlas: Atlas) -> Iterator[Finding]:
    places = {name: atlas.position(point) for name, point in atlas.landmarks.items()}
    axes = atlas.axes
    for pairs, toward, words in (
        (_SIDES, axes.left_vector, "on the wearer's right of"),
        (_DEPTHS, axes.front_vector, "behind"),
    ):
        for first, second in pairs:
            if {first, second} <= set(places) and (places[first] - places[second]) @ toward < 0.0:
                yield _error(
                    FindingKind.SIDES,
                    f"the landmark {first!r} lies {words} {second!r}, unlike the others; exchange "
                    "the two names, or move one of the points",
                )
    for (upper, above), (lower, below) in _ORDERS:
        heights = [_height(atlas, places, names) for names in (above, below)]
        if heights[0] is not None and heights[1] is not None and heights[0] < heights[1]:
            yield _error(
                FindingKind.ORDER,
                f"the landmarks of the {upper} lie {heights[1] - heights[0]:.3g} {atlas.unit} "
                f"below those of the {lower}; expected them above; correct names or points",
            )


def _height(atlas: Atlas, places: dict[str, Array], names: Sequence[str]) -> float | None:
    heights = [places[name] @ atlas.axes.up_vector for name in names if name in places]
    return float(np.mean(heights)) if heights else None


def _size_findings(atlas: Atlas, stature: float) -> Iterator[Finding]:
    meters = stature * atlas.unit.meters
    if SMALL <= meters <= LARGEST:
        return
    likely = [unit for unit in Unit if _LIKELY[0] <= stature * unit.meters <= _LIKELY[1]]
    size = f"by its landmarks the body is about {stature:.4g} {atlas.unit} tall"
    remedy = 'give the unit of the coordinates (--file-unit, or "unit" in the file), or scale them'
    if likely:
        remedy = f"are the coordinates in {likely[0]}? If so, {remedy}"
    if SMALLEST <= meters < SMALL:
        message = f"{size}, as infants are; if it is no infant, {remedy}"
        yield Finding(Severity.WARNING, FindingKind.SIZE, (), message)
        return
    yield _error(FindingKind.SIZE, f"{size}; expected {SMALLEST} to {LARGEST} m; {remedy}")

"""Loops that go round more than the part of the body that is to be measured."""

from bodymeasure.errors import InputError
from bodymeasure.section import PlaneSection, SectionLoop

# Beginnings of the names of regions.
ARM = ("upper arm", "elbow", "forearm", "wrist", "hand")
TRUNK = ("torso", "hip", "crotch")
SIDES = ("left", "right")
# How much of the arm's patches the trunk's loop may cross, as a part of the arm's own loop. Just
# below the armpits of the sample bodies it is up to 0.31; a loop that goes round the arm, too, has
# about as much as the arm's.
TOUCHED = 0.4

UNCHECKED = (
    "whether the loop goes round more than one part of the body was not checked, since the atlas "
    "names no regions"
)


def refuse_merged(section: PlaneSection, loop: SectionLoop, *, limb: bool) -> None:
    """Refuse a loop that goes round the trunk and an arm, or, for a limb, round both sides.

    The names of the patches' regions decide; an atlas without regions cannot be checked, and its
    girths say so (`Girth.remark`).

    Parameters
    ----------
    section : PlaneSection
    loop : SectionLoop
        One of its loops.
    limb : bool
        Whether it is to be the loop of an arm or a leg.

    Raises
    ------
    InputError
        The message names the regions and the remedy.

    Notes
    -----
    Just below the armpit a loop of the trunk may cross patches that belong to the arm, but only a
    little beside the arm's own loop. A tilted plane may cut the arm a second time, farther down:
    that it has another loop proves nothing. The loop of an armhole crosses the trunk's patches, but
    only those of its own side.
    """
    reason = merged(section, loop, limb=limb)
    if reason is not None:
        raise InputError(reason)


def merged(section: PlaneSection, loop: SectionLoop, *, limb: bool) -> str | None:
    """Say why `refuse_merged` refuses a loop, with the remedy; None if it does not."""
    for side in SIDES:
        arm, trunk = _length(loop, ARM, side), _length(loop, TRUNK)
        if arm == 0.0 or trunk == 0.0 or (limb and trunk <= max(arm, _length(loop, TRUNK, side))):
            continue
        others = [other for other in section.loops if other is not loop]
        own = [other.length for other in others if _length(other, ARM, side) > 0.5 * other.length]
        if not limb and own and arm <= TOUCHED * max(own):
            continue
        return (
            f"the loop merges the trunk and the {side} arm ({_words(loop)}): the plane passes "
            "above the armpit; choose a landmark below it, tilt the plane until arm and trunk are "
            "cut apart, or have a horizontal loop cut at the armpits (cut)"
        )
    if limb and all(_length(loop, ("",), side) > 0.0 for side in SIDES):
        return (
            f"the loop is to go round one limb, but has parts of both sides ({_words(loop)}): "
            "choose a place farther down the limb, or tilt the axis"
        )
    return None


def _length(loop: SectionLoop, beginnings: tuple[str, ...], side: str = "") -> float:
    return sum(
        length
        for region, length in loop.length_by_region.items()
        if region.startswith(beginnings) and region.endswith(side)
    )


def _words(loop: SectionLoop) -> str:
    return ", ".join(
        f"{region} {length:.3g} {loop.unit}"
        for region, length in sorted(loop.length_by_region.items())
    )

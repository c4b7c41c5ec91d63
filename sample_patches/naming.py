"""Names and body regions of a mannequin's patches, by a rule of its layout and landmarks.

The layout is a quadrilateral mesh whose strips (straight walks across opposite sides of patches)
follow the body: rings round neck, arms, legs and trunk, and strips along the limbs which run on
into the trunk. Strips and landmarks delimit the regions; README.md describes the scheme. Only the
wearer's left half is named by the rule; the right half mirrors it.
"""

from collections.abc import Iterator

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas

from .layout import Layout, LayoutError, Limb, Step, limb, until

# Two patches are each other's mirror image if their centers are, to this part of the body's width.
MIRROR_TOLERANCE = 1e-6

CROTCH = "crotch left"

Names = dict[int, tuple[str, str]]
"""Region, and place in it, by patch."""


def name_patches(atlas: Atlas) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Name the patches of a symmetric mannequin.

    Parameters
    ----------
    atlas : Atlas
        With the landmarks that `build.py` projects onto it; open at neck, wrists and ankles.

    Returns
    -------
    names, regions : tuple of str
        The name of each patch, which is unique and begins with its region.

    Raises
    ------
    LayoutError
        If a patch gets no name, or the halves of the body are not mirror images.
    """
    layout = Layout(atlas)
    named = _name_left_half(layout)
    mirror = mirror_patches(layout)
    for patch, (region, place) in list(named.items()):
        named[int(mirror[patch])] = (region.replace("left", "right"), place)
    missing = [patch for patch in range(len(atlas)) if patch not in named]
    if missing:
        raise LayoutError(f"the rule reaches no patch of {missing}")
    ordered = [named[patch] for patch in range(len(atlas))]
    return tuple(f"{region} {place}" for region, place in ordered), tuple(r for r, _ in ordered)


def mirror_patches(layout: Layout) -> Ints:
    """Number of each patch's mirror image across the body's center plane.

    Raises
    ------
    LayoutError
        If some patch has none.
    """
    centers = layout.centers
    mirrored = centers - 2.0 * layout.to_left[:, None] * layout.atlas.axes.left_vector
    apart = np.linalg.norm(mirrored[:, None] - centers, axis=-1)
    if apart.min(axis=1).max() > MIRROR_TOLERANCE * np.ptp(layout.to_left):
        raise LayoutError("the halves of the body are not mirror images of each other")
    return np.asarray(apart.argmin(axis=1))


def _name_left_half(layout: Layout) -> Names:
    neck_loop, wrist_loop, ankle_loop = layout.boundary_loops()
    # Past its last ring, the arm has one more patch of each strip up to the armhole.
    arm = limb(layout, wrist_loop, beyond=1)
    leg = limb(layout, ankle_loop, beyond=0)
    named: Names = {}
    for patch, region, place in _in_order(layout, neck_loop, arm, leg):
        named[patch] = (f"{region} left", place)
    _name_trunk(layout, _center_strip(layout, neck_loop), leg.into_trunk("outer"), named)
    return named


def _in_order(
    layout: Layout, neck_loop: list[Step], arm: Limb, leg: Limb
) -> Iterator[tuple[int, str, str]]:
    """Patch, region and place of all but the trunk."""
    elbow = _row_above(layout, arm, layout.landmark("elbow point left"))
    for row in range(arm.length):
        region, first = ("upper arm", 0) if row <= elbow else ("forearm", elbow + 1)
        for place, (patch, _) in arm.ring(row).items():
            yield patch, region, f"{row - first + 1} {place}"

    knee = _row_with(leg, layout.atlas.landmarks["patella point left"].patch)
    for row in range(leg.length):
        for place, (patch, _) in leg.ring(row).items():
            if row < knee:
                yield patch, "thigh", f"{row + 1} {place}"
            elif row == knee:
                yield patch, "knee", place
            else:
                yield patch, "lower leg", f"{row - knee} {place}"

    # Half the neck's ring, from the front center round to the back center.
    neck = [patch for patch, _ in neck_loop if layout.to_left[patch] > 0.0]
    neck.sort(key=lambda patch: -layout.to_front[patch])
    for column, patch in enumerate(neck, start=1):
        yield patch, "neck", f"1-{column}"

    # The outer and front strips of the arm run on to the neck.
    for place, name in (("outer", "top"), ("front", "front")):
        strap = until(arm.into_trunk(place), neck)
        for row, (patch, _) in enumerate(reversed(strap), start=1):
            yield patch, "shoulder", f"{row} {name}"

    # The inner strip of the leg runs on to its mirror image.
    crotch = [patch for patch, _ in leg.into_trunk("inner") if layout.to_left[patch] > 0.0]
    crotch.sort(key=lambda patch: layout.to_left[patch])
    for column, patch in enumerate(crotch, start=1):
        yield patch, "crotch", f"1-{column}"


def _center_strip(layout: Layout, neck_loop: list[Step]) -> list[Step]:
    """The patches on the left of the center line, from the front neck to the back neck."""
    patch, side = max(
        (step for step in neck_loop if layout.to_left[step[0]] > 0.0),
        key=lambda step: layout.to_front[step[0]],
    )
    return layout.strip((patch, side ^ 1))


def _name_trunk(layout: Layout, center: list[Step], outer: list[Step], named: Names) -> None:
    """Name what is left: rows from the center line to the strip below the armhole, and that."""
    bottom = next(i for i, (patch, _) in enumerate(center) if _region(named, patch) == CROTCH)
    beside = until(outer, named.keys())[::-1]
    # Walked backwards, a patch of the strip is left by the opposite side.
    up_the_back = [(patch, side ^ 1) for patch, side in reversed(center[bottom + 1 :])]
    stop = named.keys() | {patch for patch, _ in beside}
    part: dict[int, str] = {}
    rows: dict[tuple[str, str], list[list[int]]] = {}
    for aspect, strip in (("front", center[:bottom]), ("back", up_the_back)):
        column = [step for step in strip if step[0] not in named]
        waist = _side_nearest(layout, column, layout.landmark(f"{aspect} waist point"))
        for i, step in enumerate(column):
            outwards = layout.strip(layout.left_side(step))
            row = until(outwards, stop)
            where = "torso" if i <= waist else "hip"
            rows.setdefault((where, aspect), []).append([patch for patch, _ in row])
            part[outwards[len(row)][0]] = where

    # Below the end of the front center, rows are reached from the side only.
    reached = stop | {patch for found in rows.values() for patches in found for patch in patches}
    for step in beside:
        patch, left = layout.left_side(step)
        for side in (left, left ^ 1):
            row = until(layout.strip((patch, side))[1:], reached)
            if row:
                rows[part[patch], "front"].append([patch for patch, _ in reversed(row)])

    for (where, aspect), found in rows.items():
        for i, patches in enumerate(found, start=1):
            for j, patch in enumerate(patches, start=1):
                named[patch] = (f"{where} {aspect} left", f"{i}-{j}")
    for where in ("torso", "hip"):
        for i, patch in enumerate((patch for patch, _ in beside if part[patch] == where), start=1):
            named[patch] = (f"{where} side left", f"{i}")
    # The patch that no row reaches is the tip of the breast, which rows frame.
    for patch in np.flatnonzero(layout.to_left > 0.0).tolist():
        named.setdefault(patch, ("torso front left", "bust"))


def _region(named: Names, patch: int) -> str:
    return named[patch][0] if patch in named else ""


def _side_nearest(layout: Layout, column: list[Step], position: Array) -> int:
    """Number of the step whose side has the end closest to a position."""
    apart = [np.linalg.norm(layout.ends(step) - position, axis=1).min() for step in column]
    return int(np.argmin(apart))


def _row_above(layout: Layout, part: Limb, position: Array) -> int:
    """Row of a limb whose lower end is closest to a position."""
    apart = [
        min(
            np.linalg.norm(layout.ends((patch, side ^ 1)) - position, axis=1).min()
            for patch, side in part.ring(row).values()
        )
        for row in range(part.length)
    ]
    return int(np.argmin(apart))


def _row_with(part: Limb, patch: int) -> int:
    """Row of a limb that holds a patch."""
    for row in range(part.length):
        if patch in [step[0] for step in part.ring(row).values()]:
            return row
    raise LayoutError(f"patch {patch} is not on the limb")

"""The choice of parts of an atlas by the groups that its file names."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from bodymeasure.atlas import Atlas
from bodymeasure.atlas.approximation import extent
from bodymeasure.errors import InputError

# Groups that an error lists; it counts the others.
_LISTED = 12


def select_groups(atlas: Atlas, groups: Sequence[str]) -> Atlas:
    """Return the patches of some groups.

    Parameters
    ----------
    atlas : Atlas
    groups : sequence of str
        Each is a region of patches, or one of the words of it.

    Returns
    -------
    Atlas
        Without the other patches, their control points and their landmarks.

    Raises
    ------
    InputError
        If there is no such group; the message lists those that there are.
    """
    known = {word for region in set(atlas.regions) for word in (region, *region.split()) if word}
    for group in groups:
        if group not in known:
            listed = ", ".join(sorted(known)[:_LISTED])
            more = f" and {len(known) - _LISTED} more" if len(known) > _LISTED else ""
            raise InputError(
                f"no patch is in a group {group!r}; there are: {listed}{more}"
                if known
                else f"no patch is in a group {group!r}; the file names no groups"
            )
    wanted = set(groups)
    chosen = [
        number
        for number, region in enumerate(atlas.regions)
        if region in wanted or not wanted.isdisjoint(region.split())
    ]
    used, index = np.unique(atlas.index[chosen], return_inverse=True)
    points, approximation = atlas.points[used], atlas.approximation
    if approximation is not None:
        size = extent(atlas.points) / (extent(points) or 1.0)
        approximation = approximation.part(np.array(chosen), size)
    new_number = {old: new for new, old in enumerate(chosen)}
    return replace(
        atlas,
        points=points,
        index=index.reshape(len(chosen), *atlas.index.shape[1:]),
        weights=None if atlas.weights is None else atlas.weights[chosen],
        patch_names=tuple(atlas.patch_names[number] for number in chosen),
        regions=tuple(atlas.regions[number] for number in chosen),
        landmarks={
            name: point._replace(patch=new_number[point.patch])
            for name, point in atlas.landmarks.items()
            if point.patch in new_number
        },
        approximation=approximation,
        faces=None if atlas.faces is None else atlas.faces.part(np.array(chosen)),
        scan=None if atlas.scan is None else atlas.scan.part(np.array(chosen)),
    )

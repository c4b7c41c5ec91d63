"""Sentences that say what an atlas approximates, and how well."""

import numpy as np

from bodymeasure.atlas.approximation import ApproximationKind, extent
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.units import Unit, convert_length

# What patches of each kind approximate.
_SURFACES = {
    ApproximationKind.SMOOTHED: "the Catmull-Clark surface of a mesh",
    ApproximationKind.INTERPOLATED: "a Catmull-Clark surface through the vertices of a mesh",
}


def approximation_sentences(atlas: Atlas, unit: Unit | str | None = None) -> tuple[str, ...]:
    """Return what the patches of an atlas approximate and what that costs, in sentences.

    Parameters
    ----------
    atlas : Atlas
    unit : Unit or str, optional
        Unit of the distances; that of the atlas if not given.

    Returns
    -------
    tuple of str
        None if the atlas approximates nothing.
    """
    found = atlas.approximation
    if found is None:
        return ()
    target = atlas.unit if unit is None else Unit.parse(unit)
    size = convert_length(extent(atlas.points), atlas.unit, target)

    def length(part: float) -> str:
        return f"{size * part:.2g} {target}"

    largest, root = float(found.distance.max()), float(np.sqrt((found.distance**2).mean()))
    most, mean = _percent(found.stretch.max()), _percent(found.stretch.mean())
    if largest:
        first = (
            f"The patches approximate {_SURFACES[found.kind]}: they lie within {length(largest)} "
            f"of it (root mean square {length(root)}), and lengths differ by at most {most} there, "
            f"{mean} on average."
        )
    else:
        first = f"The patches are {_SURFACES[found.kind]}."
    change = found.mesh_lengths
    return (
        first,
        f"The mesh itself lies within {length(found.mesh_distance)} of the patches (root mean "
        f"square {length(found.mesh_rms)}); lengths on it are about {_percent(abs(change))} "
        f"{'shorter' if change < 0.0 else 'longer'}.",
    )


def _percent(part: float) -> str:
    return f"{100.0 * part:.2g} %"

"""An atlas in numbers, and in sentences that say what it approximates."""

from dataclasses import dataclass

import numpy as np

from bodymeasure.atlas.approximation import ApproximationKind, extent
from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.check.degeneracy import collapsed_sides
from bodymeasure.atlas.queries.farthest import size_along
from bodymeasure.atlas.seams import edge_table
from bodymeasure.atlas.size import patch_sizes
from bodymeasure.atlas.topology.joins import parts, seams_of
from bodymeasure.atlas.units import Unit, convert_length
from bodymeasure.bezier import project

# What patches of each kind approximate.
_SURFACES = {
    ApproximationKind.SMOOTHED: "the Catmull-Clark surface of a mesh",
    ApproximationKind.INTERPOLATED: "a Catmull-Clark surface through the vertices of a mesh",
}


@dataclass(frozen=True)
class AtlasSummary:
    """The content of an atlas in numbers.

    Parameters
    ----------
    patches, control_points : int
    degree : int
    rational : bool
    unit : Unit
    height, width, depth : float
        Sizes of the box around the surface, along the atlas's axes: up, across, to the front.
    seams, boundary_edges, parts : int
        Numbers of edges that two patches share, of edges that one has alone, and of connected
        parts.
    collapsed_edges : int
        Number of sides that are a point, whether their control points are one or lie in one place.
    smallest_patch, largest_patch : float
        Diagonals of the boxes around their control points.
    regions, landmarks : tuple of str
    """

    patches: int
    control_points: int
    degree: int
    rational: bool
    unit: Unit
    height: float
    width: float
    depth: float
    seams: int
    boundary_edges: int
    parts: int
    collapsed_edges: int
    smallest_patch: float
    largest_patch: float
    regions: tuple[str, ...]
    landmarks: tuple[str, ...]


def summarize(atlas: Atlas) -> AtlasSummary:
    """Describe an atlas in numbers, in its unit.

    Parameters
    ----------
    atlas : Atlas

    Returns
    -------
    AtlasSummary
    """
    table = edge_table(atlas.index)
    collapsed = table.collapsed | collapsed_sides(project(atlas.control_points))
    sides = table.sides[table.edge][~collapsed]
    axes, nets = atlas.axes, atlas.points[atlas.index]
    frame = np.stack([axes.up_vector, axes.left_vector, axes.front_vector])
    box = size_along(atlas, frame)
    sizes = patch_sizes(nets)
    return AtlasSummary(
        patches=len(atlas),
        control_points=len(np.unique(atlas.index)),
        degree=atlas.degree,
        rational=atlas.is_rational,
        unit=atlas.unit,
        height=float(box[0]),
        width=float(box[1]),
        depth=float(box[2]),
        seams=int((sides == 2).sum()) // 2,
        boundary_edges=int((sides == 1).sum()),
        parts=int(parts(seams_of(table, collapsed), len(atlas)).max()) + 1,
        collapsed_edges=int(collapsed.sum()),
        smallest_patch=float(sizes.min()),
        largest_patch=float(sizes.max()),
        regions=tuple(sorted(set(atlas.regions) - {""})),
        landmarks=tuple(atlas.landmarks),
    )


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

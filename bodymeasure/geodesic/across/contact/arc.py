"""Arcs along an edge of the atlas, or along a seam that holds a path from both sides."""

import numpy as np

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.seams import EDGES
from bodymeasure.atlas.topology.neighbors import Neighbors
from bodymeasure.bezier import scaled
from bodymeasure.geodesic.across.contact.pattern import side_of
from bodymeasure.geodesic.contact.edge_arc import EdgeArc, edge_arc
from bodymeasure.geodesic.contact.legs import Contact
from bodymeasure.geodesic.surfaces.rational import surfaces_of


def on_edge(neighbors: Neighbors, place: AtlasPoint, patch: int, contact: Contact) -> AtlasPoint:
    """Return the same point of the atlas as a place on an edge of a given patch."""
    return next(
        same
        for same in neighbors.same(place)
        if same.patch == patch and same[1 + contact.axis] == contact.value
    )


def pressed_arc(
    atlas: Atlas,
    neighbors: Neighbors,
    contact: Contact,
    ends: tuple[AtlasPoint, AtlasPoint],
    size: float,
) -> EdgeArc | None:
    """Return an arc along an edge, with lengths in parts of the size.

    None if a path would be shorter inside of the patch or of one that it meets along that edge.
    """
    patch = ends[0].patch
    sides = [(patch, contact, ends)]
    for crossing in neighbors.over.get((patch, side_of(contact)), ()):
        edge = EDGES[crossing.to_side]
        beyond = Contact(edge.fixed_axis, edge.fixed_value)
        begin, end = (on_edge(neighbors, place, crossing.to_patch, beyond) for place in ends)
        sides.append((crossing.to_patch, beyond, (begin, end)))
    arcs = []
    for number, on, (begin, end) in sides:
        surface = surfaces_of(scaled(atlas.control_points[[number]], 1.0 / size))
        arcs.append(edge_arc(surface, on, np.array(begin[1:]), np.array(end[1:])))
    if not all(arc.is_pressed for arc in arcs):
        return None
    return arcs[0]._replace(is_geodesic=all(arc.is_geodesic for arc in arcs))

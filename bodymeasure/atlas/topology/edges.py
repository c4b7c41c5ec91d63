"""The edges of an atlas, which all sections, meshes and searches of it share."""

from bodymeasure.atlas.atlas import Atlas
from bodymeasure.atlas.prepared import prepared
from bodymeasure.atlas.seams import EdgeTable, edge_table


@prepared
def edges_of(atlas: Atlas) -> EdgeTable:
    """Return the table of an atlas's edges; its arrays are read-only."""
    table = edge_table(atlas.index)
    for array in (table.control_index, table.edge, table.reversed, table.sides):
        array.flags.writeable = False
    return table

"""The objects of a Rhino file that are seen, each with the place to which blocks bring it."""

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from bodymeasure._typing import Array

# Blocks may hold blocks, and a damaged file may nest them without end.
DEEPEST = 64
# Members of blocks that a file may place; nested blocks multiply them.
MOST_PLACED = 100_000
# The transform of what no block places.
UNMOVED = np.eye(4)
# Objects that a note names; it counts the others.
_NAMED = 12


class Placed(NamedTuple):
    """An object that is seen.

    Parameters
    ----------
    number : int
        Its place in the file's table of objects.
    item : Any
    name : str
        Its name, after those of the blocks' instances that place it.
    transform : ndarray, shape (4, 4)
        Takes the homogeneous coordinates of its points to their places.
    """

    number: int
    item: Any
    name: str
    transform: Array


class _Reader(NamedTuple):
    """A file, its objects by their identifiers, and what is found on the way through it."""

    file: Any
    numbers: dict[str, int]
    hidden: dict[int, str]
    notes: list[str]
    placed: list[int]


def seen_objects(file: Any) -> tuple[list[Placed], list[str]]:
    """Return the objects that Rhino shows, those of blocks where they are placed, and notes.

    Members of block definitions are seen where instances place them only. Hidden objects, and all
    on layers that are off or lie under one that is off, are left out; a note counts and names them.
    """
    items = list(file.Objects)
    numbers = {str(item.Attributes.Id): number for number, item in enumerate(items)}
    reader = _Reader(file, numbers, {}, [], [])
    found: list[Placed] = []
    for number, item in enumerate(items):
        if not item.Attributes.IsInstanceDefinitionObject:
            found += _placed(reader, Placed(number, item, "", UNMOVED), ())
    notes = list(dict.fromkeys(reader.notes))
    if len(reader.placed) > MOST_PLACED:
        notes.append(f"blocks place more than {MOST_PLACED:,} objects; the others are left out")
    if reader.hidden:
        notes.append(_left_out(list(reader.hidden.values())))
    return found, notes


def called(number: int, item: Any) -> str:
    """Return the words by which a message names an object."""
    name = item.Attributes.Name
    return f"object {number}" + (f" ({name!r})" if name else "")


def _placed(reader: _Reader, at: Placed, inside: Sequence[str]) -> Iterator[Placed]:
    """The object itself, or the members of the block that it places; `inside` are those round it.

    The name of `at` is that of the instances round it.
    """
    import rhino3dm

    attributes, geometry = at.item.Attributes, at.item.Geometry
    why = _why_hidden(reader.file, attributes)
    if why:
        reader.hidden[at.number] = f"{called(at.number, at.item)}{why}"
        return
    at = at._replace(name=" ".join(name for name in (at.name, attributes.Name) if name))
    if not isinstance(geometry, rhino3dm.InstanceReference):
        yield at
        return
    reference: Any = geometry
    block = str(reference.ParentIdefId)
    members = _members(reader, block)
    place = called(at.number, at.item)
    if not members or block in inside or len(inside) >= DEEPEST:
        nested = f"holds itself or lies more than {DEEPEST} deep"
        why = nested if members else "has no objects in this file (it may be linked)"
        reader.notes.append(f"{place} places a block that {why}; it is left out")
        return
    transform: Array = at.transform @ _matrix(reference.Xform)
    for number in members:
        reader.placed.append(number)
        if len(reader.placed) > MOST_PLACED:
            return
        member = Placed(number, reader.file.Objects[number], at.name, transform)
        yield from _placed(reader, member, (*inside, block))


def _members(reader: _Reader, block: str) -> list[int]:
    """The numbers of a block definition's objects."""
    for definition in reader.file.InstanceDefinitions:
        if str(definition.Id) == block:
            listed = map(str, definition.GetObjectIds())
            return [reader.numbers[each] for each in listed if each in reader.numbers]
    return []


def _matrix(transform: Any) -> Array:
    return np.array([[getattr(transform, f"M{i}{j}") for j in range(4)] for i in range(4)])


def _why_hidden(file: Any, attributes: Any) -> str | None:
    """Return what a note adds to the name of a hidden object; None if it is seen."""
    if not attributes.Visible or attributes.Mode.name == "Hidden":
        return " is hidden"
    index, layers = attributes.LayerIndex, file.Layers
    if not 0 <= index < len(layers):
        return None
    by_id = {str(layer.Id): layer for layer in layers}
    layer: Any = layers[index]
    for _ in range(len(layers)):
        if layer is None:
            return None
        if not layer.Visible:
            return f" on the layer {layer.Name!r}, which is off"
        layer = by_id.get(str(layer.ParentLayerId))
    return None


def _left_out(hidden: list[str]) -> str:
    more = f" and {len(hidden) - _NAMED} more" if len(hidden) > _NAMED else ""
    what = "1 object is" if len(hidden) == 1 else f"{len(hidden)} objects are"
    return f"{what} not shown in Rhino and left out: {', '.join(hidden[:_NAMED])}{more}"

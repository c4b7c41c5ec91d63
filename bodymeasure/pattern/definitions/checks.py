"""What is wrong with a panel, apart from the types of its members."""

from collections import Counter
from collections.abc import Iterator

from bodymeasure.pattern.definitions.panels import Dart, Edge, Extend, Panel
from bodymeasure.wording import hint

# In meters: a hem has some centimeters.
MOST_ALLOWANCE = 0.2


# In meters: the longest paper beyond an edge.
LONGEST = 3.0
# In meters: the most that is gathered into a seam.
MOST_EASE = 1.0


def panel_faults(panel: Panel) -> Iterator[str]:
    """Yield sentences on what is wrong with a panel."""
    yield from _name_faults(panel)
    names = [edge.name for edge in panel.edge]
    if len(names) < 3:
        yield f"has {len(names)} edges; expected three or more, in order round the panel"
        return
    for name, count in Counter([*names, *(dart.name for dart in panel.dart)]).items():
        if count > 1:
            yield f"has {count} edges or darts named {name!r}; rename them"
    yield from _allowance_faults(panel)
    for edge in panel.edge:
        yield from _edge_faults(edge)
    for before, after in zip(panel.edge, (*panel.edge[1:], panel.edge[0]), strict=True):
        ends = before.through[-1:], after.through[:1]
        if ends[0] != ends[1]:
            yield (
                f"edge {before.name!r} ends at {', '.join(map(repr, ends[0]))}, but the next edge "
                f"{after.name!r} begins at {', '.join(map(repr, ends[1]))}; let them meet at one "
                "landmark, or list the edges in order round the panel"
            )
    for member in ("fold", "grain"):
        named = getattr(panel, member)
        if named and named not in names:
            yield f"{member} names the edge {named!r}, which it lacks; {hint(named, names)}"
    for edge in panel.edge:
        if edge.ease and edge.name == panel.fold:
            yield f"edge {edge.name!r} has ease, but is the fold, which is no seam"
    if panel.extend is not None:
        yield from _extend_faults(panel, panel.extend)
    for dart in panel.dart:
        yield from _dart_faults(dart, names, panel.fold)


def _name_faults(panel: Panel) -> Iterator[str]:
    """Names are the labels of pieces, and identify their paths in files."""
    yield from _bad_name("", panel.name)
    for number, edge in enumerate(panel.edge, start=1):
        yield from _bad_name(f"edge {number}: ", edge.name)
    for number, dart in enumerate(panel.dart, start=1):
        yield from _bad_name(f"dart {number}: ", dart.name)


def _bad_name(where: str, name: str) -> Iterator[str]:
    if not name.strip() or not name.isprintable():
        yield f"{where}has the name {name!r}; expected one of printable characters, on one line"


def _allowance_faults(panel: Panel) -> Iterator[str]:
    given = [("", panel.allowance), *((f"edge {e.name!r}: ", e.allowance) for e in panel.edge)]
    for where, allowance in given:
        if allowance is not None and not 0.0 <= allowance <= MOST_ALLOWANCE:
            yield (
                f"{where}allowance is {allowance}; expected a length in meters, 0 to "
                f"{MOST_ALLOWANCE}"
            )
    for edge in panel.edge:
        if edge.name == panel.fold and edge.allowance:
            yield f"edge {edge.name!r} is the fold, which has no allowance; leave it out"
        for place in edge.notches or ():
            if not 0.0 < place < 1.0:
                yield (
                    f"edge {edge.name!r} has a notch at {place}; expected a part of its length "
                    "between 0 and 1"
                )


def _extend_faults(panel: Panel, extend: Extend) -> Iterator[str]:
    names = [edge.name for edge in panel.edge]
    if extend.edge not in names:
        yield f"extends the edge {extend.edge!r}, which it lacks; {hint(extend.edge, names)}"
        return
    if extend.edge == panel.fold:
        yield "extends its fold, which ends the piece; choose another edge"
    if next(edge.seam for edge in panel.edge if edge.name == extend.edge):
        yield (
            f"extends the edge {extend.edge!r}, which is sewn to another there; extend a hem, or "
            "leave out its seam"
        )
    if not panel.fold and not panel.grain:
        yield "is extended along its grain, but has none; name the edge of its grain"
    if not 0.0 < extend.length <= LONGEST or not abs(extend.flare) <= extend.length:
        yield (
            f"is extended by {extend.length} and flared by {extend.flare}; expected lengths in "
            f"meters, up to {LONGEST}, and the flare no more than the length"
        )


def _edge_faults(edge: Edge) -> Iterator[str]:
    if len(edge.through) < 2:
        yield f"edge {edge.name!r} has fewer than two landmarks in 'through'; give both ends"
    if len(set(edge.through)) < len(edge.through):
        yield f"edge {edge.name!r} leads through one landmark twice; leave it out"
    if not abs(edge.ease) <= MOST_EASE:
        yield (
            f"edge {edge.name!r} has an ease of {edge.ease}; expected by how much it is longer "
            f"than its curve, in meters, at most {MOST_EASE}"
        )
    if edge.ease and not edge.seam:
        yield f"edge {edge.name!r} has ease, but no seam into which it is eased; name one"
    if edge.kind == "section":
        if edge.plane is None:
            yield (
                f"edge {edge.name!r} is a section without a plane; give three landmarks, or two to "
                "whose way it is square, or 'front', 'level' or 'median'"
            )
        elif not isinstance(edge.plane, str) and (
            len(edge.plane) not in (2, 3) or len(set(edge.plane)) < len(edge.plane)
        ):
            yield (
                f"edge {edge.name!r} has a plane of {', '.join(map(repr, edge.plane))}; expected "
                "three different landmarks of it, or two between which it is square"
            )
        if len(edge.through) > 2:
            yield f"edge {edge.name!r} is a section, which has two ends and no landmark between"
    elif edge.plane is not None or edge.via:
        yield (
            f"edge {edge.name!r} is a {edge.kind}, which has neither plane nor via; make it a "
            'section (kind = "section"), or leave them out'
        )


def _dart_faults(dart: Dart, edges: list[str], fold: str) -> Iterator[str]:
    if dart.edge not in edges:
        yield f"dart {dart.name!r} begins on the edge {dart.edge!r}, which it lacks; " + hint(
            dart.edge, edges
        )
    elif dart.edge == fold:
        yield f"dart {dart.name!r} begins on the fold, which stays straight; choose another edge"
    if bool(dart.foot) == (dart.at is not None):
        yield f"dart {dart.name!r} has to have one of 'foot' and 'at', where it begins"
    if dart.at is not None and not 0.0 < dart.at < 1.0:
        yield f"dart {dart.name!r}: at is {dart.at}; expected a part of the edge between 0 and 1"
    if bool(dart.tip) == bool(dart.towards):
        yield f"dart {dart.name!r} has to have one of 'tip' and 'towards', to where it leads"
    if dart.towards and dart.towards not in edges:
        yield (
            f"dart {dart.name!r} leads towards the edge {dart.towards!r}, which it lacks; "
            + hint(dart.towards, edges)
        )
    if dart.length is not None and (dart.short or not 0.0 < dart.length < 10.0):
        yield (
            f"dart {dart.name!r}: length is {dart.length}, short {dart.short}; expected one of "
            "them, in meters"
        )
    if not 0.0 <= dart.short < 10.0:
        yield f"dart {dart.name!r}: short is {dart.short}; expected a length in meters"
    if not 0.0 <= dart.drill < 1.0:
        yield f"dart {dart.name!r}: drill is {dart.drill}; expected a length in meters"
    if dart.towards and not dart.short and dart.length is None:
        yield f"dart {dart.name!r} would reach the edge {dart.towards!r}; give it a length or short"

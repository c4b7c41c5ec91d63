"""Seams of sets of panels that nothing is sewn to, as when a name is misspelled."""

from collections import defaultdict
from collections.abc import Collection, Iterator, Sequence
from itertools import combinations

from bodymeasure.pattern.definitions.panels import Edge, Panel
from bodymeasure.wording import nearest


def seam_faults(panels: Sequence[Panel]) -> Iterator[str]:
    """Yield sentences on edges of two panels that are one curve, but name different seams."""
    edges = [(panel, edge) for panel in panels for edge in panel.edge if edge.seam]
    lonely = {edge.seam for _, edge in _lonely(panels)}
    for (one, first), (other, second) in combinations(edges, 2):
        same = one is not other and _curve(first) == _curve(second)
        if same and first.seam != second.seam and lonely & {first.seam, second.seam}:
            yield (
                f"edge {first.name!r} of panel {one.name!r} and edge {second.name!r} of panel "
                f"{other.name!r} are one curve, but name the seams {first.seam!r} and "
                f"{second.seam!r}; let both name the same seam, or leave one of them out"
            )


def lonely_seams(panels: Sequence[Panel], known: Collection[str]) -> Iterator[str]:
    """Yield sentences on edges to which nothing is sewn, in a set of panels.

    Parameters
    ----------
    panels : sequence of Panel
    known : collection of str
        Seams of which the other side may be in another set.
    """
    every = [edge.seam for panel in panels for edge in panel.edge if edge.seam]
    for panel, edge in _lonely(panels):
        if edge.seam in known:
            continue
        near = nearest(edge.seam, {*every, *known} - {edge.seam})
        asked = f"did you mean {near!r}? If not, name" if near else "name"
        yield (
            f"seam {edge.seam!r}: nothing is sewn to edge {edge.name!r} of {panel.name!r}; {asked} "
            "the seam of another edge, or leave it out"
        )


def _lonely(panels: Sequence[Panel]) -> Iterator[tuple[Panel, Edge]]:
    """Yield the edges that are alone in their seams.

    An edge in the middle of the body is sewn to its mirror image if its panel is on one side.
    """
    by_seam: dict[str, list[tuple[Panel, Edge]]] = defaultdict(list)
    for panel in panels:
        for edge in panel.edge:
            by_seam[edge.seam].append((panel, edge))
    for seam, members in by_seam.items():
        panel, edge = members[0]
        on_one_side = not panel.fold and not all(map(is_middle, panel.edge))
        if seam and len(members) == 1 and not (on_one_side and is_middle(edge)):
            yield panel, edge


def is_middle(edge: Edge) -> bool:
    """Return whether an edge is in the middle of the body: none of its landmarks is on a side."""
    return not any({"left", "right"} & set(name.split(" ")) for name in edge.through)


def _curve(edge: Edge) -> tuple[object, ...]:
    return edge.kind, edge.plane, edge.via, min(edge.through, edge.through[::-1])

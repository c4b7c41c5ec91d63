"""The landmarks that panels name, as far as the chart's rules give them."""

from collections.abc import Iterable, Mapping

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart import LandmarkRule, both_sides, derive_landmarks, load_definitions
from bodymeasure.errors import InputError
from bodymeasure.pattern.definitions.panels import Panel, PatternDefinitions
from bodymeasure.wording import hint


def named_in(panel: Panel) -> list[str]:
    """Return all landmarks that a panel names."""
    names = [panel.inside] if isinstance(panel.inside, str) else [*panel.inside]
    for edge in panel.edge:
        names += edge.through
        if isinstance(edge.plane, tuple):
            names += edge.plane
        names.append(edge.via)
    for dart in panel.dart:
        names += [dart.foot, dart.tip]
    return [name for name in dict.fromkeys(names) if name]


def panel_landmarks(
    atlas: Atlas, definitions: PatternDefinitions, levels: Iterable[str] = ()
) -> Mapping[str, AtlasPoint]:
    """Return the landmarks that panels name, and those of levels that are there.

    Raises
    ------
    InputError
        If a landmark is missing; the message names the panel, the landmark and the reason.
    """
    rules = {rule.name: rule for rule in both_sides(load_definitions().landmark)}
    rules |= {rule.name: rule for rule in definitions.landmark}
    panels = definitions.panel
    needed = _needed(rules, [*levels, *(name for panel in panels for name in named_in(panel))])
    derived = derive_landmarks(atlas, [rules[name] for name in needed], strict=False)
    for panel in panels:
        for name in named_in(panel):
            if name in derived.landmarks:
                continue
            if name in derived.missing:
                reason = f"is missing: {derived.missing[name]}"
            else:
                known = sorted({*atlas.landmarks, *rules})
                reason = f"neither the body nor a rule has ({hint(name, known)})"
            raise InputError(
                f"panel {panel.name!r} needs the landmark {name!r}, which {reason}; pick it with "
                "`bodymeasure landmarks add`, or name another"
            )
    return derived.landmarks


def _needed(rules: Mapping[str, LandmarkRule], names: Iterable[str]) -> list[str]:
    """Return the names of the rules that some landmarks need, in the rules' own order."""
    queue, found = [*names], set()
    while queue:
        name = queue.pop()
        if name in rules and name not in found:
            found.add(name)
            queue += rules[name].landmarks
    return [name for name in rules if name in found]

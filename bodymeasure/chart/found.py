"""Landmarks of a fitted body by its shape, in place of those that the body model carries."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np

from bodymeasure.arguments import several
from bodymeasure.atlas import Atlas, AtlasPoint, LandmarkFound, LandmarkOrigin
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.chart.landmarks.derive import derive_landmarks
from bodymeasure.chart.landmarks.rules.base import LandmarkRule
from bodymeasure.chart.reading.read import definitions_from
from bodymeasure.chart.sides import both_sides
from bodymeasure.files import read_bytes
from bodymeasure.threads import one_blas_thread

FILE = Path(__file__).parent / "data" / "found.toml"
# In meters: a rule that finds a landmark farther from its carried place has found something else.
# The rules' places are 1 to 5 cm from the model's where they find the right thing.
FARTHEST = 0.08
# In meters: the root mean square distance of a landmark that a rule finds on a fitted body from the
# place where it finds it on the true one (`tests/benchmarks/bodies/found_landmarks.py`).
UNCERTAINTY = 0.003


@dataclass(frozen=True, eq=False)
class FoundLandmarks:
    """The landmarks of a fitted body that its shape defines.

    Parameters
    ----------
    atlas : Atlas
        With these landmarks in place of the carried ones; its provenance names them, and its record
        of the scan, if it has one, says how sure they are.
    by_rule : tuple of str
        The landmarks that rules have found.
    carried : mapping of str to str
        The landmarks that stay where they were because their rules failed, each with the reason.
    """

    atlas: Atlas
    by_rule: tuple[str, ...]
    carried: Mapping[str, str]


@one_blas_thread()
def found_landmarks(atlas: Atlas, *, keep: Collection[str] = ()) -> FoundLandmarks:
    """Find the landmarks of a fitted body that are defined by its shape.

    `fit_body` does so already.

    Parameters
    ----------
    atlas : Atlas
        On the samples' layout, with the landmarks that the body model carries.
    keep : collection of str
        Landmarks that stay where they are, as those that a user has picked.

    Returns
    -------
    FoundLandmarks

    Raises
    ------
    InputError
        If `atlas` is none, or `keep` is a single name.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> found = bm.found_landmarks(bm.load_sample("female_average"), keep=["back hip point"])
    >>> found.by_rule, found.carried
    (('side hip point left', 'side hip point right', 'front hip point'), {})
    """
    require_atlas(atlas)
    keep = several(keep, str, "keep", "the name of a landmark")
    rules = found_rules()
    sought = {name for rule in rules for name in _names(rule)} - {*keep}
    bare = {name: point for name, point in atlas.landmarks.items() if name not in sought}
    derived = derive_landmarks(replace(atlas, landmarks=bare), rules, strict=False)
    landmarks, carried = dict(atlas.landmarks), {}
    for name in derived.rules:
        # Other rules need the rest.
        if name in landmarks:
            reason = derived.missing.get(name) or _strayed(atlas, name, derived.landmarks[name])
            if reason:
                carried[name] = reason
            else:
                landmarks[name] = derived.landmarks[name]
    by_rule = tuple(name for name in derived.rules if name in landmarks and name not in carried)
    return FoundLandmarks(_noted(atlas, landmarks, by_rule, carried), by_rule, carried)


@cache
def found_rules() -> tuple[LandmarkRule, ...]:
    """Return the rules for landmarks that the shape of a fitted body defines."""
    return definitions_from(read_bytes(FILE), str(FILE)).landmark


def _names(rule: LandmarkRule) -> tuple[str, ...]:
    return tuple(one.name for one in both_sides([rule]))


def _strayed(atlas: Atlas, name: str, point: AtlasPoint) -> str:
    """Return why a point cannot be a landmark; empty if it can."""
    apart = float(np.linalg.norm(atlas.position(point) - atlas.position(name)))
    meters = apart * atlas.unit.meters
    if meters <= FARTHEST:
        return ""
    return (
        f"the rule finds a point {100.0 * meters:.1f} cm from the carried place, more than "
        f"{100.0 * FARTHEST:.0f} cm, which is another part of the body"
    )


def _noted(
    atlas: Atlas,
    landmarks: Mapping[str, AtlasPoint],
    by_rule: tuple[str, ...],
    carried: Mapping[str, str],
) -> Atlas:
    """Return the atlas with its landmarks and with words on how they were found."""
    said = {}
    if by_rule:
        said["landmarks by rule"] = ", ".join(by_rule)
    if carried:
        said["landmarks carried"] = "; ".join(f"{name}: {why}" for name, why in carried.items())
    scan = atlas.scan
    if scan is not None:
        found = {name: LandmarkFound(LandmarkOrigin.RULE, UNCERTAINTY) for name in by_rule}
        scan = replace(scan, landmarks={**scan.landmarks, **found})
    return replace(atlas, landmarks=landmarks, provenance={**atlas.provenance, **said}, scan=scan)

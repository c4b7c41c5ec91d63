"""The kinds of measurements: how bodymeasure takes them, and what else can."""

import math
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.bench.bodies.meshed_body import MeshedBody
from bodymeasure.bench.bodies.peers import (
    Call,
    edge_flips,
    flip_loop,
    igl_exact,
    igl_hull,
    igl_isoline,
    pygeodesic_exact,
    trimesh_hull,
    trimesh_section,
)
from bodymeasure.bench.bodies.problems import (
    Item,
    Ring,
    ends_of_paths,
    ends_of_tapes,
    loop_places,
    one_chart,
    rings,
)
from bodymeasure.bench.entrants.entrant import Pace
from bodymeasure.chart import measure_chart
from bodymeasure.geodesic import geodesic_between
from bodymeasure.measure import Girth, closed_geodesic, plane_girth
from bodymeasure.taut import taut_tape

FLIPS, EXACT, PYGEODESIC = "potpourri3d edge flips", "libigl exact", "pygeodesic exact"
SECTION, ISOLINE = "trimesh sections", "libigl isolines"


class Peer(NamedTuple):
    """A library's way to measure on a mesh."""

    make: Callable[[MeshedBody, Any], Call]
    pace: Pace


class Kind(NamedTuple):
    """A kind of measurement.

    Parameters
    ----------
    name, title, noun : str
    draw : callable
        Returns some items of an atlas.
    ours : callable
        Returns length and error estimate of an item.
    peers : mapping of str to Peer
    witness : str
        The peer whose extrapolated lengths confirm ours; empty where there is no peer.
    """

    name: str
    title: str
    noun: str
    draw: Callable[[Atlas, int], tuple[Item, ...]]
    ours: Callable[[Atlas, Any], tuple[float, float]]
    peers: Mapping[str, Peer]
    witness: str


def _path(atlas: Atlas, ends: tuple[AtlasPoint, AtlasPoint]) -> tuple[float, float]:
    path = geodesic_between(atlas, *ends)
    return path.length, path.error_estimate


def _girth(atlas: Atlas, ring: Ring) -> Girth:
    return plane_girth(atlas, ring.plane, ring.place, limb=ring.limb)


def _skin(atlas: Atlas, ring: Ring) -> tuple[float, float]:
    girth = _girth(atlas, ring)
    return girth.contact, girth.error_estimate


def _taut(atlas: Atlas, ring: Ring) -> tuple[float, float]:
    girth = _girth(atlas, ring)
    return girth.taut, girth.error_estimate


def _loop(atlas: Atlas, place: str) -> tuple[float, float]:
    loop = closed_geodesic(atlas, place)
    return loop.length, loop.error_estimate


def _tape(atlas: Atlas, ends: tuple[str, str]) -> tuple[float, float]:
    tape = taut_tape(atlas, *ends)
    return tape.length, tape.error_estimate


def _chart(atlas: Atlas, _: None) -> tuple[float, float]:
    """The sum of what is measured by tapes, with an error of as large a part as the worst has."""
    known = [
        (each.value, each.error_estimate)
        for each in measure_chart(atlas).measured
        if each.tapes and math.isfinite(each.value)
    ]
    whole = sum(value for value, _ in known)
    return whole, whole * max(error / value for value, error in known)


KINDS = (
    Kind(
        "paths",
        "paths across a body",
        "paths",
        ends_of_paths,
        _path,
        {
            FLIPS: Peer(edge_flips, "slow"),
            EXACT: Peer(igl_exact, "very slow"),
            PYGEODESIC: Peer(pygeodesic_exact, "very slow"),
        },
        EXACT,
    ),
    Kind(
        "girths",
        "girths along the skin",
        "girths",
        rings,
        _skin,
        {SECTION: Peer(trimesh_section, "slow"), ISOLINE: Peer(igl_isoline, "slow")},
        SECTION,
    ),
    Kind(
        "taut girths",
        "girths drawn taut",
        "girths",
        rings,
        _taut,
        {SECTION: Peer(trimesh_hull, "slow"), ISOLINE: Peer(igl_hull, "slow")},
        SECTION,
    ),
    Kind(
        "loops",
        "loops that slide to rest",
        "loops",
        loop_places,
        _loop,
        {FLIPS: Peer(flip_loop, "slow")},
        FLIPS,
    ),
    Kind("tapes", "tapes drawn taut", "tapes", ends_of_tapes, _tape, {}, ""),
    Kind("charts", "a chart", "charts", one_chart, _chart, {}, ""),
)

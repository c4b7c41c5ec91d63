"""The sets of measurements of a body, their confirmed lengths, and who takes part on each."""

from collections.abc import Callable
from functools import partial

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas
from bodymeasure.bench.bodies.kinds import Kind
from bodymeasure.bench.bodies.meshed_body import meshed_body
from bodymeasure.bench.bodies.problems import BodyProblems, Item
from bodymeasure.bench.entrants.entrant import FAILURES, Entrant, Solve, in_numpy, lengths
from bodymeasure.bench.problems.sets import BODY, ProblemSet
from bodymeasure.oracle.extrapolate import richardson
from bodymeasure.samples import load_sample

OURS, OURS_IN_NUMPY = "bodymeasure", "bodymeasure in NumPy"
# Segments of each edge of a patch: the points of paths lie on multiples of a quarter.
SEGMENTS = (4, 8, 16)

BodySet = ProblemSet[BodyProblems]


def segments_setting(segments: int) -> str:
    """Return the name of a mesh."""
    return f"{segments} segments an edge"


def make_body_set(kind: Kind, count: int) -> BodySet:
    """Return measurements of a kind whose lengths a peer confirms, if there is one.

    It confirms a length that it gives within its own uncertainty, extrapolated over its meshes.

    Parameters
    ----------
    kind : Kind
    count : int
        How many are drawn; some kinds have fewer.
    """
    atlas = load_sample(BODY)
    problems = BodyProblems(atlas, kind.draw(atlas, count))
    length, error = np.array([_measured(kind, atlas, item) for item in problems.items]).T
    good, away = np.isfinite(length), None
    if kind.witness:
        make = kind.peers[kind.witness].make
        by_level = [_on_meshes(make, segments)(problems)() for segments in SEGMENTS]
        extrapolated, doubt = richardson(np.stack(by_level, axis=-1), SEGMENTS)
        good &= np.abs(length - extrapolated) <= doubt + error
        if good.any():
            away = float(np.median(np.abs(extrapolated / length - 1.0)[good]))
    rows = np.flatnonzero(good)
    return ProblemSet(
        kind.name,
        kind.title,
        problems.take(rows),
        length[rows],
        drawn=len(length),
        leaving=0,
        unresolved=len(length) - len(rows),
        noun=kind.noun,
        stated=(error / length)[rows],
        confirmed_to=away,
    )


def body_entrants(kind: Kind) -> tuple[Entrant[BodyProblems], ...]:
    """Return who takes part on a kind of measurements, bodymeasure first."""
    ours = partial(_ours, kind)
    found = [
        Entrant(OURS, "", "bodymeasure", "fast", ours),
        Entrant(OURS_IN_NUMPY, "", "bodymeasure", "fast", in_numpy(ours)),
    ]
    for name, peer in kind.peers.items():
        for segments in SEGMENTS:
            prepare = _on_meshes(peer.make, segments)
            found.append(Entrant(name, segments_setting(segments), "mesh", peer.pace, prepare))
    return tuple(found)


def _ours(kind: Kind, problems: BodyProblems) -> Solve:
    return lambda: np.array([_measured(kind, problems.atlas, item)[0] for item in problems.items])


def _measured(kind: Kind, atlas: Atlas, item: Item) -> tuple[float, float]:
    try:
        return kind.ours(atlas, item)
    except FAILURES:
        return np.nan, np.nan


def _on_meshes(
    make: Callable[..., Callable[[], float]], segments: int
) -> Callable[[BodyProblems], Callable[[], Array]]:
    def prepare(problems: BodyProblems) -> Callable[[], Array]:
        mesh = meshed_body(problems.atlas, segments)
        calls = [make(mesh, item) for item in problems.items]
        return lambda: lengths(calls)

    return prepare

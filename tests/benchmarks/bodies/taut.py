"""How well and how fast tapes are drawn taut.

Run it by hand: ``python tests/benchmarks/bodies/taut.py [BODY ...]``.

On each body, for all pairs of the first 13 landmarks and for random pairs, it prints whether chord
<= taut <= contact holds, how much the length changes from a start that is pushed outward by 2 cm,
whether the error estimate covers the change to a string of four times as many points, and the time.
It also prints how far mirror images are apart and, on the center lines, how far tapes are from the
hull of the exact profile. Where a tape slides off the median plane, it is shorter than that hull.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
import time
from collections import Counter
from itertools import combinations
from pathlib import Path

import numpy as np

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.atlas import convert_length
from bodymeasure.taut.skin import Skin, skin_of
from bodymeasure.taut.solve import TautLeg, draw_taut
from bodymeasure.taut.starts import SEGMENTS

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.bodies import BODIES
from helpers.oracles.profiles import profile_hull

LANDMARKS = 13
PUSH = 0.02
CENTER_LINES = (
    ("back neck point", "back waist point"),
    ("back waist point", "back hip point"),
    ("back neck point", "back hip point"),
    ("front neck point", "front waist point"),
    ("front waist point", "front hip point"),
)


def start_of(path: bm.AtlasPath, segments: int) -> Array:
    """Points of a path of one leg, from which a string starts."""
    return path.position(np.linspace(0.0, 1.0, segments + 1))


def pushed(skin: Skin, path: bm.AtlasPath, far: float) -> TautLeg:
    """The tape from a start that stands clear of the skin but for its ends."""
    nodes = start_of(path, SEGMENTS)
    nodes[1:-1] += far * skin.feet(nodes[1:-1]).normal
    return draw_taut(skin, nodes)


def survey(name: str, pairs: list[tuple[bm.AtlasPoint, bm.AtlasPoint]], atlas: bm.Atlas) -> None:
    """Draw tapes between pairs of points, and print how well they satisfy what must hold."""
    skin = skin_of(atlas, "determined")
    far = convert_length(PUSH, bm.Unit.M, atlas.unit)
    statuses: Counter[str] = Counter()
    seconds, errors, push, finer = [], [], [], []
    ordered = covered = 0
    for start, end in pairs:
        contact = bm.geodesic_between(atlas, start, end, on_failure="status")
        begin = time.thread_time()
        tape = bm.taut_tape(atlas, start, end, contact=contact, on_failure="status")
        seconds.append(time.thread_time() - begin)
        statuses[tape.status.name] += 1
        if not tape.converged or tape.length == 0.0:
            continue
        along = contact.length if contact.converged else contact.raw_length
        ordered += int(tape.chord <= tape.length <= along)
        errors.append(tape.error_estimate / tape.length)
        push.append(abs(pushed(skin, contact, far).length / tape.length - 1.0))
        fine = draw_taut(skin, start_of(contact, 4 * SEGMENTS)).length
        finer.append(abs(fine / tape.length - 1.0))
        covered += int(finer[-1] <= errors[-1])
    count = len(errors)
    print(f"  {name}: {dict(statuses)}; chord <= taut <= contact for {ordered} of {count}")
    print(
        f"    estimate: median {np.median(errors):.1e}, worst {max(errors):.1e}; from a string of "
        f"{4 * SEGMENTS}: median {np.median(finer):.1e}, worst {max(finer):.1e}, within the "
        f"estimate {covered} of {count}"
    )
    print(
        f"    pushed by 2 cm: median {np.median(push):.1e}, worst {max(push):.1e}, within 1e-6: "
        f"{np.count_nonzero(np.array(push) <= 1e-6)}; {1e3 * np.median(seconds):.0f} ms (median), "
        f"{1e3 * max(seconds):.0f} ms (most)",
        flush=True,
    )


def mirror(atlas: bm.Atlas) -> None:
    """Print how far tapes on the left are from their mirror images."""
    names = [name for name in atlas.landmarks if not name.endswith("right")][:LANDMARKS]
    apart = []
    for first, second in combinations(names, 2):
        images = [name.replace("left", "right") for name in (first, second)]
        if images == [first, second]:
            continue
        lengths = [
            bm.taut_tape(atlas, atlas.landmarks[a], atlas.landmarks[b]).length
            for a, b in ((first, second), images)
        ]
        apart.append(abs(lengths[0] / lengths[1] - 1.0))
    print(f"  mirror images of {len(apart)}: worst {max(apart):.1e}", flush=True)


def center_lines(atlas: bm.Atlas) -> None:
    """Print how far tapes are from the hull of the profile."""
    for first, second in CENTER_LINES:
        ends = atlas.landmarks[first], atlas.landmarks[second]
        hull = profile_hull(atlas, *ends)
        tape = bm.taut_tape(atlas, *ends, on_failure="status")
        print(
            f"  {first} to {second}: hull {hull:.8f}, taut {tape.length / hull - 1.0:+.1e}, "
            f"estimate {tape.error_estimate / hull:.0e}; off the plane by "
            f"{np.abs(tape.points[:, 0]).max() / hull:.0e}; {tape.status.name}",
            flush=True,
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bodies", nargs="*", default=BODIES)
    parser.add_argument("--pairs", type=int, default=40, help="random ones on each body")
    arguments = parser.parse_args()
    for name in arguments.bodies:
        atlas, rng = bm.load_sample(name), np.random.default_rng(5)
        print(name)
        landmarks = list(atlas.landmarks.values())[:LANDMARKS]
        survey("landmarks", list(combinations(landmarks, 2)), atlas)
        points = [
            bm.AtlasPoint(int(rng.integers(len(atlas))), *rng.random(2).tolist())
            for _ in range(2 * arguments.pairs)
        ]
        survey("random", list(zip(points[::2], points[1::2], strict=True)), atlas)
        mirror(atlas)
        center_lines(atlas)


if __name__ == "__main__":
    main()

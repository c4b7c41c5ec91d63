"""Girths of the mannequins, and the accuracy of their planes.

Run it by hand: ``python tests/benchmarks/bodies/girths.py``.

It prints girths at landmarks, the largest and smallest over stretches, the processor time of each,
and how far sections by random planes are from those of tessellations, which take two minutes for
160 planes of a body.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, convert_length
from bodymeasure.errors import InputError
from bodymeasure.measure import Girth, body_girth, extreme_girth, limb_girth
from bodymeasure.samples import load_sample
from bodymeasure.section import Plane, convex_hull, plane_section

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.bodies import BODIES
from helpers.oracles.mesh_sections import richardson_length


def girths(atlas: Atlas) -> dict[str, Callable[[], Girth]]:
    """The girths to measure, by name."""
    knee = atlas.position(atlas.landmarks["patella point left"])
    below_knee, shin = knee * (1.0, 1.0, 0.85), knee * (1.0, 1.0, 0.5)
    return {
        "bust": lambda: body_girth(atlas, "bust point left"),
        "waist": lambda: body_girth(atlas, "front waist point"),
        "hip": lambda: body_girth(atlas, "side hip point left"),
        "knee": lambda: body_girth(atlas, "patella point left"),
        "upper arm": lambda: limb_girth(atlas, "shoulder point left", "elbow point left", at=0.7),
        "thigh": lambda: limb_girth(atlas, "side hip point left", "patella point left", at=0.6),
        "smallest waist": lambda: (
            extreme_girth(atlas, "side hip point left", "bust point left", "smallest").girth
        ),
        "largest calf": lambda: extreme_girth(atlas, below_knee, shin, "largest").girth,
    }


def report_girths(name: str) -> None:
    atlas = load_sample(name)
    print(f"\n{name}, cm: contact, taut, gap, error estimate; ms of one core")
    for what, measure in girths(atlas).items():
        begin = time.process_time()
        try:
            girth = measure()
        except InputError as refusal:
            print(f"  {what:15} {refusal}")
            continue
        seconds = time.process_time() - begin
        contact, taut, gap, error = (
            convert_length(value, girth.unit, atlas.unit.CM)
            for value in (girth.contact, girth.taut, girth.gap, girth.error_estimate)
        )
        print(
            f"  {what:15} {contact:9.4f} {taut:9.4f} {gap:7.4f} {error:8.0e} {1e3 * seconds:6.0f}"
        )


def report_planes(name: str, count: int) -> None:
    """Compare sections by random planes, half of them level, with tessellations."""
    atlas = load_sample(name)
    rng = np.random.default_rng(5)
    errors, seconds, hulls, loops, refused = [], [], [], 0, 0
    for number in range(count):
        normal = rng.normal(size=3) if number % 2 else atlas.axes.up_vector
        plane = Plane(atlas.points[rng.integers(len(atlas.points))], normal)
        begin = time.process_time()
        try:
            section = plane_section(atlas, plane)
        except InputError as error:
            print(f"  refused: {error}")
            refused += 1
            continue
        seconds.append(time.process_time() - begin)
        begin = time.process_time()
        for loop in section.loops:
            if loop.closed:
                assert convex_hull(loop).length <= loop.length
                loops += 1
        hulls.append(time.process_time() - begin)
        known, move = richardson_length(atlas, plane)
        length = sum(loop.length for loop in section.loops)
        errors.append((abs(length - known) / known, move / known))
    _print_errors(np.array(errors), refused)
    print(
        f"  section {1e3 * np.median(seconds):.0f} ms (median), hulls "
        f"{1e3 * sum(hulls) / max(loops, 1):.0f} ms a loop; {loops} closed loops, taut <= contact"
    )


def _print_errors(errors: Array, refused: int) -> None:
    relative, move = errors.T
    worst = int(relative.argmax())
    print(
        f"  {len(errors)} planes, {refused} refused: off the tessellations by "
        f"{np.median(relative):.0e} (median), {relative[worst]:.0e} (worst; their own last move "
        f"there {move[worst]:.0e}); within 1e-6: {np.count_nonzero(relative <= 1e-6)}"
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--planes", type=int, default=160, help="random ones for each body")
    parser.add_argument("bodies", nargs="*", default=BODIES)
    arguments = parser.parse_args()
    for name in arguments.bodies:
        report_girths(name)
        report_planes(name, arguments.planes)


if __name__ == "__main__":
    main()

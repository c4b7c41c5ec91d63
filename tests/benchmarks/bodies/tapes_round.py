"""Natural waists, armpits, girths cut there, and drops, on the five bodies, with their times.

Run it by hand: ``python tests/benchmarks/bodies/tapes_round.py``. Lengths are in centimeters, times
in seconds of one thread.
"""

import os
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

os.environ["OMP_NUM_THREADS"] = "1"
import numpy as np

from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError
from bodymeasure.measure import body_girth, closed_geodesic, fork_point, vertical_drop
from bodymeasure.samples import load_sample

sys.path.insert(0, str(Path(__file__).parents[2]))
from helpers.bodies import BODIES

Result = TypeVar("Result")
DROPS = (
    ("back neck point", "back waist point", "median"),
    ("front neck point", "front waist point", "median"),
    ("side neck point left", "bust point left", "median"),
    ("side waist point left", "side hip point left", "side"),
)


def timed(measure: Callable[[], Result]) -> tuple[Result, float]:
    begin = time.thread_time()
    return measure(), time.thread_time() - begin


def waists(atlas: Atlas) -> None:
    under = atlas.position(atlas.landmarks["bust point left"]) * (0.0, 1.0, 1.0) - (0.0, 0.0, 7.0)
    lengths = []
    for name, place in (
        ("waist", "front waist point"),
        ("underbust", under),
        ("hip", "front hip point"),
    ):
        path, seconds = timed(lambda place=place: closed_geodesic(atlas, place))  # type: ignore[misc]
        lengths.append(path.length)
        print(
            f"  natural waist from {name:10} {path.length:.8f} +- {path.error_estimate:.0e} "
            f"{path.kind.name} {len(path.pieces)} patches {seconds:.2f} s"
        )
    print(f"  largest relative difference {np.ptp(lengths) / lengths[0]:.1e}")


def armpits(atlas: Atlas) -> None:
    (left, seconds), (right, _) = (
        timed(lambda side=side: fork_point(atlas, ("torso", f"upper arm {side}")))  # type: ignore[misc]
        for side in ("left", "right")
    )
    position, mirror = atlas.position(left), atlas.position(right) * (-1.0, 1.0, 1.0)
    print(
        f"  armpit left {np.round(position, 4)}, mirror image off by "
        f"{np.abs(position - mirror).max():.1e}, {seconds:.2f} s"
    )
    crotch, seconds = timed(lambda: fork_point(atlas, ("thigh left", "thigh right")))
    apart = np.linalg.norm(atlas.position(crotch) - atlas.position(atlas.landmarks["crotch point"]))
    print(
        f"  crotch {np.round(atlas.position(crotch), 4)}, {apart:.2f} from the landmark, "
        f"{seconds:.2f} s"
    )
    for above in (-3.0, 0.3, 1.0, 2.0):
        at = position * (0.0, 1.0, 1.0) + (0.0, -20.0, above)
        girth, seconds = timed(lambda at=at: body_girth(atlas, at, cut=(left, right)))  # type: ignore[misc]
        cut = "whole" if girth.tape is girth.loop else "cut"
        print(
            f"  girth {above:+.1f} from the armpits, {cut}: contact {girth.contact:.3f}, taut "
            f"{girth.taut:.3f} +- {girth.error_estimate:.0e}, {seconds:.2f} s"
        )


def drops(atlas: Atlas) -> None:
    for start, level, plane in DROPS:
        try:
            found, seconds = timed(lambda: vertical_drop(atlas, start, level, plane=plane))  # type: ignore[arg-type]  # noqa: B023
        except InputError as error:
            print(f"  {start} to {level}: {error}")
            continue
        print(
            f"  {start} to the level of {level}: contact {found.contact:.3f}, taut "
            f"{found.taut:.3f} +- {found.error_estimate:.0e}, {seconds:.2f} s"
        )


if __name__ == "__main__":
    for name in BODIES:
        print(name)
        atlas = load_sample(name).converted("cm")
        waists(atlas)
        armpits(atlas)
        drops(atlas)

"""How long each renderer takes to draw the pictures of a body's chart.

python tests/benchmarks/bodies/tape_pictures.py [BODY]
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"

import sys
import time
from functools import partial

import numpy as np

import bodymeasure as bm
from bodymeasure.chart import measure_chart
from bodymeasure.scene import tape_pictures
from bodymeasure.scene.drawing.opengl_check import PYVISTA, SOFTWARE, opengl_trouble


def main(name: str) -> None:
    """Measure a sample body, draw its chart, and print seconds of the processor."""
    start = time.process_time()
    chart = measure_chart(bm.load_sample(name))
    print(f"{name}: {len(chart.measured)} measurements in {time.process_time() - start:.1f} s")
    for renderer in (PYVISTA, SOFTWARE):
        if renderer == PYVISTA and opengl_trouble():
            print(f"{renderer}: {opengl_trouble()}")
            continue
        ticks = [time.process_time()]
        pictures = tape_pictures(chart, renderer=renderer, advance=partial(_note, ticks))
        each = np.diff(ticks)
        body, near = np.split(each, [len(pictures.body)])
        size = sum(map(len, (*pictures.body.values(), *pictures.closeups.values())))
        print(f"{renderer}: {each.sum():.1f} s, {size / 2**20:.1f} MiB")
        for what, some in (("of the body", body), ("from near", near)):
            print(f"  {len(some)} {what}, median {np.median(some):.2f} s")


def _note(ticks: list[float], _: str) -> None:
    ticks.append(time.process_time())


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "female_average")

"""How well the patches of the sample bodies lie flat, each by itself."""

import time

import numpy as np

import bodymeasure as bm
from bodymeasure.pattern.patches.six_lengths import flat_quadrilaterals

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")


def main() -> None:
    print(
        "body               misfit in mm: median, 95 %, largest; turned over; ms without diagonals"
    )
    for name in BODIES:
        body = bm.load_sample(name)
        unfolded = bm.unfold_patches(body)
        begin = time.process_time()
        flat_quadrilaterals(unfolded.lengths)
        milliseconds = 1000.0 * (time.process_time() - begin)
        worst = 1000.0 * body.unit.meters * unfolded.worst
        figures = f"{np.median(worst):.2f}, {np.percentile(worst, 95):.2f}, {worst.max():.2f}"
        print(f"{name:18} {figures}; {unfolded.turned_over.sum()}; {milliseconds:.0f}")


if __name__ == "__main__":
    main()

"""The pieces of all sets on the sample bodies: strain, darts, seams, processor time.

With ``--ease``, 4 cm wider at the bust and 2 cm at the waist; with ``--bridge``, over hollows.

With ``--random N``, on N random bodies instead, of which it prints the spread of each piece, and
what is not sound.
"""

import argparse
import sys
from collections import defaultdict
from pathlib import Path

import numpy as np

import bodymeasure as bm
from bodymeasure.pattern import SETS

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
EASE = {"bust": 0.04, "waist": 0.02}


def line(piece: bm.Piece) -> str:
    largest = np.abs(piece.strains).max()
    darts = [f"{1e3 * dart.intake:.0f} mm, {dart.angle:.0f} degrees" for dart in piece.darts]
    return (
        f"{piece.name:14} strain {100 * piece.rms_strain:5.2f} % rms, at most {100 * largest:.0f}; "
        f"{piece.flips} flips, {'simple' if piece.is_simple else 'CROSSES ITSELF'}; border off by "
        f"{1e3 * piece.flat.missed:.0e} mm{'' if piece.flat.converged else ' NOT SETTLED'}; darts: "
        f"{'; '.join(darts) or 'none'}; {piece.flat.steps} steps"
    )


def worst_seam(pattern: bm.Pattern) -> float:
    return 1e3 * max((abs(seam.excess) for seam in pattern.seams), default=0.0)


def samples(bodies: list[str], sets: list[str], ease: dict[str, float], bridge: bool) -> None:
    for name in bodies:
        body = bm.load_sample(name)
        for key in sets:
            pattern = bm.make_pattern(body, key, ease=ease, bridge=bridge)
            for piece in pattern.pieces:
                print(f"{name:17} {key:9} {line(piece)}, {pattern.seconds[piece.name]:.2f} s")
            worst = worst_seam(pattern)
            print(f"{name:17} {key:9} {len(pattern.seams)} seams, worst {worst:.1e} mm")
            for words in pattern.warnings:
                print(f"{name:17} {key:9} {words}")


def random_bodies(count: int, sets: list[str]) -> None:
    sys.path.insert(0, str(Path(__file__).parents[2]))
    from helpers.body_space import random_body

    strains, seconds = defaultdict(list), defaultdict(list)
    worst, unsound = 0.0, 0
    for number in range(count):
        body = random_body(number)
        for key in sets:
            try:
                pattern = bm.make_pattern(body, key)
            except bm.InputError as error:
                print(f"{body.name} {key}: {error}")
                continue
            worst = max(worst, worst_seam(pattern))
            for piece in pattern.pieces:
                strains[key, piece.name].append(100 * piece.rms_strain)
                seconds[key, piece.name].append(pattern.seconds[piece.name])
                if not piece.is_sound:
                    unsound += 1
                    print(f"{body.name} {key}: {line(piece)}")
    for (key, name), values in strains.items():
        took = seconds[key, name]
        print(
            f"{key:9} {name:14} {len(values)} bodies: strain {np.median(values):5.2f} % rms in the "
            f"median, {min(values):.2f} to {max(values):.2f}; {np.median(took):.2f} s in the "
            f"median, {max(took):.2f} at most"
        )
    print(f"seams differ by {worst:.1e} mm at most; {unsound} pieces are not sound")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("bodies", nargs="*", default=BODIES)
    parser.add_argument("--sets", nargs="*", default=SETS)
    parser.add_argument("--random", type=int, metavar="N")
    parser.add_argument("--ease", action="store_true")
    parser.add_argument("--bridge", action="store_true")
    given = parser.parse_args()
    if given.random:
        random_bodies(given.random, list(given.sets))
    else:
        ease = EASE if given.ease else {}
        samples(list(given.bodies), list(given.sets), ease, given.bridge)


if __name__ == "__main__":
    main()

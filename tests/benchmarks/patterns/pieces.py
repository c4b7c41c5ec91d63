"""The pieces of all sets on the sample bodies: strain, darts, seams, processor time."""

import sys

import numpy as np

import bodymeasure as bm
from bodymeasure.pattern import SETS

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")


def line(piece: bm.Piece) -> str:
    largest = np.abs(piece.strains).max()
    darts = [f"{1e3 * dart.intake:.0f} mm, {dart.angle:.0f} degrees" for dart in piece.darts]
    return (
        f"{piece.name:13} strain {100 * piece.rms_strain:5.2f} % rms, at most {100 * largest:.0f}; "
        f"{piece.flips} flips, {'simple' if piece.is_simple else 'CROSSES ITSELF'}; border off by "
        f"{1e3 * piece.flat.missed:.0e} mm{'' if piece.flat.converged else ' NOT SETTLED'}; darts: "
        f"{'; '.join(darts) or 'none'}; {piece.flat.steps} steps"
    )


def main(bodies: tuple[str, ...]) -> None:
    for name in bodies:
        body = bm.load_sample(name)
        for key in SETS:
            pattern = bm.make_pattern(body, key)
            for piece in pattern.pieces:
                print(f"{name:17} {key:9} {line(piece)}, {pattern.seconds[piece.name]:.2f} s")
            worst = max((abs(seam.difference) for seam in pattern.seams), default=0.0)
            print(f"{name:17} {key:9} {len(pattern.seams)} seams, worst {1e3 * worst:.1e} mm")
            for words in pattern.warnings:
                print(f"{name:17} {key:9} {words}")


if __name__ == "__main__":
    main(tuple(sys.argv[1:]) or BODIES)

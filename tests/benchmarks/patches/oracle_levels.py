"""How well libigl's distances, extrapolated, agree with smooth geodesics, and what they cost.

Run it by hand: ``python tests/benchmarks/patches/oracle_levels.py [SAMPLE] [--patches N]``. The
reference is `scipy.integrate.solve_bvp` on the geodesic equation, which shares nothing with the
oracle.
"""

import argparse
import os
import time
import warnings
from unittest import mock

import numpy as np
from scipy.integrate import solve_bvp

from bodymeasure._typing import Array
from bodymeasure.bezier import derivatives
from bodymeasure.oracle import LEVELS, MeshDistances, mesh_distances
from bodymeasure.oracle.grid import CELLS_V_PER_U
from bodymeasure.samples import load_sample

START = np.array([(0.0, 0.0), (1.0, 0.0)])
END = np.array([(1.0, 1.0), (0.0, 1.0)])
GAUSS_NODES, GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(60)


def smooth_length(net: Array, start: Array, end: Array) -> float:
    """Length of the geodesic that solve_bvp finds from the straight diagonal; NaN if it leaves."""

    def slope(_: Array, y: Array) -> Array:
        d = derivatives(net, y[:2].T, order=2)
        u, v = y[2][:, None], y[3][:, None]
        tangents = np.stack([d[:, 1, 0], d[:, 0, 1]], axis=1)
        bend = d[:, 2, 0] * u**2 + 2 * d[:, 1, 1] * u * v + d[:, 0, 2] * v**2
        metric = tangents @ np.swapaxes(tangents, 1, 2)
        second = np.linalg.solve(metric, -tangents @ bend[..., None])[..., 0]
        return np.vstack([y[2:], second.T])

    def ends(first: Array, last: Array) -> Array:
        return np.concatenate([first[:2] - start, last[:2] - end])

    t = np.linspace(0.0, 1.0, 17)
    line = start[:, None] + (end - start)[:, None] * t
    guess = np.vstack([line, np.broadcast_to((end - start)[:, None], line.shape)])
    try:
        solution = solve_bvp(slope, ends, t, guess, tol=1e-9, max_nodes=4000)
    except np.linalg.LinAlgError:
        return np.nan
    path = solution.sol(np.linspace(0.0, 1.0, 401))[:2]
    if not solution.success or path.min() < -1e-9 or path.max() > 1 + 1e-9:
        return np.nan
    y = solution.sol(0.5 * (GAUSS_NODES + 1.0))
    d = derivatives(net, y[:2].T, order=1)
    speed = np.linalg.norm(d[:, 1, 0] * y[2][:, None] + d[:, 0, 1] * y[3][:, None], axis=1)
    return float(0.5 * GAUSS_WEIGHTS @ speed)


def quantiles(error: Array) -> str:
    return "  ".join(f"{q:8.1e}" for q in np.quantile(error, [0.5, 0.9, 0.99, 1.0]))


def measure(
    nets: Array, levels: tuple[int, ...], processes: int
) -> tuple[MeshDistances, float, float]:
    """The distances along both diagonals, and the seconds on the clock and of this process."""
    start, end = (np.broadcast_to(ends, (len(nets), 2, 2)) for ends in (START, END))
    clock, own = time.perf_counter(), time.process_time()
    measured = mesh_distances(nets, start, end, levels=levels, processes=processes)
    return measured, time.perf_counter() - clock, time.process_time() - own


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sample", nargs="?", default="female_average")
    parser.add_argument("--patches", type=int, default=None, help="a random choice, not all")
    options = parser.parse_args()
    nets = load_sample(options.sample).control_points
    if options.patches is not None:
        nets = np.random.default_rng(0).choice(nets, options.patches, replace=False)

    with warnings.catch_warnings():
        # solve_bvp's trials for paths that leave the patch may overflow; they end as NaN.
        warnings.simplefilter("ignore", RuntimeWarning)
        smooth = np.array(
            [[smooth_length(net, *ends) for ends in zip(START, END, strict=True)] for net in nets]
        )
    stays = np.isfinite(smooth)
    length = smooth[stays]
    print(f"{options.sample}: {smooth.size} diagonals, {len(length)} stay in their patches")

    print(
        "\nextrapolated from                 median       90 %      99 %       max   ms a diagonal"
    )
    # Square cells, whose edges the diagonals follow, show why the grids are oblong.
    for levels, shape in (
        ((6, 12, 18, 24), 1.0),
        ((4, 8, 16), CELLS_V_PER_U),
        ((5, 10, 20), CELLS_V_PER_U),
        (LEVELS, CELLS_V_PER_U),
        ((6, 12, 18, 24), CELLS_V_PER_U),
    ):
        with mock.patch("bodymeasure.oracle.grid.CELLS_V_PER_U", shape):
            measured, _, own = measure(nets, levels, processes=1)
        along_v = round(levels[0] * shape)
        cells = ", ".join(f"{level}x{level // levels[0] * along_v}" for level in levels)
        print(
            f"{cells:33s}",
            quantiles(np.abs(measured.exact[stays] / length - 1.0)),
            f"{1e3 * own / smooth.size:9.1f}",
        )
        if levels == LEVELS:
            kept = measured
    for level, raw in zip(LEVELS, np.moveaxis(kept.by_level, -1, 0), strict=True):
        print(
            f"not extrapolated, {level:2d} along u    ", quantiles(np.abs(raw[stays] / length - 1))
        )
    print(f"{'heat':33s}", quantiles(np.abs(kept.heat[stays] / length - 1)))

    error = np.abs(kept.exact[stays] - length)
    uncertainty = kept.exact_uncertainty[stays]
    share = uncertainty / length
    print(
        f"\nuncertainty: covers {100 * (error <= uncertainty).mean():.1f} % of the errors; "
        f"{np.median(share):.1e} of the length in the median, {share.max():.1e} at most; "
        f"{np.median(uncertainty / error):.0f} times the error in the median"
    )
    processes = os.cpu_count() or 1
    clock = measure(nets, LEVELS, processes)[1]
    print(f"{processes} processes: {clock:.1f} s for all, with heat")


if __name__ == "__main__":
    main()

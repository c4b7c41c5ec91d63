"""The paths of measurements as curves in a file."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.cli.needs import require
from bodymeasure.files import require_writable

if TYPE_CHECKING:
    from bodymeasure.atlas import Atlas
    from bodymeasure.chart import Chart
    from bodymeasure.geodesic import GeodesicSolution
    from bodymeasure.measure import Survey
    from bodymeasure.mesh.curves.curve import Curve

RHINO = ("a .3dm file", "rhino3dm", "rhino3dm", "rhino")


def check_paths_file(path: Path) -> None:
    """Refuse, before any work, a file of paths that could not be written.

    Raises
    ------
    InputError
        If its name ends otherwise, or it is not writable.
    MissingExtraError
        If a package that it needs is missing.
    """
    from bodymeasure.mesh.curves.write import require_path_suffix

    require_path_suffix(path)
    if path.suffix.lower() == ".3dm":
        require(RHINO)
    require_writable(path)


def write_curves(path: Path, atlas: "Atlas", curves: "Sequence[Curve]") -> None:
    """Write curves on an atlas; see `bodymeasure.write_paths`."""
    from bodymeasure.mesh.curves.write import write_curves as write

    write(path, atlas, curves)


def diagonal_curves(survey: "Survey") -> "list[Curve]":
    """Return the diagonals of a survey that have a length."""
    from bodymeasure.mesh.curves.curve import smooth_curve

    curves = []
    atlas, solutions = survey.atlas, survey.diagonals
    for patch, which in np.argwhere(solutions.converged).tolist():
        solution = solutions[patch, which]
        net = atlas.control_points[patch]

        def position(t: Array, net: Array = net, solution: "GeodesicSolution" = solution) -> Array:
            return evaluate(net, np.clip(solution.path(t), 0.0, 1.0))

        facts = {
            "length": float(solution.length),
            "error_estimate": float(solution.error_estimate),
            "unit": atlas.unit.value,
        }
        name = f"{atlas.patch_names[patch]} diagonal {which + 1}"
        curves.append(smooth_curve(name, position, (0.0, 1.0), facts))
    return curves


def tape_curves(chart: "Chart") -> "list[Curve]":
    """Return the tapes of a chart, those along the skin and those drawn taut."""
    from bodymeasure.mesh.curves.curve import curve_of

    curves = []
    for item in chart.measured:
        for tape in item.tapes:
            several = len(item.tapes) > 1
            name = f"{item.definition.key} {tape.kind}" if several else item.definition.key
            if len(tape.points) > 1:
                curves.append(curve_of(name, tape.points))
    return curves

"""All measurements of a body, each with its outcome."""

import time
from collections.abc import Callable

from bodymeasure.atlas import Atlas
from bodymeasure.chart.body import Body, MissingLandmarkError
from bodymeasure.chart.chart import Chart, Measured, Outcome
from bodymeasure.chart.formula.checks import evaluation_order
from bodymeasure.chart.formula.parse import parse_formula
from bodymeasure.chart.kinds.arithmetic import measure_formula
from bodymeasure.chart.kinds.definitions import (
    BreadthMeasure,
    ChordMeasure,
    ClosedMeasure,
    Definitions,
    DepthMeasure,
    DropMeasure,
    ExtremeGirthMeasure,
    FormulaMeasure,
    GirthArcMeasure,
    GirthMeasure,
    HeightMeasure,
    LimbGirthMeasure,
    Measurement,
    OverMeasure,
    PathMeasure,
    TiltedGirthMeasure,
)
from bodymeasure.chart.kinds.lengths import measure_closed, measure_drop, measure_path
from bodymeasure.chart.kinds.over import measure_over
from bodymeasure.chart.kinds.rounds import (
    measure_extreme_girth,
    measure_girth,
    measure_girth_arc,
    measure_limb_girth,
    measure_tilted_girth,
)
from bodymeasure.chart.kinds.straight import (
    measure_breadth,
    measure_chord,
    measure_depth,
    measure_height,
)
from bodymeasure.chart.landmarks.complete import completed
from bodymeasure.chart.reading.read import load_definitions
from bodymeasure.chart.reading.sides import both_sides
from bodymeasure.errors import ConvergenceError, InputError
from bodymeasure.measure import package_versions

# Packages whose versions can change a number of a chart.
PACKAGES = ("bodymeasure", "numpy", "scipy", "pygeodesic")


def measure_chart(
    atlas: Atlas,
    definitions: Definitions | None = None,
    *,
    progress: Callable[[int, int], None] | None = None,
) -> Chart:
    """Measure a body by a set of definitions.

    Parameters
    ----------
    atlas : Atlas
    definitions : Definitions, optional
        The default set, if not given; `load_definitions` reads others.
    progress : callable, optional
        Called with the number of measurements done so far, and the number of all.

    Returns
    -------
    Chart
        A measurement that cannot be taken says why, and the others are taken all the same.

    Raises
    ------
    InputError
        If rules for landmarks need one another in a circle.
    MissingExtraError
        If paths are asked for and pygeodesic is not installed.

    Notes
    -----
    Heights are above the floor, where the coordinate along the atlas's way up is 0.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> chart = measure_chart(bm.load_sample("female_average"))
    >>> waist = chart["waist_girth"]
    >>> print(f"{waist.value:.4f} {chart.atlas.unit}, {waist.outcome}")
    0.7110 m, measured
    """
    begin = time.perf_counter()
    definitions = load_definitions() if definitions is None else definitions
    body = completed(atlas, definitions.landmark)
    every = {one.key: one for one in both_sides(definitions.measurement)}
    formulas = {
        key: parse_formula(one.formula)
        for key, one in every.items()
        if isinstance(one, FormulaMeasure)
    }
    order = [key for key in every if key not in formulas] + list(evaluation_order(formulas))
    measured: dict[str, Measured] = {}
    for number, key in enumerate(order, start=1):
        measured[key] = _measured(body, every[key], measured)
        if progress is not None:
            progress(number, len(order))
    return Chart(
        atlas,
        definitions,
        body.landmarks,
        body.missing,
        tuple(measured[key] for key in every),
        time.perf_counter() - begin,
        package_versions(PACKAGES),
    )


def _measured(body: Body, definition: Measurement, others: dict[str, Measured]) -> Measured:
    try:
        return _by_kind(body, definition, others)
    except MissingLandmarkError as error:
        return Measured(definition, Outcome.MISSING_LANDMARK, str(error))
    except InputError as error:
        return Measured(definition, Outcome.REFUSED, str(error))
    except ConvergenceError as error:
        return Measured(definition, Outcome.NOT_CONVERGED, str(error))


def _by_kind(body: Body, definition: Measurement, others: dict[str, Measured]) -> Measured:
    match definition:
        case PathMeasure():
            return measure_path(body, definition)
        case ClosedMeasure():
            return measure_closed(body, definition)
        case DropMeasure():
            return measure_drop(body, definition)
        case OverMeasure():
            return measure_over(body, definition)
        case GirthMeasure():
            return measure_girth(body, definition)
        case GirthArcMeasure():
            return measure_girth_arc(body, definition)
        case TiltedGirthMeasure():
            return measure_tilted_girth(body, definition)
        case LimbGirthMeasure():
            return measure_limb_girth(body, definition)
        case ExtremeGirthMeasure():
            return measure_extreme_girth(body, definition)
        case HeightMeasure():
            return measure_height(body, definition)
        case ChordMeasure():
            return measure_chord(body, definition)
        case BreadthMeasure():
            return measure_breadth(body, definition)
        case DepthMeasure():
            return measure_depth(body, definition)
        case FormulaMeasure():
            return measure_formula(definition, others)

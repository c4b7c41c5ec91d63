"""The words that the window shows about a patch or a tape."""

from typing import TYPE_CHECKING

import numpy as np

from bodymeasure.atlas import Unit, convert_length
from bodymeasure.report.numbers import at_most, millimeters

if TYPE_CHECKING:
    from bodymeasure.chart import Measured
    from bodymeasure.geodesic import AtlasPath
    from bodymeasure.measure import Survey

# Points along a tape at which the patch below it is looked up.
SAMPLES = 101
DIAGONALS = ("(0, 0) - (1, 1)", "(1, 0) - (0, 1)")


def describe(survey: "Survey", patch: int, diagonal: int | None = None) -> str:
    """Describe a patch by its name, its region, and the lengths of its diagonals in centimeters.

    Parameters
    ----------
    survey : Survey
    patch : int
    diagonal : int, optional
        Which of its diagonals was picked, 0 or 1; by default the patch as a whole.

    Returns
    -------
    str
        A few lines; of the diagonals only the picked one, if one was picked.
    """
    atlas = survey.atlas
    title = atlas.patch_names[patch]
    if atlas.regions[patch] and atlas.regions[patch] not in title:
        title += f" ({atlas.regions[patch]})"
    wanted = range(len(DIAGONALS)) if diagonal is None else (diagonal,)
    return "\n".join([title, *(_diagonal(survey, patch, number) for number in wanted)])


def _diagonal(survey: "Survey", patch: int, diagonal: int) -> str:
    solution, check, unit = survey.diagonals, survey.cross_check, survey.atlas.unit
    length = float(solution.length[patch, diagonal])
    if not np.isfinite(length):
        status = np.asarray(solution.status)[patch, diagonal]
        return f"{DIAGONALS[diagonal]}: no length; {getattr(status, 'value', status)}"
    text = f"{DIAGONALS[diagonal]}: {convert_length(length, unit, Unit.CM):.4f} cm"
    if check is not None and np.isfinite(check.relative_difference[patch, diagonal]):
        text += f", {check.relative_difference[patch, diagonal]:+.1e} from exact"
    return text


def describe_path(path: "AtlasPath", straight: float) -> str:
    """Describe a tape between two points by its length, its error and what they are worth.

    Parameters
    ----------
    path : AtlasPath
        With a length.
    straight : float
        The straight distance between its ends, in the atlas's unit.

    Returns
    -------
    str
        Three lines; on a body that was fitted to a scan, one more says how far its surface is
        from that below the tape.
    """
    unit = path.atlas.unit
    length, error = length_words(path.length, unit), at_most(path.error_estimate, unit)
    return "\n".join(
        [
            f"{length}, error {error}",
            f"straight {length_words(straight, unit)}",
            path.status.sentence,
            *_from_scan(path),
        ]
    )


def _from_scan(path: "AtlasPath") -> list[str]:
    scan = path.atlas.scan
    if scan is None:
        return []
    under = np.unique(path.path(np.linspace(0.0, 1.0, SAMPLES))[0])
    if len(np.intersect1d(under, scan.uncovered)):
        return ["The scan does not show all of it: that part is a guess."]
    off = millimeters(scan.part(under).rms, Unit.M)
    return [f"The surface is {off} from the scan there (root mean square)."]


def describe_measured(item: "Measured", unit: Unit) -> str:
    """Describe a measurement by its name, its value in centimeters, and how the tape lies.

    Parameters
    ----------
    item : Measured
    unit : Unit
        Unit of its lengths.

    Returns
    -------
    str
        A few lines: name and key, value, lengths along the skin and taut if there are both, and
        a remark.
    """
    definition = item.definition
    lines = [f"{definition.name} ({definition.key})"]
    if np.isfinite(item.value):
        lines.append(value_words(item, unit))
        if np.isfinite(item.contact) and np.isfinite(item.taut):
            skin, taut = length_words(item.contact, unit), length_words(item.taut, unit)
            lines.append(f"along the skin {skin}, taut {taut}")
    if item.reason:
        lines.append(item.reason)
    return "\n".join(lines)


def value_words(item: "Measured", unit: Unit) -> str:
    """Return the value of a measurement that has one, in centimeters or degrees."""
    if item.definition.in_degrees:
        return f"{item.value:.2f} degrees"
    return length_words(item.value, unit)


def length_words(length: float, unit: Unit) -> str:
    """Return a length in centimeters with its unit, to a tenth of a millimeter."""
    return f"{convert_length(length, unit, Unit.CM):.2f} cm"

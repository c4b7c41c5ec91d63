"""The files of a fit: the atlas, and a page beside it."""

from pathlib import Path
from typing import TYPE_CHECKING

from bodymeasure.files import write_all
from bodymeasure.formats import FORMATS
from bodymeasure.wording import counted

if TYPE_CHECKING:
    from bodymeasure.fit import FittedBody


def page_of(atlas: Path) -> Path:
    """Return the page that belongs to the atlas of a fit."""
    return atlas.with_suffix(".fit.html")


def write_fit(body: "FittedBody", path: Path, *, page: bool, pictures: bool) -> tuple[Path, ...]:
    """Write the atlas of a fit, and its page: both or none.

    Parameters
    ----------
    body : FittedBody
    path : Path
        The file of the atlas; the page stands beside it.
    page, pictures : bool
        Whether there is a page, and whether it has pictures.
    """
    write = FORMATS["atlas"].write
    assert write is not None
    contents = {path: write(body.atlas)}
    if page:
        contents[page_of(path)] = rendered(body, pictures=pictures)
    write_all(contents)
    return tuple(contents)


def rendered(body: "FittedBody", *, pictures: bool) -> bytes:
    """Return the page of a fit."""
    # Slow imports, which `--help` does not need.
    from bodymeasure.report.fits import render_fit
    from bodymeasure.report.fits.drawn import drawn

    return render_fit(body.atlas, scores_of(body), drawn(body) if pictures else None)


def fitted_in_words(body: "FittedBody") -> str:
    """Return what a chart says of the fit that it begins with."""
    scan = body.atlas.scan
    assert scan is not None
    bare = len(scan.uncovered)
    return (
        f"Fitted a body to the scan: {1e3 * scan.rms:.2f} mm from it (root mean square), "
        f"{100.0 * scan.coverage.mean():.1f} % covered"
        + (f", {counted(bare, 'patch', 'patches')} without scan" if bare else "")
        + ". "
        + " ".join((*scan.done, *scan.warnings))
    )


def scores_of(body: "FittedBody") -> dict[str, str]:
    """Return how good a fit is, in words."""
    scores = body.scores
    return {
        "body that has scan within 12 mm": f"{scores.covered:.1%}",
        "scan that has the body within 20 mm": f"{scores.explained:.1%}",
        "distance before the body followed the surface": _millimeters(scores.rms_before),
        "distance after it": _millimeters(scores.rms),
        "noise of the scan": _millimeters(scores.noise),
        "largest coefficient of the shape": f"{scores.largest_coefficient:.1f} standard deviations",
        "largest turn of a joint": f"{scores.largest_angle:.1f} standard deviations",
        "stature in the A-pose": f"{100.0 * scores.stature:.1f} cm",
        "fault of the coarse start": f"{scores.start:.2f} of 2",
    }


def _millimeters(length: float) -> str:
    return f"{1e3 * length:.2f} mm (root mean square)"

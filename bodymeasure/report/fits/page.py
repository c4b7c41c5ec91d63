"""A fit as one self-contained page: how well the body follows the scan, and where it cannot."""

import math
from collections.abc import Mapping
from datetime import UTC, datetime
from typing import NamedTuple, Protocol

import numpy as np

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas, ScanFit
from bodymeasure.errors import InputError
from bodymeasure.report.numbers import NONE, millimeters
from bodymeasure.report.templating import images, moment, render_page

# What a residual cannot show, since a wrong body of the right shape fits as well.
BLIND = (
    "Whether the scan is mirrored: left and right would be exchanged.",
    "Whether the scale is wrong by up to a tenth, as from a scanner that is not calibrated: every "
    "length would be, too. Compare one length that you know, such as the stature.",
    "Whether it shows skin or clothes: loose clothes are measured as they are.",
    "Whether the person stood upright and breathed out.",
)
# A mean of ones may fall short of 1 by rounding.
ROUNDING = 1e-9


class BodyPictures(Protocol):
    """Pictures of a fit, as `bodymeasure.scene.fits.pictures` makes them."""

    @property
    def body(self) -> Mapping[str, bytes]:
        """WebP or PNG by side: front, left and back; to be shown at half their size."""

    @property
    def note(self) -> str:
        """A remark on how they were drawn; may be empty."""


class Part(NamedTuple):
    """A region of the body as the table shows it."""

    region: str
    patches: int
    covered: str
    distance: str
    uncovered: str


def render_fit(
    atlas: Atlas,
    scores: Mapping[str, str],
    pictures: BodyPictures | None = None,
    *,
    created: datetime | None = None,
) -> bytes:
    """Return the page of a fitted body, which loads nothing else.

    Parameters
    ----------
    atlas : Atlas
        With the scan that it was fitted to.
    scores : mapping of str to str
        How good the fit is: what each number is, and the number with its unit.
    pictures : BodyPictures, optional
        Without them, the page has none.
    created : datetime, optional
        The time that the page states; the present if not given.

    Raises
    ------
    InputError
        If the atlas was not fitted to a scan.
    MissingExtraError
        If jinja2 is not installed.
    """
    scan = atlas.scan
    if scan is None:
        raise InputError(
            f"{atlas.name or 'the atlas'}: was not fitted to a scan; expected one that "
            "`bodymeasure fit` has made"
        )
    context = {
        "name": atlas.name,
        "created": moment((created or datetime.now(UTC)).isoformat(timespec="seconds")),
        "tiles": _tiles(atlas, scan),
        "scan": scan,
        "scores": scores,
        "parts": _parts(atlas, scan),
        "landmarks": [
            (name, found.origin.value, millimeters(found.uncertainty, "m"))
            for name, found in scan.landmarks.items()
        ],
        "blind": BLIND,
        "provenance": atlas.provenance,
        "pictures": {} if pictures is None else images(pictures.body),
        "picture_note": "" if pictures is None else pictures.note,
    }
    return render_page(
        "bodymeasure.report",
        "fit.html.j2",
        context,
        feature="the page of a fit",
        styles=("measurements.css",),
    )


def _tiles(atlas: Atlas, scan: ScanFit) -> list[tuple[str, str, str]]:
    """Return the key figures, each with a heading and a remark."""
    off = [found.uncertainty for found in scan.landmarks.values()]
    uncovered = len(scan.uncovered)
    return [
        ("Distance from the scan", millimeters(_finite(scan.rms), "m"), "root mean square"),
        ("Covered by the scan", _percent(float(scan.coverage.mean())), "of the atlas"),
        (
            "Patches without scan",
            f"{uncovered} of {len(atlas)}",
            "what is measured there has no value" if uncovered else "",
        ),
        (
            "Landmarks uncertain by",
            _span(off) if off else NONE,
            "root mean square along the skin",
        ),
    ]


def _span(lengths: list[float]) -> str:
    least, most = millimeters(min(lengths), "m"), millimeters(max(lengths), "m")
    return most if least == most else f"{least} to {most}"


def _parts(atlas: Atlas, scan: ScanFit) -> list[Part]:
    """Return the coverage of each region, the worst first."""
    regions = np.array(atlas.regions)
    bare = set(scan.uncovered.tolist())
    found = []
    for region in dict.fromkeys(atlas.regions):
        patches = np.flatnonzero(regions == region)
        names = [atlas.patch_names[patch] for patch in patches.tolist() if patch in bare]
        coverage = float(scan.coverage[patches].mean())
        part = Part(
            region or "elsewhere",
            len(patches),
            _percent(coverage),
            millimeters(_finite(_rms(scan.distance, patches)), "m"),
            ", ".join(names),
        )
        found.append((coverage, part))
    return [part for _, part in sorted(found, key=lambda each: each[0])]


def _rms(distance: Array, patches: Ints) -> float:
    known = distance[patches][np.isfinite(distance[patches])]
    return float(np.sqrt((known**2).mean())) if len(known) else float("nan")


def _finite(value: float) -> float | None:
    return value if np.isfinite(value) else None


def _percent(part: float) -> str:
    # A body that is nearly whole is not whole.
    return f"{math.floor(100.0 * part + ROUNDING)} %"

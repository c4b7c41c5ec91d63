"""A sheet of all unfolded patches, and a table of their lengths."""

import csv
import io
from html import escape
from itertools import groupby

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.pattern.patches.colors import color_of
from bodymeasure.pattern.patches.unfold import UnfoldedPatches

# The sheet in millimeters: its width, the distance between patches, and the size of headings.
WIDTH = 1200.0
GAP = 6.0
TEXT = 12.0
# Names of the six lengths of a patch, in the order of `UnfoldedPatches.lengths`.
NAMES = ("v=0", "u=1", "v=1", "u=0", "diagonal from (0, 0)", "diagonal from (1, 0)")
# The percentile of the misfits at which the scale of colors ends, so that one bad patch does not
# leave all others dark.
FULL = 95.0


def patches_sheet(unfolded: UnfoldedPatches) -> str:
    """Return an SVG file with all patches in true size, by region, colored by their misfit.

    The unit is the millimeter; pointing at a patch shows its name and its misfit.
    """
    atlas = unfolded.atlas
    to_mm = 1000.0 * atlas.unit.meters
    worst = to_mm * unfolded.worst
    full = float(np.percentile(worst, FULL)) or 1.0
    body, y = _legend(full, float(worst.max())), 4.0 * TEXT
    order = sorted(range(len(atlas)), key=lambda patch: atlas.regions[patch])
    for region, members in groupby(order, key=lambda patch: atlas.regions[patch]):
        y += 2.0 * TEXT
        body.append(_text(GAP, y, region or "all patches"))
        y += 0.5 * TEXT
        x, tallest = GAP, 0.0
        for patch in members:
            corners = _lying(to_mm * unfolded.corners[patch])
            width, height = corners.max(axis=0).tolist()
            if x + width > WIDTH - GAP and x > GAP:
                x, y, tallest = GAP, y + tallest + GAP, 0.0
            title = f"{atlas.patch_names[patch]}: {worst[patch]:.2f} mm"
            body.append(_polygon(corners + np.array([x, y]), color_of(worst[patch] / full), title))
            x, tallest = x + width + GAP, max(tallest, height)
        y += tallest
    size = f'width="{WIDTH:g}mm" height="{y + GAP:.1f}mm" viewBox="0 0 {WIDTH:g} {y + GAP:.1f}"'
    head = f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif">'
    paper = '<rect width="100%" height="100%" fill="white"/>'
    return "\n".join([head, f"<title>{escape(atlas.name)}</title>", paper, *body, "</svg>", ""])


def patches_table(unfolded: UnfoldedPatches) -> str:
    """Return a CSV file with the six lengths of each patch and their misfits, in millimeters."""
    to_mm = 1000.0 * unfolded.atlas.unit.meters
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    names = [f"{name} ({what})" for what in ("on the body", "misfit") for name in NAMES]
    writer.writerow(["patch", "region", *names])
    rows = np.concatenate([unfolded.lengths, unfolded.misfit], axis=1) * to_mm
    atlas = unfolded.atlas
    for name, region, row in zip(atlas.patch_names, atlas.regions, rows.tolist(), strict=True):
        writer.writerow([name, region, *(f"{value:.4f}" for value in row)])
    return text.getvalue()


def _lying(corners: Array) -> Array:
    """Return a quadrilateral with its longest side level and below, from the origin on."""
    sides = np.roll(corners, -1, axis=0) - corners
    along = sides[int(np.argmax(np.linalg.norm(sides, axis=1)))]
    along = along / np.linalg.norm(along)
    # The second axis of an SVG file points down, so that the quadrilateral is drawn upright.
    turned = corners @ np.array([[along[0], along[1]], [along[1], -along[0]]])
    return np.asarray(turned - turned.min(axis=0))


def _legend(full: float, largest: float) -> list[str]:
    words = (
        f"Largest misfit of the six lengths of each patch, in mm: 0 to {full:.2f} or more "
        f"(the largest is {largest:.2f})"
    )
    boxes = [
        f'<rect x="{GAP + 2.0 * i:g}" y="{2.0 * TEXT:g}" width="2.1" height="{TEXT:g}" '
        f'fill="{color_of(i / 99.0)}"/>'
        for i in range(100)
    ]
    return [_text(GAP, 1.5 * TEXT, words), *boxes]


def _text(x: float, y: float, words: str) -> str:
    return f'<text x="{x:g}" y="{y:g}" font-size="{TEXT:g}">{escape(words)}</text>'


def _polygon(corners: Array, fill: str, title: str) -> str:
    points = " ".join(",".join(f"{value:.3f}" for value in corner) for corner in corners.tolist())
    return (
        f'<polygon points="{points}" fill="{fill}" stroke="black" stroke-width="0.3">'
        f"<title>{escape(title)}</title></polygon>"
    )

"""A pattern as one self-contained page: its pieces, how their cloth has to give, and its seams."""

from collections.abc import Mapping
from datetime import UTC, datetime
from typing import NamedTuple, Protocol

from bodymeasure.pattern import (
    FULL_STRAIN,
    Pattern,
    color_of,
    pattern_record,
    strain_pictures,
)
from bodymeasure.report.numbers import fixed
from bodymeasure.report.templating import images, moment, render_page
from bodymeasure.wording import counted

# Pixels for a millimeter of a piece, so that pieces are to one scale.
SCALE = 0.9
# What the files beside the page are for.
FILES = {
    "pattern.pdf": "print it in true size, and check the square of 50 mm",
    "pattern.svg": "true size, for drawing programs",
    "pattern.dxf": "for cutting rooms, in the layers of AAMA and ASTM D6673",
    "garmentcode.json": "panels with stitches, for programs that simulate cloth",
    "strain.svg": "the maps of strain below, as one drawing",
    "pattern.json": "all numbers of this page",
}
# Seams that differ by less than this, in millimeters, are equal but for rounding.
ROUNDING = 1e-4


class BodyPictures(Protocol):
    """Pictures of the panels on the body, as `bodymeasure.scene.panels` makes them."""

    @property
    def body(self) -> Mapping[str, bytes]:
        """WebP or PNG by side; to be shown at half their size."""

    @property
    def note(self) -> str:
        """A remark on how they were drawn; may be empty."""


class Card(NamedTuple):
    """A piece as the page shows it."""

    name: str
    drawing: str
    width: int
    rms: str
    largest: str
    cut: str


def render_pattern(
    pattern: Pattern,
    pictures: BodyPictures | None = None,
    *,
    allowance: float = 10.0,
    files: tuple[str, ...] = (),
    created: datetime | None = None,
) -> bytes:
    """Return the page of a pattern, which loads nothing else.

    Parameters
    ----------
    pattern : Pattern
    pictures : BodyPictures, optional
        Without them, the page has none.
    allowance : float
        Of seams, in millimeters, where their panels do not say otherwise.
    files : tuple of str
        Names of the files beside the page, to which it links.
    created : datetime, optional
        The time that the page states; the present if not given.

    Raises
    ------
    MissingExtraError
        If jinja2 is not installed.
    """
    record = pattern_record(pattern, allowance=allowance)
    maps = strain_pictures(pattern)
    cards = []
    for piece in record.pieces:
        drawing, width, _ = maps[piece.name]
        rms, largest = fixed(piece.rms_strain, 1), fixed(piece.largest_strain, 0)
        cards.append(Card(piece.name, drawing, round(SCALE * width), rms, largest, piece.cut))
    context = {
        "name": record.body,
        "set": record.set,
        "created": moment((created or datetime.now(UTC)).isoformat(timespec="seconds")),
        "tiles": _tiles(pattern),
        "warnings": record.warnings,
        "cards": cards,
        "pieces": record.pieces,
        "seams": record.seams,
        "allowance": f"{allowance:g}",
        "ease": _ease(pattern),
        "bar": [color_of(part / 15.0) for part in range(16)],
        "ticks": [f"{100.0 * FULL_STRAIN * part / 3.0:.0f} %" for part in range(4)],
        "files": [(name, FILES.get(name, "")) for name in files],
        "pictures": {} if pictures is None else images(pictures.body),
        "picture_note": "" if pictures is None else pictures.note,
    }
    return render_page(
        "bodymeasure.report",
        "pattern.html.j2",
        context,
        feature="the page of a pattern",
        filters={"mm": lambda value: fixed(value, 1), "difference": _difference},
        styles=("measurements.css",),
    )


def _difference(value: float) -> str:
    """Return the difference of both sides of a seam in millimeters."""
    return "none" if abs(value) < ROUNDING else f"{value:+.2f}".replace("-", "\N{MINUS SIGN}")


def _ease(pattern: Pattern) -> str:
    """Return the ease of girths in words; empty if there is none."""
    return ", ".join(f"{name} {100.0 * ease:g} cm" for name, ease in pattern.ease.items() if ease)


def _tiles(pattern: Pattern) -> list[tuple[str, str, str]]:
    """Return the key figures, each with a heading and a remark."""
    seams = pattern.seams
    worst = max(pattern.pieces, key=lambda piece: piece.rms_strain)
    millimeters = 1000.0 * pattern.atlas.unit.meters
    largest = max((abs(millimeters * seam.excess) for seam in seams), default=0.0)
    equal = "equal to rounding" if largest < ROUNDING else f"off by up to {largest:.2f} mm"
    sound = sum(piece.is_sound for piece in pattern.pieces)
    all_sound = sound == len(pattern.pieces)
    return [
        ("Pieces", str(len(pattern.pieces)), "" if all_sound else f"{sound} of them sound"),
        ("Seams between them", str(len(seams)), equal if seams else ""),
        ("Cloth gives at most", f"{100.0 * worst.rms_strain:.1f} %", f"rms, in {worst.name}"),
        ("Darts", str(sum(len(piece.darts) for piece in pattern.pieces)), ""),
        ("To look at", counted(len(pattern.warnings), "remark"), ""),
    ]

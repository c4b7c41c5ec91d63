"""The output of `bodymeasure landmarks`: the landmarks of an atlas, and how symmetric they are."""

from typing import Literal

from msgspec import Struct

from bodymeasure._typing import Array
from bodymeasure.atlas import Atlas, Unit, convert_length
from bodymeasure.chart import Definitions, Derived, derive_landmarks, lacking, names_in
from bodymeasure.chart.landmarks.names import other_side, suggested_name
from bodymeasure.chart.landmarks.symmetry import SymmetryCheck, check_symmetry
from bodymeasure.report.serial import csv_bytes, records_csv

# In meters. Experienced measurers find a landmark on a body again within about this distance.
SYMMETRIC_WITHIN = 0.005


class LandmarkRecord(Struct, frozen=True):
    """A landmark: where it is, and whether it was picked or a rule gives it, in words."""

    name: str
    patch: str
    u: float
    v: float
    x: float
    y: float
    z: float
    origin: Literal["picked", "rule"]
    rule: str


class MissingRecord(Struct, frozen=True):
    """A landmark that its rule could not give, and why."""

    name: str
    reason: str


class LackingRecord(Struct, frozen=True):
    """A measurement, and the landmarks that it lacks."""

    key: str
    name: str
    landmarks: tuple[str, ...]


class LandmarksDocument(Struct, frozen=True):
    """The landmarks of an atlas, and what is missing for a set of definitions."""

    atlas: str
    unit: str
    definitions: str
    landmarks: list[LandmarkRecord]
    missing: list[MissingRecord]
    lacking: list[LackingRecord]


def landmarks_document(
    atlas: Atlas, definitions: Definitions, unit: Unit | str, *, name: str = ""
) -> LandmarksDocument:
    """Return the landmarks of an atlas by the rules of a set, and what its measurements lack.

    Parameters
    ----------
    atlas : Atlas
    definitions : Definitions
    unit : Unit or str
        Unit of the positions.
    name : str
        Name of the atlas, for one that has none itself.

    Raises
    ------
    InputError
        As in `derive_landmarks`.
    """
    unit = Unit.parse(unit)
    derived = derive_landmarks(atlas, definitions.landmark)
    return LandmarksDocument(
        atlas=atlas.name or name,
        unit=unit.value,
        definitions=definitions.name,
        landmarks=_landmarks(atlas, derived, unit),
        missing=[MissingRecord(*item) for item in derived.missing.items()],
        lacking=[
            LackingRecord(one.measurement.key, one.measurement.name, one.landmarks)
            for one in lacking(definitions.measurement, derived.landmarks)
        ],
    )


def _landmarks(atlas: Atlas, derived: Derived, unit: Unit) -> list[LandmarkRecord]:
    records = []
    for name, point in derived.landmarks.items():
        rule = derived.rules.get(name)
        x, y, z = convert_length(atlas.position(point), atlas.unit, unit).tolist()
        records.append(
            LandmarkRecord(
                name,
                atlas.patch_names[point.patch],
                point.u,
                point.v,
                x,
                y,
                z,
                origin="picked" if rule is None else "rule",
                rule="" if rule is None else rule.description,
            )
        )
    return records


def landmarks_to_csv(document: LandmarksDocument) -> bytes:
    """Return the landmarks that are there, and those that are missing, as CSV."""
    columns = (*LandmarkRecord.__struct_fields__, "missing")
    rows: list[list[object]] = [
        [*(getattr(record, field) for field in LandmarkRecord.__struct_fields__), None]
        for record in document.landmarks
    ]
    blank = [None] * (len(columns) - 2)
    rows += [[missing.name, *blank, missing.reason] for missing in document.missing]
    return csv_bytes(columns, rows)


class CheckedLandmark(Struct, frozen=True):
    """The result of checking the symmetry and the name of a landmark.

    `distance` is that of the mirrored landmark from its partner, or that of a landmark without a
    side from the mirror; `remark` is empty where nothing is wrong.
    """

    name: str
    checked: Literal["pair", "median", "partner", "name"]
    distance: float | None
    remark: str


class SymmetryDocument(Struct, frozen=True):
    """The result of checking symmetry and names of an atlas's landmarks; lengths are in `unit`.

    `deviation` is the root mean square distance of the surface from its mirror image.
    """

    atlas: str
    unit: str
    mirror: Literal["fitted", "axes"]
    mirror_point: tuple[float, float, float]
    mirror_normal: tuple[float, float, float]
    deviation: float
    within: float
    landmarks: list[CheckedLandmark]

    @property
    def to_look_at(self) -> int:
        """Number of remarks."""
        return sum(bool(record.remark) for record in self.landmarks)


def symmetry_document(
    atlas: Atlas,
    definitions: Definitions,
    unit: Unit | str,
    *,
    mirror: Literal["fitted", "axes"] = "fitted",
    within: float | None = None,
    name: str = "",
) -> SymmetryDocument:
    """Return how symmetric landmarks are, and whether their names are those of measurements.

    Parameters
    ----------
    atlas : Atlas
    definitions : Definitions
        Their names are known, besides those of ISO 8559-1.
    unit : Unit or str
    mirror : {"fitted", "axes"}
        As in `check_symmetry`.
    within : float, optional
        The largest distance that counts as symmetric, in `unit`; 5 mm if not given.
    name : str
        Name of the atlas, for one that has none itself.
    """
    unit = Unit.parse(unit)
    found = check_symmetry(atlas, mirror)
    scale = atlas.unit.meters / unit.meters
    limit = SYMMETRIC_WITHIN / unit.meters if within is None else within
    return SymmetryDocument(
        atlas=atlas.name or name,
        unit=unit.value,
        mirror=mirror,
        mirror_point=_triple(scale * found.plane.point),
        mirror_normal=_triple(found.plane.normal),
        deviation=scale * found.deviation,
        within=limit,
        landmarks=[
            *_distances(found, scale, limit),
            *(
                CheckedLandmark(name, "partner", None, f"has no partner {other_side(name)}")
                for name in found.unpaired
            ),
            *_names(atlas, definitions),
        ],
    )


def _triple(vector: Array) -> tuple[float, float, float]:
    x, y, z = vector.tolist()
    return x, y, z


def _distances(found: SymmetryCheck, scale: float, limit: float) -> list[CheckedLandmark]:
    records = []
    for pair in found.pairs:
        apart = scale * pair.apart
        remark = f"not the mirror image of {pair.right}" if apart > limit else ""
        records.append(CheckedLandmark(pair.left, "pair", apart, remark))
    for name, away in found.median:
        off = abs(scale * away)
        side = "left" if away > 0.0 else "right"
        remark = f"off the mirror, to the {side}" if off > limit else ""
        records.append(CheckedLandmark(name, "median", off, remark))
    return records


def _names(atlas: Atlas, definitions: Definitions) -> list[CheckedLandmark]:
    known = names_in(definitions)
    suggestions = {name: suggested_name(name, known) for name in atlas.landmarks}
    return [
        CheckedLandmark(name, "name", None, f"unknown; did you mean {suggested!r}?")
        for name, suggested in suggestions.items()
        if suggested is not None
    ]


def symmetry_to_csv(document: SymmetryDocument) -> bytes:
    """Return the landmarks that were checked as CSV."""
    return records_csv(CheckedLandmark, document.landmarks)

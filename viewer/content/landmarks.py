"""Landmarks that a page puts on a body, and the files that hold them."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from bodymeasure.viewer.content.requests import Place, SaveLandmarks
from bodymeasure.viewer.content.shown import ShownBody

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.atlas.queries.locations import atlas_point
from bodymeasure.chart import load_definitions, names_in
from bodymeasure.chart.landmarks.places import place_in_words
from bodymeasure.chart.picks.file import COLUMNS
from bodymeasure.chart.picks.picking import Pick, with_landmarks, without_landmarks
from bodymeasure.chart.sides import both_sides
from bodymeasure.errors import InputError
from bodymeasure.formats import FORMATS, read_atlas, write_atlas
from bodymeasure.report.serial import csv_bytes

ATLAS = ".atlas"


def with_changes(body: ShownBody, changes: Mapping[str, Place | None]) -> ShownBody:
    """Return a body with some landmarks put or moved, and some taken off.

    Raises
    ------
    InputError
        If a name or a place is none.
    """
    return replace(body, atlas=_changed(body.atlas, changes)) if changes else body


def _changed(atlas: Atlas, changes: Mapping[str, Place | None]) -> Atlas:
    gone = [name for name, place in changes.items() if place is None and name in atlas.landmarks]
    picks = [
        Pick(name, atlas_point(atlas, AtlasPoint(*place), f"landmark {name!r}"))
        for name, place in changes.items()
        if place is not None
    ]
    return with_landmarks(without_landmarks(atlas, gone), picks, replacing=True)


def lacking_landmarks(atlas: Atlas) -> list[dict[str, str]]:
    """Return the landmarks of the standard chart that neither the body nor a rule gives.

    Each is said where to find, in words.
    """
    definitions = load_definitions()
    ruled = {rule.name for rule in both_sides(definitions.landmark)}
    names = sorted(names_in(definitions) - ruled - set(atlas.landmarks))
    return [{"name": name, "text": place_in_words(name)} for name in names]


def saved(body: ShownBody, request: SaveLandmarks) -> tuple[bytes, str] | dict[str, Any]:
    """Return a file with the landmarks, and how its name ends; or say which file was written.

    Raises
    ------
    InputError
        If a landmark is none, or the body has no file that holds landmarks.
    """
    if request.to == "file":
        return _saved_into_file(body, request.landmarks)
    changed = _changed(body.atlas, request.landmarks)
    if request.to == "atlas":
        write = FORMATS["atlas"].write
        assert write is not None
        return write(changed), ATLAS
    rows = [(name, *changed.position(place).tolist()) for name, place in changed.landmarks.items()]
    return csv_bytes(COLUMNS, rows), ".landmarks.csv"


def _saved_into_file(body: ShownBody, changes: Mapping[str, Place | None]) -> dict[str, Any]:
    if not body.savable:
        raise InputError(
            f"{body.name}: landmarks are saved into .atlas files, which this body was not opened "
            "from; save it as an atlas instead"
        )
    path = Path(body.file)
    # What others have changed in the file since it was read stays.
    current = read_atlas(path, **dict(body.settings or {}))
    write_atlas(_changed(current, changes), path)
    return {"saved": str(path)}

"""The message of a chart: its measurements with their names, and its tapes."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from bodymeasure.viewer.content.bodies import Bodies
from bodymeasure.viewer.content.landmarks import with_changes
from bodymeasure.viewer.content.requests import Export, MeasureChart
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.content.wire import packed
from msgspec import UNSET

from bodymeasure._typing import Array
from bodymeasure.atlas import Unit
from bodymeasure.chart import Chart, Definitions, Measured, Tape, load_definitions, measure_chart
from bodymeasure.chart.landmarks.names import side_of
from bodymeasure.errors import InputError
from bodymeasure.report.body import (
    BodyRecord,
    chart_document,
    chart_to_csv,
    to_freesewing,
    to_garmentcode,
    to_smis,
)
from bodymeasure.report.serial import to_json
from bodymeasure.scene.model import free_of_body
from bodymeasure.scene.tapes.build import evenly_spaced, smoothed, without_gaps
from bodymeasure.wording import counted, hint

DEFAULT, OWN = "default", "own"
SPACING = 1.0 / 300.0
# The function that makes a file of each format, and how the file's name ends.
FILES: Mapping[str, tuple[Callable[[Any], bytes], str]] = {
    "csv": (chart_to_csv, ".csv"),
    "json": (to_json, ".json"),
    "smis": (to_smis, ".smis"),
    "freesewing": (to_freesewing, ".freesewing.json"),
    "garmentcode": (to_garmentcode, ".garmentcode.yaml"),
}


def sets_of(own: Definitions | None) -> list[dict[str, str]]:
    """Return the sets of measurements that a page offers: their keys and names."""
    whole = load_definitions()
    sets = [{"key": DEFAULT, "label": whole.name}, *_presets(whole, "")]
    if own is None:
        return sets
    return [{"key": OWN, "label": own.name}, *_presets(own, f"{OWN}:"), *sets]


def _presets(definitions: Definitions, prefix: str) -> list[dict[str, str]]:
    return [
        {"key": prefix + name, "label": f"{name} ({counted(len(keys), 'key')})"}
        for name, keys in definitions.presets.items()
    ]


def chart_of(
    bodies: Bodies,
    request: MeasureChart,
    progress: Callable[[int, int], None] | None = None,
) -> tuple[ShownBody, Chart]:
    """Return a body with the landmarks that a request puts on it, and its chart.

    Raises
    ------
    InputError
        If there is no such set or body, or the landmarks contradict the body's axes or size.
    """
    body = bodies[request.body]
    changes = request.landmarks or {}
    definitions, only = _set_of(bodies, request.set)
    places = tuple(sorted((name, place) for name, place in changes.items() if place is not None))
    gone = tuple(sorted(name for name, place in changes.items() if place is None))
    key = (body.id, body.version, request.set, places, gone)
    changed = with_changes(body, changes)
    chart = bodies.chart(
        key,
        lambda: measure_chart(
            changed.atlas,
            definitions,
            only=only,
            progress=progress,
            despite_errors=body.despite_errors,
        ),
    )
    return changed, chart


def keep_chart(bodies: Bodies, body: ShownBody, chart: Chart) -> str:
    """Keep a chart that was measured elsewhere; return the key of its set.

    A page that asks for that set, on the body as it is, gets this chart.
    """
    whole = load_definitions()
    if chart.definitions == whole and not chart.only:
        key = DEFAULT
    elif chart.definitions == whole and len(chart.only) == 1 and chart.only[0] in whole.presets:
        (key,) = chart.only
    else:
        key, bodies.own = OWN, chart.definitions
    bodies.chart((body.id, body.version, key, (), ()), lambda: chart)
    return key


def _set_of(bodies: Bodies, key: str) -> tuple[Definitions, tuple[str, ...]]:
    of, _, preset = key.rpartition(":")
    definitions = bodies.own if OWN in (of, key) else load_definitions()
    if definitions is not None and key in (OWN, DEFAULT):
        return definitions, ()
    if definitions is None or preset not in definitions.presets or of not in ("", OWN):
        known = [one["key"] for one in sets_of(bodies.own)]
        raise InputError(f"there is no set {key!r} of measurements; {hint(key, known)}")
    return definitions, (preset,)


def chart_message(
    bodies: Bodies,
    request: MeasureChart,
    progress: Callable[[int, int], None] | None = None,
) -> bytes:
    """Return the measurements of a set with their tapes."""
    body, chart = chart_of(bodies, request, progress)
    return chart_content(body, chart, request.set)


def chart_content(body: ShownBody, chart: Chart, name: str = DEFAULT) -> bytes:
    """Return the message of a chart of a body; `name` is the key of its set."""
    document = chart_document(chart, Unit.M, subject=body.name)
    size = float(np.ptp(chart.atlas.points, axis=0).max())
    tapes: list[dict[str, Any]] = []
    parts: list[tuple[Array, Array, Array]] = []
    measurements, first = [], 0
    for item, record in zip(chart.measured, document.measurements, strict=True):
        drawn = [tape for tape in item.tapes if len(tape.points) > 1]
        numbers = range(len(tapes), len(tapes) + len(drawn))
        measurements.append({**_members(item, record), "tapes": list(numbers)})
        for tape in drawn:
            part = _line(tape, SPACING * size)
            tapes.append(
                {
                    "key": record.key,
                    "kind": tape.kind.value,
                    "first": first,
                    "count": len(part[0]),
                    "closed": bool(np.array_equal(tape.points[0], tape.points[-1])),
                    "through_body": tape.kind.value == "straight",
                }
            )
            parts.append(part)
            first += len(part[0])
    none = (np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(0))
    points, lift, free = (np.concatenate(each) for each in zip(none, *parts, strict=True))
    return packed(
        {
            "set": name,
            "title": document.definitions,
            "body": body.id,
            "seconds": document.seconds,
            "measurements": measurements,
            "tapes": tapes,
            "landmarks": [_landmark(body, chart, name) for name in chart.landmarks],
            "missing": [
                {"name": missing.name, "reason": missing.reason}
                for missing in document.missing_landmarks
            ],
            "to_pick": document.to_pick,
        },
        {
            "tape_points": body.positions_on_page(points),
            "tape_normals": body.vectors_on_page(lift),
            "tape_free": free.astype(np.uint8),
        },
    )


def _members(item: Measured, record: BodyRecord) -> dict[str, Any]:
    iso = " ".join(filter(None, (record.iso_name, record.iso_clause)))
    codes = {
        "iso": iso,
        "seamlyme": record.seamly,
        "freesewing": record.freesewing,
        "garmentcode": record.garmentcode,
    }
    uncertainty = record.input_uncertainty
    return {
        "key": record.key,
        "number": record.number,
        "title": record.name,
        "group": record.group,
        "side": side_of(record.key.replace("_", " ")),
        "codes": {name: code for name, code in codes.items() if code},
        "value": record.value,
        "kind": "angle" if item.definition.in_degrees else "length",
        "way": record.kind,
        "error_estimate": record.error_estimate,
        "input_uncertainty": None if uncertainty is UNSET else uncertainty,
        "contact": record.contact,
        "taut": record.taut,
        "outcome": record.outcome,
        "status": record.status,
        "words": record.words,
        "reason": record.reason,
        "landmarks": record.landmarks,
        # Of a path, the points that it leads through, in their order.
        "through": list(getattr(item.definition, "through", ())) if record.kind == "path" else [],
        "accuracy_class": record.accuracy_class,
    }


def _line(tape: Tape, spacing: float) -> tuple[Array, Array, Array]:
    """Return points, the directions in which the tape is lifted, and where it stands free."""
    lift = without_gaps(tape.points, tape.normals)
    values = np.concatenate([tape.normals, lift], axis=1)
    points, values = evenly_spaced(tape.points, values, spacing)
    return points, smoothed(values[:, 3:]), free_of_body(values[:, :3]).astype(np.float64)


def _landmark(body: ShownBody, chart: Chart, name: str) -> dict[str, Any]:
    place = chart.landmarks[name]
    return {
        "name": name,
        "location": list(place),
        "position": body.positions_on_page(chart.atlas.position(place)).tolist(),
        "origin": "file" if name in chart.atlas.landmarks else "rule",
    }


def export_file(
    bodies: Bodies,
    request: Export,
    progress: Callable[[int, int], None] | None = None,
) -> tuple[bytes, str]:
    """Return the measurements of a set as a file, and how its name ends."""
    body, chart = chart_of(bodies, request, progress)
    make, ending = FILES[request.format]
    return make(chart_document(chart, request.unit, subject=body.name)), ending

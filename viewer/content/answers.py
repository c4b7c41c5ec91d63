"""The answer to any request, which the server's worker and the notebook's widget both give."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import PurePath
from typing import Any

from bodymeasure.viewer.content import requests
from bodymeasure.viewer.content.bodies import Bodies
from bodymeasure.viewer.content.body import body_message
from bodymeasure.viewer.content.chart import chart_message, export_file, sets_of
from bodymeasure.viewer.content.landmarks import lacking_landmarks, saved
from bodymeasure.viewer.content.layers import layer_message
from bodymeasure.viewer.content.on_mesh import mesh_answer
from bodymeasure.viewer.content.opening import opened
from bodymeasure.viewer.content.points import mirror_answer, point_answer
from bodymeasure.viewer.content.quantities import QUANTITIES, quantity_message
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.content.tapes import closed_answer, girth_answer, path_answer

Progress = Callable[[int, int, str], None]
"""Called with how much is done, of how much, and what it is, in words."""


class File(bytes):
    """An answer that is a file to be saved; `name` is what it is to be called."""

    name: str

    @classmethod
    def of(cls, content: bytes, name: str) -> "File":
        """Return a file of some content and name."""
        file = cls(content)
        file.name = name
        return file


Answer = bytes | dict[str, Any]


def answer(bodies: Bodies, request: requests.Request, progress: Progress | None = None) -> Answer:
    """Return the answer to a request: a binary message, a file, or members for JSON.

    Parameters
    ----------
    bodies : Bodies
    request : Request
    progress : callable, optional
        Is told how far an answer is that takes long.

    Raises
    ------
    BodymeasureError
        What the user is told: what cannot be measured, opened or saved, and what to do.
    """
    if isinstance(request, requests.OpenFile):
        return _opened(bodies, request)
    body = bodies[request.body]
    match request:
        case requests.ShowBody():
            return body_message(body, _offers(bodies, body))
        case requests.ShowLayer():
            return layer_message(body, request, _telling(progress, "comparing with the mesh"))
        case requests.ShowQuantity():
            return quantity_message(bodies, request)
        case requests.MeasurePath():
            return path_answer(body, request)
        case requests.MeasureGirth():
            return girth_answer(body, request)
        case requests.MeasureClosed():
            return closed_answer(body, request)
        case requests.MeasureOnMesh():
            return mesh_answer(body, request, _telling(progress, "measuring on the mesh"))
        case requests.FindPoint():
            return point_answer(body, request)
        case requests.FindMirror():
            return mirror_answer(body, request)
        case requests.Export():
            return _named(body, export_file(bodies, request, _telling(progress, "measuring")))
        case requests.MeasureChart():
            return chart_message(bodies, request, _telling(progress, "measuring"))
        case requests.SaveLandmarks():
            done = saved(body, request)
            return done if isinstance(done, dict) else _named(body, done)
    raise TypeError(f"no answer to {type(request).__name__}")


def _offers(bodies: Bodies, body: ShownBody) -> dict[str, Any]:
    """Return what a page can do with a body."""
    return {
        "lacking": lacking_landmarks(body.atlas),
        "quantities": [{"key": key, "label": label} for key, label in QUANTITIES.items()],
        "can": {"chart": True, "save_atlas": body.savable, "mirror": True, "taut": True},
        "sets": sets_of(bodies.own),
        "bodies": [{"id": one.id, "name": one.name} for one in bodies.shown.values()],
    }


def _opened(bodies: Bodies, request: requests.OpenFile) -> dict[str, Any]:
    number = 1
    while str(number) in bodies.shown:
        number += 1
    body = replace(opened(request), id=str(number))
    bodies.put(body)
    return {"id": body.id, "name": body.name, "warnings": list(body.warnings)}


def _named(body: ShownBody, content: tuple[bytes, str]) -> File:
    stem = PurePath(body.file).stem or body.name or "body"
    return File.of(content[0], stem + content[1])


def _telling(progress: Progress | None, words: str) -> Callable[[int, int], None] | None:
    if progress is None:
        return None
    return lambda done, total: progress(done, total, words)

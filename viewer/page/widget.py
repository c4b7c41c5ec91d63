"""The viewer as a widget of a notebook."""

import logging
import secrets
from importlib.resources import files
from typing import Any

import anywidget
import msgspec
import traitlets
from bodymeasure.viewer.content import requests
from bodymeasure.viewer.content.answers import File, answer
from bodymeasure.viewer.content.bodies import Bodies
from bodymeasure.viewer.content.chart import keep_chart
from bodymeasure.viewer.content.opening import read_again
from bodymeasure.viewer.page.given import Given

from bodymeasure.errors import BodymeasureError, InputError

HEIGHT = 620
FAILED = "The program that measures failed; the notebook's log says why. The body is shown on."
_STATIC = files("bodymeasure.viewer").joinpath("static")
_log = logging.getLogger(__name__)


class BodyView(anywidget.AnyWidget):
    """A body in a cell of a notebook, to be turned and measured by clicking.

    `bodymeasure.show` makes it. The cell asks the notebook's kernel over the channel that widgets
    have, so that it works wherever the notebook does.

    Parameters
    ----------
    content : Given
        What is shown.
    height : int
        Height of the cell in pixels.
    """

    _esm = _STATIC.joinpath("viewer.js").read_text("utf-8")
    _css = _STATIC.joinpath("viewer.css").read_text("utf-8")
    height = traitlets.Int(HEIGHT).tag(sync=True)
    options = traitlets.Dict().tag(sync=True)

    def __init__(self, content: Given, *, height: int = HEIGHT) -> None:
        self.bodies = Bodies()
        body = content.body
        self.bodies.put(body)
        # The cells of a notebook share a memory, in which each keeps its tapes under its own name.
        options: dict[str, Any] = {
            "can": {"save": True, "open": False},
            "key": secrets.token_hex(8),
        }
        if content.chart is not None:
            options["chart"] = keep_chart(self.bodies, body, content.chart)
        if content.survey is not None:
            options["settings"] = {"layers": {"diagonals": True}}
        super().__init__(height=height, options=options)
        self.on_msg(self._received)

    def _received(self, _widget: Any, message: Any, _buffers: Any) -> None:
        """Answer a request of the cell: with members, or with a buffer where it is large."""
        number = message.get("id") if isinstance(message, dict) else None
        try:
            request = _request(message)
            found = answer(self.bodies, request)
            if isinstance(request, requests.SaveLandmarks) and request.to == "file":
                # What is asked next is asked of the body as it was saved.
                self.bodies.put(read_again(self.bodies[request.body]))
        except BodymeasureError as error:
            self.send({"id": number, "error": str(error)})
        except Exception:
            _log.exception("a request of a notebook's cell failed")
            self.send({"id": number, "error": FAILED, "status": 500})
        else:
            if isinstance(found, dict):
                # The members may be anything that JSON can hold, which the channel cannot.
                members = msgspec.json.decode(msgspec.json.encode(found))
                self.send({"id": number, "answer": members})
            else:
                name = {"name": found.name} if isinstance(found, File) else {}
                self.send({"id": number, **name}, buffers=[bytes(found)])


def _request(message: Any) -> requests.Request:
    asked = message.get("request") if isinstance(message, dict) else None
    request = requests.parsed_message(msgspec.json.encode(asked))
    if isinstance(request, requests.OpenFile):
        raise InputError("in a notebook, open another body with bm.show(path)")
    return request

"""A cell of a notebook, without a notebook: what it asks, and what it is answered."""

from typing import Any


class Cell:
    """The browser's side of a widget.

    Parameters
    ----------
    view : BodyView
        Its messages are kept here rather than sent.
    """

    def __init__(self, view: Any) -> None:
        self.view = view
        self.sent: list[dict[str, Any]] = []
        self.asked: list[dict[str, Any]] = []
        view.send = self._receive

    def _receive(self, content: dict[str, Any], buffers: Any = ()) -> None:
        self.sent.append({**content, "buffers": list(buffers)})

    def ask(self, kind: str, **members: Any) -> dict[str, Any]:
        """Return the answer to a request, which carries the request's number."""
        number = len(self.sent) + 1
        message = {"id": number, "request": {"request": kind, **members}}
        self.view._received(self.view, message, [])
        answer = self.sent[-1]
        assert answer["id"] == number
        return answer

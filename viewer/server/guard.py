"""The gate before all requests: who may ask, from where, and how much may be sent."""

import ipaddress
import secrets
import socket
from collections.abc import Awaitable, Callable, Iterable, MutableMapping
from typing import Any

from msgspec import json

Scope = MutableMapping[str, Any]
Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

# Bytes that a request may carry; a file that is opened may be larger.
MOST_BYTES = 1_000_000
MOST_FILE_BYTES = 64_000_000
FILES = ("/api/open",)
API = "/api/"
# The port of http, which addresses need not name.
USUAL = 80
LOOPBACK = ("127.0.0.1", "localhost", "[::1]")
# What a page of ours may load: its own files and nothing else; nobody may frame it.
POLICY = (
    "default-src 'none'; script-src 'self'; connect-src 'self'; style-src 'self'; "
    "img-src 'self' blob: data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
HEADERS = {
    "content-security-policy": POLICY,
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-resource-policy": "same-origin",
    "cross-origin-opener-policy": "same-origin",
    "cache-control": "no-store",
}


class TooLargeError(Exception):
    """More was sent than may be."""


class Guard:
    """Refuse what does not come from the page that this server has sent.

    Parameters
    ----------
    app : ASGI application
    token : str
        The secret that the link holds.
    port : int
    hosts : iterable of str
        Names under which the server may be addressed, besides those of the machine itself.
    anywhere : bool
        Whether other machines may ask, so that it may be addressed by any number (which no name
        that an attacker owns is, so that it cannot be rebound to this machine).
    """

    def __init__(
        self,
        app: App,
        *,
        token: str,
        port: int,
        hosts: Iterable[str] = (),
        anywhere: bool = False,
    ) -> None:
        self.app, self.token, self.port, self.anywhere = app, token, port, anywhere
        names = [host.lower() for host in (*LOOPBACK, *hosts)]
        # Browsers leave out the port that is usual.
        self.hosts = {f"{name}:{port}" for name in names} | {*(names if port == USUAL else ())}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer a request, or refuse it."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        if scope["type"] != "http":
            # A WebSocket that is closed before it was accepted is refused with 403.
            await send({"type": "websocket.close", "code": 1008})
            return
        headers = _headers(scope)
        if reason := self._fault(scope["path"], headers):
            await _refuse(send, 403, reason)
            return
        most = MOST_FILE_BYTES if scope["path"] in FILES else MOST_BYTES
        words = f"more than {most:,} bytes were sent; send a smaller file"
        declared = headers.get("content-length", "0")
        if not declared.isdigit() or int(declared) > most:
            await _refuse(send, 413, words)
            return

        async def begin(message: Message) -> None:
            if message["type"] == "http.response.start":
                given = {name for name, _ in message["headers"]}
                message["headers"] = [
                    *message["headers"],
                    *(
                        (name.encode(), value.encode())
                        for name, value in HEADERS.items()
                        if name.encode() not in given
                    ),
                ]
            await send(message)

        await self.app(scope, _limited(receive, most, words), begin)

    def _fault(self, path: str, headers: dict[str, str]) -> str:
        """Return why a request is refused; empty if it is not."""
        host = headers.get("host", "").lower()
        if not self._is_ours(host):
            return (
                f"the address {host!r} is not one of this viewer's; open the link that "
                "`bodymeasure view` has printed"
            )
        if "upgrade" in headers:
            return "this viewer has no WebSockets"
        origin = headers.get("origin")
        if origin is not None and origin.lower() != f"http://{host}":
            return f"a page of {origin} asked; only this viewer's own page may"
        navigates = path == "/" and (
            headers.get("sec-fetch-mode"),
            headers.get("sec-fetch-dest"),
        ) == ("navigate", "document")
        # A link may lead to the page, which holds no secret; nothing else may ask from elsewhere.
        if headers.get("sec-fetch-site", "none") not in ("same-origin", "none") and not navigates:
            return (
                "a page of another site led here; copy the link that `bodymeasure view` has "
                "printed into the address bar"
            )
        if path.startswith(API) and not secrets.compare_digest(
            headers.get("x-token", "").encode(), self.token.encode()
        ):
            return (
                "the page has no token, or that of an earlier viewer; open the link that "
                "`bodymeasure view` has printed"
            )
        return ""

    def _is_ours(self, host: str) -> bool:
        if host in self.hosts:
            return True
        name = host.removesuffix(f":{self.port}")
        return self.anywhere and (name != host or self.port == USUAL) and _is_number(name)


def own_names() -> tuple[str, ...]:
    """Return the names under which other machines know this one."""
    return tuple(dict.fromkeys((socket.gethostname(), socket.getfqdn())))


def _is_number(name: str) -> bool:
    try:
        ipaddress.ip_address(name.removeprefix("[").removesuffix("]"))
    except ValueError:
        return False
    return True


def _headers(scope: Scope) -> dict[str, str]:
    """Return the headers of a request; one that is given twice counts with all its values."""
    headers: dict[str, str] = {}
    for name, value in scope["headers"]:
        key, text = name.decode("latin-1").lower(), value.decode("latin-1")
        headers[key] = f"{headers[key]}, {text}" if key in headers else text
    return headers


def _limited(receive: Receive, most: int, words: str) -> Receive:
    """Return what receives a body, and raises `TooLargeError` when it is larger than it may be."""
    size = 0

    async def limited() -> Message:
        nonlocal size
        message = await receive()
        size += len(message.get("body", b""))
        if size > most:
            raise TooLargeError(words)
        return message

    return limited


async def _refuse(send: Send, status: int, sentence: str) -> None:
    headers = {**HEADERS, "content-type": "application/json", "connection": "close"}
    encoded = [(name.encode(), value.encode()) for name, value in headers.items()]
    await send({"type": "http.response.start", "status": status, "headers": encoded})
    await send({"type": "http.response.body", "body": json.encode({"error": sentence})})

"""The server from its start to its end: port, link, browser, Ctrl-C."""

import ipaddress
import os
import re
import secrets
import socket
import tempfile
import threading
import webbrowser
from collections.abc import Callable, Sequence
from contextlib import suppress
from html import escape
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING

from bodymeasure.errors import InputError, MissingExtraError

if TYPE_CHECKING:
    from bodymeasure.viewer.content.shown import ShownBody

    from bodymeasure.chart import Definitions

LOOPBACK = "127.0.0.1"
EVERYWHERE = ("0.0.0.0", "::")
TOKEN_BYTES = 24
# Gives the token, so that pages find a server that was started again; nobody must guess it.
TOKEN_VARIABLE = "BODYMEASURE_VIEW_TOKEN"
TOKEN_PATTERN = re.compile(r"[A-Za-z0-9_-]{20,200}")
# Seconds for which a connection is kept: longer than pages think, so that none is closed just when
# the next request comes.
KEEP_ALIVE = 600


def serve(
    body: "ShownBody",
    *,
    own: "Definitions | None" = None,
    others: "Sequence[ShownBody]" = (),
    host: str = LOOPBACK,
    port: int = 0,
    browser: bool = True,
    listening: Callable[[str], None] | None = None,
) -> None:
    """Serve the page of a body until the process is interrupted.

    Parameters
    ----------
    body : ShownBody
    own : Definitions, optional
        A set of definitions that the page offers beside the default one.
    others : sequence of ShownBody
        Bodies that are open beside it.
    host : str
        The address to listen at; any other than loopback lets other machines in that know the link.
    port : int
        0 takes a free one.
    browser : bool
        Whether to open the page in a browser.
    listening : callable, optional
        Called with the link as soon as the page can be opened.

    Raises
    ------
    InputError
        If the server cannot listen there.
    MissingExtraError
        If starlette or uvicorn is not installed.
    KeyboardInterrupt
        When it was interrupted, and has ended in order.
    """
    try:
        import uvicorn
        from bodymeasure.viewer.server.app import application
        from bodymeasure.viewer.server.service import Service
    except ModuleNotFoundError as error:
        if error.name not in ("uvicorn", "starlette"):
            raise
        raise MissingExtraError("the page", str(error.name), "viewer") from None
    from bodymeasure.viewer.server.guard import own_names

    token = chosen_token()
    listener = bound(host, port)
    service = Service(body, own, others)
    # The worker imports what it needs while this process does.
    service.workers[0].begin()
    taken = listener.getsockname()[1]
    local = is_loopback(host)
    app = application(
        service,
        token=token,
        port=taken,
        hosts=(_in_link(host), *(() if local else own_names())),
        anywhere=not local,
    )
    link = f"http://{_in_link(host)}:{taken}/#token={token}"

    class Server(uvicorn.Server):
        """Says when it listens, and ends open streams when it is to end."""

        async def startup(self, sockets: list[socket.socket] | None = None) -> None:
            await super().startup(sockets)
            if self.started and listening is not None:
                listening(link)
            if self.started and browser:
                threading.Thread(target=_open, args=(link, Path(folder)), daemon=True).start()

        def handle_exit(self, sig: int, frame: FrameType | None) -> None:
            service.close()
            # The end takes a second at the most; an impatient user must not break it off half-way.
            if not self.should_exit:
                super().handle_exit(sig, frame)

    config = uvicorn.Config(
        app,
        http="h11",
        ws="none",
        loop="asyncio",
        lifespan="on",
        log_config=None,
        access_log=False,
        server_header=False,
        timeout_keep_alive=KEEP_ALIVE,
        timeout_graceful_shutdown=1,
    )
    with listener, tempfile.TemporaryDirectory(prefix="bodymeasure-") as folder:
        try:
            Server(config).run(sockets=[listener])
        finally:
            for worker in service.workers:
                worker.end()


def chosen_token() -> str:
    """Return the token of the link: a random one, unless the environment gives it.

    Raises
    ------
    InputError
        If it is one that could be guessed, or that a link cannot hold.
    """
    given = os.environ.get(TOKEN_VARIABLE)
    if given is None:
        return secrets.token_urlsafe(TOKEN_BYTES)
    if not TOKEN_PATTERN.fullmatch(given):
        raise InputError(
            f"{TOKEN_VARIABLE}: expected 20 to 200 letters, digits, - and _, which nobody can "
            "guess; leave the variable out to have a random token"
        )
    return given


def bound(host: str, port: int) -> socket.socket:
    """Return a socket that is bound to an address.

    Raises
    ------
    InputError
        If it cannot be.
    """
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(
            host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE
        )[0]
        found = socket.socket(family, kind, protocol)
    except (OSError, UnicodeError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(
            f"--host {host}: is no address of this machine ({reason}); leave it out, and only "
            "this machine can open the page"
        ) from None
    try:
        found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        found.bind(address)
    except OSError as error:
        found.close()
        raise InputError(
            f"the viewer cannot listen at {host}, port {port} ({error.strerror}); choose another "
            "--port, or leave it out to take a free one"
        ) from None
    return found


def is_loopback(host: str) -> bool:
    """Whether an address is reached from this machine alone."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host.lower() == "localhost"


def _in_link(host: str) -> str:
    if host in EVERYWHERE:
        return socket.gethostname()
    return f"[{host}]" if ":" in host else host


def _open(link: str, folder: Path) -> None:
    """Open a link in the user's browser.

    The command line of a browser is seen by all users of the machine, so that the link, which
    holds the secret, goes through a file in a folder that only this user can read.
    """
    page = folder / "open.html"
    target = escape(link, quote=True)
    page.write_text(
        f'<!doctype html><meta charset="utf-8"><meta http-equiv="refresh" content="0;url={target}">'
        f'<title>bodymeasure</title><a href="{target}">Open the viewer</a>',
        encoding="utf-8",
    )
    with suppress(webbrowser.Error):
        webbrowser.open(page.as_uri())

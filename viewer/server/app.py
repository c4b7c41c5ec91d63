"""The routes of the server."""

import logging
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import quote, unquote

from bodymeasure.viewer.content import requests
from bodymeasure.viewer.server.guard import Guard, TooLargeError
from bodymeasure.viewer.server.queue import BusyError, GoneError, StoppedError
from bodymeasure.viewer.server.service import Service
from bodymeasure.viewer.server.work import Done
from msgspec import json
from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import ClientDisconnect, Request
from starlette.responses import Response, StreamingResponse
from starlette.routing import Route

from bodymeasure.errors import InputError

LOG = logging.getLogger("bodymeasure.viewer")
STATIC = Path(__file__).parents[1] / "static"
# All files of the page; no other name is ever looked up.
FILES = {
    "index.html": "text/html; charset=utf-8",
    "viewer.js": "text/javascript; charset=utf-8",
    "viewer.css": "text/css; charset=utf-8",
    "icon.svg": "image/svg+xml",
    "LICENSES.txt": "text/plain; charset=utf-8",
}
BINARY, JSON = "application/octet-stream", "application/json"
Asked = TypeVar("Asked", bound=requests.Request)


def application(service: Service, *, token: str, port: int, **guard: Any) -> Guard:
    """Return the server as an ASGI application.

    Parameters
    ----------
    service : Service
    token : str
        The secret that the link holds.
    port : int
    **guard
        See `Guard`.
    """

    @asynccontextmanager
    async def lifespan(_app: Starlette) -> AsyncIterator[None]:
        service.begin()
        try:
            yield
        finally:
            await service.end()

    async def events(_request: Request) -> Response:
        return StreamingResponse(service.events.listen(), media_type="application/x-ndjson")

    async def page(_request: Request) -> Response:
        return await _file("index.html")

    async def static(request: Request) -> Response:
        return await _file(request.path_params["name"])

    def asks(kind: type[Asked], make: Callable[[Request, bytes], Asked]) -> Any:
        async def endpoint(request: Request) -> Response:
            try:
                asked = make(request, await request.body())
                return _response(await service.answer(asked))
            except InputError as error:
                return _error(422, str(error))
            except TooLargeError as error:
                return _error(413, str(error), {"connection": "close"})
            except ClientDisconnect:
                return Response(status_code=400)
            except GoneError as error:
                return _error(500, str(error))
            except StoppedError as error:
                return _error(409, str(error))
            except BusyError:
                return _error(503, "too many requests wait; wait for an answer, and try again")

        endpoint.__name__ = kind.__name__
        return endpoint

    queries: list[tuple[str, type[requests.Request]]] = [
        ("/api/body", requests.ShowBody),
        ("/api/layer", requests.ShowLayer),
        ("/api/quantity", requests.ShowQuantity),
    ]
    posts: list[tuple[str, type[requests.Request]]] = [
        ("/api/path", requests.MeasurePath),
        ("/api/girth", requests.MeasureGirth),
        ("/api/closed", requests.MeasureClosed),
        ("/api/mesh", requests.MeasureOnMesh),
        ("/api/point", requests.FindPoint),
        ("/api/mirror", requests.FindMirror),
        ("/api/chart", requests.MeasureChart),
        ("/api/export", requests.Export),
        ("/api/landmarks", requests.SaveLandmarks),
        ("/api/stop", requests.Stop),
    ]
    routes = [
        Route("/", page),
        Route("/static/{name}", static),
        Route("/api/events", events),
        Route("/api/open", asks(requests.OpenFile, _open), methods=["POST"]),
        *(Route(path, asks(kind, _query(kind))) for path, kind in queries),
        *(Route(path, asks(kind, _post(kind)), methods=["POST"]) for path, kind in posts),
    ]
    app = Starlette(routes=routes, lifespan=lifespan)
    return Guard(app, token=token, port=port, **guard)


def _query(kind: type[Asked]) -> Callable[[Request, bytes], Asked]:
    """Return what makes a request of the members of an address."""

    def make(request: Request, _body: bytes) -> Asked:
        return requests.converted(dict(request.query_params), kind)

    return make


def _post(kind: type[Asked]) -> Callable[[Request, bytes], Asked]:
    """Return what makes a request of JSON, about the body that the address names."""

    def make(request: Request, body: bytes) -> Asked:
        return requests.parsed(body, kind, body=request.query_params.get("body"))

    return make


def _open(request: Request, body: bytes) -> requests.OpenFile:
    members = {"name": unquote(request.headers.get("x-name", "")), "content": body}
    if unit := request.headers.get("x-unit"):
        members["unit"] = unit
    return requests.converted(members, requests.OpenFile)


def _response(done: Done | None) -> Response:
    if done is None:
        return Response(b'{"superseded":true}', media_type=JSON)
    match done.kind:
        case "json":
            return Response(done.content, media_type=JSON)
        case "binary":
            return Response(done.content, media_type=BINARY)
        case "file":
            name = quote(done.name, safe="")
            return Response(done.content, headers={"X-Filename": name}, media_type=BINARY)
        case "error":
            return _error(422, done.content.decode(), wants=done.wants)
    LOG.error("a request failed:\n%s", done.content.decode())
    return _error(
        500, "something unexpected happened, which the viewer has logged; the page goes on"
    )


def _error(
    status: int, sentence: str, headers: dict[str, str] | None = None, wants: str = ""
) -> Response:
    told = {"error": sentence, **({"wants": wants} if wants else {})}
    return Response(json.encode(told), status, headers, JSON)


async def _file(name: str) -> Response:
    if name not in FILES:
        return _error(404, "there is no such file")
    try:
        content = await run_in_threadpool((STATIC / name).read_bytes)
    except OSError:
        return _error(
            404, f"the page's file {name} is missing; `node build.mjs` in viewer/web makes it"
        )
    return Response(content, media_type=FILES[name])

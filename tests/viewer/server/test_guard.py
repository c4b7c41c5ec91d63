"""Nothing but the page that has the link's token may ask, and it may not send too much."""

import asyncio
import socket
import sys
from typing import Any

import httpx
import pytest
from bodymeasure.viewer.server.guard import MOST_BYTES, MOST_FILE_BYTES, Guard
from helpers.viewer_server import Viewer, viewer

TOKEN, PORT = "the secret", 4321
PATIENCE = 60.0
OURS = {"host": f"127.0.0.1:{PORT}", "x-token": TOKEN}


async def echo(_scope: Any, receive: Any, send: Any) -> None:
    """Read a body, and answer."""
    while (await receive()).get("more_body"):
        pass
    await send({"type": "http.response.start", "status": 200, "headers": []})
    await send({"type": "http.response.body", "body": b"answered"})


def answered(path: str, headers: dict[str, str], **options: Any) -> tuple[int, bytes, list[Any]]:
    """Ask a guard; return the status, the content and the headers of its answer."""
    sent: list[Any] = []
    encoded = [(name.encode(), value.encode()) for name, value in headers.items()]
    scope = {"type": "http", "path": path, "headers": encoded, "method": "GET"}

    async def receive() -> dict[str, Any]:
        return {"type": "http.request", "body": b"", "more_body": False}

    async def send(message: Any) -> None:
        sent.append(message)

    guard = Guard(echo, **{"token": TOKEN, "port": PORT, **options})
    asyncio.run(guard(scope, receive, send))
    return sent[0]["status"], sent[1]["body"], sent[0]["headers"]


def test_our_own_page_is_answered() -> None:
    for host in ("127.0.0.1", "localhost", "[::1]", "LOCALHOST"):
        headers = {**OURS, "host": f"{host}:{PORT}", "origin": f"http://{host}:{PORT}".lower()}
        status, body, _ = answered("/api/body", {**headers, "sec-fetch-site": "same-origin"})
        assert (status, body) == (200, b"answered")


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"host": "evil.example:4321"}, "is not one of this viewer's"),
        ({"host": "127.0.0.1"}, "is not one of this viewer's"),
        ({"host": "127.0.0.1:80"}, "is not one of this viewer's"),
        ({"host": "127.0.0.1:4321.evil.example"}, "is not one of this viewer's"),
        ({"host": "127.0.0.2:4321"}, "is not one of this viewer's"),
        ({"host": "192.168.0.5:4321"}, "is not one of this viewer's"),
        ({"host": ""}, "is not one of this viewer's"),
        ({"origin": "http://evil.example"}, "only this viewer's own page may"),
        ({"origin": "http://127.0.0.1:4322"}, "only this viewer's own page may"),
        ({"origin": "https://127.0.0.1:4321"}, "only this viewer's own page may"),
        ({"origin": "null"}, "only this viewer's own page may"),
        ({"origin": "http://localhost:4321"}, "only this viewer's own page may"),
        ({"sec-fetch-site": "cross-site"}, "a page of another site"),
        ({"sec-fetch-site": "same-site"}, "a page of another site"),
        ({"sec-fetch-site": "none, cross-site"}, "a page of another site"),
        ({"x-token": ""}, "the page has no token"),
        ({"x-token": "the secreT"}, "the page has no token"),
        ({"x-token": "ä"}, "the page has no token"),
        ({"upgrade": "websocket", "connection": "Upgrade"}, "no WebSockets"),
    ],
)
@pytest.mark.parametrize("path", ["/api/body", "/api/open", "/api/events"])
def test_others_are_refused(changed: dict[str, str], words: str, path: str) -> None:
    status, body, headers = answered(path, {**OURS, **changed})
    assert status == 403
    assert words in body.decode()
    assert TOKEN not in body.decode()
    assert not any(name.startswith(b"access-control") for name, _ in headers)


def test_no_token_is_refused_too() -> None:
    status, body, _ = answered("/api/body", {"host": OURS["host"]})
    assert (status, b"the page has no token" in body) == (403, True)


def test_the_page_itself_needs_no_token_but_our_host() -> None:
    assert answered("/", {"host": OURS["host"]})[0] == 200
    assert answered("/", {"host": "evil.example:4321"})[0] == 403
    assert answered("/", {**OURS, "origin": "http://evil.example"})[0] == 403


def test_a_link_may_lead_to_the_page_and_to_nothing_else() -> None:
    link = {
        **OURS,
        "sec-fetch-site": "cross-site",
        "sec-fetch-mode": "navigate",
        "sec-fetch-dest": "document",
    }
    assert answered("/", link)[0] == 200
    assert answered("/api/body", link)[0] == 403
    assert answered("/static/viewer.js", link)[0] == 403
    assert answered("/", {**link, "sec-fetch-dest": "iframe"})[0] == 403
    assert answered("/", {**link, "sec-fetch-mode": "no-cors"})[0] == 403


def test_other_machines_are_answered_by_number_if_they_are_let_in() -> None:
    given = {"hosts": ("anna.local",), "anywhere": True}
    for host in ("192.168.0.5", "[fe80::1]", "anna.local"):
        assert answered("/api/body", {**OURS, "host": f"{host}:{PORT}"}, **given)[0] == 200
    for host in ("evil.example", "192.168.0.5.evil.example", "otto.local"):
        assert answered("/api/body", {**OURS, "host": f"{host}:{PORT}"}, **given)[0] == 403


def test_at_the_usual_port_browsers_leave_it_out() -> None:
    given = {"port": 80, "hosts": ("anna.local",), "anywhere": True}
    for host in ("127.0.0.1", "[::1]", "anna.local", "192.168.0.5", "[fe80::1]"):
        for named in (host, f"{host}:80"):
            assert answered("/api/body", {**OURS, "host": named}, **given)[0] == 200
    local = {"port": 80}
    assert answered("/api/body", {**OURS, "host": "127.0.0.1"}, **local)[0] == 200
    for host in ("evil.example", "192.168.0.5", "127.0.0.1:4321", "127.0.0.1:", ""):
        assert answered("/api/body", {**OURS, "host": host}, **local)[0] == 403


def test_every_answer_says_what_a_page_may_load() -> None:
    for changed in ({}, {"x-token": "other"}):
        _, _, headers = answered("/api/body", {**OURS, **changed})
        told = {name.decode(): value.decode() for name, value in headers}
        policy = told["content-security-policy"]
        assert policy.startswith("default-src 'none'; script-src 'self';")
        assert "frame-ancestors 'none'" in policy
        assert "unsafe" not in policy
        assert told["x-content-type-options"] == "nosniff"
        assert told["referrer-policy"] == "no-referrer"
        assert told["cross-origin-resource-policy"] == "same-origin"


def test_a_websocket_is_closed_before_it_is_accepted() -> None:
    sent: list[Any] = []

    async def send(message: Any) -> None:
        sent.append(message)

    guard = Guard(echo, token=TOKEN, port=PORT)
    scope = {"type": "websocket", "path": "/api/events", "headers": []}
    asyncio.run(guard(scope, None, send))
    assert [message["type"] for message in sent] == ["websocket.close"]


# What follows is asked of a real server.


def raw(server: Viewer, request: str) -> str:
    """Send a request as it is, and return the first line of the answer."""
    with socket.create_connection(("127.0.0.1", server.port), PATIENCE) as connection:
        connection.sendall(request.replace("\n", "\r\n").encode("latin-1"))
        return connection.makefile("rb").readline().decode().strip()


@pytest.mark.parametrize(
    ("headers", "status"),
    [
        ({}, 200),
        ({"Origin": "http://evil.example"}, 403),
        ({"Host": "evil.example"}, 403),
        ({"Sec-Fetch-Site": "cross-site"}, 403),
        ({"X-Token": "guessed"}, 403),
    ],
)
def test_the_server_is_guarded(server: Viewer, headers: dict[str, str], status: int) -> None:
    found = server.post("/api/point", json={"location": [0, 0.5, 0.5]}, headers=headers)
    assert found.status_code == status
    assert ("error" in found.json()) == (status != 200)


def test_a_host_of_another_name_is_refused(server: Viewer) -> None:
    asked = f"GET / HTTP/1.1\nHost: evil.example:{server.port}\n\n"
    assert raw(server, asked).startswith("HTTP/1.1 403")
    assert raw(server, "GET / HTTP/1.1\nHost: \n\n").startswith("HTTP/1.1 403")


def test_a_websocket_is_refused(server: Viewer) -> None:
    asked = (
        f"GET /api/events HTTP/1.1\nHost: 127.0.0.1:{server.port}\nUpgrade: websocket\n"
        f"Connection: Upgrade\nSec-WebSocket-Version: 13\nX-Token: {server.token}\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\n\n"
    )
    assert raw(server, asked).startswith("HTTP/1.1 403")


@pytest.mark.parametrize(
    "path",
    [
        "/static/../server/app.py",
        "/static/..%2f..%2fserver%2fapp.py",
        "/static/%2e%2e/%2e%2e/pyproject.toml",
        "/static/....//app.py",
        "/static//etc/passwd",
        "/static/index.html%00.js",
        "/static/..\\server\\app.py",
        "/static/viewer.js/../../server/app.py",
    ],
)
def test_no_path_leads_out_of_the_page(server: Viewer, path: str) -> None:
    asked = f"GET {path} HTTP/1.1\nHost: 127.0.0.1:{server.port}\n\n"
    assert raw(server, asked).split()[1] in ("404", "400")


def test_the_page_and_its_files_hold_no_secret(server: Viewer) -> None:
    with httpx.Client(base_url=server.address) as stranger:
        for path in ("/", "/static/viewer.js", "/static/viewer.css", "/static/icon.svg"):
            found = stranger.get(path)
            assert found.status_code == 200
            assert server.token not in found.text


@pytest.mark.parametrize(
    ("path", "most"), [("/api/point", MOST_BYTES), ("/api/open", MOST_FILE_BYTES)]
)
def test_a_body_that_says_it_is_too_large_is_not_read(server: Viewer, path: str, most: int) -> None:
    asked = (
        f"POST {path} HTTP/1.1\nHost: 127.0.0.1:{server.port}\nX-Token: {server.token}\n"
        f"Content-Length: {most + 1}\n\n"
    )
    assert raw(server, asked).startswith("HTTP/1.1 413")


def test_a_body_that_does_not_say_its_size_is_counted(server: Viewer) -> None:
    found = server.post("/api/point", content=(b" " * 100_000 for _ in range(11)))
    assert found.status_code == 413
    assert found.json()["error"] == "more than 1,000,000 bytes were sent; send a smaller file"
    # The server goes on.
    assert server.post("/api/point", json={"location": [0, 0.5, 0.5]}).status_code == 200


def test_a_size_that_is_none_is_refused(server: Viewer) -> None:
    asked = (
        f"POST /api/point HTTP/1.1\nHost: 127.0.0.1:{server.port}\nX-Token: {server.token}\n"
        "Content-Length: -1\n\n"
    )
    assert raw(server, asked).split()[1] in ("400", "413")


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "darwin", reason="there 127.0.0.1 is the only one")
def test_the_address_that_was_asked_for_is_answered() -> None:
    with viewer("paraboloid", "--host", "127.0.0.2") as server:
        assert server.address.startswith("http://127.0.0.2:")
        assert server.get("/api/body").status_code == 200
        asked = {"location": [0, 0.5, 0.5]}
        assert server.post("/api/point", json=asked).status_code == 200

"""What the server answers is what the library says, and nobody waits for a chart."""

import threading
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import pytest
from bodymeasure.viewer.content.wire import unpacked
from helpers.command_line import part_of_a_body
from helpers.viewer_server import PATIENCE, Viewer, viewer
from msgspec import json

import bodymeasure as bm
from bodymeasure.samples import sample_path

LENGTHS = {"locations": ["back neck point", [150, 0.25, 0.5]]}


def test_a_length_has_all_of_its_digits(server: Viewer) -> None:
    found = server.post("/api/path", json={"tab": "a", "serial": 1, **LENGTHS}).json()
    body = bm.load_sample("female_average")
    path = bm.geodesic_between(body, "back neck point", bm.AtlasPoint(150, 0.25, 0.5))
    assert found["length"] == path.length


def test_all_tabs_get_the_same_body(server: Viewer) -> None:
    first, second = server.get("/api/body"), server.get("/api/body?body=0")
    assert first.content == second.content
    header, _ = unpacked(first.content)
    assert (header["name"], header["version"]) == ("Average female body, 160.5 cm", 1)
    assert header["file"] == ""
    assert header["start"] == {"chart": None}


@pytest.mark.slow
def test_tapes_do_not_wait_for_a_chart(server: Viewer) -> None:
    order: list[str] = []

    def chart() -> None:
        assert server.post("/api/chart", json={"set": "default", "tab": "a"}).status_code == 200
        order.append("chart")

    thread = threading.Thread(target=chart)
    thread.start()
    for number in range(3):
        asked = {"tab": "a", "serial": number, "locations": ["crotch point", [number, 0.5, 0.5]]}
        assert server.post("/api/path", json=asked).status_code == 200
        assert server.get("/static/icon.svg").status_code == 200
        order.append("tape")
    thread.join(PATIENCE)
    assert order == ["tape", "tape", "tape", "chart"]


@pytest.mark.parametrize(
    ("method", "path", "options", "status", "words"),
    [
        ("GET", "/api/layer?name=neets", {}, 422, "neets"),
        ("GET", "/api/body?body=9", {}, 422, "no body is open as '9' any more"),
        ("GET", "/api/body?nobody=9", {}, 422, "nobody"),
        ("POST", "/api/path", {"content": b"{"}, 422, "the request is not understood"),
        ("POST", "/api/path", {"json": {"locations": ["nape", "navel"]}}, 422, "no landmark"),
        ("POST", "/api/chart", {"json": {"set": "all"}}, 422, "there is no set 'all'"),
        ("POST", "/api/open", {"content": b"x"}, 422, "has no extension"),
        ("POST", "/api/landmarks", {"json": {"landmarks": {}, "to": "file"}}, 422, ".atlas"),
    ],
)
def test_what_cannot_be_answered_is_a_sentence(
    server: Viewer, method: str, path: str, options: dict[str, Any], status: int, words: str
) -> None:
    found = server.client.request(method, path, **options)
    assert found.status_code == status
    assert words in found.json()["error"]
    assert found.json()["error"].count("Traceback") == 0


def test_what_is_not_asked_in_its_way_is_refused(server: Viewer) -> None:
    assert server.get("/api/path").status_code == 405
    assert server.post("/api/body").status_code == 405
    assert server.get("/api/secrets").status_code == 404


def test_a_file_that_is_opened_is_a_body_beside_the_first(server: Viewer) -> None:
    content = sample_path("male_average").read_bytes()
    headers = {"X-Name": "..%2F..%2Fhome%2FJ%C3%B6rg.atlas"}
    opened = server.post("/api/open", content=content, headers=headers).json()
    assert opened["name"] == bm.load_sample("male_average").name
    header, _ = unpacked(server.get(f"/api/body?body={opened['id']}").content)
    assert header["file"] == "Jörg.atlas"
    assert header["can"]["save_atlas"] is False
    found = server.post(f"/api/path?body={opened['id']}", json=LENGTHS).json()
    path = bm.geodesic_between(
        bm.load_sample("male_average"), "back neck point", bm.AtlasPoint(150, 0.25, 0.5)
    )
    assert found["length"] == path.length
    other = server.get(f"/api/quantity?key=distance&other={opened['id']}")
    assert unpacked(other.content)[0]["high"] > 0.0


def test_the_bodies_opened_longest_ago_are_closed(server: Viewer) -> None:
    content = sample_path("paraboloid").read_bytes()
    ids = [
        server.post("/api/open", content=content, headers={"X-Name": "a.atlas"}).json()["id"]
        for _ in range(8)
    ]
    assert len(set(ids)) == 8
    found = [server.get(f"/api/body?body={name}").status_code for name in ids]
    assert found == [422, 422, *[200] * 6]
    assert server.get("/api/body").status_code == 200


@pytest.mark.slow
def test_a_file_has_the_name_of_the_body(server: Viewer) -> None:
    found = server.post("/api/export", json={"set": "core", "format": "csv", "unit": "mm"})
    assert unquote(found.headers["X-Filename"]) == "Average female body, 160.5 cm.csv"
    rows = found.content.decode().splitlines()
    assert rows[0].startswith("number,key,name")
    assert ",mm," in rows[1]


@pytest.mark.slow
def test_a_file_that_changes_is_read_again(tmp_path: Path) -> None:
    path = tmp_path / "body.atlas"
    bm.write_atlas(part_of_a_body(100, 106), path)
    with viewer(path, "--chart", "core") as server:
        header, _ = unpacked(server.get("/api/body").content)
        assert (header["patches"], header["version"]) == (6, 1)
        assert header["start"] == {"chart": "core"}
        assert header["can"]["save_atlas"] is True
        asked = {"landmarks": {"mole": [1, 0.5, 0.5]}, "to": "file"}
        with server.client.stream("GET", "/api/events") as stream:
            lines = stream.iter_lines()
            assert json.decode(next(lines)) == {"tick": 0, "bodies": {"0": header["mark"]}}
            assert server.post("/api/landmarks", json=asked).json() == {"saved": str(path)}
            # At once, not only when the file is looked at the next time.
            header, _ = unpacked(server.get("/api/body").content)
            assert [mark["name"] for mark in header["landmarks"]] == ["mole"]
            assert next(line for line in lines if "tick" not in line) == '{"changed":true}'
            header, _ = unpacked(server.get("/api/body").content)
            assert [mark["name"] for mark in header["landmarks"]] == ["mole"]
            assert header["version"] == 2
            path.write_bytes(b"half")
            told = json.decode(next(line for line in lines if "tick" not in line))
            assert "body.atlas" in told["error"]
        # What was read before is still there.
        found = server.post("/api/path", json={"locations": ["mole", [0, 0.5, 0.5]]})
        assert found.status_code == 200


@pytest.mark.slow
def test_a_preset_a_file_and_an_atlas_after_chart_are_told_apart(tmp_path: Path) -> None:
    from bodymeasure.chart import default_set

    definitions = tmp_path / "mine.toml"
    definitions.write_text(default_set())
    for arguments, chart, name in (
        (("--chart", "paraboloid"), "default", "Paraboloid of revolution"),
        (("paraboloid", "--chart", "tops"), "tops", "Paraboloid of revolution"),
        (("--chart", definitions, "enneper"), "own", bm.load_sample("enneper").name),
    ):
        with viewer(*arguments) as server:
            header, _ = unpacked(server.get("/api/body").content)
            assert header["start"] == {"chart": chart}
            assert header["name"] == name
            assert (header["sets"][0]["key"] == "own") == (chart == "own")

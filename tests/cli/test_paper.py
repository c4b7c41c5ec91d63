import csv
import json
import re
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
from helpers.command_line import Run, hide_here, recorded_bars

from bodymeasure.paper import reproduce, reproduction
from bodymeasure.paper.data.random_patches import READINGS
from bodymeasure.paper.tables.statistics import key

FEW = READINGS[1:3]
OTHER = next(r.name for r in FEW if r.name != reproduction.CHOSEN)
FILES = ["paper.html", "summary.md", "tables.json", "tables.csv"]


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Run as little of the study as shows that everything is there."""
    monkeypatch.setattr(reproduction, "QUICK_GROUP_SIZE", 1)
    monkeypatch.setattr(reproduce, "READINGS", FEW)
    monkeypatch.setattr(reproduce, "FEW_COUNTS", (4,))
    monkeypatch.setattr(reproduction, "QUICK_BODY_STEP", 94)
    monkeypatch.setattr(reproduce, "QUICK_CURVES", 2)
    monkeypatch.setattr(reproduce, "QUICK_BEYOND_PATCHES", 4)
    monkeypatch.setattr(reproduce, "QUICK_SCALING_PATCHES", 4)


def untimed(content: dict[str, Any]) -> dict[str, Any]:
    """All tables without the columns that are measured times."""
    tables = {}
    for name, table in content["tables"].items():
        timed = {column["name"] for column in table["columns"] if column["timing"]}
        rows = [{k: v for k, v in row.items() if k not in timed} for row in table["rows"]]
        tables[name] = {**table, "rows": rows}
    return tables


class Loads(HTMLParser):
    """The addresses that a page would load or lead to."""

    def __init__(self) -> None:
        super().__init__()
        self.addresses: list[str] = []
        self.anchors: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:  # noqa: ARG002
        for name, value in attrs:
            if name in ("src", "href", "srcset", "data", "action"):
                self.addresses.append(value or "")
            if name == "id":
                self.anchors.add(value or "")


@pytest.mark.usefixtures("small")
@pytest.mark.slow
def test_every_table_and_the_page(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bars = recorded_bars(monkeypatch, "study.paper")
    folder = tmp_path / "new" / "paper"
    ran = run("paper", "-o", folder, "--quick", "--seed", 5, "--processes", 2)
    assert (ran.code, ran.err) == (0, "")
    assert sorted(path.name for path in folder.iterdir()) == sorted(FILES)
    assert ran.out.splitlines()[-4:] == [str(folder / name) for name in FILES]
    for reading in FEW:
        assert re.search(rf"^ *{re.escape(reading.name)}  +(\S+ %|-)", ran.out, re.MULTILINE)
    for _, total, done in bars:
        assert done == sorted(done)
        assert done[-1] == total

    content = json.loads((folder / "tables.json").read_bytes())
    assert content["settings"] == {
        "seed": 5,
        "quick": True,
        "processes": 2,
        "patches_a_set": 1,
    }
    tables = content["tables"]
    for start, count in (("table_3_", 2), ("table_4_", 4), ("truth_", 3), ("speed_", 3)):
        assert sum(name.startswith(start) for name in tables) == count
    assert {"closest", "events", "table_5", "scaling", "beyond", "named_methods"} <= set(tables)
    assert all(row["identical"] for row in tables["scaling"]["rows"])
    with (folder / "tables.csv").open(encoding="utf-8", newline="") as file:
        lines = list(csv.DictReader(file))
    cells = sum(len(table["rows"]) * len(table["columns"]) for table in tables.values())
    assert len(lines) == cells

    summary = (folder / "summary.md").read_text("utf-8")
    assert f"| {FEW[0].name} |" in summary
    assert f"**{tables['table_4_grid_0_6_inside']['title']}**" in summary
    assert tables[f"table_4_{key(OTHER)}_inside"]["title"] not in summary
    assert str(tmp_path) not in summary
    page = Loads()
    page.feed((folder / "paper.html").read_text("utf-8"))
    assert sum(address.startswith("data:image/svg") for address in page.addresses) == 11
    for address in page.addresses:
        assert address.startswith(("data:", "#"))
        if address.startswith("#"):
            assert address[1:] in page.anchors


@pytest.mark.slow
def test_one_seed_gives_the_same_tables_timings_aside(run: Run, tmp_path: Path) -> None:
    contents = []
    # That another seed gives other patches is tried where they are made.
    for name, processes, seed in (("a", 1, 3), ("b", 2, 3)):
        folder = tmp_path / name
        ran = run("paper", "-o", folder, "--quick", "--seed", seed, "--processes", processes)
        assert ran.code == 0
        contents.append(untimed(json.loads((folder / "tables.json").read_bytes())))
    assert contents[0] == contents[1]


def test_a_file_in_the_folders_place_is_bad_input(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_text("mine")
    ran = run("paper", "-o", file, "--quick")
    assert ran.code == 2
    assert f"{file}: cannot be written (it is a file, not a folder)" in ran.err
    assert file.read_text() == "mine"


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--seed", "-1"), "-1 is not in the range x>=0"),
        (("--processes", "0"), "0 is not in the range x>=1"),
        (("--seed", "many"), "'many' is not a valid integer"),
        (("female_average",), "unexpected extra argument"),
    ],
)
def test_bad_options_are_bad_input(
    run: Run, tmp_path: Path, arguments: tuple[str, ...], words: str
) -> None:
    ran = run("paper", "-o", tmp_path / "out", "--quick", *arguments)
    assert ran.code == 2
    assert words in ran.err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("module", "package"),
    [
        ("igl", "libigl"),
        ("jinja2", "jinja2"),
        ("matplotlib", "matplotlib"),
        ("potpourri3d", "potpourri3d"),
    ],
)
def test_a_missing_package_is_told_before_any_work(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, module: str, package: str
) -> None:
    hide_here(monkeypatch, module)
    ran = run("paper", "-o", tmp_path / "out", "--quick")
    assert ran.code == 2
    assert f"needs the package '{package}'" in ran.err
    assert not (tmp_path / "out").exists()

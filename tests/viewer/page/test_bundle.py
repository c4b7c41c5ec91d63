"""The committed page: all of its files, the licenses of what is in it, and no address of others."""

import json
import re
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
STATIC, WEB = ROOT / "viewer" / "static", ROOT / "viewer" / "web"
FILES = {"index.html", "viewer.js", "viewer.css", "icon.svg", "LICENSES.txt"}


def test_all_files_are_there_and_go_into_the_wheel() -> None:
    assert {path.name for path in STATIC.iterdir()} == FILES
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    data = project["tool"]["setuptools"]["package-data"]["bodymeasure.viewer"]
    assert data == ["static/*"]


def test_every_package_in_the_bundle_has_its_license() -> None:
    licenses = (STATIC / "LICENSES.txt").read_text(encoding="utf-8")
    package = json.loads((WEB / "package.json").read_text(encoding="utf-8"))
    for name, version in package["dependencies"].items():
        begin = licenses.index(f"{name} {version} (MIT)")
        text = licenses[begin : begin + 1500]
        assert "Permission is hereby granted" in text
        assert re.search(r"Copyright .*\d{4}", text)


def test_versions_are_exact_so_that_builds_are_the_same() -> None:
    package = json.loads((WEB / "package.json").read_text(encoding="utf-8"))
    versions = {**package["dependencies"], **package["devDependencies"]}
    assert all(re.fullmatch(r"\d+\.\d+\.\d+", version) for version in versions.values())
    assert (WEB / "package-lock.json").is_file()


@pytest.mark.parametrize("name", ["index.html", "viewer.css", "viewer.js"])
def test_no_file_is_fetched_from_elsewhere(name: str) -> None:
    text = (STATIC / name).read_text(encoding="utf-8")
    assert not re.findall(r"""(?:src|href)=["']?https?://""", text)
    assert not re.findall(r"""(?:url\(|@import\s*["']?|import\(["'])https?://""", text)

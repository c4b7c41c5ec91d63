import io
import json
import zipfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers.files.format_atlases import body_like, read, write
from helpers.files.mutations import read_or_refused
from hypothesis import given
from hypothesis import strategies as st

from bodymeasure import (
    AtlasPoint,
    InputError,
    Unit,
    read_atlas,
    read_population,
    write_atlas,
    write_population,
)

ATLAS = replace(body_like(2, 2), name="a", landmarks={"c7": AtlasPoint(1, 0.25, 0.5)})
CONTENT = write(ATLAS, "npz")


def arrays() -> dict[str, Any]:
    with np.load(io.BytesIO(CONTENT)) as file:
        return dict(file)


def packed(**changed: Any) -> bytes:
    buffer = io.BytesIO()
    np.savez(buffer, **{k: v for k, v in {**arrays(), **changed}.items() if v is not None})
    return buffer.getvalue()


def test_a_population_is_written_to_one_file(tmp_path: Path, rng: np.random.Generator) -> None:
    bodies = [
        replace(ATLAS, points=ATLAS.points + rng.normal(size=ATLAS.points.shape), name=f"no. {k}")
        for k in range(5)
    ]
    path = tmp_path / "all.npz"
    write_population(bodies, path)
    back = read_population(path)
    assert [body.name for body in back] == [body.name for body in bodies]
    for body, again in zip(bodies, back, strict=True):
        assert again.digest == body.digest
        assert again.landmarks == body.landmarks
    with pytest.raises(InputError, match="holds 5 bodies; expected one; read them all with"):
        read_atlas(path)


def test_one_body_is_a_population_of_one(tmp_path: Path) -> None:
    write_atlas(ATLAS, tmp_path / "one.npz")
    (body,) = read_population(tmp_path / "one.npz")
    assert body.digest == ATLAS.digest


@pytest.mark.parametrize(
    ("other", "message"),
    [
        (replace(ATLAS, unit=Unit.M), "atlas 1 .'a'. has other unit than the first"),
        (replace(ATLAS, landmarks={}), "has other landmarks than the first"),
        (body_like(2, 2), "has other landmarks"),
        (replace(ATLAS, index=ATLAS.index[:, ::-1]), "has another index or other weights"),
        (replace(ATLAS, weights=np.ones((4, 4, 4))), "has another index or other weights"),
    ],
)
def test_bodies_of_a_population_have_the_same_patches(
    tmp_path: Path, other: Any, message: str
) -> None:
    with pytest.raises(InputError, match=message):
        write_population([ATLAS, other], tmp_path / "all.npz")
    assert not (tmp_path / "all.npz").exists()


def test_a_population_is_not_empty_and_goes_into_an_npz_file(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no atlas to write"):
        write_population([], tmp_path / "all.npz")
    with pytest.raises(InputError, match=r"go into an .npz file"):
        write_population([ATLAS], tmp_path / "all.atlas")


def member(name: str, value: Any) -> Callable[[], bytes]:
    def change() -> bytes:
        header = json.loads(str(arrays()["header"]))
        header[name] = value
        return packed(header=np.array(json.dumps(header)))

    return change


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (lambda: b"", "is no .npz file, or damaged"),
        (lambda: b"PK\x03\x04" + b"0" * 100, "is no .npz file, or damaged"),
        (lambda: CONTENT[:-30], "is no .npz file, or damaged"),
        (lambda: packed(index=None), "holds header.npy, points.npy; expected the arrays"),
        (lambda: packed(more=np.zeros(3)), "expected the arrays header, index, points, weights"),
        (lambda: packed(points=np.zeros((3, 3, 3, 3))), r"points have shape \(3, 3, 3, 3\)"),
        (lambda: packed(points=np.full((2, 49, 3), 1.0)), r"\(2, 49, 3\), for 1 names of bodies"),
        (lambda: packed(points=np.full((1, 49, 3), np.nan)), "control point 0 is .nan"),
        (lambda: packed(points=np.ones((1, 49, 3), dtype=int)), "points: is no array .holds int64"),
        (lambda: packed(points=np.full((1, 49, 3), None)), "points: is no array .holds object"),
        (lambda: packed(index=np.full((4, 4, 4), 49)), "patch 0 .* refers to control point 49"),
        (lambda: packed(index=np.zeros((4, 4, 4))), "index: is no array .holds float64"),
        (lambda: packed(header=np.array("{}")), "its header is wrong: Object missing required"),
        (lambda: packed(header=np.array("")), "its header is wrong"),
        (lambda: packed(header=np.array("{}" * 2).repeat(2)), "header"),
        (member("version", 2), "has format 'bodymeasure atlas', version 2; this bodymeasure reads"),
        (member("unit", "ft"), "unknown unit 'ft'"),
        (member("names", []), "for 0 names of bodies"),
        (member("landmarks", {"c7": [9, 0, 0]}), "landmark 'c7' lies on patch 9"),
    ],
)
def test_damaged_files_are_refused(content: Callable[[], bytes], message: str) -> None:
    with pytest.raises(InputError, match=f"^file.*{message}"):
        read(content(), "npz")


def test_a_claim_of_a_thousand_million_points_is_refused_at_once() -> None:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, value in arrays().items():
            array = io.BytesIO()
            np.save(array, value)
            raw = array.getvalue()
            if name == "points":
                raw = raw.replace(b"(1, 49, 3), }          ", b"(1, 1000000000, 3), }  ")
                assert b"1000000000" in raw
            archive.writestr(f"{name}.npy", raw)
    with pytest.raises(InputError, match=r"points: is no array .has shape \(1, 1000000000, 3\)"):
        read(buffer.getvalue(), "npz")


def test_a_file_made_to_fill_memory_is_refused() -> None:
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **{**arrays(), "points": np.zeros((1, 2_000_000, 3))})
    with pytest.raises(InputError, match=r"says that it expands to 48.* bytes, which is too much"):
        read(buffer.getvalue(), "npz")


@given(st.integers(0, len(CONTENT) - 1), st.binary(min_size=1, max_size=4))
def test_garbled_bytes_are_read_or_refused(place: int, change: bytes) -> None:
    content = CONTENT[:place] + change + CONTENT[place + len(change) :]
    atlas = read_or_refused(content, "npz")
    assert atlas is None or atlas.digest == ATLAS.digest

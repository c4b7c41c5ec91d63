"""Files of many bodies: their three kinds, and what is refused."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from helpers.populations import coefficients, knees, vertices, write_shapes

import bodymeasure as bm
from bodymeasure.errors import InputError
from bodymeasure.fit.model import atlas_of_vertices
from bodymeasure.surveys.bodies import is_population, open_population
from bodymeasure.surveys.bodies.rows import NpzFile
from bodymeasure.surveys.bodies.surveyed import unique_names

pytest.importorskip("pyarrow")


def test_the_three_kinds_of_files_give_the_same_numbers(tmp_path: Path) -> None:
    count = 3
    files = [write_shapes(tmp_path / "shapes.npz", count)]
    files.append(tmp_path / "vertices.npz")
    np.savez_compressed(files[-1], vertices=vertices(count))
    files.append(tmp_path / "points.npz")
    atlases = [atlas_of_vertices(each, name=f"p {n}") for n, each in enumerate(vertices(count))]
    bm.write_population(atlases, files[-1])
    tables = [bm.survey(file, knees(), folder=tmp_path / file.stem) for file in files]
    assert tables[0].subjects == ("shapes 1", "shapes 2", "shapes 3")
    assert tables[2].subjects == ("p 0", "p 1", "p 2")
    for table in tables[1:]:
        assert table["knee"].tolist() == tables[0]["knee"].tolist()
        assert table["waist"].tolist() == tables[0]["waist"].tolist()


def test_names_of_subjects_are_those_of_the_file_and_all_different(tmp_path: Path) -> None:
    path = write_shapes(tmp_path / "many.npz", 3, names=np.array(["Ann", "", "Ann"]))
    bodies = open_population(path, tmp_path)
    names = [body.name for body in bodies.between(0, 3)]
    assert names == ["Ann 1", "many 2", "Ann 2"]
    assert list(unique_names(["a", "a 1", "a"])) == ["a 2", "a 1", "a 3"]


def test_rows_are_read_in_any_order_and_a_few_at_a_time(tmp_path: Path) -> None:
    rows = np.arange(60, dtype=np.float32).reshape(20, 3)
    np.savez_compressed(tmp_path / "rows.npz", coefficients=rows)
    with NpzFile(tmp_path / "rows.npz") as file:
        found = file.rows("coefficients")
        assert len(found) == 20
        for start, stop in ((0, 2), (5, 9), (19, 20), (3, 4), (0, 20)):
            assert found.between(start, stop).tolist() == rows[start:stop].tolist()


def test_an_atlas_is_no_population(tmp_path: Path) -> None:
    bm.write_atlas(bm.load_sample("paraboloid"), tmp_path / "one.npz")
    (tmp_path / "text.npz").write_text("nothing", encoding="utf-8")
    assert not is_population(tmp_path / "one.npz")
    assert not is_population(tmp_path / "text.npz")
    assert not is_population(tmp_path / "missing.npz")


def test_a_file_alone_that_is_no_population_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "many.npz"
    for words in ("holds coeffs; expected `coefficients`", "is no .npz file, or damaged"):
        np.savez(path, coeffs=coefficients(2))
        if "damaged" in words:
            path.write_text("bodies")
        with pytest.raises(InputError, match=words):
            bm.survey(path, knees(), folder=tmp_path / "out")
        assert not (tmp_path / "out").exists()


def test_a_body_with_a_number_that_is_none_fails_alone(tmp_path: Path) -> None:
    rows = coefficients(3)
    rows[1, 4] = np.nan
    np.savez(tmp_path / "many.npz", coefficients=rows)
    table = bm.survey(tmp_path / "many.npz", knees(), folder=tmp_path / "out")
    (failed,) = table.failures
    assert failed.subject == "many 2"
    assert failed.reason == "its coefficients are not all finite; give numbers"
    assert np.isfinite(table["knee"]).tolist() == [True, False, True]


@pytest.mark.parametrize(
    ("arrays", "words"),
    [
        ({"coefficients": np.zeros((2, 121))}, r"\(2, 121\); expected .* k from 1 to 120"),
        ({"coefficients": np.zeros(2)}, r"coefficients have shape \(2,\)"),
        ({"coefficients": np.zeros((0, 4))}, r"float64 of shape \(0, 4\); expected floats"),
        ({"coefficients": np.zeros((2, 3), int)}, "is int64 of shape"),
        ({"coefficients": np.full((2, 3), None)}, "is object of shape"),
        ({"coefficients": np.zeros((2, 3), order="F")}, "stored by columns"),
        ({"coefficients": np.zeros((2, 3)), "sex": np.zeros(2)}, "holds coefficients, sex; expect"),
        ({"coefficients": np.zeros((2, 3)), "names": np.array(["a"])}, "2 texts, one for each"),
        ({"coefficients": np.zeros((2, 3)), "names": np.zeros(2)}, "names are float64"),
        ({"vertices": np.zeros((2, 5, 3))}, r"\(2, 5, 3\); expected"),
        ({"shapes": np.zeros((2, 5))}, "holds shapes; expected `coefficients`"),
    ],
)
def test_files_of_another_kind_are_refused(
    arrays: dict[str, Any], words: str, tmp_path: Path
) -> None:
    np.savez(tmp_path / "many.npz", **arrays)
    with pytest.raises(InputError, match=f"many.npz: .*{words}"):
        open_population(tmp_path / "many.npz", tmp_path)


def test_a_damaged_file_is_refused(tmp_path: Path) -> None:
    path = write_shapes(tmp_path / "many.npz", 50)
    whole = path.read_bytes()
    path.write_bytes(whole[:300] + bytes(100) + whole[400:])
    with pytest.raises(InputError, match=r"many.npz: is no .npz file, or damaged"):
        open_population(path, tmp_path).between(0, 50)
    path.write_bytes(whole[:-30])
    with pytest.raises(InputError, match=r"many.npz: is no .npz file, or damaged"):
        open_population(path, tmp_path)


def test_a_file_with_points_of_other_bodies_than_its_header_is_refused(tmp_path: Path) -> None:
    body = bm.load_sample("paraboloid")
    bm.write_population([body, body], tmp_path / "two.npz")
    with np.load(tmp_path / "two.npz") as data:
        arrays = dict(data)
    arrays["points"] = np.concatenate([arrays["points"]] * 2)
    np.savez(tmp_path / "two.npz", **arrays)
    with pytest.raises(InputError, match=r"two.npz: points have shape .*, for 2 names of bodies"):
        open_population(tmp_path / "two.npz", tmp_path)

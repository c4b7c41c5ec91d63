"""Landmarks that were clicked are saved where the user wants them, and nothing else is lost."""

from pathlib import Path

import numpy as np
import pytest
from bodymeasure.viewer.content.answers import File, answer
from bodymeasure.viewer.content.bodies import Bodies
from bodymeasure.viewer.content.landmarks import lacking_landmarks
from bodymeasure.viewer.content.points import mirror_answer
from bodymeasure.viewer.content.requests import FindMirror, FindPoint, SaveLandmarks
from bodymeasure.viewer.content.shown import ShownBody
from helpers.command_line import part_of_a_body

import bodymeasure as bm
from bodymeasure.chart.picks.file import read_picks
from bodymeasure.errors import InputError

NEW = {"navel point": (12, 0.25, 0.75), "back neck point": (3, 0.5, 0.5), "front neck point": None}


def saved(bodies: Bodies, to: str) -> File:
    found = answer(bodies, SaveLandmarks(landmarks=NEW, to=to))
    assert isinstance(found, File)
    return found


def test_picks_are_read_back(bodies: Bodies, tmp_path: Path) -> None:
    file = saved(bodies, "picks")
    assert file.name == "Average.landmarks.csv"
    path = tmp_path / file.name
    path.write_bytes(file)
    names, positions = read_picks(path)
    atlas = bodies["0"].atlas
    assert set(names) == {*atlas.landmarks, "navel point"} - {"front neck point"}
    for name, position in zip(names, positions, strict=True):
        place = NEW.get(name) or atlas.landmarks[name]
        np.testing.assert_array_equal(position, atlas.position(bm.AtlasPoint(*place)))


def test_an_atlas_holds_the_landmarks_and_all_else(bodies: Bodies, tmp_path: Path) -> None:
    path = tmp_path / "saved.atlas"
    path.write_bytes(saved(bodies, "atlas"))
    atlas, before = bm.read_atlas(path), bodies["0"].atlas
    assert atlas.landmarks["navel point"] == NEW["navel point"]
    assert atlas.landmarks["back neck point"] == NEW["back neck point"]
    assert "front neck point" not in atlas.landmarks
    assert atlas.digest == before.digest
    assert atlas.provenance == before.provenance


def test_the_file_itself_is_written_whole(tmp_path: Path) -> None:
    path = tmp_path / "body.atlas"
    bm.write_atlas(part_of_a_body(100, 106), path)
    bodies = Bodies()
    bodies.put(ShownBody("0", bm.read_atlas(path), "Part", str(path), settings={}))
    assert bodies["0"].savable
    # Somebody else adds a landmark after the page has read the file.
    other = bm.read_atlas(path)
    bm.write_atlas(
        bm.Atlas(other.points, other.index, other.unit, landmarks={"mole": bm.AtlasPoint(1, 0, 0)}),
        path,
    )
    request = SaveLandmarks(landmarks={"elbow point left": (0, 0.5, 0.5)}, to="file")
    assert answer(bodies, request) == {"saved": str(path)}
    landmarks = bm.read_atlas(path).landmarks
    assert landmarks == {"mole": (1, 0.0, 0.0), "elbow point left": (0, 0.5, 0.5)}
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize(
    ("name", "place", "words"),
    [
        ("  ", (0, 0.5, 0.5), "expected a name on one line"),
        ("a\nb", (0, 0.5, 0.5), "expected a name on one line"),
        ("mole", (999, 0.5, 0.5), "landmark 'mole' is on patch 999, but the patches"),
    ],
)
def test_a_landmark_that_is_none_changes_no_file(
    tmp_path: Path, name: str, place: tuple[int, float, float], words: str
) -> None:
    path = tmp_path / "body.atlas"
    bm.write_atlas(part_of_a_body(100, 106), path)
    before = path.read_bytes()
    bodies = Bodies()
    bodies.put(ShownBody("0", bm.read_atlas(path), "Part", str(path), settings={}))
    with pytest.raises(InputError, match=words):
        answer(bodies, SaveLandmarks(landmarks={name: place}, to="file"))
    assert path.read_bytes() == before


def test_a_sample_is_not_written_to(bodies: Bodies) -> None:
    with pytest.raises(InputError, match="save it as an atlas instead"):
        answer(bodies, SaveLandmarks(landmarks={}, to="file"))


def test_what_the_chart_lacks_is_said_with_its_place(bodies: Bodies) -> None:
    every = {one["name"]: one["text"] for one in lacking_landmarks(part_of_a_body(100, 106))}
    assert every["elbow point left"] == "the tip of the elbow, on the wearer's left"
    some = {one["name"] for one in lacking_landmarks(bodies["0"].atlas)}
    assert some < set(every)


def test_a_point_is_where_the_surface_is(bodies: Bodies) -> None:
    found = answer(bodies, FindPoint(location=(5, 0.25, 0.5)))
    assert isinstance(found, dict)
    x, y, z = bodies["0"].atlas.position(bm.AtlasPoint(5, 0.25, 0.5))
    np.testing.assert_allclose(found["position"], (x, z, -y), rtol=1e-15)
    assert found["name"] == bodies["0"].atlas.patch_names[5]
    assert np.linalg.norm(found["normal"]) == pytest.approx(1.0)


@pytest.mark.parametrize("name", ["elbow point", "bust point", "patella point"])
def test_the_mirrored_point_is_the_one_on_the_other_side(bodies: Bodies, name: str) -> None:
    found = answer(bodies, FindMirror(location=f"{name} left"))
    assert isinstance(found, dict)
    body = bodies["0"]
    other, _ = body.point(body.atlas.landmarks[f"{name} right"])
    np.testing.assert_allclose(found["position"], other, atol=1e-6)


def test_what_has_no_other_side_is_told() -> None:
    body = ShownBody("0", part_of_a_body(0, 30), "Half a neck and a shoulder")
    with pytest.raises(InputError, match="click the other side itself"):
        mirror_answer(body, FindMirror(location=(29, 0.5, 0.5)))

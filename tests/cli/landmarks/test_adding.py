"""`bodymeasure landmarks add` by positions and by parameters."""

from pathlib import Path

import numpy as np
import pytest
from helpers.command_line import Run

from bodymeasure import load_sample, read_atlas
from bodymeasure.atlas import AtlasPoint

BUST = ("9.1", "-16", "116.4")
AT = ("--at", *BUST)


def words(text: str) -> str:
    return " ".join(text.split())


def test_a_position_is_added(run: Run, tmp_path: Path) -> None:
    new = tmp_path / "new.atlas"
    ran = run(
        "landmarks", "add", "female_average", "bust pont left", "--at", *BUST,
        "--position-unit", "cm", "-o", new,
    )  # fmt: skip
    note = "'bust pont left' is no name that measurements use; did you mean 'bust point left'?\n"
    assert (ran.code, ran.err) == (0, note)
    assert ran.out == (
        "bust pont left: torso front left bust, u = 0.009345, v = 0.634832, 0.056 cm from the "
        f"position\n{new}: 22 landmarks\n"
    )
    atlas = read_atlas(new)
    found = atlas.position(atlas.landmarks["bust pont left"])
    assert np.linalg.norm(found - np.array(BUST, float) / 100.0) == pytest.approx(5.6e-4, rel=0.01)
    before = load_sample("female_average")
    assert np.array_equal(atlas.points, before.points)
    assert {**atlas.landmarks, **before.landmarks} == atlas.landmarks


def test_a_position_in_a_wrong_unit_is_refused_with_the_right_one(run: Run, bare: Path) -> None:
    before = bare.read_bytes()
    place = ("landmarks", "add", bare, "bust point left", "--in-place", "--at")
    ran = run(*place, *BUST, "--position-unit", "mm")
    assert (ran.code, ran.out) == (2, "")
    assert "from the surface, more than 20 mm; in cm it would be 0.056 cm from it: check" in ran.err
    assert bare.read_bytes() == before
    ran = run(*place, "9.1", "-30", "116.4", "--position-unit", "cm")
    assert ran.code == 2
    assert "cm from the surface, more than 2 cm; check its coordinates, its unit" in ran.err
    assert run(*place, "9.1", "-30", "116.4", "--position-unit", "cm", "--far").code == 0
    assert set(read_atlas(bare).landmarks) == {"front waist point", "bust point left"}


def test_landmarks_are_moved_only_when_told(run: Run, bare: Path) -> None:
    atlas = read_atlas(bare)
    patch = atlas.patch_names[5]
    place = ("landmarks", "add", bare, "front waist point", "--patch", patch, "--uv", "0.25", "1")
    ran = run(*place, "--in-place")
    assert ran.code == 2
    assert "a landmark 'front waist point' already; give --replace to move it" in ran.err
    ran = run(*place, "--in-place", "--replace")
    assert (ran.code, ran.err) == (0, "")
    assert ran.out.endswith(f"{bare}: 1 landmark\n")
    assert read_atlas(bare).landmarks == {"front waist point": AtlasPoint(5, 0.25, 1.0)}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("x", "--in-place"), "one way of --at, --patch, --mesh and --from; got none"),
        (("x", *AT, "--patch", "p", "--in-place"), "got --at and --patch"),
        (
            ("x", *AT, "--in-place"),
            "--at needs --position-unit, the unit of the position: m, cm, mm or inch",
        ),
        (("x", *AT, "--position-unit", "cm"), "Give either -o FILE or --in-place"),
        (
            ("x", *AT, "--position-unit", "cm", "--in-place", "-o", "y.atlas"),
            "Give either -o FILE or",
        ),
        (
            (*AT, "--position-unit", "cm", "--in-place"),
            "Missing argument 'NAME': what the landmark is",
        ),
        (("x", "--patch", "p", "--in-place"), "--patch and --uv belong together; give both"),
        (
            ("x", *AT, "--uv", "0", "1", "--position-unit", "cm", "--in-place"),
            "--patch and --uv belong",
        ),
        (
            ("x", "--mesh", "m.obj", "--position-unit", "cm", "--in-place"),
            "--mesh and --vertex belong",
        ),
        (
            ("x", *AT, "--position-unit", "cm", "--from-one", "--in-place"),
            "--from-one says how --vertex",
        ),
        (
            ("x", "--patch", "p", "--uv", "0", "1", "--position-unit", "cm", "--in-place"),
            "--position-unit is for positions; --patch has none",
        ),
        (
            ("x", "--from", "picks.csv", "--position-unit", "cm", "--in-place"),
            "--from takes the names from its file; leave NAME out",
        ),
    ],
)
def test_wrong_usage_is_told(
    run: Run, bare: Path, arguments: tuple[str, ...], message: str
) -> None:
    ran = run("landmarks", "add", bare, *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert message in words(ran.err)
    assert "Try 'bodymeasure landmarks add" in ran.err


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--patch", "sleeve", "--uv", "0", "1"), "the atlas has no patch named 'sleeve'"),
        (("--patch", "hip back left 1-1", "--uv", "0", "1.5"), "expected both in [0, 1]"),
        (("--patch", "hip back left 1-1", "--uv", "nan", "1"), "expected both in [0, 1]"),
    ],
)
def test_bad_places_are_told(
    run: Run, bare: Path, arguments: tuple[str, ...], message: str
) -> None:
    ran = run("landmarks", "add", bare, "x", *arguments, "--in-place")
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err

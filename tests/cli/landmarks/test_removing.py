"""`bodymeasure landmarks remove`, and files that are not to be written."""

from pathlib import Path

from helpers.command_line import Run

from bodymeasure import load_sample, read_atlas

BUST = ("9.1", "-16", "116.4")
AT = ("--at", *BUST)


def test_samples_stay_as_they_are(run: Run, tmp_path: Path) -> None:
    for arguments in (
        ("add", "female_average", "x", *AT, "--position-unit", "cm"),
        ("remove", "female_average", "crotch point"),
    ):
        ran = run("landmarks", *arguments, "--in-place")
        assert (ran.code, ran.out) == (2, "")
        assert "is a sample, which stays as it is; write to a file with -o FILE" in ran.err
    ran = run("landmarks", "remove", "enneper", "x", "-o", tmp_path / "gone" / "a.atlas")
    assert "the atlas has no landmark 'x'; there are none" in ran.err


def test_nothing_is_left_where_nothing_can_be_written(run: Run, tmp_path: Path) -> None:
    target = tmp_path / "gone" / "a.atlas"
    ran = run("landmarks", "remove", "female_average", "crotch point", "-o", target)
    assert (ran.code, ran.out) == (2, "")
    assert "cannot be written" in ran.err
    for name, said in (("a.obj", "a.obj: .obj files hold no landmarks"), ("a", "a: such files")):
        ran = run("landmarks", "remove", "female_average", "crotch point", "-o", tmp_path / name)
        assert (ran.code, ran.out) == (2, "")
        assert said in ran.err
        assert "write to one of .atlas, .npz with -o FILE" in ran.err
    assert list(tmp_path.iterdir()) == []


def test_landmarks_are_removed(run: Run, tmp_path: Path) -> None:
    new = tmp_path / "new.atlas"
    ran = run("landmarks", "remove", "female_old", "crotch point", "elbow point left", "-o", new)
    assert (ran.code, ran.err, ran.out) == (0, "", f"{new}: 19 landmarks\n")
    gone = set(load_sample("female_old").landmarks) - set(read_atlas(new).landmarks)
    assert gone == {"crotch point", "elbow point left"}
    ran = run("landmarks", "remove", new, "crotch pont", "--in-place")
    assert (ran.code, ran.out) == (2, "")
    ran = run("landmarks", "remove", new, "bust pont left", "--in-place")
    assert "no landmark 'bust pont left'; did you mean 'bust point left'?" in ran.err

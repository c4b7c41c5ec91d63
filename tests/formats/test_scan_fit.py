"""What the fit to a scan leaves on an atlas, kept by the atlas and its files."""

from dataclasses import replace

import numpy as np
import pytest
from helpers.files.format_atlases import body_like, read, write

from bodymeasure import Atlas, InputError, LandmarkFound, LandmarkOrigin, ScanFit
from bodymeasure.formats.groups import select_groups
from bodymeasure.formats.npz import write_bodies

FIT = ScanFit(
    np.array([1.0, 0.6, 0.0, 0.25]),
    np.array([0.0004, 0.0013, np.nan, 0.001]),
    {
        "navel": LandmarkFound(LandmarkOrigin.PICKED, 0.001),
        "chin": LandmarkFound(LandmarkOrigin.CARRIED, 0.0045),
    },
    ("The file's unit is mm.",),
    ("A part of one arm is missing.",),
)
ATLAS = replace(body_like(2, 2), scan=FIT, regions=("arm", "arm", "leg", "leg"))


def fit(atlas: Atlas) -> ScanFit:
    assert atlas.scan is not None
    return atlas.scan


@pytest.mark.parametrize("form", ["atlas", "npz"])
def test_a_fit_is_kept_without_loss(form: str) -> None:
    assert fit(read(write(ATLAS, form), form)).is_same(FIT)
    plain = replace(ATLAS, scan=None)
    assert read(write(plain, form), form).scan is None
    assert b'"scan"' not in write(plain, form)


def test_patches_that_are_less_than_half_covered_are_uncovered() -> None:
    assert FIT.uncovered.tolist() == [2, 3]
    assert FIT.rms == pytest.approx(np.sqrt((0.0004**2 + 0.0013**2 + 0.001**2) / 3.0))
    assert np.isnan(ScanFit(np.zeros(1), np.array([np.nan])).rms)


def test_a_part_of_an_atlas_keeps_its_part_of_the_fit() -> None:
    leg = fit(select_groups(ATLAS, ["leg"]))
    assert leg.coverage.tolist() == [0.0, 0.25]
    assert leg.landmarks == FIT.landmarks
    # Distances are in meters, whatever the unit of the atlas.
    assert fit(ATLAS.converted("mm")).is_same(FIT)


def test_bodies_of_one_file_have_one_fit() -> None:
    other = replace(ATLAS, scan=replace(FIT, warnings=()))
    assert not FIT.is_same(other.scan)
    for scan in (other.scan, None):
        with pytest.raises(InputError, match=r"^atlas 1 .* was fitted to another scan"):
            write_bodies([ATLAS, replace(ATLAS, scan=scan)])


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"coverage": np.array([1.0, 2.0])}, "within 0 to 1"),
        ({"coverage": np.array([1.0, np.nan])}, "within 0 to 1"),
        ({"coverage": np.ones(3)}, "3 numbers of coverage and 2 distances"),
        ({"distance": np.array([-1.0, 0.0])}, "negative or infinite"),
        ({"distance": np.zeros((2, 1))}, r"distance has shape \(2, 1\)"),
        ({"landmarks": {"chin": LandmarkFound(LandmarkOrigin.RULE, np.nan)}}, "'chin' is nan"),
    ],
)
def test_wrong_numbers_are_refused(values: dict[str, object], message: str) -> None:
    good: dict[str, object] = {"coverage": np.ones(2), "distance": np.zeros(2)}
    with pytest.raises(InputError, match=message):
        ScanFit(**(good | values))  # type: ignore[arg-type]


def test_a_fit_has_a_number_for_each_patch() -> None:
    with pytest.raises(InputError, match="has 2 numbers for 4 patches"):
        replace(ATLAS, scan=ScanFit(np.ones(2), np.zeros(2)))
    text = write(ATLAS, "atlas").decode()
    with pytest.raises(InputError, match=r"^file: .*coverage and 4 distances"):
        read(text.replace('"coverage": [1.0, ', '"coverage": [').encode(), "atlas")
    with pytest.raises(InputError, match=r"Invalid enum value 'guessed'"):
        read(text.replace('"carried"', '"guessed"').encode(), "atlas")

"""The name of a sample, or nothing, where an atlas is expected."""

from collections.abc import Callable
from typing import Any

import pytest

import bodymeasure as bm

USES: dict[str, Callable[[Any], object]] = {
    "a path": lambda atlas: bm.geodesic_between(atlas, "front neck point", "back neck point"),
    "a tape": lambda atlas: bm.taut_tape(atlas, "bust point left", "bust point right"),
    "a girth": lambda atlas: bm.body_girth(atlas, "front waist point"),
    "diagonals": bm.diagonals,
    "boundary curves": bm.boundary_lengths,
    "a check": bm.check_atlas,
    "a survey": bm.measure_atlas,
    "a chart": bm.measure_chart,
}


@pytest.mark.parametrize("use", USES.values(), ids=USES)
@pytest.mark.parametrize("value", ["female_average", None])
def test_what_is_no_atlas_is_refused(use: Callable[[Any], object], value: object) -> None:
    with pytest.raises(bm.InputError, match=f"atlas is {value!r}; expected an Atlas, as load_sam"):
        use(value)


def test_what_is_no_plane_is_refused() -> None:
    body = bm.load_sample("paraboloid")
    with pytest.raises(bm.InputError, match="plane is 'waist'; expected a Plane"):
        bm.plane_girth(body, "waist", (0.0, 0.0, 0.0))  # type: ignore[arg-type]

import numpy as np
import pytest

from bodymeasure import Axes, InputError


def test_left_is_the_wearers() -> None:
    axes = Axes(up="+z", front="-y")
    assert axes.up_vector.tolist() == [0, 0, 1]
    assert axes.front_vector.tolist() == [0, -1, 0]
    assert axes.left_vector.tolist() == [1, 0, 0]


@pytest.mark.parametrize("up", ["+x", "-x", "+y", "-y", "+z", "-z"])
@pytest.mark.parametrize("front", ["+x", "-x", "+y", "-y", "+z", "-z"])
def test_directions_form_a_right_handed_frame(up: str, front: str) -> None:
    if up[1] == front[1]:
        with pytest.raises(InputError, match="lie along the same axis; they must be perpendicular"):
            Axes(up, front)
        return
    axes = Axes(up, front)
    frame = np.stack([axes.front_vector, axes.left_vector, axes.up_vector])
    assert np.linalg.det(frame) == pytest.approx(1.0)


@pytest.mark.parametrize("direction", ["z", "up", "", "+w", "+Z"])
def test_unknown_directions_are_refused(direction: str) -> None:
    with pytest.raises(InputError, match=r"axes: up is .*; expected one of"):
        Axes(up=direction)
    with pytest.raises(InputError, match=r"axes: front is .*; expected one of"):
        Axes(front=direction)

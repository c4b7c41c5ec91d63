"""Lines over the body are where they belong and have the library's lengths."""

import numpy as np
import pytest
from bodymeasure.viewer.content.layers import layer_message
from bodymeasure.viewer.content.requests import ShowLayer
from bodymeasure.viewer.content.shown import ShownBody
from bodymeasure.viewer.content.wire import unpacked
from helpers.command_line import part_of_a_body

import bodymeasure as bm


@pytest.fixture(scope="module")
def part() -> ShownBody:
    return ShownBody("0", part_of_a_body(100, 106), "Part")


def test_diagonals_have_their_lengths_and_statuses(part: ShownBody) -> None:
    header, arrays = unpacked(layer_message(part, ShowLayer(name="diagonals")))
    solutions = bm.diagonals(part.atlas, on_failure="status")
    assert [item["length"] for item in header["items"]] == solutions.length.ravel().tolist()
    assert [item["patch"] for item in header["items"]] == np.repeat(range(6), 2).tolist()
    assert all(item["words"] == bm.Status.CONVERGED.sentence for item in header["items"])
    assert not any("difference" in item for item in header["items"])
    drawn = np.linalg.norm(np.diff(arrays["points"], axis=1), axis=-1).sum(axis=1)
    np.testing.assert_allclose(drawn, solutions.length.ravel(), rtol=1e-3)
    first, _ = part.surface(np.array([2]), np.array([[[1.0, 0.0], [0.0, 1.0]]]))
    np.testing.assert_allclose(arrays["points"][5][[0, -1]], first[0], atol=1e-7)


def test_diagonals_are_compared_with_the_mesh_if_asked(part: ShownBody) -> None:
    told: list[tuple[int, int]] = []
    request = ShowLayer(name="diagonals", compare=True)
    header, _ = unpacked(layer_message(part, request, lambda *done: told.append(done)))
    differences = [item["difference"] for item in header["items"]]
    assert max(map(abs, differences)) < 1e-3
    assert any(differences)
    assert told[-1] == (12, 12)


def test_boundaries_have_their_lengths(part: ShownBody) -> None:
    header, arrays = unpacked(layer_message(part, ShowLayer(name="boundary")))
    lengths = np.array([item["length"] for item in header["items"]])
    sides = bm.boundary_lengths(part.atlas).length
    assert set(lengths.tolist()) <= set(sides.ravel().tolist())
    drawn = np.linalg.norm(np.diff(arrays["points"], axis=1), axis=-1).sum(axis=1)
    np.testing.assert_allclose(drawn, lengths, rtol=1e-3)


def test_control_nets_are_those_of_the_atlas(part: ShownBody) -> None:
    header, arrays = unpacked(layer_message(part, ShowLayer(name="nets")))
    assert header["items"] == []
    nets = part.positions_on_page(part.atlas.control_points)
    assert arrays["points"].shape == (6 * 8, 4, 3)
    np.testing.assert_allclose(arrays["points"][0], nets[0, 0], atol=1e-7)
    np.testing.assert_allclose(arrays["points"][4], nets[0, :, 0], atol=1e-7)

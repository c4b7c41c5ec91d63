"""Sizes of surfaces."""

import numpy as np
import pytest
from helpers.surfaces.quadrics import joined, sphere_nets, torus_nets

from bodymeasure.atlas import Atlas, FindingKind, Unit, check_atlas, summarize, tessellate
from bodymeasure.atlas.queries.farthest import size_along
from bodymeasure.samples import load_sample


@pytest.mark.parametrize(
    ("atlas", "size"),
    [
        (joined(sphere_nets()), lambda along: 2.0 + 0.0 * along[:, 2]),
        # A circle of radius 2 thickened by 0.7: the farthest point is right above the circle's.
        (joined(torus_nets(2.0, 0.7)), lambda d: 4.0 * np.hypot(d[:, 0], d[:, 1]) + 1.4),
    ],
    ids=["sphere", "torus"],
)
def test_closed_forms(atlas: Atlas, size, rng: np.random.Generator) -> None:  # type: ignore[no-untyped-def]
    along = np.concatenate([np.eye(3), rng.normal(size=(5, 3))])
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    found = size_along(atlas, along)
    np.testing.assert_allclose(found, size(along), rtol=3e-7)
    # The values are those at corners of parts of the surface, which lie on it.
    assert (found <= size(along) * (1.0 + 1e-14)).all()


@pytest.mark.slow
def test_a_body_is_as_high_as_a_fine_mesh_of_it() -> None:
    body = load_sample("female_average")
    summary = summarize(body)
    depth, height = summary.depth, summary.height
    sides = [np.ptp(tessellate(body, segments).vertices, axis=0) for segments in (8, 16, 32)]
    # Meshes fall short by less and less.
    away = np.array([[height - side[2], depth - side[1]] for side in sides])
    assert (away > -1e-6).all()
    assert (away[-1] < 2e-5).all()
    assert (away[-1] < 0.5 * away[0]).all()


def test_collapsed_edges_are_counted_as_the_check_counts_them() -> None:
    # A dome of four sectors, whose edges at the top have several control points in one place.
    angle = 0.5 * np.pi * np.arange(4)
    sector = np.stack(
        np.meshgrid([0.0, 1.0, 2.0, 3.0], np.linspace(0.0, 1.0, 4), indexing="ij"), -1
    )
    nets = np.stack(
        [
            np.stack(
                [
                    sector[..., 0] * np.cos(start + 0.5 * np.pi * sector[..., 1]),
                    sector[..., 0] * np.sin(start + 0.5 * np.pi * sector[..., 1]),
                    -(sector[..., 0] ** 2),
                ],
                axis=-1,
            )
            for start in angle
        ]
    )
    index = np.arange(64).reshape(4, 4, 4)
    for before in range(4):
        index[(before + 1) % 4, :, 0] = index[before, :, 3]
    atlas = Atlas(nets.reshape(-1, 3), index, Unit.CM)
    summary = summarize(atlas)
    kinds = [finding.kind for finding in check_atlas(atlas)]
    assert summary.collapsed_edges == kinds.count(FindingKind.COLLAPSED_EDGE) == 4
    assert (summary.seams, summary.boundary_edges, summary.parts) == (4, 4, 1)

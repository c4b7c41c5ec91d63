import numpy as np

from bodymeasure.scene.drawing.raster import rasterize


def test_a_triangle_covers_the_pixels_whose_centers_it_holds(rng: np.random.Generator) -> None:
    for _ in range(20):
        corners = rng.uniform(-5.0, 25.0, (3, 2))
        buffer = rasterize(corners, np.zeros(3), np.array([[0, 1, 2]]), (20, 16))
        x, y = np.meshgrid(np.arange(20) + 0.5, np.arange(16) + 0.5)
        turns = [
            (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
            for a, b in zip(corners, np.roll(corners, -1, axis=0), strict=True)
        ]
        inside = np.all([t > 0 for t in turns], axis=0) | np.all([t < 0 for t in turns], axis=0)
        np.testing.assert_array_equal(buffer.triangle >= 0, inside)


def test_values_are_interpolated_linearly() -> None:
    corners = np.array([[-40.0, -30.0], [90.0, -20.0], [5.0, 100.0]])
    buffer = rasterize(corners, corners @ [0.3, -0.2], np.array([[0, 1, 2]]), (20, 16))
    x, y = np.meshgrid(np.arange(20) + 0.5, np.arange(16) + 0.5)
    np.testing.assert_allclose(buffer.depth, 0.3 * x - 0.2 * y, atol=1e-11)
    values = corners @ [2.0, 1.0] + 7.0
    picture = buffer.interpolated(values, background=0.0)
    np.testing.assert_allclose(picture, 2.0 * x + y + 7.0, atol=1e-11)


def test_the_nearer_triangle_hides_the_farther_in_any_order() -> None:
    big = np.array([[-40.0, -30.0], [90.0, -20.0], [5.0, 100.0]])
    corners, depth = np.concatenate([big, big]), np.repeat([1.0, 2.0], 3)
    for order in ([0, 1], [1, 0]):
        triangles = np.arange(6).reshape(2, 3)[order]
        buffer = rasterize(corners, depth, triangles, (20, 16))
        assert (triangles[buffer.triangle][..., 0] == 3).all()


def test_a_grid_of_triangles_has_no_cracks(rng: np.random.Generator) -> None:
    ticks = np.linspace(0.0, 30.0, 9)
    grid = np.stack(np.meshgrid(ticks, ticks, indexing="ij"), -1)
    grid[1:-1, 1:-1] += rng.uniform(-1.2, 1.2, (7, 7, 2))
    number = np.arange(81).reshape(9, 9)
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    triangles = np.concatenate(
        [np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)]
    )
    buffer = rasterize(grid.reshape(-1, 2), np.zeros(81), triangles, (30, 30))
    assert (buffer.triangle >= 0).all()


def test_triangles_seen_edge_on_or_outside_cover_nothing() -> None:
    corners = np.array([[1.0, 1.0], [5.0, 5.0], [9.0, 9.0], [-5.0, -5.0], [-1.0, -9.0], [-3, -2]])
    buffer = rasterize(corners, np.zeros(6), np.array([[0, 1, 2], [3, 4, 5]]), (10, 10))
    assert (buffer.triangle < 0).all()
    assert np.isneginf(buffer.depth).all()


def test_what_is_nearer_than_a_plane_is_cut_away() -> None:
    big = np.array([[-40.0, -30.0], [90.0, -20.0], [5.0, 100.0]])
    corners, depth = np.concatenate([big, big]), np.concatenate([big[:, 0], [-50.0, -50.0, -50.0]])
    triangles = np.arange(6).reshape(2, 3)
    buffer = rasterize(corners, depth, triangles, (20, 16), nearest=7.0)
    # The first triangle's depth is its column: it is cut at 7, and the second shows through.
    x = np.broadcast_to(np.arange(20) + 0.5, (16, 20))
    np.testing.assert_array_equal(buffer.triangle, np.where(x <= 7.0, 0, 1))
    assert buffer.depth.max() <= 7.0
    nothing = rasterize(corners, depth, triangles, (20, 16), nearest=-60.0)
    assert (nothing.triangle < 0).all()

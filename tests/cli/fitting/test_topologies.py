"""Bodies of models on the command line: recognized, or mapped by a correspondence."""

from pathlib import Path

import numpy as np
import pytest
from helpers.command_line import Run

from bodymeasure import read_atlas
from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.fit.model import body_model, limit_matrix, shaped

PLACES = np.stack(np.meshgrid(*2 * [np.linspace(0.0, 1.0, 4)], indexing="ij"), axis=-1)


def obj_of(path: Path, vertices: Array, *, reversed_order: bool = False) -> Path:
    """Write the quads of the model with vertices, in centimeters."""
    quads = body_model().quads + 1
    if reversed_order:
        vertices, quads = vertices[::-1], len(vertices) + 1 - quads
    lines = [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in (100.0 * vertices).tolist()]
    lines += [f"f {a} {b} {c} {d}" for a, b, c, d in quads.tolist()]
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


def positions(path: Path) -> Array:
    return evaluate(read_atlas(path).control_points, PLACES[None])


def test_a_body_of_makehuman_is_recognized(run: Run, tmp_path: Path) -> None:
    mesh = obj_of(tmp_path / "anna.obj", body_model().mean)
    atlas = tmp_path / "anna.atlas"
    ran = run("fit", mesh, "--file-unit", "cm", "-o", atlas, "--no-page")
    assert ran.code == 0, ran.err
    assert "hm08" in ran.out
    assert len(read_atlas(atlas)) == 376


@pytest.mark.slow
def test_quads_of_makehuman_are_charted_as_a_body(run: Run, tmp_path: Path) -> None:
    mesh = obj_of(tmp_path / "anna.obj", body_model().mean)
    ran = run("chart", mesh, "--file-unit", "cm", "--only", "bust_span", "--unit", "m")
    assert ran.code == 0, ran.err
    assert "hm08" in ran.err


@pytest.mark.slow
def test_a_stored_correspondence_maps_another_body(run: Run, tmp_path: Path) -> None:
    limits = limit_matrix()
    rest = obj_of(tmp_path / "rest.obj", limits @ body_model().mean)
    rng = np.random.default_rng(4)
    other = obj_of(tmp_path / "other.obj", limits @ shaped(rng.standard_normal(20)))
    stored, atlas, truth = (tmp_path / name for name in ("model.npz", "b.atlas", "truth.atlas"))
    common = ("--file-unit", "cm", "--no-page")
    # Limit positions are those of a surface that goes through the vertices of the file.
    made = run(
        *("fit", rest, *common, "--topology", "hm08 faces", "--save-topology", stored),
        *("-o", tmp_path / "rest.atlas"),
    )
    assert made.code == 0, made.err
    assert stored.name in made.out
    ran = run("fit", other, *common, "--topology", stored, "-o", atlas)
    assert ran.code == 0, ran.err
    assert "'model'" in ran.out
    exact = run("fit", other, *common, "--topology", "hm08 faces", "-o", truth)
    assert exact.code == 0, exact.err
    apart = np.linalg.norm(positions(atlas) - positions(truth), axis=-1)
    # The correspondence says 0.3 mm of itself.
    assert np.sqrt(np.mean(apart**2)) < 5e-4


def test_a_mesh_of_another_topology_is_refused(run: Run, tmp_path: Path) -> None:
    mesh = obj_of(tmp_path / "other.obj", body_model().mean, reversed_order=True)
    atlas = tmp_path / "other.atlas"
    ran = run("fit", mesh, "--file-unit", "cm", "--topology", "hm08", "-o", atlas)
    assert ran.code == 2
    assert "is not of the topology 'hm08'" in ran.err
    assert not atlas.exists()


@pytest.mark.parametrize(
    ("mesh", "file", "words"),
    [
        ("anna.stl", "model.npz", "do not keep the numbers of vertices"),
        ("anna.obj", "model.txt", "ends in .npz"),
    ],
)
def test_a_correspondence_that_cannot_be_stored_is_refused_before_the_fit(
    run: Run, tmp_path: Path, mesh: str, file: str, words: str
) -> None:
    path = tmp_path / mesh
    path.write_text("solid\n", encoding="utf-8")
    ran = run("fit", path, "--file-unit", "cm", "--save-topology", tmp_path / file)
    assert ran.code == 2
    assert words in ran.err
    assert [each.name for each in tmp_path.iterdir()] == [mesh]

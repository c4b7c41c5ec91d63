"""The same mesh laid flat by libigl's LSCM and ARAP, conformally with its border kept, and here."""

import igl
import numpy as np

import bodymeasure as bm
from bodymeasure._typing import Array
from bodymeasure.bezier import evaluate
from bodymeasure.pattern import Flat
from bodymeasure.pattern.flat.conformal import flat_conformally
from bodymeasure.pattern.flat.flatten import flattened

# Rounds of local and global steps, after which nothing changes that is shown.
ROUNDS = 100


def line(name: str, flat: Flat, positions: Array) -> str:
    """The strain, and the edge whose length in the piece differs most from that on the skin."""
    stretch, mesh = flat.stretch, flat.mesh
    strains = stretch.strains(positions)
    rms = np.sqrt(stretch.area @ (strains**2).mean(axis=1) / stretch.area.sum())
    worst, part = 0.0, 0.0
    for chains in mesh.edges:
        length = sum(chain.length for chain in chains)
        drawn = sum(
            np.linalg.norm(np.diff(positions[chain.vertices], axis=0), axis=1).sum()
            for chain in chains
        )
        worst, part = max(worst, abs(drawn - length)), max(part, abs(drawn / length - 1.0))
    flips = int(stretch.flipped(positions).sum())
    return f"{name:34} {100 * rms:6.2f} % {1e3 * worst:9.2e} mm {100 * part:9.2e} % {flips:5}"


def main() -> None:
    body = bm.load_sample("female_average")
    piece = bm.make_pattern(body, "bodice")["bodice front"]
    mesh = piece.flat.mesh
    nets = body.control_points[mesh.places.patch]
    vertices = np.ascontiguousarray(evaluate(nets, mesh.places.parameters))
    faces = np.ascontiguousarray(mesh.triangles)
    border = igl.boundary_loop(faces)
    ends = np.array([border[0], border[len(border) // 2]])
    apart = float(np.linalg.norm(vertices[ends[0]] - vertices[ends[1]]))
    conformal = igl.lscm(vertices, faces, ends, np.array([[0.0, 0.0], [apart, 0.0]]))[0]
    # It is conformal at any size, so that it may have the one with the right area.
    first = Flat(mesh, conformal, 0.0, True, 0)
    ratio = np.linalg.det(first.stretch.deformations(conformal)) @ first.stretch.area
    if ratio < 0.0:
        conformal = conformal * [1.0, -1.0]
    conformal = conformal * np.sqrt(first.stretch.area.sum() / abs(ratio))
    first_flat = flat_conformally(mesh.triangles, mesh.sides, np.asarray(border))
    data = igl.ARAPData()
    data.max_iter = ROUNDS
    data.energy = igl.ARAP_ENERGY_TYPE_ELEMENTS
    igl.arap_precomputation(vertices, faces, 2, ends[:1], data)
    rigid = igl.arap_solve(first_flat[ends[:1]], data, first_flat.copy())
    free = flattened(mesh, straight=(False,))
    print("bodice front, with a dart             strain  worst edge            flips")
    print(line("LSCM (libigl), at its best size", first, conformal))
    print(line("conformal, border kept", first, first_flat))
    print(line(f"ARAP (libigl, {ROUNDS} rounds)", first, rigid))
    print(line("here, no edge straight", free, free.positions))
    print(line("here, fold and legs straight", piece.flat, piece.flat.positions))


if __name__ == "__main__":
    main()

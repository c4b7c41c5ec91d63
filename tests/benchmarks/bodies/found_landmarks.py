"""Landmarks, and lengths of head, hands and feet, of fitted bodies whose truth is known.

Run it by hand: ``python tests/benchmarks/bodies/found_landmarks.py SCANS``. The folder holds scans
``NAME.ply`` in meters with z up, and ``NAME_truth.npz`` with the `vertices` of each true quad mesh.

A carried landmark is compared with its place on the atlas of the true mesh, and one that a rule
finds with what the same rule finds there. Lengths are compared with those of the true mesh.
"""

import os

os.environ["OMP_NUM_THREADS"] = "1"
import argparse
from pathlib import Path

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.chart import found_landmarks
from bodymeasure.extremities import extremity_lengths
from bodymeasure.fit import fit_body
from bodymeasure.fit.model import atlas_of_vertices, body_model

MILLIMETERS = 1e3


def compare(scan: Path, truth: Array) -> tuple[dict[str, list[float]], dict[str, float]]:
    """The errors of landmarks, carried and by rule, and of lengths, in millimeters."""
    fitted = fit_body(scan, file_unit="m", up="+z")
    turn, shift = fitted.transform[:3, :3], fitted.transform[:3, 3]
    vertices = truth @ turn.T + shift
    true, here = atlas_of_vertices(vertices), atlas_of_vertices(fitted.vertices)
    errors = {
        name: [MILLIMETERS * float(np.linalg.norm(here.position(name) - true.position(name)))]
        for name in true.landmarks
    }
    by_rule = found_landmarks(true), found_landmarks(here)
    for name in set(by_rule[0].by_rule) & set(by_rule[1].by_rule):
        there, found = (each.atlas.position(name) for each in by_rule)
        errors[name].append(MILLIMETERS * float(np.linalg.norm(found - there)))
    known = extremity_lengths(vertices, body_model().quads)
    lengths = {
        key: MILLIMETERS * (length.value - known[key].value)
        for key, length in fitted.atlas.given.items()
    }
    return errors, lengths


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scans", type=Path)
    folder = parser.parse_args().scans
    landmarks: dict[str, list[list[float]]] = {}
    lengths: dict[str, list[float]] = {}
    for truth in sorted(folder.glob("*_truth.npz")):
        name = truth.name.removesuffix("_truth.npz")
        with np.load(truth) as data:
            vertices = data["vertices"].astype(float)
        errors, more = compare(folder / f"{name}.ply", vertices)
        for landmark, each in errors.items():
            landmarks.setdefault(landmark, []).append(each)
        for key, error in more.items():
            lengths.setdefault(key, []).append(error)
        best = np.array([each[-1] for each in errors.values()])
        carried = np.array([each[0] for each in errors.values()])
        print(f"{name}: landmarks {_rms(carried):.2f} mm carried, {_rms(best):.2f} mm with rules")
    print("\nRMS and worst, mm: carried, by rule")
    for landmark, several in landmarks.items():
        columns = [[each[k] for each in several if len(each) > k] for k in (0, 1)]
        words = [f"{_rms(np.array(c)):5.1f} {max(c):5.1f}" for c in columns if c]
        print(f"{landmark:24s}", "   ".join(words))
    print("\nRMS and worst error of lengths, mm, and how many scans show them")
    for key, each in lengths.items():
        array = np.array(each)
        print(f"{key:24s} {_rms(array):5.1f} {np.abs(array).max():5.1f} {len(array):3d}")


def _rms(errors: Array) -> float:
    return float(np.sqrt(np.mean(errors**2)))


if __name__ == "__main__":
    main()

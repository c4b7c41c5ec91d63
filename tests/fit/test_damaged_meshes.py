"""Damaged mesh files are read or refused, whatever the damage; a benchmark runs many more."""

import numpy as np
import pytest
from helpers.files.mutations import mutated
from helpers.scans.damaged import MESH, mesh_files, scan_or_refused
from helpers.scans.meshes import volume
from hypothesis import given
from hypothesis import strategies as st

FILES = mesh_files()
MUTATIONS = 40


@pytest.mark.parametrize("name", FILES)
def test_whole_files_are_read(name: str) -> None:
    extension, content = FILES[name]
    scan = scan_or_refused(content, extension)
    assert scan is not None
    assert volume((scan.vertices, scan.triangles)) == pytest.approx(volume(MESH), rel=1e-5)


@pytest.mark.parametrize("name", FILES)
def test_damaged_files_are_read_or_refused(name: str) -> None:
    extension, content = FILES[name]
    refused = 0
    for seed in range(MUTATIONS):
        damaged = mutated(content, np.random.default_rng([7, seed]))
        refused += scan_or_refused(damaged, extension) is None
    # Most damage is noticed; some, such as another digit of a coordinate, cannot be.
    assert refused > MUTATIONS // 3


@pytest.mark.parametrize("extension", [".stl", ".ply", ".obj", ".off", ".glb", ".gltf"])
@given(content=st.binary(max_size=200))
def test_any_bytes_are_refused(extension: str, content: bytes) -> None:
    assert scan_or_refused(content, extension) is None


@pytest.mark.parametrize("extension", [".stl", ".ply", ".obj", ".off"])
@given(content=st.text(alphabet="OFsolidvertexendfacet plyf 0123456789.-\n", max_size=200))
def test_text_of_the_right_signs_breaks_nothing(extension: str, content: str) -> None:
    scan_or_refused(content.encode(), extension)

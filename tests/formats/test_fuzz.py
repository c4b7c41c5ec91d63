"""Damaged files are read or refused, whatever the damage; a benchmark runs many more."""

import numpy as np
import pytest
from helpers.files.mutations import mutated, read_or_refused, valid_files
from hypothesis import given
from hypothesis import strategies as st

FILES = valid_files()
MUTATIONS = 150


@pytest.mark.parametrize("name", FILES)
def test_valid_files_are_read(name: str) -> None:
    form, content = FILES[name]
    assert read_or_refused(content, form) is not None


@pytest.mark.parametrize("name", FILES)
def test_mutations_are_read_or_refused(name: str) -> None:
    form, content = FILES[name]
    refused = 0
    for seed in range(MUTATIONS):
        refused += read_or_refused(mutated(content, np.random.default_rng(seed)), form) is None
    # Most damage is noticed; some, such as another digit of a coordinate, cannot be.
    assert refused > MUTATIONS // 3


@pytest.mark.parametrize("form", ["bpt", "bez", "obj", "geomdl", "npz"])
@given(content=st.binary(max_size=200))
def test_any_bytes_are_refused(form: str, content: bytes) -> None:
    assert read_or_refused(content, form) is None


@pytest.mark.parametrize("form", ["bpt", "bez", "obj"])
@given(content=st.text(alphabet="v 0123456789.-\nfsurfBEZ3#\\/", max_size=200))
def test_text_of_the_right_signs_is_read_or_refused(form: str, content: str) -> None:
    read_or_refused(content.encode(), form)

"""Arguments of wrong types end in the package's own errors, at every function that it exports."""

import inspect
from collections.abc import Callable
from contextlib import suppress
from itertools import permutations
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import bodymeasure as bm

FUNCTIONS = {
    name: function
    for name in bm.__all__
    if inspect.isfunction(function := getattr(bm, name)) and inspect.signature(function).parameters
}
WRONG = [None, 3, "x", b"x", [], {}, [None], 1.5, float("nan"), object(), np.zeros(2)]
ATLAS = bm.load_sample("paraboloid")
RIGHT: dict[str, Any] = {
    "atlas": ATLAS,
    "start": bm.AtlasPoint(0, 0.1, 0.2),
    "end": bm.AtlasPoint(0, 0.8, 0.7),
}


def required(function: Callable[..., object]) -> list[str]:
    return [
        parameter.name
        for parameter in inspect.signature(function).parameters.values()
        if parameter.default is parameter.empty and parameter.kind is not parameter.KEYWORD_ONLY
    ]


def call(function: Callable[..., object], *given: object) -> None:
    """Call a function, which may be content, or raise an error of the package."""
    with suppress(bm.BodymeasureError):
        function(*given)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_wrong_types(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    function, names = FUNCTIONS[name], required(FUNCTIONS[name])
    for number in range(len(names)):
        for value in (*WRONG, ATLAS):
            given = [RIGHT.get(other) for other in names]
            given[number] = value
            if value is not RIGHT.get(names[number]):
                call(function, *given)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_swapped(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    function, names = FUNCTIONS[name], required(FUNCTIONS[name])
    values = {"path": "body.atlas", "folder": "folder", **RIGHT}
    given = [values.get(other, "x") for other in names]
    for swapped in permutations(given):
        if list(map(type, swapped)) != list(map(type, given)):
            call(function, *swapped)


def test_what_a_user_reads() -> None:
    for function, given, words in (
        (bm.read_atlas, (None,), "the path is None; expected the name of a file"),
        (bm.load_definitions, (3,), "the path is 3; expected the name of a file"),
        (bm.derive_landmarks, (None, []), "the atlas is None; expected an Atlas"),
        (bm.write_atlas, ("body.atlas", ATLAS), "the atlas is 'body.atlas'; expected an Atlas"),
        (bm.write_chart, (ATLAS, "x"), "expected a Chart, as measure_chart returns it"),
        (bm.write_report, (ATLAS, "x"), "expected a Survey, as measure_atlas returns it"),
    ):
        with pytest.raises(bm.InputError) as caught:
            function(*given)
        assert words in str(caught.value)

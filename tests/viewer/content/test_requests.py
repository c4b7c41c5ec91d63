"""Requests from outside are what they must be, or are refused with a sentence."""

from typing import Any

import pytest
from bodymeasure.viewer.content import requests
from bodymeasure.viewer.content.requests import MeasurePath, converted, parsed, parsed_message

from bodymeasure import AtlasPoint
from bodymeasure.errors import InputError


def test_numbers_keep_all_their_digits() -> None:
    text = b'{"locations": [[3, 0.12345678901234567, 1], "back neck point"], "body": "0"}'
    found = parsed(text, MeasurePath, body="1")
    assert found.locations == ((3, 0.12345678901234567, 1.0), "back neck point")
    assert found.body == "1"
    assert requests.place_of(found.locations[0]) == AtlasPoint(3, 0.12345678901234567, 1.0)
    assert requests.place_of(found.locations[1]) == "back neck point"


def test_a_message_says_itself_what_it_is() -> None:
    found = parsed_message(b'{"request": "girth", "location": "navel point", "tab": "a"}')
    assert found == requests.MeasureGirth(location="navel point", tab="a")
    with pytest.raises(InputError, match="the request is not understood"):
        parsed_message(b'{"request": "again"}')


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (b"", "truncated"),
        (b"[1]", "expected 'object'"),
        (b"\xff", "the request is not understood"),
        (b'{"locations": []}', "length >= 2"),
        (b'{"locations": [[0, 0.5, 0.5]]}', "length >= 2"),
        (b'{"locations": [[0, 0.5, 1.5], [0, 0, 0]]}', "<= 1.0"),
        (b'{"locations": [[-1, 0.5, 0.5], [0, 0, 0]]}', ">= 0"),
        (b'{"locations": [[0, NaN, 0.5], [0, 0, 0]]}', "the request is not understood"),
        (b'{"locations": [[0.5, 0.5, 0.5], [0, 0, 0]]}', "int"),
        (b'{"locations": [[0, 0.5, 0.5], [0, 0, 0]], "kind": "loose"}', "loose"),
        (b'{"locations": [[0, 0.5, 0.5], [0, 0, 0]], "more": 1}', "unknown field 'more'"),
        (b'{"request": "girth", "locations": [[0, 0.5, 0.5], [0, 0, 0]]}', "girth"),
    ],
)
def test_what_is_no_path_is_told(text: bytes, words: str) -> None:
    with pytest.raises(InputError, match="the request is not understood: ") as told:
        parsed(text, MeasurePath)
    assert words in str(told.value)


def test_more_points_than_a_tape_has_are_refused() -> None:
    places = ",".join(["[0, 0.5, 0.5]"] * 51)
    with pytest.raises(InputError, match="length <= 50"):
        parsed(f'{{"locations": [{places}]}}'.encode(), MeasurePath)


@pytest.mark.parametrize(
    ("members", "words"),
    [({"name": "net"}, "net"), ({}, "name"), ({"name": "nets", "compare": "maybe"}, "compare")],
)
def test_an_address_is_checked_like_json(members: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match="the request is not understood: ") as told:
        converted(members, requests.ShowLayer)
    assert words in str(told.value)


def test_an_address_holds_texts() -> None:
    found = converted({"name": "diagonals", "compare": "true", "body": "2"}, requests.ShowLayer)
    assert found == requests.ShowLayer(name="diagonals", compare=True, body="2")

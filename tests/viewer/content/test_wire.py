"""Binary messages hold what was packed, where a browser can read it."""

import json

import numpy as np
from bodymeasure.viewer.content.wire import packed, unpacked
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays


@given(
    st.text(max_size=20),
    st.lists(arrays(np.float32, array_shapes(max_side=4, min_side=0)), max_size=3),
)
def test_what_is_packed_is_unpacked(text: str, given: list[np.ndarray]) -> None:
    message = packed({"text": text}, {str(number): each for number, each in enumerate(given)})
    header, found = unpacked(message)
    assert header["text"] == text
    for number, each in enumerate(given):
        assert found[str(number)].dtype == np.float32
        np.testing.assert_array_equal(found[str(number)], each)


def test_typed_arrays_begin_at_multiples_of_four_bytes() -> None:
    odd = np.arange(3, dtype=np.uint8)
    for text in ("", "a", "ab", "abc", "ä"):
        message = packed({"text": text}, {"odd": odd, "even": np.arange(2.0)})
        length = int.from_bytes(message[:4], "little")
        header = json.loads(message[4 : 4 + length])
        assert (4 + length) % 4 == 0
        assert all(place["offset"] % 4 == 0 for place in header["arrays"].values())
        even = header["arrays"]["even"]["offset"]
        assert np.frombuffer(message, "<f4", 2, 4 + length + even).tolist() == [0.0, 1.0]
        assert len(message) % 4 == 0


def test_numbers_that_json_does_not_have_become_null() -> None:
    message = packed({"value": np.nan, "other": np.inf}, {})
    assert b'"value":null,"other":null' in message


def test_whole_numbers_and_flags_keep_their_kind() -> None:
    arrays = {"numbers": np.array([0, 2**32 - 1]), "flags": np.array([True, False])}
    header, found = unpacked(packed({}, arrays))
    assert [header["arrays"][name]["dtype"] for name in arrays] == ["uint32", "uint8"]
    assert found["numbers"].tolist() == [0, 2**32 - 1]
    assert found["flags"].tolist() == [1, 0]

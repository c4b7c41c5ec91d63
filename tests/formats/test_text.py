"""Words of text files that become numbers a block at a time."""

import pytest

from bodymeasure.errors import InputError
from bodymeasure.formats import text
from bodymeasure.formats.text import Words


@pytest.fixture(autouse=True)
def small_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(text, "_AT_ONCE", 3)


def gathered(*lines: bytes) -> Words:
    words = Words()
    for number, line in enumerate(lines, 1):
        words.add(10 * number, line.split())
    return words


def test_numbers_of_all_blocks_are_in_order() -> None:
    words = gathered(b"1 2", b"3 4", b"", b"5e0", b"6 7 8 9")
    assert words.numbers("file").tolist() == [1, 2, 3, 4, 5, 6, 7, 8, 9]
    assert [words.line_of(k) for k in (0, 2, 4, 8)] == [10, 20, 40, 50]
    assert list(words.ends) == [2, 4, 4, 5, 9]


@pytest.mark.parametrize("bad", [b"x", b"nan", b"1e999", b"1_0", b"-inf"])
def test_the_first_word_that_is_no_number_is_named(bad: bytes) -> None:
    words = gathered(b"1 2", b"3 4", b"5 " + bad, b"6 7", b"8 word")
    with pytest.raises(InputError, match=f"file, line 30: '{bad.decode()}' is not a finite number"):
        words.numbers("file")


def test_words_that_are_not_chosen_need_not_be_numbers() -> None:
    words = gathered(b"1 2 red", b"3 4 blue", b"5 6 7")
    assert words.numbers("file", slice(6, None)).tolist() == [5, 6, 7]
    with pytest.raises(InputError, match="line 20: 'blue'"):
        words.numbers("file", slice(4, None))

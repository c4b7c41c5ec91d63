"""What a survey keeps of a body: numbers and reasons, without tapes; some kilobytes."""

from collections.abc import Sequence

import msgspec

from bodymeasure.errors import InputError


class Lack(msgspec.Struct, frozen=True, array_like=True):
    """A measurement of a body that has no value.

    Parameters
    ----------
    key : str
    outcome, reason : str
        As the chart has them.
    """

    key: str
    outcome: str
    reason: str


class Row(msgspec.Struct, frozen=True, array_like=True):
    """The chart of one body.

    Parameters
    ----------
    subject : str
    source : str
        The file, with its number if that holds many bodies.
    failure : str
        Why there is no chart; empty if there is one.
    numbers : bytes
        Doubles, little-endian, of all measurements with all their members; NaN for none. Empty if
        there is no chart.
    lacking : tuple of Lack
    """

    subject: str
    source: str
    failure: str
    numbers: bytes = b""
    lacking: tuple[Lack, ...] = ()


_DECODER = msgspec.msgpack.Decoder(list[Row])


def rows_to_bytes(rows: Sequence[Row]) -> bytes:
    """Return rows as the content of a file."""
    return msgspec.msgpack.encode(rows)


def rows_from_bytes(content: bytes, source: str) -> list[Row]:
    """Return the rows in a file's content.

    Raises
    ------
    InputError
        If it is damaged.
    """
    try:
        return _DECODER.decode(content)
    except msgspec.DecodeError as error:
        raise InputError(
            f"{source}: is no part of a survey ({error}); remove it, and it is measured again"
        ) from None

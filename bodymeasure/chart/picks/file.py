"""Files of picked positions: CSV with the columns name, x, y and z."""

import codecs
import csv
import io
from pathlib import Path

import numpy as np

from bodymeasure._typing import Array
from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes

COLUMNS = ("name", "x", "y", "z")


def read_picks(path: Path) -> tuple[tuple[str, ...], Array]:
    """Return the names and positions, shape (k, 3), of a CSV file with the columns name, x, y, z.

    A first row with these words is skipped, as are empty rows.

    Raises
    ------
    InputError
        If the file cannot be read or is empty, or a row is not a name and three numbers; the
        message names the file and the line.
    """
    try:
        # Spreadsheets put a byte order mark in front.
        text = read_bytes(path).removeprefix(codecs.BOM_UTF8).decode()
    except UnicodeDecodeError:
        raise InputError(f"{path}: is not text in UTF-8; save it as CSV in UTF-8") from None
    names: list[str] = []
    positions: list[list[float]] = []
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    try:
        for row in reader:
            cells = [cell.strip() for cell in row]
            is_header = not names and tuple(cell.lower() for cell in cells) == COLUMNS
            if not any(cells) or is_header:
                continue
            names.append(cells[0])
            positions.append(_numbers(cells, f"{path}, line {reader.line_num}"))
    except csv.Error as error:
        raise InputError(f"{path}, line {reader.line_num}: is no CSV ({error})") from None
    if not names:
        raise InputError(
            f"{path}: holds no landmark; expected lines such as: bust point left,9,1,2"
        )
    return tuple(names), np.array(positions)


def _numbers(cells: list[str], place: str) -> list[float]:
    try:
        if len(cells) != len(COLUMNS):
            raise ValueError
        return [float(cell) for cell in cells[1:]]
    except ValueError:
        hint = "separate them by commas, with points in numbers" if ";" in "".join(cells) else ""
        raise InputError(
            f"{place}: is {', '.join(cells)!r}; expected {', '.join(COLUMNS)}: a name and three "
            f"numbers{'; ' + hint if hint else ''}"
        ) from None

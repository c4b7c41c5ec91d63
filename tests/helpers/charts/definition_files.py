"""Texts of files of definitions, and the messages about them."""

import pytest

from bodymeasure.chart import Definitions
from bodymeasure.chart.reading.read import definitions_from
from bodymeasure.errors import InputError

HEAD = 'format = "bodymeasure measurements"\nversion = 1\nname = "Mine"\n'
# An entry that is right, to be spoiled: its lines are 5 to 9 of a file after `HEAD` and a blank.
PATH = """
[[measurement]]
key = "back"
kind = "path"
name = "Back"
through = ["back neck point", "back waist point"]
"""


def read(text: str) -> Definitions:
    return definitions_from(text.encode(), "my.toml")


def fault(text: str) -> str:
    with pytest.raises(InputError) as caught:
        read(text)
    return str(caught.value)


def entry(kind: str, members: str, key: str = "it") -> str:
    return f'\n[[measurement]]\nkey = "{key}"\nkind = "{kind}"\nname = "It"\n{members}\n'

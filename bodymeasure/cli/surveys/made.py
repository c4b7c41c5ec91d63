"""Bodies made to measure for the sizes of a table."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from bodymeasure.errors import BodymeasureError

if TYPE_CHECKING:
    from bodymeasure.atlas import Atlas
    from bodymeasure.surveys import SizeTable


def made_bodies(
    table: "SizeTable", progress: Callable[[int, int], None]
) -> "dict[str, Atlas | str]":
    """Return a body for each size by its name, or the reason why there is none.

    A body has the key measurements of its size, and the means of other main ones over the bodies
    that the size fits. These need not be those of any body; where none is likely to have them
    together, none is made.
    """
    from bodymeasure.make import make_body
    from bodymeasure.surveys.statistics import MAIN

    found: dict[str, Atlas | str] = {}
    for number, size in enumerate(table.sizes, start=1):
        means = {each.key: each.mean for each in size.controls if each.mean is not None}
        values = {**{key: means[key] for key in MAIN if key in means}, **size.center}
        try:
            made = make_body(values, unit=table.survey.unit, name=size.name)
            found[size.name] = made.atlas
        except BodymeasureError as error:
            found[size.name] = " ".join(str(error).split())
        progress(number, len(table.sizes))
    return found

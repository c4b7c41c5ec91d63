"""Batches of bodies: what is sent to the processes that measure, and what they answer."""

import pickle
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import NamedTuple

from bodymeasure.surveys.bodies import Body
from bodymeasure.surveys.records import Charting, Row, measured_row
from bodymeasure.threads import one_blas_thread

# A survey is cut into so many batches, if a batch does not become too large or too small by it: a
# batch is what is lost where a process dies, and what makes one file until the survey is done.
BATCHES = 500
MOST = 64
# How often a batch is tried whose process dies, before its bodies are tried one by one; and how
# often a single body is, before it is given up.
TRIES = 3
DIED = (
    "the process that measured it died each time it was tried: it ran out of memory, or crashed; "
    "measure it by itself with `bodymeasure chart` to see where"
)


class Batch(NamedTuple):
    """Some bodies that follow each other.

    Parameters
    ----------
    number : int
        Of the batch.
    first : int
        The place of the first body among those of the batch; other than 0 where a batch was taken
        apart.
    bodies : tuple of Body
    """

    number: int
    first: int
    bodies: tuple[Body, ...]

    def apart(self) -> list["Batch"]:
        """Return each body by itself."""
        return [
            Batch(self.number, self.first + place, (body,))
            for place, body in enumerate(self.bodies)
        ]

    def given_up(self) -> list[Row]:
        """Return the rows of bodies with which processes die."""
        return [Row(body.name, body.source, DIED) for body in self.bodies]


class Answer(NamedTuple):
    """The rows of a batch."""

    batch: Batch
    rows: list[Row]


class Work(NamedTuple):
    """What is done with every batch.

    Parameters
    ----------
    pickled : bytes
        The `Charting`, which a process unpickles once.
    """

    pickled: bytes

    @classmethod
    def of(cls, charting: Charting) -> "Work":
        """Return the work of a charting."""
        return cls(pickle.dumps(charting))

    @one_blas_thread()
    def rows(self, bodies: Sequence[Body]) -> list[Row]:
        """Return the rows of bodies."""
        charting = _unpickled(self.pickled)
        return [measured_row(body, charting) for body in bodies]


@lru_cache(2)
def _unpickled(content: bytes) -> Charting:
    charting: Charting = pickle.loads(content)
    # Made anew, so that what is computed from it once is kept with it.
    return replace(charting)


def batch_size(count: int) -> int:
    """Return the number of bodies of a batch, of a survey of so many."""
    return min(max(count // BATCHES, 1), MOST)

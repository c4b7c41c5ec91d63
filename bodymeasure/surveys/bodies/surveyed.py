"""What a survey asks of a body and of many of them: small references that are loaded one by one."""

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import count
from typing import NamedTuple, Protocol

from bodymeasure.atlas import Atlas

Layout = Atlas | None
"""The atlas whose patches all bodies of a file share, where there is one."""


class Asked(NamedTuple):
    """What a survey wants of every body.

    Parameters
    ----------
    layout : Atlas, optional
        The patches that all bodies share, where they do.
    extremities : bool
        Whether it measures what head, hands and feet give, which takes as long as several girths.
    """

    layout: Layout = None
    extremities: bool = True


class Body(Protocol):
    """A reference to a body, small enough to be sent to the process that measures it."""

    @property
    def name(self) -> str:
        """The name of the subject."""
        ...

    @property
    def source(self) -> str:
        """The file it comes from, with its number if that holds many; empty if it has none."""
        ...

    def atlas(self, asked: Asked) -> Atlas:
        """Return the body.

        Raises
        ------
        BodymeasureError
            If it cannot be read, or is no body.
        """
        ...


class Bodies(Protocol):
    """Many bodies, in an order that stays."""

    layout: Layout

    def __len__(self) -> int: ...

    def identity(self) -> dict[str, object]:
        """Return what tells these bodies from others; a survey goes on with the same ones only."""
        ...

    def between(self, start: int, stop: int) -> Sequence[Body]:
        """Return some of the bodies; asked for in ascending order, no more are read than these."""
        ...


def unique_names(names: Sequence[str]) -> Iterator[str]:
    """Yield names, with numbers behind those that several have: two files may have one name."""
    counts = Counter(names)
    taken = set(counts)
    numbers: dict[str, Iterator[int]] = {}
    for name in names:
        if counts[name] > 1:
            numbered = (f"{name} {number}" for number in numbers.setdefault(name, count(1)))
            name = next(each for each in numbered if each not in taken)
            taken.add(name)
        yield name

"""The measurements that keys and names mean."""

from collections.abc import Iterable
from dataclasses import dataclass

from bodymeasure.chart import MeasurementDefinition
from bodymeasure.errors import InputError
from bodymeasure.wording import nearest

# Similarity of names from which on one is taken for a misspelling of the other.
NEAR = 0.6


@dataclass(frozen=True)
class Known:
    """A measurement of which there may be values.

    Parameters
    ----------
    key, name : str
    accuracy_class : str or None
        The class in ISO 20685-1.
    angle : bool
        Whether it is in degrees.
    """

    key: str
    name: str
    accuracy_class: str | None
    angle: bool = False


def known_from(definitions: Iterable[MeasurementDefinition]) -> tuple[Known, ...]:
    """Return the measurements of definitions in which left and right have been filled in."""
    return tuple(
        Known(
            key=definition.key,
            name=definition.name,
            accuracy_class=None if (found := definition.accuracy_class) is None else found.value,
            angle=definition.in_degrees,
        )
        for definition in definitions
    )


class Vocabulary:
    """Measurements by their keys and names, in which case does not matter.

    Parameters
    ----------
    known : iterable of Known
        The first one counts if several have the same key.
    """

    def __init__(self, known: Iterable[Known]) -> None:
        self.by_key: dict[str, Known] = {}
        self._by_text: dict[str, list[Known]] = {}
        for each in known:
            self.by_key.setdefault(each.key, each)
        for each in self.by_key.values():
            self._by_text.setdefault(_plain(each.name), []).append(each)
        # Unlike names, keys are unique, and therefore go first.
        self._by_text |= {_plain(key): [each] for key, each in self.by_key.items()}

    def find(self, text: str, place: str) -> Known:
        """Return the measurement of a key or name.

        Raises
        ------
        InputError
            If there is none, or several; the message names the most similar one, or all of them.
        """
        found = self._by_text.get(_plain(text), [])
        if len(found) == 1:
            return found[0]
        if found:
            keys = ", ".join(each.key for each in found)
            raise InputError(
                f"{place}: several measurements are named {text!r}; give the key of one: {keys}"
            )
        near = nearest(_plain(text), self._by_text, similarity=NEAR)
        if near:
            meant = self._by_text[near][0]
            hint = f"did you mean {meant.key!r} ({meant.name})?"
        else:
            hint = "give a key or a name of the chart, or the file of definitions with --set"
        raise InputError(f"{place}: no measurement is named {text!r}; {hint}")


def _plain(text: str) -> str:
    return " ".join(text.casefold().replace("_", " ").split())

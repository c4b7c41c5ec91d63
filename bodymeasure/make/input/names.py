"""The measurements that keys, names and the names of pattern programs stand for."""

from collections.abc import Callable, Iterable

from bodymeasure.chart import Definitions, MeasurementDefinition
from bodymeasure.chart.sides import both_sides
from bodymeasure.errors import InputError
from bodymeasure.wording import nearest

# Similarity of names from which on one is taken for a misspelling of the other.
NEAR = 0.6


class Names:
    """The measurements of a set by the names that may stand for them.

    A name without its side stands for the wearer's right side, on which measurers take what they
    take once, and which the files of pattern programs hold.

    Parameters
    ----------
    definitions : Definitions
    """

    def __init__(self, definitions: Definitions) -> None:
        self._every = tuple(both_sides(definitions.measurement))
        self.by_key = {one.key: one for one in self._every}
        self._by_text: dict[str, str] = {}
        for one in self._every:
            for text in (one.name, one.key):
                self._by_text[_plain(text)] = one.key
                # The right side comes after the left one, and takes its place.
                self._by_text[_plain(_without_side(text))] = one.key
        # People say bust and waist for their girths.
        for one in self._every:
            plain = _plain(_without_side(one.key))
            self._by_text.setdefault(plain.removesuffix(" girth"), self._by_text[plain])
        self.seamly = self._codes(lambda one: one.seamly)
        self.freesewing = self._codes(lambda one: (one.freesewing,) if one.freesewing else ())

    def find(self, text: str, place: str) -> str:
        """Return the key of a measurement by its key or name.

        Raises
        ------
        InputError
            If there is none; the message names the most similar one.
        """
        key = self._by_text.get(_plain(text))
        if key is not None:
            return key
        near = nearest(_plain(text), self._by_text, similarity=NEAR)
        hint = (
            f"did you mean {self._by_text[near]!r}?"
            if near
            else "give a key or a name of the chart, or the file of definitions with --set"
        )
        raise InputError(f"{place}: no measurement is named {text!r}; {hint}")

    def _codes(self, codes: Callable[[MeasurementDefinition], Iterable[str]]) -> dict[str, str]:
        found: dict[str, str] = {}
        for one in self._every:
            for code in codes(one):
                if code not in found or one.key.endswith("_right"):
                    found[code] = one.key
        return found


def _plain(text: str) -> str:
    return " ".join(text.casefold().replace("_", " ").replace(",", " ").split())


def _without_side(text: str) -> str:
    for side in ("left", "right"):
        text = text.removesuffix(f"_{side}").removesuffix(f", {side}")
    return text

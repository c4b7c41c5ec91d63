"""The bodies that are open, and the charts that were measured on them."""

from collections import OrderedDict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from bodymeasure.viewer.content.shown import ShownBody

from bodymeasure.chart import Chart, Definitions
from bodymeasure.errors import InputError

# Charts that are kept: a page asks for one and then for its files.
KEPT = 4


@dataclass(eq=False)
class Bodies:
    """The bodies that are open, by the ids under which requests know them.

    Parameters
    ----------
    shown : dict of str to ShownBody
    own : Definitions, optional
        A set of definitions that the user has given.
    """

    shown: dict[str, ShownBody] = field(default_factory=dict)
    own: Definitions | None = None
    _charts: OrderedDict[tuple[object, ...], Chart] = field(default_factory=OrderedDict)

    def __getitem__(self, name: str) -> ShownBody:
        """Return the body of an id.

        Raises
        ------
        InputError
            If there is none.
        """
        if name not in self.shown:
            raise InputError(f"no body is open as {name!r} any more; open its file again")
        return self.shown[name]

    def put(self, body: ShownBody) -> None:
        """Open a body, in place of the one that has its id."""
        self.shown[body.id] = body

    def keep_only(self, ids: Mapping[str, object]) -> None:
        """Close the bodies whose ids are not among some."""
        for name in [name for name in self.shown if name not in ids]:
            del self.shown[name]

    def chart(self, key: tuple[object, ...], measure: Callable[[], Chart]) -> Chart:
        """Return the chart of a key, which is measured when it is first asked for."""
        if key not in self._charts:
            self._charts[key] = measure()
            while len(self._charts) > KEPT:
                self._charts.popitem(last=False)
        self._charts.move_to_end(key)
        return self._charts[key]

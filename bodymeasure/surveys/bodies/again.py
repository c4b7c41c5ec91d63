"""Bodies of a survey, read again from where its table says that they come from."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError
from bodymeasure.surveys.bodies.files import FileBody
from bodymeasure.surveys.bodies.population import Population, open_population
from bodymeasure.surveys.bodies.surveyed import Asked


class BodiesAgain:
    """Reads bodies of a survey; those of one file are the quicker in ascending order.

    Parameters
    ----------
    folder : Path
        Of the table.
    settings : mapping
        What the user said about files; see `FileBody`.
    """

    def __init__(self, folder: Path, settings: Mapping[str, Any]) -> None:
        self._folder, self._settings = folder, settings
        self._populations: dict[Path, Population] = {}

    def atlas(self, name: str, source: str) -> Atlas:
        """Return a body with all that it has.

        Parameters
        ----------
        name, source : str
            As the table has them.

        Raises
        ------
        BodymeasureError
            If its file is not there any more, or the survey was one of atlases in memory.
        """
        if not source:
            raise InputError(
                f"{name}: was given as an atlas, not as a file, and cannot be read again"
            )
        file, mark, number = source.rpartition("#")
        if mark and number.isdecimal() and not (self._folder / source).exists():
            path = (self._folder / file).resolve()
            if path not in self._populations:
                self._populations[path] = open_population(path, self._folder)
            bodies, place = self._populations[path], int(number) - 1
            if not 0 <= place < len(bodies):
                raise InputError(f"{path}: holds {len(bodies)} bodies, and no body {number}")
            return bodies.between(place, place + 1)[0].atlas(Asked(bodies.layout))
        path = (self._folder / source).resolve()
        return FileBody(name, source, path, self._settings).atlas(Asked())

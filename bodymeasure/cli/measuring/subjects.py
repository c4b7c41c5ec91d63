"""The bodies that a command is given: files, samples, folders, and files of many bodies."""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from bodymeasure.cli.console import progress_bar
from bodymeasure.cli.inputs import path_of_atlas, require_sound
from bodymeasure.errors import InputError
from bodymeasure.formats import EXTENSIONS, read_population

if TYPE_CHECKING:
    from bodymeasure.atlas import Atlas
    from bodymeasure.chart import Definitions
    from bodymeasure.report.body import ChartDocument


class Subject(NamedTuple):
    """A body by the name of its subject."""

    name: str
    atlas: "Atlas"


def subjects_of(
    names: Sequence[str], load: Callable[[str], "Atlas"], *, despite_errors: bool
) -> list[Subject]:
    """Return the bodies of atlases, each under the name of its file or, of many, its own.

    Parameters
    ----------
    names : sequence of str
        Atlases, samples, ``.npz`` files of many bodies, and folders of atlases.
    load : callable
        Reads the atlas of a name.
    despite_errors : bool
        Whether bodies of a file of many are taken in spite of errors.

    Raises
    ------
    InputError
        If a name is none of these, a folder holds no atlas, or a file is given twice.
    """
    files = [file for name in names for file in _files(name)]
    places: set[Path] = set()
    for file in files:
        place = path_of_atlas(file).resolve()
        if place in places:
            raise InputError(f"{file}: is given twice; give every subject once")
        places.add(place)
    found = [one for file in files for one in _of_file(file, load, despite_errors)]
    counts = Counter(one.name for one in found)
    taken = set(counts)
    result = []
    for name, atlas in found:
        if counts[name] > 1:
            # Two files of one name in two folders are two subjects.
            numbered = (f"{name} {number}" for number in count(1))
            name = next(each for each in numbered if each not in taken)
            taken.add(name)
        result.append(Subject(name, atlas))
    return result


def _files(name: str) -> list[str]:
    path = path_of_atlas(name)
    if not path.is_dir():
        return [name]
    files = sorted(file for file in path.iterdir() if file.suffix.lower() in EXTENSIONS)
    # A chart's own files may lie beside the atlases.
    files = [file for file in files if file.suffix.lower() != ".json"]
    if not files:
        raise InputError(f"{name}: is a folder without an atlas; give a file, or such a folder")
    return [str(file) for file in files]


def _of_file(name: str, load: Callable[[str], "Atlas"], despite_errors: bool) -> Iterator[Subject]:
    path = path_of_atlas(name)
    if path.suffix.lower() == ".npz" and path.is_file():
        bodies = read_population(path)
        if len(bodies) > 1:
            for number, body in enumerate(bodies, start=1):
                require_sound(body, f"{name}, body {number}", despite_errors=despite_errors)
                yield Subject(body.name or f"{path.stem} {number}", body)
            return
    yield Subject(path.stem, load(name))


def charts_of(
    subjects: Sequence[Subject],
    definitions: "Definitions",
    *,
    unit: str,
    only: Sequence[str] = (),
    sensitivity: bool = False,
) -> list["ChartDocument"]:
    """Measure several bodies, with a progress bar.

    Raises
    ------
    InputError
        If the set of definitions is empty.
    """
    from bodymeasure.chart import measure_chart
    from bodymeasure.report.body import chart_document

    if not definitions.measurement:
        raise InputError(f"the set {definitions.name!r} defines no measurement; add one to it")
    documents = []
    with progress_bar("measuring", len(subjects)) as progress:
        for number, (name, atlas) in enumerate(subjects, start=1):
            # Errors that were to be refused were refused when the atlas was loaded.
            chart = measure_chart(
                atlas, definitions, only=only, sensitivity=sensitivity, despite_errors=True
            )
            documents.append(chart_document(chart, unit, subject=name))
            progress(number)
    return documents

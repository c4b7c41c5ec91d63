"""The survey of many bodies, as users call it."""

from collections.abc import Callable, Sequence
from os import PathLike
from pathlib import Path
from typing import Any

from bodymeasure.arguments import file_path, require_kind, require_progress, shown
from bodymeasure.atlas import Atlas, Unit
from bodymeasure.chart import Definitions, load_definitions, selected_keys
from bodymeasure.chart.evaluate import names_listed
from bodymeasure.errors import InputError
from bodymeasure.files import output_folder
from bodymeasure.surveys.bodies import (
    Bodies,
    HeldAtlases,
    file_bodies,
    is_population,
    open_population,
)
from bodymeasure.surveys.engine import Cluster, Engine, Here, Pool, require_distributed
from bodymeasure.surveys.engine.cluster import Client
from bodymeasure.surveys.records import Charting, SurveyTable, require_pyarrow
from bodymeasure.surveys.run import run_survey
from bodymeasure.threads import one_blas_thread

Name = str | PathLike[str]


@one_blas_thread()
def survey(
    bodies: Name | Sequence[Name | Atlas],
    definitions: Definitions | None = None,
    *,
    folder: Name = "survey",
    only: Sequence[str] = (),
    unit: Unit | str = Unit.CM,
    processes: int = 1,
    client: Client | None = None,
    file_unit: Unit | str | None = None,
    up: str | None = None,
    front: str | None = None,
    despite_errors: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> SurveyTable:
    """Take the chart of every body, and keep the numbers in one table.

    A survey that was ended, however that came about, goes on where it was when it is called again
    in the same way, and its table is the same as if it had not been ended.

    Parameters
    ----------
    bodies : path-like, or sequence of path-like or Atlas
        A file ``.npz`` of many bodies: coefficients of the space of bodies, vertices of its mesh,
        or what `write_population` writes. Or files, folders of files and samples, each an atlas or
        a scan, to which a body is fitted. Or atlases.
    definitions : Definitions, optional
        The default set if not given; `load_definitions` reads others.
    folder : path-like
        For ``survey.parquet``, and for what is done until it is written. Made if it is not there.
    only : sequence of str
        Keys of measurements and names of presets, as for `measure_chart`; all if none are given.
    unit : Unit or str
        Of the lengths.
    processes : int
        How many worker processes; with 1, bodies are measured in this process.
    client : distributed.Client, optional
        Measures on Dask's workers, in place of processes.
    file_unit : Unit or str, optional
        Unit of the coordinates in files that do not say it.
    up, front : str, optional
        Which way is up and which way the body looks, in files that do not say so.
    despite_errors : bool
        Whether bodies are measured whose check finds errors; else they fail with these.
    progress : callable, optional
        Called with the number of bodies done so far, and the number of all.

    Returns
    -------
    SurveyTable
        A body that cannot be read or measured is a row with the reason, as is a measurement.

    Raises
    ------
    InputError
        If there is no body, `only` names what the set does not have, the folder cannot be written
        to or holds a survey of other bodies or with other settings.
    MissingExtraError
        If pyarrow is not installed, or distributed where a client is given.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> names = ["female_average", "female_heavy", "male_average"]
    >>> with TemporaryDirectory() as folder:
    ...     survey = bm.survey(names, only=["waist_girth", "hip_girth"], folder=folder)
    ...     print(survey["waist_girth"].round(1))
    [71.1 79.7 76.1]
    """
    require_pyarrow()
    require_progress(progress)
    path = file_path(folder, "the folder")
    if not isinstance(processes, int) or processes < 1:
        raise InputError(f"processes is {shown(processes)}; expected a number from 1 on")
    definitions = load_definitions() if definitions is None else definitions
    require_kind(definitions, Definitions, "definitions", "what load_definitions returns")
    selected_keys(definitions, names_listed(only))
    given = {"unit": file_unit, "up": up, "front": front}
    settings: dict[str, Any] = {name: str(each) for name, each in given.items() if each is not None}
    found = bodies_given(bodies, path, settings)
    charting = Charting(
        definitions, tuple(only), Unit.parse(unit), bool(despite_errors), found.layout
    )
    with output_folder(path):
        return run_survey(found, charting, path, engine_of(processes, client), progress=progress)


def engine_of(processes: int, client: Client | None) -> Engine:
    """Return what measures: a cluster, worker processes, or this process."""
    if client is not None:
        require_distributed()
        return Cluster(client)
    return Pool(processes) if processes > 1 else Here()


def bodies_given(
    bodies: Name | Sequence[Name | Atlas], folder: Path, settings: dict[str, Any]
) -> Bodies:
    """Return the bodies that a user gives.

    Parameters
    ----------
    bodies : path-like, or sequence of path-like or Atlas
    folder : Path
        Of the survey, from which tables name files.
    settings : dict
        What the user says about files; see `FileBody`.

    Raises
    ------
    InputError
        If they are none of these.
    """
    given = [bodies] if isinstance(bodies, (str, PathLike)) else bodies
    if not isinstance(given, Sequence):
        raise InputError(f"bodies are {shown(bodies)}; expected files or atlases, as in a list")
    atlases = [each for each in given if isinstance(each, Atlas)]
    if atlases:
        if len(atlases) < len(given):
            raise InputError("bodies are atlases and files; expected either the ones or the others")
        return HeldAtlases(atlases)
    paths = [file_path(each, "a body") for each in given]
    many = [path for path in paths if is_population(path, alone=len(paths) == 1)]
    if many:
        if len(paths) > 1:
            raise InputError(f"{many[0]}: holds many bodies; survey it by itself")
        return open_population(many[0], folder)
    return file_bodies([str(path) for path in paths], folder, settings)

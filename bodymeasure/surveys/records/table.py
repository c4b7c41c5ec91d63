"""The table of a survey: one Parquet file, with a row for each body."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from importlib.util import find_spec
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec
import numpy as np

from bodymeasure._typing import Array
from bodymeasure.arguments import file_path
from bodymeasure.errors import InputError, MissingExtraError
from bodymeasure.surveys.records.columns import MEMBERS, Column, column_name
from bodymeasure.surveys.records.row import Row
from bodymeasure.wording import counted, hint

if TYPE_CHECKING:
    import pyarrow as pa
    import pyarrow.parquet as pq

# The name of the file in the folder of a survey.
TABLE = "survey.parquet"
FORMAT = "bodymeasure survey"
VERSION = 1
KEY = b"bodymeasure survey"
# Rows of a group of the file. Each has a head of some 60 KB for all columns, so that small groups
# would make a large file; and a group is what memory has to hold.
GROUP = 8192


class Head(msgspec.Struct, frozen=True, kw_only=True):
    """What the file says of itself, as JSON in the metadata of its schema.

    Parameters
    ----------
    unit : str
        Of lengths; angles are in degrees.
    definitions : str
        Name of the set of definitions.
    only : list of str
        The keys and presets that were asked for, none if all were.
    bodies : int
    versions : dict of str to str
        Of the packages that can change a number.
    measurements : list of Column
    """

    format: str = FORMAT
    version: int = VERSION
    unit: str
    definitions: str
    only: list[str]
    bodies: int
    versions: dict[str, str]
    measurements: list[Column]


@dataclass(frozen=True)
class Failed:
    """A body of a survey without a chart, and the reason."""

    subject: str
    source: str
    reason: str


def require_pyarrow() -> None:
    """Raise a MissingExtraError if Parquet files cannot be read and written."""
    if find_spec("pyarrow") is None:
        raise MissingExtraError("a survey", "pyarrow", "survey")


def write_table(path: Path, head: Head, parts: Iterable[Sequence[Row]]) -> None:
    """Write rows to a Parquet file, a group of them at a time.

    Columns without any number are left out. The same rows give the same bytes.

    Parameters
    ----------
    path : Path
    head : Head
    parts : iterable of sequence of Row
        It is gone through twice.
    """
    import pyarrow.parquet as pq

    shape = (len(head.measurements), len(MEMBERS))
    there = np.zeros(shape, bool)
    there[:, 0] = True
    for part in parts:
        for row in part:
            if row.numbers:
                there |= ~np.isnan(np.frombuffer(row.numbers, "<f8").reshape(shape))
    schema = _schema(head, there)
    with pq.ParquetWriter(path, schema, compression="zstd", version="2.6") as writer:
        for group in _groups(row for part in parts for row in part):
            writer.write_table(_arrow(group, schema, there))


def _groups(rows: Iterable[Row]) -> Iterator[list[Row]]:
    group: list[Row] = []
    for row in rows:
        group.append(row)
        if len(group) == GROUP:
            yield group
            group = []
    if group:
        yield group


def _schema(head: Head, there: Array) -> "pa.Schema":
    import pyarrow as pa

    lack = pa.struct([("key", pa.string()), ("outcome", pa.string()), ("reason", pa.string())])
    named = [
        pa.field(column_name(column.key, member), pa.float64())
        for column, kept in zip(head.measurements, there, strict=True)
        for member, one in zip(MEMBERS, kept, strict=True)
        if one
    ]
    fixed = [
        pa.field("subject", pa.string(), nullable=False),
        pa.field("source", pa.string(), nullable=False),
        pa.field("failure", pa.string()),
        pa.field("lacking", pa.list_(lack)),
    ]
    return pa.schema([*fixed, *named], metadata={KEY: msgspec.json.encode(head)})


def _arrow(rows: Sequence[Row], schema: "pa.Schema", there: Array) -> "pa.Table":
    import pyarrow as pa

    numbers = np.full((len(rows), *there.shape), np.nan)
    for place, row in enumerate(rows):
        if row.numbers:
            numbers[place] = np.frombuffer(row.numbers, "<f8").reshape(there.shape)
    lacking = [[msgspec.structs.asdict(lack) for lack in row.lacking] for row in rows]
    columns: list[Any] = [
        pa.array([row.subject for row in rows], pa.string()),
        pa.array([row.source for row in rows], pa.string()),
        pa.array([row.failure or None for row in rows], pa.string()),
        pa.array(lacking, schema.field("lacking").type),
    ]
    # Not a number is what no measurement gives; in the file, it is null.
    columns += [pa.array(column, from_pandas=True) for column in numbers[:, there].T.copy()]
    return pa.Table.from_arrays(columns, schema=schema)


@dataclass(frozen=True, eq=False, repr=False)
class SurveyTable:
    """The table of a survey, of which columns are read when they are asked for.

    Parameters
    ----------
    path : Path
        The Parquet file.
    unit : str
        Of lengths; angles are in degrees.
    definitions : str
        Name of the set of definitions.
    measurements : tuple of Column
        In the order of the set.
    bodies : int
    versions : mapping of str to str

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> with TemporaryDirectory() as folder:
    ...     survey = bm.survey(["female_average"], only=["waist_girth"], folder=folder, processes=1)
    ...     print(survey, survey.subjects, survey["waist_girth"].round(2))
    <SurveyTable of 1 body, 1 measurement in cm> ('female_average',) [71.1]
    """

    path: Path
    unit: str
    definitions: str
    measurements: tuple[Column, ...]
    bodies: int
    versions: dict[str, str] = field(default_factory=dict)

    def __repr__(self) -> str:
        bodies = counted(self.bodies, "body", "bodies")
        measurements = counted(len(self.measurements), "measurement")
        return f"<SurveyTable of {bodies}, {measurements} in {self.unit}>"

    def __len__(self) -> int:
        return self.bodies

    @cached_property
    def _file(self) -> "pq.ParquetFile":
        import pyarrow.parquet as pq

        return pq.ParquetFile(self.path)

    @cached_property
    def _names(self) -> frozenset[str]:
        return frozenset(self._file.schema_arrow.names)

    def __getitem__(self, key: str) -> Array:
        """The values of a measurement, NaN where a body has none; shape (bodies,)."""
        return self.member(key, "value")

    def member(self, key: str, member: str) -> Array:
        """Return a number of a measurement for all bodies, such as its ``error_estimate``.

        Raises
        ------
        KeyError
            If the survey has no such measurement; the message suggests one.
        """
        known = [column.key for column in self.measurements]
        if key not in known or member not in MEMBERS:
            words, among = (key, known) if key not in known else (member, list(MEMBERS))
            raise KeyError(f"the survey has no {words!r}; {hint(words, among)}")
        name = column_name(key, member)
        if name not in self._names:
            return np.full(self.bodies, np.nan)
        column = self._file.read([name]).column(0)
        return np.asarray(column.to_numpy(), dtype=np.float64)

    def column(self, key: str) -> Column:
        """Return what a measurement is.

        Raises
        ------
        InputError
            If the survey has no such measurement; the message suggests one.
        """
        for column in self.measurements:
            if column.key == key:
                return column
        known = [column.key for column in self.measurements]
        raise InputError(f"{self.path}: has no measurement {key!r}; {hint(key, known)}")

    @cached_property
    def subjects(self) -> tuple[str, ...]:
        """The names of the bodies."""
        return tuple(self._file.read(["subject"]).column(0).to_pylist())

    @cached_property
    def sources(self) -> tuple[str, ...]:
        """The file of each body, from the table's folder, with its number if that holds many."""
        return tuple(self._file.read(["source"]).column(0).to_pylist())

    @cached_property
    def failures(self) -> tuple[Failed, ...]:
        """The bodies without a chart."""
        table = self._file.read(["subject", "source", "failure"])
        columns = (table.column(number).to_pylist() for number in range(3))
        return tuple(Failed(*row) for row in zip(*columns, strict=True) if row[2] is not None)

    def lacking(self) -> Iterator[tuple[str, str, str, str]]:
        """Yield the measurements without a value: subject, key, outcome and reason."""
        for batch in self._file.iter_batches(columns=["subject", "lacking"]):
            for subject, lacks in zip(*(each.to_pylist() for each in batch.columns), strict=True):
                for lack in lacks or ():
                    yield subject, lack["key"], lack["outcome"], lack["reason"]


def read_survey(path: str | PathLike[str]) -> SurveyTable:
    """Open the table of a survey.

    Parameters
    ----------
    path : path-like
        The Parquet file, or the folder that it is in.

    Raises
    ------
    InputError
        If it is missing, or no table of a survey.
    MissingExtraError
        If pyarrow is not installed.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> with TemporaryDirectory() as folder:
    ...     bm.survey(["female_average"], only=["waist_girth"], folder=folder, processes=1)
    ...     bm.read_survey(folder).subjects
    <SurveyTable of 1 body, 1 measurement in cm>
    ('female_average',)
    """
    require_pyarrow()
    import pyarrow as pa
    import pyarrow.parquet as pq

    path = file_path(path)
    path = path / TABLE if path.is_dir() else path
    if not path.is_file():
        raise InputError(f"{path}: no such file; expected what `bodymeasure survey` writes")
    try:
        schema = pq.read_schema(path)
        metadata = schema.metadata or {}
        if KEY not in metadata:
            raise ValueError("a table of something else")
        head = msgspec.json.decode(metadata[KEY], type=Head)
    except (pa.ArrowException, OSError, ValueError) as error:
        raise InputError(
            f"{path}: is not the table of a survey ({error}); expected the survey.parquet that "
            "`bodymeasure survey` writes"
        ) from None
    if (head.format, head.version) != (FORMAT, VERSION):
        raise InputError(
            f"{path}: has format {head.format!r}, version {head.version}; this bodymeasure reads "
            f"{FORMAT!r}, version {VERSION}"
        )
    return SurveyTable(
        path=path,
        unit=head.unit,
        definitions=head.definitions,
        measurements=tuple(head.measurements),
        bodies=head.bodies,
        versions=head.versions,
    )

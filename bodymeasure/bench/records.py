"""The content of ``bench.json`` and ``bench.csv``.

Null stands where there is no such value; every number is finite.
"""

from typing import Final

from msgspec import Struct

from bodymeasure.report.serial import records_csv

FORMAT: Final = "bodymeasure benchmark"
VERSION: Final = 2


class Machine(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The machine on which it was measured."""

    system: str
    architecture: str
    cores: int


class ThreadsRecord(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The limit on the threads of numerical libraries, and whether it was kept.

    `others` is the part of the processor time that threads other than the main one took.
    """

    limit: int
    pools: list[str]
    others: float


class SetRecord(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A set of problems: how many were drawn, and how many of them were used.

    `noun` says what they are. On a body the truth is bodymeasure's own length where an independent
    method confirms it; `confirmed_to` is the median of their relative differences.
    """

    name: str
    title: str
    noun: str
    drawn: int
    compared: int
    leaving_patch: int
    unresolved_truth: int
    confirmed_to: float | None


class Result(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The result of a method on a set; times are microseconds a problem, errors are relative.

    Quartiles are taken over repeats, and errors over the problems that have a length. Where the
    truth is bodymeasure's own length, its errors are those that it states.
    """

    set: str
    method: str
    setting: str
    family: str
    problems: int
    failures: int
    repeats: int
    time_median: float
    time_lower_quartile: float
    time_upper_quartile: float
    times_ours: float
    error_median: float | None
    error_tenth: float | None
    error_ninetieth: float | None
    error_worst: float | None


class GrowthRecord(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The time and memory of a batch; times are microseconds a diagonal."""

    patches: int
    failures: int
    repeats: int
    time_median: float
    time_lower_quartile: float
    time_upper_quartile: float
    peak_bytes: int


class Figure(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A single number with its name and unit."""

    name: str
    value: float | None
    unit: str


class BenchDocument(Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The results of a run of the benchmark."""

    format: str
    version: int
    created: str
    quick: bool
    machine: Machine
    versions: dict[str, str]
    threads: ThreadsRecord
    processor_seconds: float
    sets: list[SetRecord]
    results: list[Result]
    growth: list[GrowthRecord]
    stages: dict[str, dict[str, float]]
    figures: list[Figure]


def to_csv(document: BenchDocument) -> bytes:
    """Return the results as CSV (RFC 4180, UTF-8) with a header row; null is an empty field."""
    return records_csv(Result, document.results)

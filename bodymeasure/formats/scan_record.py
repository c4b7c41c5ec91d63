"""The record of a fit to a scan, as the formats that keep everything write it."""

import math

import msgspec
import numpy as np

from bodymeasure.atlas import LandmarkFound, LandmarkOrigin, ScanFit


class FoundRecord(msgspec.Struct, forbid_unknown_fields=True):
    """How a landmark was found, and its uncertainty in meters."""

    origin: LandmarkOrigin
    uncertainty: float


class ScanRecord(msgspec.Struct, forbid_unknown_fields=True):
    """A `ScanFit`; lists have a number for each patch, and null where a patch has no scan."""

    coverage: list[float]
    distance: list[float | None]
    landmarks: dict[str, FoundRecord] = {}
    done: list[str] = []
    warnings: list[str] = []


def record_of(scan: ScanFit) -> ScanRecord:
    """Return what is written of a fit."""
    return ScanRecord(
        scan.coverage.tolist(),
        [value if math.isfinite(value) else None for value in scan.distance.tolist()],
        {name: FoundRecord(*found) for name, found in scan.landmarks.items()},
        list(scan.done),
        list(scan.warnings),
    )


def scan_of(record: ScanRecord | None) -> ScanFit | None:
    """Return the fit that a record holds.

    Raises
    ------
    InputError
        If a number of it is wrong.
    """
    if record is None:
        return None
    return ScanFit(
        np.array(record.coverage),
        np.array([math.nan if value is None else value for value in record.distance]),
        {
            name: LandmarkFound(each.origin, each.uncertainty)
            for name, each in record.landmarks.items()
        },
        tuple(record.done),
        tuple(record.warnings),
    )

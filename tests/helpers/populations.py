"""Files of many bodies, and a set of measurements that takes a moment."""

import os
import signal
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

import bodymeasure as bm
from bodymeasure.chart import Definitions
from bodymeasure.chart.kinds import HeightMeasure
from bodymeasure.errors import MissingExtraError
from bodymeasure.fit.model import shaped
from bodymeasure.surveys.bodies import Asked

# Few components and small ones, so that no body has folds.
COMPONENTS = 10


def knees() -> Definitions:
    """Heights of landmarks, which need neither sections nor paths."""
    return Definitions(
        name="Knees",
        measurement=(
            HeightMeasure(key="knee", name="Knee <height>", at="patella point left"),
            HeightMeasure(key="waist", name="Waist height", at="front waist point"),
            HeightMeasure(key="tail", name="Tail height", at="tail"),
        ),
    )


def coefficients(count: int, *, seed: int = 5) -> np.ndarray:
    """Coefficients of plausible bodies."""
    return 0.5 * np.random.default_rng(seed).normal(size=(count, COMPONENTS))


def write_shapes(path: Path, count: int, **more: Any) -> Path:
    """Write a population of coefficients."""
    np.savez(path, coefficients=coefficients(count), **more)
    return path


def vertices(count: int) -> np.ndarray:
    """The vertices of the same bodies."""
    return np.stack([shaped(each) for each in coefficients(count)])


@dataclass(frozen=True)
class Deadly:
    """A body with which the process that measures it dies, or which lacks a package."""

    name: str
    mode: str = ""
    source: str = ""

    def atlas(self, asked: Asked) -> bm.Atlas:  # noqa: ARG002
        if self.mode == "dies":
            os.kill(os.getpid(), signal.SIGKILL)
        if self.mode == "lacks":
            raise MissingExtraError("a scan", "nothing", "fit")
        return bm.load_sample("female_average")

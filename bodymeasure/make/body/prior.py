"""What is known of a body before it is measured."""

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal

import msgspec
import numpy as np

from bodymeasure._typing import Array
from bodymeasure.arguments import shown
from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes
from bodymeasure.make.body.atlases import COUNT

Sex = Literal["female", "male"]
SEXES = ("female", "male")
FILE = Path(__file__).parents[1] / "data" / "mannequins.json"
# The two mannequins differ by 14 cm in stature, and the medians of both sexes among the bodies of
# the space by 9 cm: what is known of the sex moves the mean by that part of their difference.
SHARE = 0.6
# The ages that the young and the old mannequin stand for, and the middle of the ages of the space.
YOUNG, OLD, MIDDLE = 25.0, 90.0, 51.5
YOUNGEST, OLDEST = 18.0, 90.0


@dataclass(frozen=True, eq=False)
class Prior:
    """The distribution of the coefficients before anything is measured: normal, of variance 1.

    Parameters
    ----------
    mean : ndarray, shape (120,)
        0 if nothing is known.
    sex : {"female", "male"} or None
    age : float or None
        In years.
    """

    mean: Array
    sex: Sex | None = None
    age: float | None = None


def prior_of(sex: str | None = None, age: float | None = None) -> Prior:
    """Return the prior of a person.

    The space of bodies has no labels. What sex and age mean is taken from three of the sample
    bodies: the mean moves along the line between the average female and the average male one, and
    between the young and the old one. The spread stays as it is.

    Raises
    ------
    InputError
        If the sex is not one of two, or the age is not that of an adult.
    """
    if sex is not None and sex not in SEXES:
        raise InputError(f"sex is {sex!r}; expected 'female' or 'male', or nothing")
    if age is not None and not (
        isinstance(age, (int, float, np.number)) and YOUNGEST <= age <= OLDEST
    ):
        raise InputError(
            f"age is {shown(age)}; expected {YOUNGEST:g} to {OLDEST:g} years: the space of "
            "bodies holds adults only"
        )
    female, male, old = _mannequins()
    mean = np.zeros(COUNT)
    if sex is not None:
        mean += (SHARE if sex == "male" else -SHARE) * 0.5 * (male - female)
    if age is not None:
        mean += SHARE * (age - MIDDLE) / (OLD - YOUNG) * (old - female)
    return Prior(mean, sex, age)  # type: ignore[arg-type]


@cache
def _mannequins() -> tuple[Array, Array, Array]:
    held = msgspec.json.decode(read_bytes(FILE), type=dict[str, list[float]])
    female, male, old = (np.array(held[name]) for name in ("female", "male", "old"))
    return female, male, old

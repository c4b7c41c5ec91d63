"""All lengths of head, hands and feet of a body, as an atlas holds them."""

import math
from typing import NamedTuple

import numpy as np

from bodymeasure._typing import Array, Bools, Ints
from bodymeasure.atlas import GivenLength
from bodymeasure.errors import InputError
from bodymeasure.extremities.foot import foot_lengths
from bodymeasure.extremities.hand import hand_lengths
from bodymeasure.extremities.head import head_lengths
from bodymeasure.extremities.places import CHIN, FEET, GLABELLA, HANDS, Region, places
from bodymeasure.extremities.surface import Length
from bodymeasure.subdivision import QuadMesh, limit_positions
from bodymeasure.threads import one_blas_thread

UP = np.array([0.0, 0.0, 1.0])
ORIGIN = "Measured on the whole body, of which the atlas covers a part."
# A scan that shows less of a head, hand or foot does not tell how long it is.
LEAST_SHOWN = 0.5
# A scan shows the end of a length if it shows half of so many of the nearest vertices.
BESIDE = 16
FOOT_ENDS = ("heel back", "second toe tip")
# How many times the root mean square distance of a scan a length may be off: one end of a height,
# both ends of a straight length, and half of the girth of a circle that is so much wider.
HEIGHT, STRAIGHT, GIRTH = 1.0, 2.0**0.5, np.pi
# Some lengths end at vertices that a fit carries along the skin, as the chin and the finger's root,
# which is good to this part of the stature, 5 mm.
TO_CARRIED = ("head_height", "palm_length", "hand_length")
CARRIED = 0.003


@one_blas_thread()
def extremity_lengths(
    vertices: Array, quads: Ints, *, distance: Array | None = None
) -> dict[str, GivenLength]:
    """Measure head, hands and feet on the limit surface of a body's quad mesh.

    Parameters
    ----------
    vertices : ndarray, shape (13380, 3)
        The control vertices of the quad mesh on which the sample bodies and all fitted bodies are
        made, with z up and the floor at z = 0, in any unit.
    quads : ndarray of int, shape (13378, 4)
        Its quads.
    distance : ndarray, shape (13380,), optional
        Distances of the vertices' limits from the scan that the body was fitted to, NaN where it
        shows nothing. Without it, the body is taken for the person.

    Returns
    -------
    dict of str to GivenLength
        By the keys of the default set of measurements: stature, and the lengths of head, hands and
        feet. What the scan does not show is left out.

    Raises
    ------
    InputError
        If the mesh is not that of the sample bodies.

    Examples
    --------
    >>> import numpy as np
    >>> from bodymeasure.extremities import extremity_lengths
    >>> from bodymeasure.fit.model import body_model
    >>> body = body_model()
    >>> lengths = extremity_lengths(body.mean, body.quads)
    >>> print(f"{lengths['stature'].value:.3f} m, head {lengths['head_girth'].value:.3f} m")
    1.655 m, head 0.538 m
    """
    region = places().region
    if vertices.shape != (len(region), 3):
        raise InputError(
            f"the mesh has vertices of shape {vertices.shape}; expected {(len(region), 3)}, which "
            "are those of the sample bodies' quad mesh"
        )
    whole = QuadMesh(vertices, quads)
    limit = limit_positions(whole)
    away = np.zeros(len(region)) if distance is None else distance
    head = head_lengths(whole, limit, UP)
    carried = 0.0 if distance is None else CARRIED * head["stature"].value
    fit = _Fit(away, carried)
    given = _given(head, fit, region == Region.SKULL, "")
    for side in HANDS:
        hand, foot = np.isin(region, HANDS[side]), np.isin(region, FEET[side])
        given |= _given(hand_lengths(whole, limit, side), fit, hand, f"_{side}")
        given |= _given(foot_lengths(whole, limit, side), fit, foot, f"_{side}")
    hidden = _without_ends(limit, np.isfinite(away))
    return {key: length for key, length in given.items() if key not in hidden}


def _without_ends(limit: Array, shown: Bools) -> set[str]:
    """Return the lengths of which the scan does not show an end, though most of the part."""

    def sees(vertex: int) -> bool:
        beside = np.argsort(np.linalg.norm(limit - limit[vertex], axis=1))[:BESIDE]
        return bool(shown[beside].mean() >= LEAST_SHOWN)

    skull = np.flatnonzero(places().region == Region.SKULL)
    top = sees(int(skull[np.argmax(limit[skull] @ UP)]))
    seen = {"head_height": top and sees(CHIN), "head_length": sees(GLABELLA)}
    feet = []
    for number, side in enumerate(HANDS):
        feet.append([sees(places().landmarks[name][number]) for name in FOOT_ENDS])
        seen[f"foot_length_{side}"] = all(feet[-1])
        seen[f"hand_length_{side}"] = sees(int(places().finger[number, -1, 0]))
    # The floor of a scan without feet is a guess.
    seen["stature"] = top and any(any(each) for each in feet)
    return {key for key, there in seen.items() if not there}


class _Fit(NamedTuple):
    """How far vertices are off the scan, and how far carried ones are off along the skin."""

    away: Array
    carried: float


def _given(
    lengths: dict[str, Length], fit: _Fit, part: Bools, ending: str
) -> dict[str, GivenLength]:
    """Return lengths of a part of the body; none if the scan shows too little of it."""
    away = fit.away[part]
    shown = np.isfinite(away)
    if shown.mean() < LEAST_SHOWN:
        return {}
    rms = float(np.sqrt(np.mean(away[shown] ** 2)))
    return {
        f"{key}{ending}": GivenLength(
            length.value, length.error, _uncertainty(key, rms, fit.carried), ORIGIN
        )
        for key, length in lengths.items()
    }


def _uncertainty(key: str, rms: float, carried: float) -> float:
    factor = GIRTH if key.endswith("girth") else HEIGHT if key == "stature" else STRAIGHT
    return math.hypot(factor * rms, carried if key in TO_CARRIED else 0.0)

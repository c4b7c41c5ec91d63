"""Patterns from bodies."""

import time
from collections.abc import Callable, Mapping
from pathlib import Path

from bodymeasure.arguments import require_kind, require_progress, shown
from bodymeasure.atlas import Atlas
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.errors import InputError
from bodymeasure.pattern.cloth.cloth import Cloth
from bodymeasure.pattern.cloth.ease import checked_ease, ease_of, landmarks_of
from bodymeasure.pattern.definitions.landmarks import panel_landmarks
from bodymeasure.pattern.definitions.panels import PatternDefinitions
from bodymeasure.pattern.definitions.read import load_pattern
from bodymeasure.pattern.pieces.cutting import piece_of
from bodymeasure.pattern.pieces.edges import EdgeCurves
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.threads import one_blas_thread

# In meters: the sides of the mesh. A finer one changes no seam, and the strain by a thousandth.
STEP = 0.008
# The finest and the coarsest mesh, in meters: a million triangles, and a few a piece.
FINEST, COARSEST = 0.0005, 0.05


@one_blas_thread()
def make_pattern(
    body: Atlas,
    definitions: PatternDefinitions | str | Path = "bodice",
    *,
    ease: Mapping[str, float] | None = None,
    bridge: bool | None = None,
    step: float = STEP,
    progress: Callable[[int, int], None] | None = None,
) -> Pattern:
    """Make the flat pieces of a set of panels on a body.

    Parameters
    ----------
    body : Atlas
    definitions : PatternDefinitions, str or Path
        What `load_pattern` returns, or what it takes.
    ease : mapping of str to float, optional
        By how much girths of the garment are wider than those of the body, in meters, by the
        landmarks at whose levels they are, or ``neck``, ``bust``, ``waist`` and ``hip``: these
        levels take the place of those of the set.
    bridge : bool, optional
        Whether the cloth bridges hollows inside of panels; as the set says if not given.
    step : float
        The length of the sides of the mesh that is laid flat, in meters.
    progress : callable, optional
        Called with the number of pieces done so far, and the number of all.

    Returns
    -------
    Pattern
        Every edge of every piece is as long as on the skin, or as on the cloth above it where
        there is ease, but for rounding.

    Raises
    ------
    InputError
        If a landmark is missing, or a panel cannot be cut out or laid flat; the message names the
        panel, and the edge, the dart or the landmark.

    Notes
    -----
    The panel is cut out of a mesh of the skin, laid flat conformally, meshed evenly anew on the
    smooth surface, and slit along its darts. Then the energy of its strains is made the least by
    Newton's method on the Lagrangian, under the condition that each side of its border keeps its
    exact length. A fold and the straight legs of darts are approached step by step.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> pattern = bm.make_pattern(bm.load_sample("female_average"), "skirt")
    >>> pattern
    <Pattern 'Straight skirt' of 'Average female body, 160.5 cm': 2 pieces, 1 seam>
    >>> abs(pattern.seams[0].difference) < 1e-9
    True
    """
    require_atlas(body)
    require_progress(progress)
    definitions = checked_definitions(definitions)
    _check_settings(bridge, step)
    wider = {**definitions.ease, **_given_ease(ease)}
    bridge = definitions.bridge if bridge is None else bridge
    landmarks = panel_landmarks(body, definitions, landmarks_of(wider))
    cloth = Cloth(body, ease_of(body, wider, landmarks))
    curves = EdgeCurves(cloth, landmarks, bridge=bridge)
    pieces, seconds = [], {}
    for number, panel in enumerate(definitions.panel, start=1):
        begin = time.process_time()
        pieces.append(piece_of(curves, panel, step / body.unit.meters))
        seconds[panel.name] = time.process_time() - begin
        if progress is not None:
            progress(number, len(definitions.panel))
    return Pattern(body, definitions, landmarks, tuple(pieces), wider, bridge, seconds)


def checked_definitions(definitions: PatternDefinitions | str | Path) -> PatternDefinitions:
    """Return a set of panels, read if it is named.

    Raises
    ------
    InputError
        If there is none.
    """
    if not isinstance(definitions, PatternDefinitions):
        definitions = load_pattern(definitions)
    require_kind(definitions, PatternDefinitions, "definitions", "what load_pattern returns")
    return definitions


def _check_settings(bridge: bool | None, step: float) -> None:
    if not isinstance(step, (int, float)) or not FINEST <= step <= COARSEST:
        raise InputError(f"step is {step!r}; expected a length in meters, {FINEST} to {COARSEST}")
    if bridge is not None:
        require_kind(bridge, bool, "bridge", "True or False")


def _given_ease(ease: Mapping[str, float] | None) -> dict[str, float]:
    if ease is not None and not isinstance(ease, Mapping):
        raise InputError(
            f"ease is {shown(ease)}; expected a mapping of levels to lengths in meters, such as "
            '{"bust": 0.04}'
        )
    return checked_ease(ease or {})

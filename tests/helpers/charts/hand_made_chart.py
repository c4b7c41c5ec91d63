"""A small chart with made-up numbers, for tests of how numbers are shown and written."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart import (
    Chart,
    Definitions,
    Iso,
    Measured,
    Outcome,
)
from bodymeasure.chart.kinds import (
    ChordMeasure,
    FormulaMeasure,
    GirthMeasure,
    HeightMeasure,
    LimbGirthMeasure,
    PathMeasure,
)

HOSTILE = '<script>alert("x")</script> & \u00c4rmel, "links"'

BUST = GirthMeasure(
    key="bust_girth",
    name="Bust girth",
    words="Horizontal, over the bust points, the tape taut.",
    group="Girths",
    iso=Iso("bust girth", "5.3.4"),
    seamly=("bust_circ",),
    freesewing="chest",
    at="bust point left",
    tape="both",
)
UPPER_ARMS = tuple(
    LimbGirthMeasure(
        key=f"upper_arm_girth_{side}",
        name=f"Upper arm girth, {side}",
        group="Girths",
        seamly=("arm_upper_circ",),
        freesewing="biceps",
        start=f"shoulder point {side}",
        end=f"elbow point {side}",
    )
    for side in ("left", "right")
)
SHOULDER = PathMeasure(
    key="shoulder_length",
    name=HOSTILE,
    group="<b>Lengths</b>",
    iso=Iso("shoulder <length>"),
    through=("side neck point left", "shoulder point left"),
)
HEIGHT = HeightMeasure(
    key="waist_height", name="Waist height", group="Heights", freesewing="waistToFloor", at="waist"
)
CHORD = ChordMeasure(key="bust_span", name="Bust span", start="bust point left", end="right")
SLOPE = FormulaMeasure(
    key="shoulder_slope",
    name="Shoulder slope",
    seamly=("shoulder_slope",),
    freesewing="shoulderSlope",
    formula="asin(0.4)",
    angle=True,
)

MEASURED = (
    Measured(
        BUST,
        Outcome.MEASURED,
        status="CONVERGED",
        value=0.9132,
        contact=0.92345,
        taut=0.9132,
        error_estimate=1.5e-9,
        landmarks=("bust point left",),
        length_by_region={"torso front": 0.5, "": 0.42345},
    ),
    Measured(UPPER_ARMS[0], Outcome.MEASURED, value=0.301, taut=0.301, error_estimate=0.004),
    Measured(UPPER_ARMS[1], Outcome.MEASURED, value=0.302, taut=0.302, error_estimate=1e-7),
    Measured(
        SHOULDER,
        Outcome.NOT_CONVERGED,
        reason="no route <here>; run `bodymeasure check`",
        status="NO_ROUTE",
        landmarks=("side neck point left", "shoulder point left"),
    ),
    Measured(
        HEIGHT, Outcome.MISSING_LANDMARK, reason="lacks the landmark 'waist'; set it on the atlas"
    ),
    Measured(CHORD, Outcome.MEASURED, reason="the points are <close>", value=0.18),
    Measured(SLOPE, Outcome.MEASURED, value=23.578, error_estimate=0.01),
)


def hand_made_chart(**changes: Any) -> Chart:
    grid = np.stack(np.meshgrid(*[np.linspace(0.0, 0.1, 4)] * 2, [0.0], indexing="ij"), -1)
    atlas = Atlas(
        grid.reshape(-1, 3),
        np.arange(16).reshape(1, 4, 4),
        "m",  # type: ignore[arg-type]
        patch_names=("torso & more",),
        landmarks={"bust point left": AtlasPoint(0, 0.25, 0.5)},
        name="Anna <Muster>",
        provenance={"source": "a <scan>"},
    )
    chart = Chart(
        atlas=atlas,
        definitions=Definitions(
            format="bodymeasure measurements",
            version=1,
            name="Seven <tapes>",
            words="Made up for tests.",
            measurement=tuple(item.definition for item in MEASURED),
        ),
        landmarks={**atlas.landmarks, "navel": AtlasPoint(0, 0.5, 0.125)},
        missing_landmarks={"waist": "no rule `for` it"},
        measured=MEASURED,
        seconds=1.25,
        versions={"bodymeasure": "0.1.0", "numpy": "2.4"},
    )
    return replace(chart, **changes)


def png(width: int, height: int) -> bytes:
    header = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"
    return header + width.to_bytes(4, "big") + height.to_bytes(4, "big")


def tape_pictures() -> Any:
    measured = [item.definition.key for item in MEASURED if np.isfinite(item.value)]
    return SimpleNamespace(
        body={
            (group, side): png(300, 500)
            for group, side in (("Girths", "back"), ("Girths", "front"), ("", "left"))
        },
        closeups={key: png(64, 48) for key in measured},
        numbers={key: number for number, key in enumerate(measured, start=1)},
        note="Drawn without <OpenGL>.",
    )

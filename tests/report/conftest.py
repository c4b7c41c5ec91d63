"""A small survey with made-up numbers, for tests of how they are reported."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from bodymeasure.atlas import Atlas
from bodymeasure.atlas.check.finding import Finding, FindingKind, Severity
from bodymeasure.geodesic import EdgeContact, Status
from bodymeasure.measure.patches.cross_check import Verdict

HOSTILE = '<script>alert("x")</script> & \u00c4rmel, "links"'
NAMES = ("torso front left 1-1", HOSTILE, "=cmd, \u80f8", "arm right 1-1")


def make_survey(
    *, check: bool = True, statuses: tuple[Status, ...] = (), findings: bool = True
) -> Any:
    rng = np.random.default_rng(5)
    grid = np.stack(np.meshgrid(*[np.linspace(0.0, 0.1, 4)] * 2, [0.0], indexing="ij"), -1)
    nets = grid[:, :, 0] + np.arange(4)[:, None, None, None] * [0.2, 0.0, 0.0]
    atlas = Atlas(
        nets.reshape(-1, 3),
        np.arange(64).reshape(4, 4, 4),
        "m",  # type: ignore[arg-type]
        patch_names=NAMES,
        regions=("torso", "torso", "<b>arm</b>", ""),
        name="Anna <Muster>",
        provenance={"source": "a <scan>", "license": "CC0 1.0"},
    )
    status = np.full((4, 2), Status.CONVERGED, dtype=object)
    for number, value in enumerate(
        statuses or (Status.LEAVES_PATCH, Status.NOT_CONVERGED), start=1
    ):
        status.flat[3 * number % 8] = value
    good = status == Status.CONVERGED
    raw = np.hypot(0.1, 0.1) * (1.0 + rng.random((4, 2)) / 3.0)
    length = np.where(good, raw, np.nan)
    exact = raw * (1.0 + 1e-7 * rng.standard_normal((4, 2)))
    exact[0, 1] = raw[0, 1] / (1.0 + 3.0e-4)
    verdict = np.full((4, 2), Verdict.NOT_COMPARED, dtype=object)
    verdict[good] = Verdict.AGREES
    verdict[0, 1] = Verdict.LONGER
    contacts = np.empty((4, 2), dtype=object)
    contacts.fill(())
    contacts[0, 0] = (EdgeContact("u = 0", 0.25, 0.5), EdgeContact("v = 1", 1.0, 0.75))
    start = np.broadcast_to([[0.0, 0.0], [1.0, 0.0]], (4, 2, 2))
    return SimpleNamespace(
        atlas=atlas,
        diagonals=SimpleNamespace(
            start=start,
            end=1.0 - start,
            length=length,
            raw_length=raw,
            error_estimate=np.where(good, 1e-12 * raw, np.inf),
            residual=rng.random((4, 2)) * 1e-10,
            status=status,
            functions=np.full((4, 2), 12),
            proven_shortest=good & (np.arange(8).reshape(4, 2) != 1),
            iterations=np.full((4, 2), 4),
            contacts=contacts,
        ),
        boundary=SimpleNamespace(
            length=0.1 + rng.random((4, 4)) / 30.0, error_estimate=np.full((4, 4), 1e-17)
        ),
        cross_check=SimpleNamespace(
            confirmed=np.arange(4) % 2 == 0,
            exact=exact,
            exact_uncertainty=1e-7 * exact,
            heat=exact * 1.01,
            difference=length - exact,
            relative_difference=(length - exact) / exact,
            verdict=verdict,
        )
        if check
        else None,
        findings=(
            Finding(
                kind=FindingKind.KINKED_SEAM,
                severity=Severity.WARNING,
                patches=(0, 1),
                message=f"{NAMES[0]!r} and {HOSTILE!r} meet at 20 degrees",
            ),
        )
        if findings
        else (),
        settings={"kernel": "Wu C6"},
        versions={"bodymeasure": "0.1.0", "numpy": "2.4"},
        seconds={"diagonals": 0.0712},
    )


@pytest.fixture
def survey() -> Any:
    return make_survey()


@pytest.fixture
def survey_of() -> Callable[..., Any]:
    return make_survey


def png(width: int, height: int) -> bytes:
    header = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"
    return header + width.to_bytes(4, "big") + height.to_bytes(4, "big")


@pytest.fixture
def pictures() -> Any:
    return SimpleNamespace(
        body={side: png(300, 500) for side in ("front", "back", "left", "right")},
        closeups={patch: png(64, 64) for patch in range(4)},
        color_bar=b"<svg xmlns='http://www.w3.org/2000/svg'/>",
        note="Drawn without <OpenGL>.",
    )

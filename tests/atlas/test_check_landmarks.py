from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from helpers.speed import quick

import bodymeasure as bm
from bodymeasure import Atlas, AtlasPoint, Axes, Finding, FindingKind, Severity
from bodymeasure.atlas.axes import DIRECTIONS
from bodymeasure.atlas.check.stance import stance_findings

BODIES = ("female_average", "female_full_bust", "female_heavy", "female_old", "male_average")
OTHER_AXES = [
    Axes(up, front)
    for up in DIRECTIONS
    for front in DIRECTIONS
    if up[1] != front[1] and (up, front) != ("+z", "-y")
]
SIDES = {"left": "right", "right": "left"}


@pytest.fixture(params=quick(BODIES, first=2))
def body(request: pytest.FixtureRequest) -> Atlas:
    return bm.load_sample(request.param)


def turned(atlas: Atlas, degrees: float, axis: int = 2) -> Atlas:
    """An atlas turned about an axis."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turn = np.eye(3)
    turn[[i, i, j, j], [i, j, i, j]] = c, -s, s, c
    return replace(atlas, points=atlas.points @ turn.T)


def with_landmarks(atlas: Atlas, keep: Callable[[str], bool]) -> Atlas:
    return replace(atlas, landmarks={n: at for n, at in atlas.landmarks.items() if keep(n)})


def renamed(atlas: Atlas, names: dict[str, str]) -> Atlas:
    landmarks = {names.get(name, name): point for name, point in atlas.landmarks.items()}
    return replace(atlas, landmarks=landmarks)


def sides_exchanged(atlas: Atlas) -> Atlas:
    def other(name: str) -> str:
        *words, last = name.split(" ")
        return " ".join([*words, SIDES.get(last, last)])

    return renamed(atlas, {name: other(name) for name in atlas.landmarks})


def only(findings: list[Finding]) -> Finding:
    (finding,) = findings
    return finding


def test_a_body_as_its_landmarks_show_it_has_no_such_finding(body: Atlas) -> None:
    assert stance_findings(body) == []
    for unit in ("m", "cm", "mm", "inch"):
        assert stance_findings(body.converted(unit)) == []


@pytest.mark.parametrize("parts", [("neck", "waist"), ("bust", "hip"), ("front", "back"), ("hip",)])
def test_landmarks_of_a_part_are_enough_and_no_fault(body: Atlas, parts: tuple[str, ...]) -> None:
    part = with_landmarks(body, lambda name: any(word in name for word in parts))
    assert stance_findings(part) == []
    for way in (-20, 20):
        assert stance_findings(turned(part, way, axis=0)) == []
    assert stance_findings(turned(part, 37)) != []
    assert stance_findings(turned(part, 180)) != []


@pytest.mark.parametrize(
    "matrix",
    [
        np.diag([1.25, 1.0, 1.0]),
        np.diag([1.0, 1.4, 0.9]),
        np.diag([0.6, 0.6, 0.6]),
        [[1.0, 0.0, 0.15], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[1.0, 0.0, 0.0], [0.0, 1.0, -0.4], [0.0, 0.0, 1.0]],
    ],
)
def test_other_shapes_a_child_and_a_lean_are_no_fault(body: Atlas, matrix: np.ndarray) -> None:
    other = replace(body, points=body.points @ np.transpose(matrix))
    assert stance_findings(other) == []
    for degrees in (-30, 30):
        assert stance_findings(turned(other, degrees / 2, axis=1)) == []


@pytest.mark.parametrize("axes", OTHER_AXES, ids=str)
def test_axes_along_which_a_body_does_not_stand(body: Atlas, axes: Axes) -> None:
    finding = only(stance_findings(replace(body, axes=axes)))
    assert (finding.severity, finding.kind) == (Severity.ERROR, FindingKind.DIRECTIONS)
    assert "give up +z and front -y (--up and --front" in finding.message


@pytest.mark.parametrize("degrees", [12, 20, 37, 130, -20, -37])
def test_a_turn_about_the_vertical(body: Atlas, degrees: int) -> None:
    finding = only(stance_findings(turned(body, degrees)))
    assert (finding.severity, finding.kind) == (Severity.ERROR, FindingKind.TURNED)
    # Counterclockwise as seen from above is to the wearer's left.
    way, back = ("left", "right") if degrees > 0 else ("right", "left")
    assert f"turned by {abs(degrees)} degrees to its {way} about" in finding.message
    assert finding.message.endswith(f"the body to its {back}")


@pytest.mark.parametrize(("degrees", "front"), [(90, "+x"), (180, "+y"), (-90, "-x")])
def test_a_quarter_turn_is_another_front(body: Atlas, degrees: int, front: str) -> None:
    finding = only(stance_findings(turned(body, degrees)))
    assert finding.kind is FindingKind.DIRECTIONS
    assert f"give up +z and front {front} " in finding.message
    corrected = replace(turned(body, degrees), axes=Axes("+z", front))
    assert stance_findings(corrected) == []


def test_mirrored_sides(body: Atlas) -> None:
    mirrored = (replace(body, points=body.points * sign) for sign in ([-1, 1, 1], [1, -1, 1]))
    for wrong in (sides_exchanged(body), *mirrored):
        finding = only(stance_findings(wrong))
        assert (finding.severity, finding.kind) == (Severity.ERROR, FindingKind.SIDES)
        assert "mirror image" in finding.message


def test_names_that_are_exchanged_once(body: Atlas) -> None:
    for first, second in (
        ("bust point left", "bust point right"),
        ("front neck point", "back neck point"),
    ):
        finding = only(stance_findings(renamed(body, {first: second, second: first})))
        assert finding.kind is FindingKind.SIDES
        assert repr(first) in finding.message
    levels = {
        f"{a} {b} point": f"{a} {'hip' if b == 'waist' else 'waist'} point"
        for a in ("front", "back")
        for b in ("hip", "waist")
    }
    levels |= {
        f"side {b} point {s}": f"side {'hip' if b == 'waist' else 'waist'} point {s}"
        for s in SIDES
        for b in ("hip", "waist")
    }
    kinds = {finding.kind for finding in stance_findings(renamed(body, levels))}
    assert kinds == {FindingKind.ORDER}


@pytest.mark.parametrize(
    ("scale", "unit", "severity", "likely"),
    [
        (100.0, "m", Severity.ERROR, "cm"),
        (1000.0, "m", Severity.ERROR, "mm"),
        (10.0, "cm", Severity.ERROR, "mm"),
        (0.01, "cm", Severity.ERROR, "m"),
        (1.0 / 2.54, "cm", Severity.WARNING, "inch"),
        (2.54, "inch", Severity.ERROR, "cm"),
    ],
)
def test_a_size_that_no_body_has(
    body: Atlas, scale: float, unit: str, severity: Severity, likely: str
) -> None:
    scaled = body.converted(unit)
    finding = only(stance_findings(replace(scaled, points=scale * scaled.points)))
    assert (finding.severity, finding.kind) == (severity, FindingKind.SIZE)
    assert f"are the coordinates in {likely}?" in finding.message


def test_what_is_no_body_has_no_such_finding(body: Atlas) -> None:
    assert stance_findings(replace(body, landmarks={}, axes=Axes("+x", "+y"))) == []
    two = with_landmarks(body, lambda name: name in ("crotch point", "front neck point"))
    assert stance_findings(replace(two, axes=Axes("+x", "+y"))) == []
    one_place = {name: AtlasPoint(0, 0.5, 0.5) for name in body.landmarks}
    assert stance_findings(replace(body, landmarks=one_place)) == []


def test_the_check_lists_them_first_and_a_chart_is_refused() -> None:
    wrong = replace(bm.load_sample("female_average"), axes=Axes("+z", "+y"))
    assert bm.check_atlas(wrong)[0].kind is FindingKind.DIRECTIONS
    with pytest.raises(
        bm.InputError, match=r"wrong directions: .*front -y(.|\n)*despite_errors=True"
    ):
        bm.measure_chart(wrong)

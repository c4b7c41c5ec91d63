"""What libraries measure on meshes of a body, on tubes with lengths in closed form."""

import math
from dataclasses import replace

import numpy as np
import pytest
from helpers.surfaces.tubes import joined, ring_length, tube

import bodymeasure.bench.bodies.sets as body_sets
from bodymeasure import Atlas, AtlasPoint, Plane, load_sample
from bodymeasure.bench.bodies.kinds import KINDS, Kind
from bodymeasure.bench.bodies.meshed_body import meshed_body
from bodymeasure.bench.bodies.problems import BodyProblems, Item, Ring
from bodymeasure.bench.bodies.sets import OURS, body_entrants, make_body_set
from bodymeasure.bench.figure import BODY_LOOKS
from bodymeasure.bench.size import QUICK
from bodymeasure.bench.summary import results
from bodymeasure.bench.timing.timing import take_turns
from bodymeasure.errors import InputError

BY_NAME = {kind.name: kind for kind in KINDS}
SEGMENTS = (4, 8, 16)
STRAIGHT = tube([1.0] * 4)
# Thinnest in the middle, where its radius is 1.05.
WAISTED = replace(
    tube([1.2, 1.0, 1.0, 1.2]), landmarks={"side": AtlasPoint(0, 0.0, 0.5)}, name="waisted"
)
# Half of one quarter, and half of the next, and half of the height of 3.
ACROSS = AtlasPoint(0, 0.5, 0.25), AtlasPoint(1, 0.5, 0.75)
LEVEL = Ring(
    Plane(np.array([0.0, 0.0, 1.3]), np.array([0.0, 0.0, 1.0])), np.array([1.0, 0.0, 1.3]), False
)
KNOWN: dict[str, tuple[Atlas, Item, float]] = {
    "paths": (STRAIGHT, ACROSS, math.hypot(ring_length() / 4.0, 1.5)),
    "girths": (STRAIGHT, LEVEL, ring_length()),
    "taut girths": (STRAIGHT, LEVEL, ring_length()),
    "loops": (WAISTED, "side", 1.05 * ring_length()),
}
PEERS = [(kind.name, name) for kind in KINDS for name in kind.peers]


@pytest.mark.parametrize("name", KNOWN)
def test_bodymeasure_has_the_closed_form(name: str) -> None:
    atlas, item, length = KNOWN[name]
    found, error = BY_NAME[name].ours(atlas, item)
    assert abs(found - length) <= error + 1e-12 * length


@pytest.mark.parametrize(("name", "peer"), PEERS)
def test_peers_converge_to_the_closed_form(name: str, peer: str) -> None:
    if peer.startswith("pygeodesic"):
        pytest.importorskip("pygeodesic")
    atlas, item, length = KNOWN[name]
    make = BY_NAME[name].peers[peer].make
    errors = [make(meshed_body(atlas, n), item)() / length - 1.0 for n in SEGMENTS]
    rates = np.log2(np.divide(errors[:-1], errors[1:]))
    assert abs(errors[-1]) < 1e-3
    assert ((rates > 1.5) & (rates < 2.5)).all(), (errors, rates)


@pytest.mark.parametrize("name", ["girths", "taut girths"])
def test_the_loop_beside_the_place_is_measured(name: str) -> None:
    both = joined([STRAIGHT, tube([0.5] * 4, (4.0, 0.0))], ["trunk", "arm"])
    mesh = meshed_body(both, 8)
    beside = Ring(LEVEL.plane, np.array([3.5, 0.0, 1.3]), False)
    for peer in BY_NAME[name].peers.values():
        large, small = (peer.make(mesh, ring)() for ring in (LEVEL, beside))
        assert small == pytest.approx(0.5 * large, rel=1e-9)


def test_problems_are_drawn_as_described() -> None:
    atlas = load_sample("female_average")
    for kind in KINDS:
        items = kind.draw(atlas, 6)
        assert 1 <= len(items) <= 6
        some = BodyProblems(atlas, items).take(np.array([len(items) - 1]))
        assert some.items == items[-1:]
    ends = [end for pair in BY_NAME["paths"].draw(atlas, 6) for end in pair]  # type: ignore[union-attr]
    assert {4.0 * x % 1.0 for end in ends for x in (end.u, end.v)} == {0.0}  # type: ignore[union-attr]


@pytest.fixture
def _tubes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(body_sets, "load_sample", lambda _: STRAIGHT)


def girths(ours: object = BY_NAME["girths"].ours) -> Kind:
    """Girths of a tube, two of them."""
    return BY_NAME["girths"]._replace(draw=lambda _atlas, _count: (LEVEL, LEVEL), ours=ours)  # type: ignore[arg-type]


@pytest.mark.usefixtures("_tubes")
def test_errors_of_peers_are_differences_and_ours_are_stated() -> None:
    kind = girths()
    made = make_body_set(kind, 2)
    assert (len(made), made.unresolved) == (2, 0)
    assert made.confirmed_to is not None
    assert made.confirmed_to < 1e-4
    assert made.stated is not None
    size = replace(QUICK, rounds=1)
    found = results(made, take_turns(body_entrants(kind), made, size, lambda: None))
    for result in found:
        assert (result.problems, result.failures) == (2, 0)
        error = result.error_median
        assert error is not None
        if result.method == OURS:
            assert error == pytest.approx(made.stated.max(), rel=1e-3)
        elif result.family == "mesh":
            assert 1e-5 < error < 1e-1


@pytest.mark.usefixtures("_tubes")
def test_lengths_that_no_peer_confirms_are_left_out() -> None:
    made = make_body_set(girths(lambda _atlas, _ring: (1.01 * ring_length(), 1e-9)), 2)
    assert (len(made), made.drawn, made.unresolved, made.confirmed_to) == (0, 2, 2, None)


@pytest.mark.usefixtures("_tubes")
def test_measurements_that_are_refused_have_no_length() -> None:
    def refuse(_atlas: Atlas, _ring: Ring) -> tuple[float, float]:
        raise InputError("the plane misses the body")

    assert make_body_set(girths(refuse), 2).unresolved == 2


def test_each_method_can_be_drawn() -> None:
    methods = {entrant.method for kind in KINDS for entrant in body_entrants(kind)}
    assert methods == set(BODY_LOOKS)

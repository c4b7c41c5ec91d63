"""What the package exports: documented with examples that run, typed, and whole."""

import inspect
import typing
from collections.abc import Iterator

import pytest
from anywidget import AnyWidget
from trimesh import Trimesh
from trimesh.path import Path3D

import bodymeasure as bm
from bodymeasure.chart.body import Body
from bodymeasure.chart.entry import Fault
from bodymeasure.measure.patches.cross_check import CrossCheck

PUBLIC = {name: getattr(bm, name) for name in bm.__all__}
FUNCTIONS = {name: each for name, each in PUBLIC.items() if inspect.isfunction(each)}
CLASSES = {name: each for name, each in PUBLIC.items() if inspect.isclass(each)}
# Names in quoted annotations, whose modules import them for the type checker alone.
QUOTED = {
    "CrossCheck": CrossCheck,
    "AnyWidget": AnyWidget,
    "Chart": bm.Chart,
    "Path3D": Path3D,
    "Survey": bm.Survey,
    "Trimesh": Trimesh,
}
# Packages in which a reader finds what the members of results hold; methods are asked for patches
# and return batches by what is in bodymeasure.geodesic.
INNER = ("fit", "atlas", "chart", "geodesic", "measure", "section", "pattern", "surveys", "make")


def hints(member: object) -> dict[str, object]:
    """Return the types in a signature, or of the fields of a class."""
    return {
        name: kind
        for name, kind in typing.get_type_hints(member, localns=QUOTED).items()
        if not name.startswith("_")
    }


def members() -> Iterator[tuple[str, object]]:
    """Yield all public functions and classes, and their methods and properties."""
    yield from FUNCTIONS.items()
    for name, each in CLASSES.items():
        yield name, each
        for inner, held in vars(each).items():
            bare = held.__func__ if isinstance(held, (classmethod, staticmethod)) else held
            bare = bare.fget if isinstance(bare, property) else bare
            if inspect.isfunction(bare) and (not inner.startswith("_") or inner == "__getitem__"):
                yield f"{name}.{inner}", bare


def parts(kind: object) -> Iterator[object]:
    """Yield a type and what it is made of; arrays have shapes of any kind, and are left whole."""
    yield kind
    origin = typing.get_origin(kind) or kind
    if getattr(origin, "__module__", "").startswith("numpy"):
        return
    for part in typing.get_args(kind):
        for each in part if isinstance(part, list) else [part]:
            yield from parts(each)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_public_function_has_an_example(name: str) -> None:
    text = inspect.getdoc(FUNCTIONS[name]) or ""
    assert "Examples\n--------\n>>> " in text


@pytest.mark.parametrize("name", CLASSES)
def test_every_public_class_says_what_it_is(name: str) -> None:
    text = inspect.getdoc(CLASSES[name]) or ""
    assert text.partition("\n")[0].endswith((".", ":"))


def test_nothing_public_is_of_any_type() -> None:
    found = [
        f"{name}: {parameter}"
        for name, member in members()
        for parameter, kind in hints(member).items()
        if any(part is typing.Any for part in parts(kind))
    ]
    assert not found


def own(kind: object) -> Iterator[type]:
    """Yield the classes of this package that a type is made of."""
    for part in parts(kind):
        if inspect.isclass(part) and part.__module__.startswith("bodymeasure"):
            yield part


def test_what_functions_take_and_return_is_at_the_top() -> None:
    known = set(CLASSES.values())
    missing = {
        f"{name}: {kind.__name__}"
        for name, member in FUNCTIONS.items()
        for hint in hints(member).values()
        for kind in own(hint)
        # A protocol says what is read of an object; nobody needs it to pass one.
        if kind not in known and not getattr(kind, "_is_protocol", False)
    }
    assert not missing


def test_what_members_of_results_hold_can_be_imported_from_a_package() -> None:
    # What kinds of measurements deal in, and what is not loaded before libigl is asked for.
    known = {*CLASSES.values(), Body, CrossCheck, Fault}
    for inner in INNER:
        package = getattr(bm, inner)
        known |= {getattr(package, name) for name in package.__all__ if name[0].isupper()}
    missing = {
        f"{name}: {kind.__module__}.{kind.__name__}"
        for name, member in members()
        if "." in name or name in CLASSES
        for hint in hints(member).values()
        for kind in own(hint)
        if kind not in known
    }
    assert not missing


def test_each_result_is_shown_in_a_line_with_its_length_unit_error_and_status() -> None:
    body, patch = bm.load_sample("female_average"), bm.load_sample("paraboloid")
    solution = bm.diagonals(patch)
    assert repr(solution[0, 0]).startswith("<GeodesicSolution of length 2.56201, error ")
    assert repr(solution[0, 0]).endswith(", CONVERGED>")
    assert repr(solution) == (
        "<GeodesicSolution of shape (1, 2): lengths from 1.53733 to 2.56201, 2 CONVERGED>"
    )
    waist = bm.body_girth(body, "front waist point")
    assert repr(waist).startswith("<Girth of contact 0.711075 m, taut 0.710998 m, error ")
    drop = bm.vertical_drop(body, "back neck point", "back waist point")
    assert repr(drop).startswith("<Drop of contact 0.416253 m, taut 0.410664 m, error ")
    square = ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
    path = bm.measure_mesh(square, 0, 2, unit="cm")
    assert repr(path).startswith("<MeshPath of length 1.41421 cm, error ")
    assert repr(bm.boundary_lengths(patch)).startswith("<BoundaryLengths from 1.47894 to 1.47894, ")
    survey = bm.measure_atlas(patch, compare=False)
    assert repr(survey) == (
        "<Survey of <Atlas 'Paraboloid of revolution' of 1 patch in cm, 0 landmarks>: "
        "2 of 2 diagonals measured, 0 findings>"
    )

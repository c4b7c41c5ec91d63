"""The layers of the package and the groups within them, read off the syntax trees."""

import ast
from collections import Counter
from collections.abc import Iterator

import numpy as np
import pytest
import scipy
from helpers.modules import FOLDERS, ROOT, Module, all_modules, loaded_by

# Each layer imports from those above it in this list, not from others of its own line.
LAYERS = (
    ("_typing", "errors", "lazy", "threads", "wording"),
    ("arguments", "files", "npz_arrays", "trust"),
    ("native",),
    ("bezier",),
    ("subdivision",),
    ("atlas",),
    ("extremities", "formats"),
    ("samples", "sample_patches"),
    ("geodesic", "oracle", "section"),
    ("mesh", "taut"),
    ("measure",),
    ("chart",),
    ("fit", "pattern"),
    ("scene",),
    ("report",),
    ("viewer",),
    ("surveys",),
    ("bench", "compare"),
    ("paper",),
    ("make",),
    ("cli", "plugin"),
    ("__main__", "_build"),
)
# The same within a package: a name is a folder or a module. What is not named stands on top, and
# groups do not import from there.
ORDERS = {
    "atlas": "approximation, axes, normals, point, scan_fit, seams, size, units ·"
    " contents, faces, tessellation · atlas · prepared · topology · queries · check · summary",
    "bench": "problems · entrants · bodies, size · records · timing · summary · figure",
    "chart": "accuracy, formula, landmarks/choice, landmarks/names, picks, tapes · entry,"
    " landmarks/paths, landmarks/places · body, input/slopes, sides · kinds, landmarks/rules ·"
    " approximated, landmarks · input · taken · definitions, sensitivity · needed, reading,"
    " selection, chart · evaluate",
    "cli": "commands, needs, tables · console · options · inputs · fitting · atlases, docs,"
    " landmarks, measuring, study, surveys · making, patterns, viewing · main",
    "compare": "intraclass, limits, names, records · plots, readings · gaps, iso20685, plausible,"
    " shown, surveyed · read · comparison, page",
    "fit": "model, scan · completed, solving · topology · export",
    "formats": "groups, json_faults, options, patches, scan_record, spline_patches, text ·"
    " atlas_json, bez, bpt, foreign, geomdl, npz, obj · mesh_vertices · registry",
    "geodesic": "numerics, rigorous, status · across/routes, spaces, surfaces · lengths ·"
    " across/pieces, solving · proofs · contact, graph, tracing · elements · across/contact,"
    " methods, shortest · across/search · across/poles",
    "make": "gradient · body · input · checks",
    "measure": "patches · body/cutting, body/drops, body/height_saddles, body/merging,"
    " body/straight, body/taut_places · body/forks, body/girths · body/closed_girth,"
    " body/extreme_girth, body/girth_arcs",
    "mesh": "arrays, path, tubes · curved, exact, points · coarseness, curves, glb, lines ·"
    " measure",
    "native": "library · points · energy · lengths · box, closest, diagonal, normals, route,"
    " section, string, trees, ways",
    "paper": "method · data · surface · tables · analysis · reproduction · page",
    "pattern": "grid, planar · cloth, patches · curves, definitions · cutting · flat · hollows ·"
    " pieces · files",
    "report": "files, serial, ticks, units · numbers · templating · landmarks, patterns · patches ·"
    " body · population",
    "scene": "model · camera, colors · lighting · figures · drawing · diagonals · tapes",
    "section": "cells, plane, roots, through/quotient · crossings, pieces ·"
    " arcs, loop, through/poles · curve, part, sensitivity · bridged, places, section · hull",
    "surveys": "bodies · records · engine, folder · run, statistics · page · sizes, take",
    "taut": "poles, starts, status · skin · ridges, takeoffs, valleys · equilibrium · string ·"
    " refine · solve",
    "viewer": "content, window · page, server",
}
MOST_FILES = 15
LEVEL = {layer: level for level, layers in enumerate(LAYERS) for layer in layers}


def layered() -> list[Module]:
    return [module for module in all_modules() if module.layer]


def test_every_module_has_a_layer() -> None:
    assert len(all_modules()) > 20
    assert {module.layer for module in layered()} <= set(LEVEL)


def test_imports_point_downwards() -> None:
    faults = []
    for module in layered():
        for name, line in module.imports():
            if name.split(".")[0] != "bodymeasure":
                continue
            # The package itself gathers all layers, so only those on top may take from it.
            target = name.split(".")[1] if "." in name else ""
            level = LEVEL.get(target, len(LAYERS) - 2)
            if target != module.layer and level >= LEVEL[module.layer]:
                faults.append(f"{module.name}:{line}: {module.layer} must not import {name}")
    assert not faults, "\n".join(faults)


def _group(layer: str, path: str, levels: dict[str, int]) -> str:
    """The longest name in a package's order that a module's path starts with, or ""."""
    parts = path.removeprefix(f"bodymeasure.{layer}.").split(".")
    starts = ("/".join(parts[:count]) for count in range(len(parts), 0, -1))
    return next((start for start in starts if start in levels), "")


def test_the_orders_name_what_there_is() -> None:
    for layer, order in ORDERS.items():
        for name in order.replace("·", ",").split(","):
            folder = FOLDERS.get(f"bodymeasure.{layer}", FOLDERS["bodymeasure"] / layer)
            path = folder / name.strip()
            assert path.is_dir() or path.with_suffix(".py").is_file(), f"{layer}: {name.strip()}"


@pytest.mark.parametrize("layer", ORDERS)
def test_groups_of_a_package_import_only_those_before_them(layer: str) -> None:
    levels = {
        name.strip(): level
        for level, names in enumerate(ORDERS[layer].split("·"))
        for name in names.split(",")
    }
    faults = []
    for module in layered():
        group = _group(layer, module.name, levels) if module.layer == layer else ""
        for name, line in module.imports() if group else ():
            if not name.startswith(f"bodymeasure.{layer}."):
                continue
            target = _group(layer, name, levels)
            if target != group and levels.get(target, len(levels)) >= levels[group]:
                faults.append(f"{module.name}:{line}: {group} must not import {name}")
    assert not faults, "\n".join(faults)


def test_no_modules_import_each_other() -> None:
    """Each strongly connected component of the graph of imports at the top is one module."""
    trees = {module.name: module.tree for module in all_modules()}
    imports = {name: list(_imported_at_the_top(tree, set(trees))) for name, tree in trees.items()}
    number = {name: i for i, name in enumerate(imports)}
    links = [(number[name], number[other]) for name in imports for other in imports[name]]
    graph = scipy.sparse.coo_array((np.ones(len(links)), tuple(zip(*links, strict=True))))
    graph.resize(len(number), len(number))
    _, component = scipy.sparse.csgraph.connected_components(graph, connection="strong")
    circles = [
        [name for name in number if component[number[name]] == one]
        for one, size in Counter(component.tolist()).items()
        if size > 1
    ]
    assert not circles


def _imported_at_the_top(tree: ast.Module, names: set[str]) -> Iterator[str]:
    """The modules of the package that a module imports when it is loaded."""
    for node in tree.body:
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name in names)
        elif isinstance(node, ast.ImportFrom):
            for alias in node.names:
                found = {f"{node.module}.{alias.name}", str(node.module)} & names
                yield from sorted(found, key=len)[-1:]


def test_no_folder_holds_more_files_than_a_reader_can_overlook() -> None:
    folders = [*FOLDERS.values(), ROOT / "tests"]
    files = [path for folder in folders for path in folder.rglob("*.py")]
    counts = Counter(path.parent for path in files)
    crowded = {str(folder): count for folder, count in counts.items() if count > MOST_FILES}
    assert not crowded, f"more than {MOST_FILES} Python files: {crowded}"


@pytest.mark.parametrize(
    ("script", "loaded"),
    [
        ("pass", set()),
        ("bm.load_sample", {"atlas", "formats"}),
        ("bm.solve_geodesic", {"atlas", "formats", "geodesic"}),
    ],
)
def test_packages_are_loaded_when_they_are_first_asked_for(script: str, loaded: set[str]) -> None:
    layers = {name.split(".")[1] for name in loaded_by(script) if name.startswith("bodymeasure.")}
    # What lies below atlases is small, and all of it is needed by whoever has one.
    below = {layer for layer, level in LEVEL.items() if level < LEVEL["atlas"]}
    assert layers - below - {"samples"} == loaded

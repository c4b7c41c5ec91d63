"""The layers of the package, read off its syntax trees."""

import ast
import inspect
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
import scipy

import bodymeasure

ROOT = Path(bodymeasure.__file__).parent.parent
# Folders by the name under which they are installed.
FOLDERS = {
    "bodymeasure": ROOT / "bodymeasure",
    "bodymeasure.viewer": ROOT / "viewer",
    "bodymeasure.sample_patches": ROOT / "sample_patches",
}

# Each layer imports from those above it in this list, not from others of its own line.
LAYERS = (
    ("_typing", "errors", "wording"),
    ("files",),
    ("bezier", "subdivision"),
    ("atlas",),
    ("formats",),
    ("samples", "sample_patches"),
    ("geodesic", "oracle", "section"),
    ("mesh", "taut"),
    ("measure",),
    ("chart",),
    ("scene",),
    ("report", "viewer"),
    ("bench", "compare", "paper"),
    ("cli", "plugin"),
    ("__main__", "_build"),
)
# The same within a package: a name is a folder or a module. What is not named stands on top, and
# groups do not import from there.
ORDERS = {
    "atlas": "axes, components, normals, point, seams, size, units · tessellation · atlas ·"
    " topology · queries · check, summary",
    "bench": "problems · entrants · size · records · timing · summary · figure",
    "chart": "accuracy, formula, landmarks/choice, landmarks/names, picks, tapes · entry,"
    " landmarks/paths · body, sides · kinds, landmarks/rules · landmarks · definitions ·"
    " needed, reading, chart · evaluate",
    "cli": "console, tables · options · atlases, docs, landmarks, measuring, study · main",
    "compare": "names, records · readings · iso20685, read, shown · comparison, page",
    "formats": "groups, json_faults, options, patches, spline_patches, text · atlas_json, bez, bpt,"
    " foreign, geomdl, npz, obj · mesh_vertices · registry",
    "geodesic": "numerics, status · across/routes, spaces, surfaces · lengths ·"
    " across/pieces, solving · contact, graph · across/contact, methods, shortest · across/search",
    "measure": "patches · body/cutting, body/drops, body/height_saddles, body/merging,"
    " body/straight, body/taut_places · body/forks, body/girths · body/closed_girth,"
    " body/extreme_girth, body/girth_arcs",
    "mesh": "arrays, path, tubes · curved, exact, insert, points · glb, lines, measure",
    "paper": "method · data · surface · tables · reproduction · page",
    "report": "files, serial, units · numbers · templating · landmarks · patches · body",
    "scene": "model · camera, colors · lighting · figures · drawing · diagonals · tapes",
    "section": "cells, plane, roots · crossings, pieces · arcs, loop · curve, part ·"
    " bridged, places, section · hull",
    "taut": "skin, status · valleys · equilibrium · string · refine · solve",
}
MOST_FILES = 15
LEVEL = {layer: level for level, layers in enumerate(LAYERS) for layer in layers}

# Packages that are heavy, optional or talk to the user, with the layers that may import them.
RESERVED = {
    "igl": {"oracle"},
    "OCP": {"formats"},
    "rhino3dm": {"formats"},
    "trimesh": {"atlas", "formats", "mesh", "oracle"},
    "pyvista": {"scene", "viewer", "plugin"},
    "vtk": {"scene", "viewer", "plugin"},
    "vtkmodules": {"scene", "viewer", "plugin"},
    # pyvista takes its color maps from it.
    "matplotlib": {"bench", "scene", "report", "viewer", "paper"},
    "potpourri3d": {"bench"},
    "pygeodesic": {"bench", "geodesic", "mesh"},
    "threadpoolctl": {"bench"},
    "jinja2": {"report", "paper"},
    "click": {"cli"},
    "markdown_it": {"cli"},
    "rich": {"cli"},
}
# What `import bodymeasure` must not load.
HEAVY = set(RESERVED)
# What only the command line may use.
OF_THE_COMMAND_LINE = {
    *("print", "input", "exit", "quit", "sys.exit", "sys.stdout", "sys.stderr"),
    *("np.seterr", "warnings.simplefilter", "warnings.filterwarnings"),
}


class Module(NamedTuple):
    """A source file: its dotted name, its layer (empty for the package itself) and its tree."""

    name: str
    layer: str
    tree: ast.Module

    def imports(self) -> Iterator[tuple[str, int]]:
        """All imported modules, wherever in the file, and the lines."""
        for node in ast.walk(self.tree):
            if isinstance(node, ast.Import):
                for alias in node.names:
                    yield alias.name, node.lineno
            elif isinstance(node, ast.ImportFrom):
                if node.level:
                    # The samples' folder is also a package by itself, which its build script uses.
                    assert (node.level, self.layer) == (1, "sample_patches"), (
                        f"{self.name}, line {node.lineno}: imports must be absolute"
                    )
                    yield f"bodymeasure.{self.layer}.{node.module}", node.lineno
                elif node.module == "bodymeasure":
                    # `from bodymeasure import geodesic` names a layer, `import Atlas` the package.
                    for alias in node.names:
                        yield f"bodymeasure.{alias.name}", node.lineno
                else:
                    yield str(node.module), node.lineno


def _modules() -> list[Module]:
    modules = []
    for package, folder in FOLDERS.items():
        for path in sorted(folder.rglob("*.py")):
            parts = (*package.split("."), *path.relative_to(folder).with_suffix("").parts)
            parts = parts[:-1] if parts[-1] == "__init__" else parts
            layer = parts[1] if len(parts) > 1 else ""
            modules.append(Module(".".join(parts), layer, ast.parse(path.read_text("utf-8"))))
    return modules


MODULES = _modules()
LAYERED = [module for module in MODULES if module.layer]


def test_every_module_has_a_layer() -> None:
    assert len(MODULES) > 20
    assert {module.layer for module in LAYERED} <= set(LEVEL)


def test_imports_point_downwards() -> None:
    faults = []
    for module in LAYERED:
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
            path = FOLDERS["bodymeasure"] / layer / name.strip()
            assert path.is_dir() or path.with_suffix(".py").is_file(), f"{layer}: {name.strip()}"


@pytest.mark.parametrize("layer", ORDERS)
def test_groups_of_a_package_import_only_those_before_them(layer: str) -> None:
    levels = {
        name.strip(): level
        for level, names in enumerate(ORDERS[layer].split("·"))
        for name in names.split(",")
    }
    faults = []
    for module in LAYERED:
        group = _group(layer, module.name, levels) if module.layer == layer else ""
        for name, line in module.imports():
            if not group or not name.startswith(f"bodymeasure.{layer}."):
                continue
            target = _group(layer, name, levels)
            if target != group and levels.get(target, len(levels)) >= levels[group]:
                faults.append(f"{module.name}:{line}: {group} must not import {name}")
    assert not faults, "\n".join(faults)


def test_no_modules_import_each_other() -> None:
    """Each strongly connected component of the graph of imports at the top is one module."""
    trees = {module.name: module.tree for module in MODULES}
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


def test_packages_are_imported_only_where_they_belong() -> None:
    faults = []
    for module in MODULES:
        for name, line in module.imports():
            allowed = RESERVED.get(name.split(".")[0], {module.layer})
            if module.layer not in allowed:
                faults.append(f"{module.name}:{line}: imports {name}")
    assert not faults, "\n".join(faults)


def _named(node: ast.AST) -> str:
    """A name, or an attribute of a name, as it is written; or ""."""
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
        return f"{node.value.id}.{node.attr}"
    return ""


def test_only_the_command_line_prints_or_exits() -> None:
    faults = [
        f"{module.name}:{node.lineno}: {_named(node)}"
        for module in MODULES
        if module.layer != "cli"
        for node in ast.walk(module.tree)
        if isinstance(node, ast.Name | ast.Attribute) and _named(node) in OF_THE_COMMAND_LINE
    ]
    assert not faults, "\n".join(faults)


def test_no_global_random_numbers() -> None:
    faults = [
        f"{module.name}:{node.lineno}: {ast.unparse(node)}"
        for module in MODULES
        for node in ast.walk(module.tree)
        if isinstance(node, ast.Attribute)
        and node.attr not in {"default_rng", "Generator"}
        and ast.unparse(node.value) in {"np.random", "random"}
    ]
    assert not faults, "\n".join(faults)


def _loaded(script: str) -> set[str]:
    """Run a script in a new process and return the names of the modules that it loaded."""
    script = f"import sys, bodymeasure as bm; {script}; print('\\n'.join(sys.modules))"
    run = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True, timeout=60
    )
    return set(run.stdout.split())


def test_all_that_is_public_loads_nothing_heavy() -> None:
    loaded = {name.split(".")[0] for name in _loaded("from bodymeasure import *")}
    assert {"bodymeasure", "numpy", "scipy"} <= loaded
    assert loaded.isdisjoint(HEAVY), loaded & HEAVY


def test_reports_scenes_and_the_viewer_load_what_is_heavy_only_when_they_draw() -> None:
    names = _loaded("import bodymeasure.report, bodymeasure.scene, bodymeasure.viewer")
    loaded = {name.split(".")[0] for name in names}
    assert "bodymeasure.viewer" in names
    assert loaded.isdisjoint({*HEAVY, "PIL"}), loaded & HEAVY


@pytest.mark.parametrize(
    ("script", "loaded"),
    [
        ("pass", set()),
        ("bm.load_sample", {"atlas", "formats"}),
        ("bm.solve_geodesic", {"atlas", "formats", "geodesic"}),
    ],
)
def test_packages_are_loaded_when_they_are_first_asked_for(script: str, loaded: set[str]) -> None:
    layers = {name.split(".")[1] for name in _loaded(script) if name.startswith("bodymeasure.")}
    # What lies below atlases is small, and all of it is needed by whoever has one.
    below = {layer for layer, level in LEVEL.items() if level < LEVEL["atlas"]}
    assert layers - below - {"samples"} == loaded


def test_the_repository_stands_alone() -> None:
    # Put together, so that this file does not hold them.
    outside = ["../" + "shared"]
    folders = [*FOLDERS.values(), ROOT / "tests", ROOT / ".ci", ROOT / ".github"]
    files = [path for folder in folders for path in folder.rglob("*") if path.is_file()]
    files += [path for path in ROOT.iterdir() if path.is_file()]
    for path in files:
        if "__pycache__" in path.parts:
            continue
        content = path.read_bytes()
        for text in outside:
            assert text.encode() not in content, f"{path} mentions {text}"


def test_public_names_are_documented() -> None:
    undocumented = []
    for name in bodymeasure.__all__:
        member = getattr(bodymeasure, name)
        documentation = inspect.getdoc(member) or ""
        # Dataclasses without a docstring are given their signature.
        documented = documentation and not documentation.startswith(f"{name}(")
        if (inspect.isclass(member) or inspect.isroutine(member)) and not documented:
            undocumented.append(name)
    assert not undocumented


def test_arrays_of_the_usual_kinds_have_their_names_in_one_place() -> None:
    kinds = {"np.float64", "np.int64", "np.bool_", "np.complex128"}
    faults = [
        f"{module.name}:{node.lineno}: {ast.unparse(node)} belongs into bodymeasure._typing"
        for module in MODULES
        for node in ast.walk(module.tree)
        if module.layer != "_typing"
        and isinstance(node, (ast.Assign, ast.AnnAssign))
        and isinstance(node.value, ast.Subscript)
        and ast.unparse(node.value.value) == "NDArray"
        and ast.unparse(node.value.slice) in kinds
    ]
    assert not faults, "\n".join(faults)

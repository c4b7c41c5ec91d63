"""What modules may use: heavy packages, printing, random numbers, names of arrays."""

import ast

from helpers.modules import FOLDERS, ROOT, all_modules, loaded_by

# Packages that are heavy, optional or talk to the user, with the layers that may import them.
RESERVED = {
    "igl": {"bench", "fit", "oracle"},
    "OCP": {"formats"},
    "rhino3dm": {"formats"},
    "trimesh": {"atlas", "bench", "fit", "formats", "mesh", "oracle"},
    "pyvista": {"scene", "viewer", "plugin"},
    "vtk": {"scene", "viewer", "plugin"},
    "vtkmodules": {"scene", "viewer", "plugin"},
    # pyvista takes its color maps from it.
    "matplotlib": {"bench", "scene", "report", "viewer", "paper"},
    "potpourri3d": {"bench", "oracle"},
    "pygeodesic": {"bench"},
    "threadpoolctl": {"bench", "threads"},
    "jinja2": {"report", "paper"},
    "pyarrow": {"surveys"},
    "distributed": {"surveys"},
    "kmedoids": {"surveys"},
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


def test_packages_are_imported_only_where_they_belong() -> None:
    faults = []
    for module in all_modules():
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
        for module in all_modules()
        if module.layer not in {"cli", "__main__"}
        for node in ast.walk(module.tree)
        if isinstance(node, ast.Name | ast.Attribute) and _named(node) in OF_THE_COMMAND_LINE
    ]
    assert not faults, "\n".join(faults)


def test_no_global_random_numbers() -> None:
    faults = [
        f"{module.name}:{node.lineno}: {ast.unparse(node)}"
        for module in all_modules()
        for node in ast.walk(module.tree)
        if isinstance(node, ast.Attribute)
        and node.attr not in {"default_rng", "Generator"}
        and ast.unparse(node.value) in {"np.random", "random"}
    ]
    assert not faults, "\n".join(faults)


def test_all_that_is_public_loads_nothing_heavy() -> None:
    loaded = {name.split(".")[0] for name in loaded_by("from bodymeasure import *")}
    assert {"bodymeasure", "numpy", "scipy"} <= loaded
    assert loaded.isdisjoint(HEAVY), loaded & HEAVY


def test_reports_scenes_and_the_viewer_load_what_is_heavy_only_when_they_draw() -> None:
    names = loaded_by("import bodymeasure.report, bodymeasure.scene, bodymeasure.viewer")
    loaded = {name.split(".")[0] for name in names}
    assert "bodymeasure.viewer" in names
    assert loaded.isdisjoint({*HEAVY, "PIL"}), loaded & HEAVY


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


def test_arrays_of_the_usual_kinds_have_their_names_in_one_place() -> None:
    kinds = {"np.float64", "np.int64", "np.bool_", "np.complex128"}
    faults = [
        f"{module.name}:{node.lineno}: {ast.unparse(node)} belongs into bodymeasure._typing"
        for module in all_modules()
        for node in ast.walk(module.tree)
        if module.layer != "_typing"
        and isinstance(node, (ast.Assign, ast.AnnAssign))
        and isinstance(node.value, ast.Subscript)
        and ast.unparse(node.value.value) == "NDArray"
        and ast.unparse(node.value.slice) in kinds
    ]
    assert not faults, "\n".join(faults)

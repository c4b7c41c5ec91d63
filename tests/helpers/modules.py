"""The modules of the package with their syntax trees, and what a script loads of them."""

import ast
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

import bodymeasure

ROOT = Path(bodymeasure.__file__).parent.parent
# Folders by the name under which they are installed.
FOLDERS = {
    "bodymeasure": ROOT / "bodymeasure",
    "bodymeasure.viewer": ROOT / "viewer",
    "bodymeasure.sample_patches": ROOT / "sample_patches",
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


@cache
def all_modules() -> tuple[Module, ...]:
    """Every module of the package, parsed when it is first asked for: it takes over a second."""
    modules = []
    for package, folder in FOLDERS.items():
        for path in sorted(folder.rglob("*.py")):
            parts = (*package.split("."), *path.relative_to(folder).with_suffix("").parts)
            parts = parts[:-1] if parts[-1] == "__init__" else parts
            layer = parts[1] if len(parts) > 1 else ""
            modules.append(Module(".".join(parts), layer, ast.parse(path.read_text("utf-8"))))
    return tuple(modules)


def loaded_by(script: str) -> set[str]:
    """Run a script in a new process and return the names of the modules that it loaded."""
    script = f"import sys, bodymeasure as bm; {script}; print('\\n'.join(sys.modules))"
    run = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True, timeout=180
    )
    return set(run.stdout.split())

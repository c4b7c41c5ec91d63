"""Bodies of Anny and what clad-body measures of them, as files for body_models.py.

python tests/benchmarks/fit/anny_bodies.py FOLDER

Needs the packages anny (0.3.1) and clad-body (0.6.1, which asks for Python 3.12), and PyTorch;
without them it says so and ends. Each file has the vertices (meters, z up), the triangles and the
measures of one of the bodies that clad-body comes with.
"""

import json
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np


def main() -> None:
    try:
        measuring: Any = import_module("clad_body.measure")
        loading: Any = import_module("clad_body.load")
    except ImportError as error:
        print(f"Skipped: {error}; install anny==0.3.1, clad-body==0.6.1 and torch (Python 3.12).")
        return
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    bodies = Path(measuring.__file__).parent / "testdata" / "anny"
    for case in sorted(bodies.iterdir()):
        text = (case / "anny_params.json").read_text(encoding="utf-8")
        body: Any = loading.load_anny_from_params(json.loads(text))
        found = measuring.measure(body)
        numbers = {
            key: float(value) for key, value in found.items() if isinstance(value, (int, float))
        }
        np.savez(
            folder / f"{case.name}.npz",
            vertices=body.vertices,
            faces=body.faces,
            measures=json.dumps(numbers),
        )
        print(case.name, flush=True)


if __name__ == "__main__":
    main()

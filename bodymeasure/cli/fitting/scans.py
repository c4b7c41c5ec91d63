"""Scans that a command is given, and their fits."""

import hashlib
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from bodymeasure.cli.console import progress_bar
from bodymeasure.cli.inputs import path_of_atlas
from bodymeasure.cli.needs import require
from bodymeasure.cli.options import file_settings, given_topology
from bodymeasure.files import read_bytes
from bodymeasure.formats.obj.triangles import TRIANGLE_MESHES, is_of_triangles

if TYPE_CHECKING:
    from bodymeasure.atlas import Atlas
    from bodymeasure.fit import FittedBody

# The needs of a fit: see `bodymeasure.cli.needs`.
READING = ("reading a mesh", "trimesh", "trimesh", "fit")
DISTANCES = ("the fit", "igl", "libigl", "fit")
FIT_PAGE = ("the page of a fit (--no-page leaves it out)", "jinja2", "jinja2", "fit")
FIT_PICTURES = ("drawing (--no-pictures leaves it out)", "matplotlib", "matplotlib", "fit")
# What the user may say about a scan.
SETTINGS = ("unit", "up", "front")


def is_scan(name: str) -> bool:
    """Whether a file is a triangle mesh, to which a body is to be fitted.

    An .obj file may as well hold the quads or the smooth surfaces of an atlas; --quads says that it
    does. Quads of a model whose topology is known, or given, are those of a body.
    """
    path = path_of_atlas(name)
    suffix = path.suffix.lower()
    if suffix != ".obj" or file_settings().get("quads"):
        return suffix in TRIANGLE_MESHES
    if given_topology() is not None:
        return True
    lines = [line for line in read_bytes(path).splitlines() if line[:2] in (b"f ", b"f\t")]
    sizes = np.array([len(line.split()) - 1 for line in lines])
    return len(sizes) > 0 and (is_of_triangles(sizes) or _is_known(path))


def _is_known(path: Path) -> bool:
    from bodymeasure.fit.by_topology import topology_of

    return topology_of(path) is not None


def scan_settings() -> dict[str, str]:
    """Return what the user says about a scan: unit, up, front, and the model it belongs to."""
    settings = {key: value for key, value in file_settings().items() if key in SETTINGS}
    topology = given_topology()
    return settings if topology is None else {**settings, "topology": topology}


def scan_files(path: Path) -> tuple[Path, ...]:
    """Return the files on which the fit to a scan rests: its own, and that of its topology."""
    topology = Path(given_topology() or "")
    return (path, topology) if topology.is_file() else (path,)


def require_fit(*, page: bool, pictures: bool) -> None:
    """Refuse, before any work, a fit for which a package is missing.

    Raises
    ------
    MissingExtraError
        The feature, the package it needs, and how to install it.
    """
    needs = (*((FIT_PAGE,) if page else ()), *((FIT_PICTURES,) if pictures else ()))
    require(READING, DISTANCES, *needs)


def scan_subject(name: str, picks: Path | None) -> "FittedBody":
    """Return the fit of a scan by the name that a command was given."""
    return fitted(path_of_atlas(name), picks)


def fitted(path: Path, picks: Path | None) -> "FittedBody":
    """Fit the body model to a scan, with a progress bar.

    Parameters
    ----------
    path : Path
    picks : Path, optional
        A CSV file of landmarks that the user has picked.

    Raises
    ------
    FitError
        If no body is found in the scan.
    InputError
        If a file cannot be read.
    """
    # Slow imports, which `--help` does not need.
    from bodymeasure.chart.picks.file import read_picks
    from bodymeasure.fit import fit_body
    from bodymeasure.fit.fit import KNOWN

    landmarks = None
    if picks is not None:
        names, positions = read_picks(picks)
        landmarks = dict(zip(names, positions, strict=True))
    given = scan_settings()
    with progress_bar(f"fitting {path.stem}", 100) as progress:
        body = fit_body(
            path,
            file_unit=given.get("unit"),
            up=given.get("up"),
            front=given.get("front"),
            landmarks=landmarks,
            topology=given_topology() or KNOWN,
            progress=lambda _step, part: progress(round(100.0 * part)),
        )
    return replace(body, atlas=_with_source(body.atlas, path))


def _with_source(atlas: "Atlas", path: Path) -> "Atlas":
    """Return an atlas that says from which file it was made, so that this can be found again."""
    # It loads the solver, which a command that fits no scan does not need.
    from bodymeasure.measure import package_versions

    settings = ", ".join(f"{key} {value}" for key, value in scan_settings().items())
    source = {
        "scan": path.name,
        "scan, SHA-256": hashlib.sha256(read_bytes(path)).hexdigest(),
        **({"scan, as given": settings} if settings else {}),
        "fitted by": f"bodymeasure {package_versions(('bodymeasure',))['bodymeasure']}",
    }
    return replace(atlas, provenance={**atlas.provenance, **source})

"""The survey of an atlas: everything that a report, a picture or a viewer shows."""

import importlib.metadata
import platform
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from bodymeasure.atlas import Atlas, Finding, check_atlas
from bodymeasure.geodesic import GeodesicSolution, Method, RBFCollocation, Search
from bodymeasure.measure.patches.boundary import BoundaryLengths, boundary_lengths
from bodymeasure.measure.patches.checks import Check
from bodymeasure.measure.patches.diagonals import diagonals
from bodymeasure.native import is_compiled
from bodymeasure.threads import one_blas_thread
from bodymeasure.wording import counted

if TYPE_CHECKING:
    from bodymeasure.measure.patches.cross_check import CrossCheck

# Packages whose versions can change a number of a chart or a fit.
NUMERIC = ("bodymeasure", "numpy", "scipy")
# Those that can change a number or a picture of a survey.
PACKAGES = (*NUMERIC, "libigl", "potpourri3d", "pyvista", "vtk", "matplotlib")


@dataclass(frozen=True, eq=False)
class Survey:
    """All that is measured on an atlas, so that reports, scenes and viewers compute no geometry.

    Parameters
    ----------
    atlas : Atlas
    diagonals : GeodesicSolution, shape (patches, 2)
    boundary : BoundaryLengths
    cross_check : CrossCheck or None
        None if it was not asked for.
    findings : tuple of Finding
        The findings of `check_atlas`.
    settings, versions : mapping of str to str
        The settings of the computation, in words, and the versions of the packages in use.
    seconds : mapping of str to float
        The time that each step took.
    """

    atlas: Atlas
    diagonals: GeodesicSolution
    boundary: BoundaryLengths
    cross_check: "CrossCheck | None" = None
    findings: tuple[Finding, ...] = ()
    settings: Mapping[str, str] = field(default_factory=dict)
    versions: Mapping[str, str] = field(default_factory=dict)
    seconds: Mapping[str, float] = field(default_factory=dict)

    def __repr__(self) -> str:
        measured = int(self.diagonals.converged.sum())
        found = counted(len(self.findings), "finding")
        diagonals = f"{measured} of {self.diagonals.converged.size} diagonals measured"
        return f"<Survey of {self.atlas!r}: {diagonals}, {found}>"


@one_blas_thread()
def measure_atlas(
    atlas: Atlas,
    *,
    method: Method | None = None,
    search: Search | None = None,
    compare: bool = True,
    check: Check = "flips",
    processes: int = 1,
    progress: Callable[[int], None] | None = None,
) -> Survey:
    """Check an atlas, measure its diagonals and boundary curves, and compare with libigl.

    Parameters
    ----------
    atlas : Atlas
    method : Method, optional
        `RBFCollocation()` by default.
    search : {"quick", "thorough", "straight"}, optional
        See `solve_geodesic`.
    compare : bool
        Whether to compare with mesh distances, which takes by far the most time.
    check : {"flips", "libigl"}
        What measures on meshes: edge flips, of which libigl confirms a sample, each disagreement
        and the worst cases; or libigl everything, in four times the time.
    processes : int
        Worker processes of the comparison.
    progress : callable, optional
        Called with the number of diagonals compared so far.

    Returns
    -------
    Survey

    Raises
    ------
    MissingExtraError
        If the comparison is asked for and libigl is not installed.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> survey = bm.measure_atlas(bm.load_sample("paraboloid"), compare=False)
    >>> print(survey.diagonals.length.round(6), len(survey.findings))
    [[2.562007 1.53733 ]] 0
    """
    seconds: dict[str, float] = {}
    with _timed(seconds, "check of the atlas"):
        findings = check_atlas(atlas)
    with _timed(seconds, "diagonals"):
        solution = diagonals(atlas, method=method, search=search, on_failure="status")
    with _timed(seconds, "boundary curves"):
        boundary = boundary_lengths(atlas)
    checked = None
    settings = {
        "method": str(method or RBFCollocation()),
        "search": search or ("quick" if method is None else "straight"),
    }
    if compare:
        from bodymeasure.measure.patches.cross_check import cross_check

        with _timed(seconds, "cross-check"):
            checked = cross_check(
                atlas, solution, check=check, processes=processes, progress=progress
            )
        settings["cross-check"] = _in_words(checked)
    return Survey(
        atlas, solution, boundary, checked, findings, settings, package_versions(PACKAGES), seconds
    )


def _in_words(checked: "CrossCheck") -> str:
    """Return what measured on which meshes."""
    levels = ", ".join(map(str, checked.levels))
    meshes = f"{levels} segments a side of each patch, extrapolated"
    heat = "heat (libigl) on the second of them"
    confirmed, count = int(checked.confirmed.sum()), len(checked.confirmed)
    if confirmed == count:
        return f"libigl exact on {meshes}; {heat}"
    return (
        f"edge flips (potpourri3d) on {meshes}; libigl exact instead on {confirmed} of {count} "
        "patches: a sample, each that disagrees or nearly does, and the worst; there, flips were "
        f"longer by {checked.flips_longer:.1g} at most; {heat}"
    )


@contextmanager
def _timed(seconds: dict[str, float], step: str) -> Iterator[None]:
    begin = time.perf_counter()
    yield
    seconds[step] = time.perf_counter() - begin


def package_versions(packages: Sequence[str] = NUMERIC) -> dict[str, str]:
    """Return the versions of Python and of installed packages, and which kernels serve.

    Without a choice of packages, they are those that can change a number of a chart or a fit.
    """
    versions = {"Python": platform.python_version()}
    versions["kernels"] = "compiled" if is_compiled() else "NumPy"
    for package in packages:
        try:
            versions[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            continue
    return versions

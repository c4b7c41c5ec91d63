"""Packages that commands need, looked for before any work."""

from importlib.util import find_spec

from bodymeasure.errors import MissingExtraError

# The needs of features: a name for the feature, the module, its package, and the extra that
# installs the package.
COMPARISON = ("the comparison (--no-cross-check leaves it out)", "igl", "libigl", "oracle")
PICTURES = ("drawing (--no-pictures leaves it out)", "matplotlib", "matplotlib", "report")
PAGE = ("the HTML report", "jinja2", "jinja2", "report")
CHART_PAGE = ("the page of measurements", "jinja2", "jinja2", "chart")
CHART_PICTURES = ("drawing (--no-pictures leaves it out)", "matplotlib", "matplotlib", "chart")
BENCHMARK = (
    ("the benchmark", "igl", "libigl", "bench"),
    ("the benchmark", "potpourri3d", "potpourri3d", "bench"),
    ("the benchmark", "trimesh", "trimesh", "bench"),
)
BENCHMARK_FIGURE = ("the benchmark's figure", "matplotlib", "matplotlib", "bench")
VIEWER = ("the viewer", "pyvista", "pyvista", "viewer")
VIEWER_COLORS = ("the viewer", "matplotlib", "matplotlib", "viewer")


def require(*needs: tuple[str, str, str, str]) -> None:
    """Refuse, before any work, what would fail at its end because a package is missing.

    Raises
    ------
    MissingExtraError
        The feature, the package it needs, and how to install it.
    """
    for feature, module, package, extra in needs:
        if find_spec(module) is None:
            raise MissingExtraError(feature, package, extra)

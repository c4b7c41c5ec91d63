"""Geodesic body measurements on atlases of Bezier patches, with stated errors.

Each public name is loaded when it is first asked for, so that ``import bodymeasure`` is quick and
a program pays only for the parts that it uses.
"""

from importlib import import_module
from typing import TYPE_CHECKING

__all__ = [
    "WU_C2",
    "WU_C4",
    "WU_C6",
    "WU_C10",
    "Approximation",
    "ApproximationKind",
    "Atlas",
    "AtlasPath",
    "AtlasPoint",
    "Axes",
    "BodymeasureError",
    "BoundaryLengths",
    "Bounds",
    "Chart",
    "ClosedPath",
    "ConvergenceError",
    "Definitions",
    "Derived",
    "DiagonalArrays",
    "DirectedPath",
    "Drop",
    "EdgeContact",
    "ExtremeGirth",
    "Extremum",
    "FileFaces",
    "Finding",
    "FindingKind",
    "FitError",
    "FittedBody",
    "FoundLandmarks",
    "GeodesicSolution",
    "Girth",
    "GivenLength",
    "GradedPattern",
    "HasDerivatives",
    "InputError",
    "Kernel",
    "LandmarkFound",
    "LandmarkOrigin",
    "LandmarkRule",
    "Location",
    "LoopKind",
    "MadeBody",
    "Measured",
    "MeasurementDefinition",
    "Measurements",
    "MedoidSizes",
    "MeshPath",
    "Method",
    "MissingExtraError",
    "MissingUnitError",
    "Outcome",
    "Pattern",
    "PatternDefinitions",
    "Piece",
    "Plane",
    "PolynomialCollocation",
    "RBFCollocation",
    "RBFRitz",
    "Ritz",
    "Scan",
    "ScanFit",
    "SeamCrossing",
    "Severity",
    "SizeTable",
    "Status",
    "StepSizes",
    "Survey",
    "SurveyTable",
    "TautStatus",
    "TautTape",
    "Tessellation",
    "Topology",
    "TriangleMeshError",
    "UnfoldedPatches",
    "Unit",
    "approximation_error",
    "body_girth",
    "boundary_lengths",
    "check_atlas",
    "closed_geodesic",
    "closest_point",
    "contracted_loop",
    "derive_landmarks",
    "diagonals",
    "diagonals_of_bodies",
    "enclose",
    "export_page",
    "extreme_girth",
    "fit_body",
    "fork_point",
    "found_landmarks",
    "geodesic_alternatives",
    "geodesic_between",
    "geodesic_from",
    "geodesics_between",
    "grade_body",
    "grade_pattern",
    "homogeneous",
    "limb_girth",
    "load_definitions",
    "load_pattern",
    "load_sample",
    "make_body",
    "make_pattern",
    "make_sizes",
    "map_body",
    "measure_atlas",
    "measure_chart",
    "measure_mesh",
    "path_to_trimesh",
    "plane_girth",
    "rbf_coefficients",
    "read_atlas",
    "read_measurements",
    "read_population",
    "read_scan",
    "read_survey",
    "read_topology",
    "sample_names",
    "save_topology",
    "show",
    "size_table",
    "solve_geodesic",
    "survey",
    "taut_tape",
    "tessellate",
    "unfold_patches",
    "vertical_drop",
    "write_atlas",
    "write_chart",
    "write_fitted",
    "write_glb",
    "write_paths",
    "write_pattern",
    "write_population",
    "write_report",
    "write_sizes",
    "write_survey",
]


# The packages that hold the public names, each after those that it imports: a name is looked up in
# this order, so that finding it loads little more than what it needs anyway.
_HOMES = (
    "errors",
    "bezier",
    "atlas",
    "formats",
    "samples",
    "geodesic",
    "section",
    "taut",
    "mesh",
    "measure",
    "chart",
    "fit",
    "pattern",
    "report",
    "report.patterns",
    "viewer",
    "make",
    "surveys",
)

if TYPE_CHECKING:
    from bodymeasure.atlas import (
        Approximation,
        ApproximationKind,
        Atlas,
        AtlasPoint,
        Axes,
        FileFaces,
        Finding,
        FindingKind,
        GivenLength,
        LandmarkFound,
        LandmarkOrigin,
        Location,
        ScanFit,
        Severity,
        Tessellation,
        Unit,
        approximation_error,
        check_atlas,
        closest_point,
        tessellate,
    )
    from bodymeasure.bezier import homogeneous
    from bodymeasure.chart import (
        Chart,
        Definitions,
        Derived,
        FoundLandmarks,
        LandmarkRule,
        Measured,
        MeasurementDefinition,
        Outcome,
        derive_landmarks,
        found_landmarks,
        load_definitions,
        measure_chart,
    )
    from bodymeasure.errors import (
        BodymeasureError,
        ConvergenceError,
        FitError,
        InputError,
        MissingExtraError,
        MissingUnitError,
        TriangleMeshError,
    )
    from bodymeasure.fit import (
        FittedBody,
        Scan,
        Topology,
        fit_body,
        map_body,
        read_scan,
        read_topology,
        save_topology,
        write_fitted,
    )
    from bodymeasure.formats import read_atlas, read_population, write_atlas, write_population
    from bodymeasure.geodesic import (
        WU_C2,
        WU_C4,
        WU_C6,
        WU_C10,
        AtlasPath,
        Bounds,
        ClosedPath,
        DirectedPath,
        EdgeContact,
        GeodesicSolution,
        HasDerivatives,
        Kernel,
        LoopKind,
        Method,
        PolynomialCollocation,
        RBFCollocation,
        RBFRitz,
        Ritz,
        SeamCrossing,
        Status,
        contracted_loop,
        enclose,
        geodesic_alternatives,
        geodesic_between,
        geodesic_from,
        geodesics_between,
        rbf_coefficients,
        solve_geodesic,
    )
    from bodymeasure.make import (
        MadeBody,
        Measurements,
        grade_body,
        make_body,
        make_sizes,
        read_measurements,
    )
    from bodymeasure.measure import (
        BoundaryLengths,
        DiagonalArrays,
        Drop,
        ExtremeGirth,
        Extremum,
        Girth,
        Survey,
        body_girth,
        boundary_lengths,
        closed_geodesic,
        diagonals,
        diagonals_of_bodies,
        extreme_girth,
        fork_point,
        limb_girth,
        measure_atlas,
        plane_girth,
        vertical_drop,
    )
    from bodymeasure.mesh import MeshPath, measure_mesh, path_to_trimesh, write_glb, write_paths
    from bodymeasure.pattern import (
        GradedPattern,
        Pattern,
        PatternDefinitions,
        Piece,
        UnfoldedPatches,
        grade_pattern,
        load_pattern,
        make_pattern,
        unfold_patches,
    )
    from bodymeasure.report import write_chart, write_report
    from bodymeasure.report.patterns import write_pattern
    from bodymeasure.samples import load_sample, sample_names
    from bodymeasure.section import (
        Plane,
    )
    from bodymeasure.surveys import (
        MedoidSizes,
        SizeTable,
        StepSizes,
        SurveyTable,
        read_survey,
        size_table,
        survey,
        write_sizes,
        write_survey,
    )
    from bodymeasure.taut import TautStatus, TautTape, taut_tape
    from bodymeasure.viewer import export_page, show
else:

    def __getattr__(name: str) -> object:
        """Load a public name, or a package that holds some, when it is first asked for."""
        if name in _HOMES:
            return import_module(f"{__name__}.{name}")
        if name in __all__:
            for home in _HOMES:
                try:
                    module = import_module(f"{__name__}.{home}")
                except ModuleNotFoundError as error:
                    # A bare checkout, which is not installed, has no viewer.
                    if error.name != f"{__name__}.viewer":
                        raise
                    continue
                if hasattr(module, name):
                    globals()[name] = getattr(module, name)
                    return globals()[name]
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

    def __dir__() -> list[str]:
        """List the public names and the packages, whether they have been loaded or not."""
        return sorted({*globals(), *__all__, *(home for home in _HOMES if "." not in home)})

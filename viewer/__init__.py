"""The pyvista window of a measured body. Importing this does not load VTK; opening it does."""

from bodymeasure.viewer.describe import describe, describe_measured
from bodymeasure.viewer.show import view, view_chart

__all__ = ["describe", "describe_measured", "view", "view_chart"]

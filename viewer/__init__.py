"""The pyvista window of a measured body. Importing this does not load VTK; opening it does."""

from bodymeasure.viewer.describe import describe
from bodymeasure.viewer.show import view

__all__ = ["describe", "view"]

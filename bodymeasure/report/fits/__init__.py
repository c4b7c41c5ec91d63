"""The page of a body that was fitted to a scan."""

from bodymeasure.report.fits.page import BodyPictures, render_fit

__all__ = ["BodyPictures", "render_fit"]

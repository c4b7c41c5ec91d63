"""Two renderers of one kind of picture: pyvista, and software for machines without OpenGL."""

from collections.abc import Mapping

from bodymeasure.scene.drawing import opengl, software
from bodymeasure.scene.drawing.opengl_check import PYVISTA, SOFTWARE
from bodymeasure.scene.drawing.picture import Renderer

RENDERERS: Mapping[str, Renderer] = {PYVISTA: opengl.session, SOFTWARE: software.session}

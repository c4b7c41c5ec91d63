"""The accessor ``mesh.measure`` on pyvista's meshes."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import pyvista as pv

from bodymeasure.atlas import Atlas, AtlasPoint, Unit
from bodymeasure.atlas.queries.locations import Location, atlas_point
from bodymeasure.errors import BodymeasureError, InputError
from bodymeasure.geodesic import geodesic_between
from bodymeasure.measure import body_girth
from bodymeasure.mesh import measure_mesh
from bodymeasure.mesh.points import points_of
from bodymeasure.plugin.drawn import START, drawn_path, drawn_start, length_words, shown
from bodymeasure.plugin.remembered import PARAMETERS, PATCH, atlas_of, lines_of, unit_of

MeshPlace = int | Location
"""A vertex by number; a position; on meshes that remember an atlas, a landmark or its point too."""


class MeasureAccessor:
    """Measurements of a mesh, as ``mesh.measure``.

    On a mesh that was read from an atlas they are those of the smooth surface, with a stated error.
    On any other triangle mesh they are those of the mesh itself, and say so.
    """

    def __init__(self, mesh: pv.PolyData) -> None:
        self._mesh = mesh

    @property
    def atlas(self) -> Atlas | None:
        """The atlas that the mesh was made of; None for any other mesh.

        Raises
        ------
        InputError
            If the mesh was moved, deformed or cut since.
        """
        return atlas_of(self._mesh)

    @property
    def landmarks(self) -> tuple[str, ...]:
        """Names of the atlas's landmarks; none for any other mesh."""
        atlas = self.atlas
        return () if atlas is None else tuple(atlas.landmarks)

    def path(
        self,
        start: MeshPlace,
        end: MeshPlace,
        via: Sequence[MeshPlace] = (),
        *,
        unit: Unit | str | None = None,
    ) -> pv.PolyData:
        """Return the shortest path found over the surface.

        Parameters
        ----------
        start, end : int, position of shape (3,), str or AtlasPoint
            Vertices by number, positions, or landmarks of the atlas.
        via : sequence of such
            Places that the path leads through, in order.
        unit : str, optional
            Unit of a plain mesh's coordinates, which is only passed on.

        Returns
        -------
        pyvista.PolyData
            A line, with field data ``length``, ``error_estimate``, ``unit`` (empty if unknown),
            ``status`` and ``sentence``, which says what the length is worth.

        Raises
        ------
        InputError, ConvergenceError, MissingExtraError
            As `bodymeasure.geodesic_between` and `bodymeasure.measure_mesh`.
        """
        atlas = self.atlas
        if atlas is None:
            plain = [_plain(place) for place in (start, *via, end)]
            found = measure_mesh(self._mesh, plain[0], plain[-1], plain[1:-1], unit=unit)
            line = lines_of(found.points)
            said = "" if found.unit is None else found.unit.value
            return _with_facts(
                line, found.length, found.error_estimate, said, "MESH", found.sentence
            )
        if unit is not None:
            raise InputError(
                f"the mesh is of an atlas in {atlas.unit}, and unit is {unit!r}; give the unit "
                "when the atlas is read, and not here"
            )
        places = [self._point(atlas, place) for place in (start, *via, end)]
        path = geodesic_between(atlas, places[0], places[-1], places[1:-1])
        line = lines_of(points_of("between the places", path)[0])
        return _with_facts(
            line,
            path.length,
            path.error_estimate,
            unit_of(self._mesh),
            path.status.name,
            path.status.sentence,
        )

    def distance(self, start: MeshPlace, end: MeshPlace, via: Sequence[MeshPlace] = ()) -> float:
        """Length of the shortest path found; see `path`."""
        return float(self.path(start, end, via).field_data["length"][0])

    def girth(self, at: MeshPlace) -> pv.PolyData:
        """Return the horizontal girth at a place of an atlas, as a closed line.

        Its ``length`` is along the skin; the field ``taut`` is the tape drawn taut.

        Raises
        ------
        InputError
            On a mesh that remembers no atlas, or as `bodymeasure.body_girth`.
        """
        atlas = self.atlas
        if atlas is None:
            raise InputError(
                "this mesh remembers no atlas, and which way is up on it is unknown; girths are "
                "for meshes read from an atlas (of a mesh, slice it: mesh.slice(normal).length)"
            )
        girth = body_girth(atlas, self._point(atlas, at))
        points = girth.loop.positions
        line = lines_of(np.concatenate([points, points[:1]]))
        line.field_data["taut"] = [girth.taut]
        return _with_facts(
            line,
            girth.contact,
            girth.error_estimate,
            unit_of(self._mesh),
            "CONVERGED",
            "The section of the smooth surface, along the skin.",
        )

    def plot(self, *paths: pv.PolyData, **options: Any) -> Any:
        """Show the mesh with paths as tubes and their lengths.

        Parameters
        ----------
        *paths : pyvista.PolyData
            From `path` or `girth`.
        **options
            Options of `pyvista.Plotter.show`; ``off_screen`` and ``window_size`` go to the plotter.
        """
        kept = {key: options.pop(key) for key in ("off_screen", "window_size") if key in options}
        plotter: Any = pv.Plotter(**kept)
        self.draw(plotter, *paths)
        atlas = self.atlas
        if atlas is not None:
            # The view is from the front, a little from the left and from above.
            axes = atlas.axes
            view = axes.front_vector + 0.4 * axes.left_vector + 0.15 * axes.up_vector
            plotter.view_vector(tuple(view), viewup=tuple(axes.up_vector))
        return plotter.show(**options)

    def draw(self, plotter: Any, *paths: pv.PolyData) -> None:
        """Add the mesh and paths to a plotter."""
        shown(plotter, self._mesh)
        for path in paths:
            drawn_path(plotter, self._mesh, path)

    def pick(self, plotter: Any) -> list[pv.PolyData]:
        """Let the user click pairs of points in a plotter; each pair is measured and drawn.

        A click with shift adds a point on the way. A press of the button that moves turns the mesh
        as ever. The length stands at the path; its error, the straight distance and what the
        length is worth in the corner.

        Parameters
        ----------
        plotter : pyvista.Plotter
            A plotter that is not shown yet, with the style of interaction that it is to have.

        Returns
        -------
        list of pyvista.PolyData
            The paths, which the list receives as they are measured; their field data have the
            ``straight`` distance, too.
        """
        from bodymeasure.viewer.window.clicks import listen_for_clicks, picked_at

        paths: list[pv.PolyData] = []
        waiting: list[Any] = []
        body = shown(plotter, self._mesh)

        def say(words: str) -> None:
            plotter.add_text(words, name="measure", font_size=9)

        def clicked(x: int, y: int) -> None:
            picker = picked_at(plotter, x, y, body)
            if picker.GetCellId() < 0:
                say("there is no mesh; click on it")
                return
            waiting.append(np.array(picker.GetPickPosition()))
            if len(waiting) < 2 or plotter.iren.interactor.GetShiftKey():
                drawn_start(plotter, self._mesh, waiting)
                say("click where the path is to end, or with shift where it is to pass")
                return
            plotter.remove_actor(START, render=False)
            places = np.array(waiting)
            waiting.clear()
            try:
                path = self.path(places[0], places[-1], list(places[1:-1]))
            except BodymeasureError as failure:
                say(str(failure))
                return
            straight = np.linalg.norm(np.diff(places, axis=0), axis=1).sum()
            path.field_data["straight"] = [straight]
            paths.append(path)
            drawn_path(plotter, self._mesh, path)
            length = length_words(path, "length", ".6g")
            error = length_words(path, "error_estimate", ".1g")
            chord = length_words(path, "straight", ".4g")
            say(f"{length}, error {error}, straight {chord}\n{path.field_data['sentence'][0]}")

        say("click where the path is to start")
        listen_for_clicks(plotter, clicked)
        return paths

    def _point(self, atlas: Atlas, place: MeshPlace) -> AtlasPoint:
        if isinstance(place, int | np.integer) and not isinstance(place, bool):
            count = self._mesh.n_points
            if not 0 <= place < count:
                raise InputError(
                    f"vertex {place} is not there: the mesh's vertices are numbered 0 to "
                    f"{count - 1}"
                )
            u, v = np.asarray(self._mesh.point_data[PARAMETERS], dtype=float)[place].tolist()
            return AtlasPoint(int(self._mesh.point_data[PATCH][place]), u, v)
        # A truth value is no number of a vertex, and is refused here.
        return atlas_point(atlas, place, "the place")  # type: ignore[arg-type]


def _plain(place: MeshPlace) -> Any:
    if isinstance(place, (str, AtlasPoint)):
        raise InputError(
            f"the place is {place!r}, but this mesh remembers no atlas that could have landmarks; "
            "expected a vertex's number or three coordinates"
        )
    return place


def _with_facts(
    line: pv.PolyData, length: float, error: float, unit: str, status: str, sentence: str
) -> pv.PolyData:
    line.field_data["length"] = [length]
    line.field_data["error_estimate"] = [error]
    for name, text in (("unit", unit), ("status", status), ("sentence", sentence)):
        line.field_data[name] = [text]
    return line


# pyvista's entry point imports this module, which registers the accessor.
register: Any = pv.register_dataset_accessor
register("measure", pv.PolyData)(MeasureAccessor)

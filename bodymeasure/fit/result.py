"""A body fitted to a scan."""

from dataclasses import dataclass

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas import Atlas
from bodymeasure.fit.scan import Scan
from bodymeasure.fit.solving.judge import Scores


@dataclass(frozen=True, eq=False)
class FittedBody:
    """A body fitted to a scan, in the scan's pose, as `fit_body` returns it.

    Everything but `transform` is in the atlas's frame: meters, z up, front = -y, the lowest point
    of the scan at z = 0, the pelvis above the origin and facing the front.

    Parameters
    ----------
    atlas : Atlas
        On the samples' layout, with regions and landmarks; its `scan` says how well it follows.
    vertices : ndarray, shape (13380, 3)
        Control vertices of the quad mesh, whose Catmull-Clark limit the atlas approximates.
    coefficients : ndarray, shape (120,)
        The nearest body of the space of bodies, in standard deviations.
    rotations : ndarray, shape (31, 3)
        Rotation vector of each joint in its parent's frame, radians.
    shift : ndarray, shape (3,)
        How far the pelvis is moved from its place in the space.
    transform : ndarray, shape (4, 4)
        From the file's coordinates, in the file's unit, to the atlas's.
    coverage : ndarray, shape (376,)
        Share of each patch that has scan within 12 mm.
    uncovered : ndarray of int, shape (k,)
        Patches of which the scan shows less than half.
    distance : ndarray, shape (13380,)
        Signed distance of the vertices' limit positions from the scan, positive outside; NaN where
        there is none within 12 mm. Zero for a body that was mapped from its control mesh, whose
        surface it has; `coverage` is 1 then.
    scores : Scores
    picked : tuple of str
        Landmarks that the user picked; the others are carried.
    scan : Scan
        The cleaned scan.
    warnings : tuple of str
        What a user should know before relying on a number, in sentences.
    """

    atlas: Atlas
    vertices: Array
    coefficients: Array
    rotations: Array
    shift: Array
    transform: Array
    coverage: Array
    uncovered: Ints
    distance: Array
    scores: Scores
    picked: tuple[str, ...]
    scan: Scan
    warnings: tuple[str, ...]

    def __repr__(self) -> str:
        return (
            f"<FittedBody {self.atlas.name!r}, {self.scores.covered:.1%} covered, "
            f"{self.scores.rms * 1e3:.2f} mm RMS>"
        )

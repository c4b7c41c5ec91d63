"""The atlas: a body's surface as Bezier patches that share control points."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Self

import numpy as np
from numpy.typing import ArrayLike

from bodymeasure._typing import Array, Ints
from bodymeasure.atlas.approximation import Approximation
from bodymeasure.atlas.axes import Axes
from bodymeasure.atlas.contents import check_names, checked_index, checked_points, checked_weights
from bodymeasure.atlas.faces import FileFaces
from bodymeasure.atlas.point import AtlasPoint
from bodymeasure.atlas.scan_fit import ScanFit
from bodymeasure.atlas.tessellation import tessellate
from bodymeasure.atlas.units import GivenLength, Unit
from bodymeasure.bezier import evaluate, homogeneous, project
from bodymeasure.errors import InputError
from bodymeasure.wording import counted, hint

if TYPE_CHECKING:
    from trimesh import Trimesh


@dataclass(frozen=True, eq=False)
class Atlas:
    """A body's surface as Bezier patches that share control points by index.

    They are bicubic as a rule; all may be of one higher degree, or rational.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        Control points, in `unit`.
    index : array_like of int, shape (patches, degree + 1, degree + 1)
        Numbers of each patch's control points; axis 1 runs with u, axis 2 with v. Neighboring
        patches that share an edge share its numbers. The degree is from 3 to 9; `elevate` raises
        lower ones.
    unit : Unit or str
        Unit of the control points.
    patch_names : sequence of str, optional
        One unique name a patch; ``patch 0``, ``patch 1``, ... if not given.
    regions : sequence of str, optional
        Body region of each patch, for tables; empty strings if not given.
    landmarks : mapping of str to AtlasPoint
    axes : Axes
    name : str
        What the atlas shows, for titles.
    provenance : mapping of str to str
        Where it comes from: source, author, license and the like.
    weights : array_like, shape (patches, degree + 1, degree + 1), optional
        Positive weights of each patch's control points, with which patches are rational. Along an
        edge that two patches share, the weights of one are a multiple of the other's.
    approximation : Approximation, optional
        What the patches approximate, and how well, if they are not the surface itself.
    faces : FileFaces, optional
        The faces of the file that the atlas was read from, for `parameters`.
    scan : ScanFit, optional
        How well the atlas follows the scan that it was fitted to, if it was.
    given : mapping of str to GivenLength, optional
        Lengths of the body that the atlas does not show, as a head girth where it ends at the neck,
        by the keys of measurements. A chart takes them where it cannot measure.

    Raises
    ------
    InputError
        If a shape, a value, a number or a name is not what is said above; the message names it.
        Whether the geometry is sound, `bodymeasure.check_atlas` checks.
    """

    points: Array
    index: Ints
    unit: Unit
    patch_names: tuple[str, ...] = ()
    regions: tuple[str, ...] = ()
    landmarks: Mapping[str, AtlasPoint] = field(default_factory=dict)
    axes: Axes = field(default_factory=Axes)
    name: str = ""
    provenance: Mapping[str, str] = field(default_factory=dict)
    weights: Array | None = None
    approximation: Approximation | None = None
    faces: FileFaces | None = None
    scan: ScanFit | None = None
    given: Mapping[str, GivenLength] = field(default_factory=dict)

    def __repr__(self) -> str:
        patches = counted(len(self), "patch", "patches")
        landmarks = counted(len(self.landmarks), "landmark")
        return f"<Atlas {self.name!r} of {patches} in {self.unit}, {landmarks}>"

    def __post_init__(self) -> None:
        index = checked_index(self.index)
        points = checked_points(self.points, index, tuple(self.patch_names))
        set_field = object.__setattr__
        set_field(self, "points", points)
        set_field(self, "index", index)
        if self.weights is not None:
            set_field(self, "weights", checked_weights(self.weights, index))
        set_field(self, "unit", Unit.parse(self.unit))
        count = len(index)
        set_field(
            self,
            "patch_names",
            tuple(self.patch_names) or tuple(f"patch {i}" for i in range(count)),
        )
        set_field(self, "regions", tuple(self.regions) or ("",) * count)
        set_field(self, "landmarks", dict(self.landmarks))
        set_field(self, "provenance", dict(self.provenance))
        set_field(self, "given", dict(self.given))
        check_names(count, self.patch_names, self.regions, self.landmarks)
        if self.approximation is not None and len(self.approximation.distance) != count:
            raise InputError(
                f"the approximation has {len(self.approximation.distance)} numbers for {count} "
                "patches; expected one each"
            )
        if self.faces is not None and len(self.faces.names) != count:
            raise InputError(
                f"there are {len(self.faces.names)} names of faces for {count} patches; expected "
                "one each"
            )
        if self.scan is not None and len(self.scan.coverage) != count:
            raise InputError(
                f"the fit to a scan has {len(self.scan.coverage)} numbers for {count} patches; "
                "expected one each"
            )

    @classmethod
    def from_control_points(cls, control_points: ArrayLike, unit: Unit | str) -> Self:
        """An atlas of patches that are not joined to one another.

        Parameters
        ----------
        control_points : array_like, shape (4, 4, 3) or (patches, 4, 4, 3)
            The degree may be higher; control points of rational patches have four coordinates.
        unit : Unit or str
        """
        try:
            nets = np.asarray(control_points, dtype=np.float64)
        except (TypeError, ValueError):
            raise InputError(
                "control points are not numbers; expected (4, 4, 3) or (patches, 4, 4, 3)"
            ) from None
        if (
            nets.ndim not in (3, 4)
            or nets.shape[-3] != nets.shape[-2]
            or nets.shape[-1] not in (3, 4)
        ):
            raise InputError(
                f"control points have shape {nets.shape}; expected (4, 4, 3) or (patches, 4, 4, 3)"
            )
        count = int(np.prod(nets.shape[:-1]))
        index = np.arange(count).reshape(-1, *nets.shape[-3:-1])
        weights = None
        if nets.shape[-1] == 4:
            weights = checked_weights(nets[..., 3].reshape(index.shape), index)
        return cls(project(nets).reshape(-1, 3), index, Unit.parse(unit), weights=weights)

    def __len__(self) -> int:
        return len(self.index)

    @cached_property
    def control_points(self) -> Array:
        """Control points of every patch, shape (patches, degree + 1, degree + 1, 3); read-only.

        Those of rational patches are in the four homogeneous coordinates; the weights of each patch
        are multiplied by a power of 2, so that the largest is from 1/2 to 1.
        """
        control_points = self.points[self.index]
        if self.weights is not None:
            # A common factor cancels. Products of weights of any size would overflow.
            _, exponent = np.frexp(self.weights.max(axis=(1, 2), keepdims=True))
            control_points = homogeneous(control_points, np.ldexp(self.weights, -exponent))
        control_points.flags.writeable = False
        return control_points

    @property
    def degree(self) -> int:
        """The degree of the patches, in u and in v."""
        return int(self.index.shape[1]) - 1

    @property
    def is_rational(self) -> bool:
        """Whether control points have weights."""
        return self.weights is not None

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the geometry and its unit, in hexadecimal: equal if all lengths are."""
        parts = (
            self.unit.value.encode(),
            np.ascontiguousarray(self.control_points, dtype="<f8").tobytes(),
        )
        return hashlib.sha256(b"\0".join(parts)).hexdigest()

    def patch_number(self, name: str) -> int:
        """Number of the patch of that name.

        Raises
        ------
        InputError
            If there is none.
        """
        try:
            return self.patch_names.index(name)
        except ValueError:
            raise InputError(
                f"the atlas has no patch named {name!r}; {hint(name, self.patch_names)}"
            ) from None

    def position(self, point: AtlasPoint | str) -> Array:
        """Position of a point of the atlas, or of a landmark by its name, in the atlas's unit.

        Its shape is (3,).

        Raises
        ------
        InputError
            If there is no landmark of that name; the message suggests the nearest one.

        Examples
        --------
        >>> import bodymeasure as bm
        >>> bm.load_sample("female_average").position("back neck point").round(3).tolist()
        [0.0, 0.024, 1.367]
        """
        point = self.landmark(point) if isinstance(point, str) else point
        return evaluate(self.control_points[point.patch], (point.u, point.v))

    def parameters(self, face: str, s: float, t: float) -> AtlasPoint:
        r"""Return the point at the parameters (s, t) of a face of the file that was read.

        Parameters
        ----------
        face : str
            The name that notes and errors on the file have for it: ``face 3`` of a STEP or IGES
            file or of a mesh, counted from 1; ``line 7``, in which a surface of an OBJ file
            begins; ``object 0`` or ``object 2, face 1`` of a Rhino file, and ``surface 0`` of
            geomdl's JSON, with their names. `faces` lists them.
        s, t : float
            On a NURBS surface, its own parameters, in the range of its knots. On a quad of a mesh
            they run from 0 to 1: s from its first vertex to its second, t from its first to its
            last. Another polygon has parameters at each of its corners, as ``face 3 corner 1``: s
            runs from 0 at the corner to 1 at the middle of the side to the next, t to the middle
            of the side to the last, and (1, 1) is the middle of the face.

        Returns
        -------
        AtlasPoint
            On a side that patches share, it is on the first of them.

        Raises
        ------
        InputError
            If the atlas was not read from such a file, it has no such face, the face has no
            parameters (it is left out, or its surface is of a kind that is converted, as a
            sphere), or (s, t) is outside its range.

        Examples
        --------
        >>> from pathlib import Path
        >>> from tempfile import TemporaryDirectory
        >>> import bodymeasure as bm
        >>> with TemporaryDirectory() as folder:
        ...     file = Path(folder, "square.obj")
        ...     _ = file.write_text(
        ...         "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\ncstype bezier\ndeg 1\n"
        ...         "surf 0 10 0 1 1 2 3 4\nparm u 0 10\nparm v 0 1\nend\n"
        ...     )
        ...     atlas = bm.read_atlas(file, unit="m")
        >>> atlas.parameters("line 7", 2.5, 0.5)
        AtlasPoint(patch=0, u=0.25, v=0.5)
        """
        if self.faces is None:
            raise InputError(
                "the atlas has no faces with parameters of their own, which are read from NURBS "
                "surfaces and meshes (STEP, IGES, 3dm, OBJ, geomdl's JSON) and kept in .atlas and "
                ".npz files; expected such a file, or name the place by AtlasPoint(patch, u, v)"
            )
        return self.faces.point(face, s, t)

    def landmark(self, name: str) -> AtlasPoint:
        """The landmark of a name.

        Raises
        ------
        InputError
            If there is none; the message suggests the nearest name.
        """
        if name in self.landmarks:
            return self.landmarks[name]
        if not self.landmarks:
            raise InputError(
                f"the atlas has no landmark {name!r}, nor any other; add it, or give a position"
            )
        meant = hint(name, sorted(self.landmarks), expected="it has")
        raise InputError(f"the atlas has no landmark {name!r}; {meant}")

    def to_trimesh(self, segments: int = 8) -> "Trimesh":
        """A mesh of the atlas as a `trimesh.Trimesh`, with vertex attributes ``patch``, u and v.

        Parameters
        ----------
        segments : int
            Steps along a patch's side; see `tessellate`.

        Raises
        ------
        MissingExtraError
            If trimesh is not installed.
        """
        return tessellate(self, segments).to_trimesh()

    def converted(self, unit: Unit | str) -> Self:
        """The same atlas in another unit."""
        target = Unit.parse(unit)
        factor = self.unit.meters / target.meters
        given = {key: length.scaled(factor) for key, length in self.given.items()}
        return replace(self, points=self.points * factor, unit=target, given=given)

    def turned(self, axes: Axes) -> Self:
        """The same body with its coordinates turned into other axes.

        Examples
        --------
        >>> import bodymeasure as bm
        >>> body = bm.load_sample("female_average")
        >>> lying = body.turned(bm.Axes(up="+y", front="+z"))
        >>> top = body.landmarks["back neck point"]
        >>> bool(abs(body.position(top)[2] - lying.position(top)[1]) < 1e-15)
        True
        """
        old, new = (
            np.stack([each.up_vector, each.front_vector, each.left_vector])
            for each in (self.axes, axes)
        )
        return replace(self, points=self.points @ old.T @ new, axes=axes)


def require_atlas(value: object) -> None:
    """Raise an InputError unless a value is an atlas; the name of a sample, say, is none."""
    if not isinstance(value, Atlas):
        raise InputError(
            f"the atlas is {value!r}; expected an Atlas, as load_sample and read_atlas return it"
        )

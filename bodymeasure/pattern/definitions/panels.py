"""Sets of panels, as they stand in files that users read, copy and change."""

from typing import Final, Literal

import msgspec

from bodymeasure.chart import LandmarkRule
from bodymeasure.wording import counted

FORMAT: Final = "bodymeasure pattern"
VERSION: Final = 1

Laid = Literal["front", "level", "median"]


class Edge(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """An edge of a panel: a curve on the skin through landmarks.

    Parameters
    ----------
    name : str
    kind : {"geodesic", "section", "curve"}
        The shortest path along the skin, a part of a plane section, or a smooth curve.
    through : tuple of str
        Landmarks: the start, those on the way (of a geodesic or a curve), and the end.
    plane : tuple of two or three str or {"front", "level", "median"}, optional
        Of a section: three landmarks of the plane; or one that holds both ends and runs to the
        front, or as level as it can, or upright, or as square as it can to the way between two
        landmarks.
    via : str
        Of a section: the landmark near which it passes, of both ways round; the shorter way if
        not given.
    seam : str
        The seam to which the edge is sewn: edges of one seam through the same landmarks are one
        curve, and an edge may be sewn to several that lead from one of its ends to the other.
    ease : float
        By how much it is longer than its curve, in meters: what is eased or gathered into the seam.
    allowance : float, optional
        What is added to it outside, in meters; that of the panel if not given, and none at a fold.
    notches : tuple of float, optional
        Where it is notched, as parts of its length from its start; at the middle if not given and
        the edge is sewn.
    notch : {"single", "double"}, optional
        How it is notched; as the panel says if not given.
    """

    name: str
    kind: Literal["geodesic", "section", "curve"]
    through: tuple[str, ...]
    plane: tuple[str, ...] | Laid | None = None
    via: str = ""
    seam: str = ""
    ease: float = 0.0
    allowance: float | None = None
    notches: tuple[float, ...] | None = None
    notch: Literal["single", "double"] | None = None


class Dart(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A dart: a cut from an edge into the panel, which opens when the panel lies flat.

    Parameters
    ----------
    name : str
    edge : str
        The edge on which it begins.
    foot : str
        The landmark next to which it begins; or
    at : float
        the part of the edge's length at which it does, from 0 to 1.
    tip : str
        The landmark to which it leads; or
    towards : str
        the edge to whose middle it does.
    short : float
        How far before that it ends, in meters; or
    length : float
        how long it is, in meters.
    legs : {"straight", "shaped"}
    drill : float
        How far before the tip a hole marks it, in meters, so that the stitching covers the hole.
    """

    name: str
    edge: str
    foot: str = ""
    at: float | None = None
    tip: str = ""
    towards: str = ""
    short: float = 0.0
    length: float | None = None
    legs: Literal["straight", "shaped"] = "straight"
    drill: float = 0.01


class Extend(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Paper that is added beyond an edge, where the skin is no guide, as below the hip of a skirt.

    Parameters
    ----------
    edge : str
        The edge, which moves to the far end of the paper.
    length : float
        Along the grain, in meters.
    flare : float
        By how much the piece is wider at the far end, in meters, on each side but a fold.
    """

    edge: str
    length: float
    flare: float = 0.0


class Panel(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A panel: the part of the skin inside its edges.

    Parameters
    ----------
    name : str
    inside : str or tuple of (str, str)
        A landmark inside, or two between which a place halfway along the skin is inside.
    edge : tuple of Edge
        In order round the panel; each begins where the one before it ends.
    dart : tuple of Dart
    fold : str
        The edge that becomes the straight fold of a piece that is cut double.
    grain : str
        The edge whose ends lie along the grain, up the page; the fold if not given.
    cut : str
        How often the piece is cut, for its label.
    words : str
    allowance : float, optional
        What is added outside its edges, in meters, unless they say otherwise; if not given, what
        the user asks for.
    notch : {"single", "double"}
        How its edges are notched: by custom once in front, twice behind.
    extend : Extend, optional
        Paper beyond an edge.
    """

    name: str
    inside: str | tuple[str, str]
    edge: tuple[Edge, ...]
    dart: tuple[Dart, ...] = ()
    fold: str = ""
    grain: str = ""
    cut: str = ""
    words: str = ""
    allowance: float | None = None
    notch: Literal["single", "double"] = "single"
    extend: Extend | None = None


class PatternDefinitions(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A set of panels.

    Parameters
    ----------
    name : str
        The set's name, for titles.
    format : str
        ``bodymeasure pattern``; a file has to say so.
    version : int
        The version of the format, 1; a file has to say so.
    words : str
    extends : str
        The name of a set that comes along: its panels are there, too, and a panel here takes the
        place of the one with its name. Once read, this is empty.
    drop : tuple of str
        Names of panels that are left out of what is extended.
    panel : tuple of Panel
    ease : dict of str to float
        By how much girths of the garment are wider than those of the body, in meters, by the
        landmarks at whose levels they are, or ``neck``, ``bust``, ``waist`` and ``hip``.
    bridge : bool
        Whether the cloth bridges hollows inside of the panels, rather than follow the skin.
    landmark : tuple of LandmarkRule
        Rules for landmarks that neither bodies nor the default set of charts have, by the same
        rules as there.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> bm.load_pattern("bodice")
    <PatternDefinitions 'Fitted bodice': 2 panels>
    """

    format: str = FORMAT
    version: int = VERSION
    name: str
    words: str = ""
    extends: str = ""
    drop: tuple[str, ...] = ()
    panel: tuple[Panel, ...] = ()
    ease: dict[str, float] = {}
    bridge: bool = False
    landmark: tuple[LandmarkRule, ...] = ()

    def __repr__(self) -> str:
        return f"<PatternDefinitions {self.name!r}: {counted(len(self.panel), 'panel')}>"

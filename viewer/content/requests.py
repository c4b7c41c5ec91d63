"""What a page may ask, each as a structure: the only place that parses what comes from outside."""

from typing import Annotated, Any, Literal, TypeVar

import msgspec

from bodymeasure.atlas import AtlasPoint
from bodymeasure.errors import InputError

# More points than anybody clicks for one tape, and names than a chart has landmarks.
MOST_POINTS = 50
MOST_LANDMARKS = 1_000
MOST_TAPES = 1_000
MOST_LETTERS = 200

Text = Annotated[str, msgspec.Meta(max_length=MOST_LETTERS)]
Parameter = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Number = Annotated[int, msgspec.Meta(ge=0, le=2**53)]
Place = tuple[Number, Parameter, Parameter]
"""A point of an atlas: the number of a patch, and (u, v) on it."""
# A limit on a text's length beside a tuple would be taken for one on both.
Spot = Place | str
"""A point of an atlas, or the name of a landmark."""
Unit = Literal["m", "cm", "mm", "inch"]


class Request(
    msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True, tag_field="request"
):
    """A request about one body.

    Parameters
    ----------
    body : str
        The body's id.
    """

    body: Text = "0"


class ShowBody(Request, frozen=True, kw_only=True, tag="body"):
    """Ask for the surface, the seams and the landmarks."""


class ShowLayer(Request, frozen=True, kw_only=True, tag="layer"):
    """Ask for lines over the body; of diagonals, `compare` asks for the mesh's lengths, too."""

    name: Literal["nets", "diagonals", "boundary"]
    compare: bool = False
    tab: Text = ""


class ShowQuantity(Request, frozen=True, kw_only=True, tag="quantity"):
    """Ask for numbers by which the body is colored; `other` is the body to compare with."""

    key: Literal["gaussian", "mean", "seam_angle", "distance"]
    other: Text = ""


class Ask(Request, frozen=True, kw_only=True):
    """A request of which only the newest of a tab counts.

    Parameters
    ----------
    tab : str
        The tab's own name.
    serial : int
        A number that grows in the tab.
    """

    tab: Text = ""
    serial: Number = 0


class MeasurePath(Ask, frozen=True, kw_only=True, tag="path"):
    """Ask for the geodesic through two points or more, or for the tape drawn taut."""

    locations: Annotated[tuple[Spot, ...], msgspec.Meta(min_length=2, max_length=MOST_POINTS)]
    kind: Literal["contact", "taut"] = "contact"


class MeasureGirth(Ask, frozen=True, kw_only=True, tag="girth"):
    """Ask for the horizontal girth at the height of a point."""

    location: Spot
    kind: Literal["contact", "taut"] = "taut"


class MeasureClosed(Ask, frozen=True, kw_only=True, tag="closed"):
    """Ask for the closed geodesic to which the horizontal loop at a point contracts."""

    location: Spot


class MeasureOnMesh(Request, frozen=True, kw_only=True, tag="mesh"):
    """Ask for the lengths of paths over triangles, to compare them with those over patches."""

    tapes: Annotated[
        tuple[
            Annotated[tuple[Place, ...], msgspec.Meta(min_length=2, max_length=MOST_POINTS)], ...
        ],
        msgspec.Meta(max_length=MOST_TAPES),
    ]
    tab: Text = ""


class FindPoint(Request, frozen=True, kw_only=True, tag="point"):
    """Ask for the place of the smooth surface at a point."""

    location: Spot


class FindMirror(Request, frozen=True, kw_only=True, tag="mirror"):
    """Ask for the point on the other side of the body."""

    location: Spot


Places = Annotated[dict[Text, Place], msgspec.Meta(max_length=MOST_LANDMARKS)]
Changes = Annotated[dict[Text, Place | None], msgspec.Meta(max_length=MOST_LANDMARKS)]


class MeasureChart(Request, frozen=True, kw_only=True, tag="chart"):
    """Ask for the measurements of a set, on the body with some landmarks put or moved.

    Parameters
    ----------
    set : str
        The key of one of the body's sets.
    landmarks : dict of str to Place or None, optional
        Landmarks that are put in place of the body's own; None takes one off.
    tab : str
        The tab that is told of the progress.
    """

    set: Text = "default"
    landmarks: Changes | None = None
    tab: Text = ""


class Export(MeasureChart, frozen=True, kw_only=True, tag="export"):
    """Ask for the measurements of a set as a file."""

    format: Literal["csv", "json", "smis", "freesewing", "garmentcode"]
    unit: Unit = "cm"


class SaveLandmarks(Request, frozen=True, kw_only=True, tag="landmarks"):
    """Ask for landmarks to be saved: as a file of picks, as an atlas, or into the file itself."""

    landmarks: Changes
    to: Literal["picks", "atlas", "file"]


class OpenFile(Request, frozen=True, kw_only=True, tag="open"):
    """Ask for a file to be opened beside the bodies that are open.

    Parameters
    ----------
    name : str
        The file's name, of which the extension says what it holds.
    content : bytes
    unit : str, optional
        The unit of its coordinates, where the format has none.
    """

    name: Text
    content: bytes
    unit: Unit | None = None


class Stop(Request, frozen=True, kw_only=True, tag="stop"):
    """Ask for what a tab has asked for and takes long to be stopped; only the server knows it."""

    tab: Text


class ReadAgain(Request, frozen=True, kw_only=True, tag="again"):
    """Ask for a body's own file to be read again; only the server asks this."""


AnyRequest = (
    ShowBody
    | ShowLayer
    | ShowQuantity
    | MeasurePath
    | MeasureGirth
    | MeasureClosed
    | MeasureOnMesh
    | FindPoint
    | FindMirror
    | MeasureChart
    | Export
    | SaveLandmarks
    | OpenFile
)
"""What a page may ask; JSON says which it is by the member ``request``."""

Kind = TypeVar("Kind", bound=Request)


def parsed(content: bytes, kind: type[Kind], *, body: str | None = None) -> Kind:
    """Return the request in some JSON, about a body that is named beside it.

    Raises
    ------
    InputError
        If it is not one of that kind; the message says where and what was expected.
    """
    try:
        request = msgspec.json.decode(content, type=kind)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise InputError(f"the request is not understood: {_sentence(error)}") from None
    return request if body is None else msgspec.structs.replace(request, body=body)


def converted(content: dict[str, Any], kind: type[Kind]) -> Kind:
    """Return the request of some members whose values may be texts, as those of an address are.

    Raises
    ------
    InputError
        As `parsed`.
    """
    try:
        return msgspec.convert(content, type=kind, strict=False)
    except msgspec.ValidationError as error:
        raise InputError(f"the request is not understood: {_sentence(error)}") from None


def parsed_message(content: bytes) -> Request:
    """Return the request in some JSON that says itself which it is.

    Raises
    ------
    InputError
        As `parsed`.
    """
    try:
        request: Request = msgspec.json.decode(content, type=AnyRequest)
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise InputError(f"the request is not understood: {_sentence(error)}") from None
    return request


def place_of(spot: Spot) -> str | AtlasPoint:
    """Return what the library takes for a point or the name of a landmark."""
    return spot if isinstance(spot, str) else AtlasPoint(*spot)


def _sentence(error: Exception) -> str:
    text = str(error).replace("`", "'")
    return f"{text[:1].lower()}{text[1:]}"

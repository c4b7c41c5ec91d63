"""`bodymeasure view --report`: what `report` and `chart` have written, with its body."""

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import msgspec
import numpy as np

from bodymeasure._typing import Array
from bodymeasure.cli.options import DEFAULT_SAMPLE
from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes
from bodymeasure.samples import load_sample, sample_names

if TYPE_CHECKING:
    from bodymeasure.atlas import Atlas
    from bodymeasure.chart import Definitions
    from bodymeasure.report.body import ChartDocument
    from bodymeasure.report.patches.records import Document

MEASUREMENTS = "measurements.json"
# The name by which the page knows the measurements of a chart that was asked for some of them.
PRESET = "report"


class Finished(NamedTuple):
    """What a folder of a report or a chart holds.

    Parameters
    ----------
    folder : Path
    digest : str
        That of the body's atlas.
    document : Document or ChartDocument
    """

    folder: Path
    digest: str
    document: "Document | ChartDocument"


def finished(folder: Path) -> Finished:
    """Return what `bodymeasure report` or `bodymeasure chart` has written into a folder.

    Raises
    ------
    InputError
        If it is no such folder.
    """
    # Slow imports, which a page without a report does not need.
    from bodymeasure.report.body import ChartDocument
    from bodymeasure.report.patches.records import Document

    path = folder / MEASUREMENTS if folder.is_dir() else folder
    content = read_bytes(path)
    try:
        found = msgspec.json.decode(content, type=_Head)
        kind = {"bodymeasure chart": ChartDocument, "bodymeasure measurements": Document}.get(
            found.schema
        )
        if kind is None:
            raise InputError(
                f"{path}: has the schema {found.schema!r}; expected the measurements.json that "
                "`bodymeasure report -o` or `bodymeasure chart -o` of one body has written"
            )
        document = msgspec.json.decode(content, type=kind)
    except msgspec.DecodeError as error:
        raise InputError(
            f"{path}: is not the measurements.json of a report or a chart ({error}); make it "
            "again with `bodymeasure report -o` or `bodymeasure chart -o`"
        ) from None
    return Finished(path.parent, document.atlas_digest, document)


class _Head(msgspec.Struct):
    """What kind of file it is; the other members are left out."""

    schema: str = ""


def atlas_of(report: Finished) -> str:
    """Return the name of the body of a report: an atlas in its folder, or a sample.

    Raises
    ------
    InputError
        If it is neither.
    """
    found = sorted(report.folder.glob("*.atlas"))
    if len(found) == 1:
        return str(found[0])
    names = sample_names()
    for name in sorted(names, key=lambda name: name != DEFAULT_SAMPLE):
        if load_sample(name).digest == report.digest:
            return name
    raise InputError(
        f"{report.folder}: holds no atlas, and is about no sample; name the atlas that was "
        f"measured ({report.document.name or 'without a name'}) before --report"
    )


def require_same(report: Finished, atlas: "Atlas", name: str) -> None:
    """Refuse a body that is not the one that was measured.

    Raises
    ------
    InputError
        If it is another, or has changed since.
    """
    if atlas.digest != report.digest:
        raise InputError(
            f"{report.folder}: is about {report.document.name or 'another body'}, not about "
            f"{name}, or that has changed since; name the atlas that was measured, or measure it "
            "again"
        )


def differences_of(report: Finished, patches: int) -> Array | None:
    """Return the relative differences of the diagonals from the mesh, (patches, 2), if known."""
    from bodymeasure.report.patches.records import Document

    if not isinstance(report.document, Document):
        return None
    differences = np.full((patches, 2), np.nan)
    for record in report.document.measurements:
        if record.kind == "diagonal" and record.relative_difference is not None:
            # The first diagonal begins at (0, 0), the second one at (1, 0).
            differences[record.patch_number, int(record.start[0])] = record.relative_difference
    return differences if np.isfinite(differences).any() else None


def set_of(report: Finished, definitions: "Definitions") -> "tuple[Definitions, str | None] | None":
    """Return the definitions of a chart, and the preset of them that it was asked for.

    None if it is no chart.

    Raises
    ------
    InputError
        If the chart was taken by other definitions.
    """
    from bodymeasure.chart import selected_keys
    from bodymeasure.report.body import ChartDocument

    document = report.document
    if not isinstance(document, ChartDocument):
        return None
    if document.definitions != definitions.name:
        raise InputError(
            f"{report.folder}: its chart was taken by the set {document.definitions!r}, not by "
            f"{definitions.name!r}; give that set's file with --set"
        )
    if not document.only:
        return definitions, None
    keys = tuple(selected_keys(definitions, document.only))
    presets = {**definitions.presets, PRESET: keys}
    return msgspec.structs.replace(definitions, presets=presets), PRESET

"""`bodymeasure convert`."""

from pathlib import Path

import click
from rich.text import Text

from bodymeasure.atlas import (
    ApproximationKind,
    Atlas,
    Axes,
    Unit,
    approximation_sentences,
    summarize,
)
from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import RESULTS, print_note
from bodymeasure.cli.inputs import load_atlas, path_of_atlas
from bodymeasure.cli.options import atlas_argument
from bodymeasure.errors import InputError
from bodymeasure.files import require_writable
from bodymeasure.formats import FORMATS, format_of, write_atlas
from bodymeasure.wording import counted

# A mesh whose lengths its smooth surface shortens by more than this part may be meant otherwise.
SHRUNK = 1e-3


@click.command(epilog=EXIT_CODES)
@atlas_argument
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE",
    required=True,
    help="File to write; its extension determines the format.",
)
@click.option(
    "--unit",
    type=click.Choice([unit.value for unit in Unit]),
    help="Unit of the coordinates that are written.  [default: that of ATLAS]",
)
@click.option(
    "--upright",
    is_flag=True,
    help="Turn the coordinates so that the body stands along +z and looks along -y.",
)
@click.option(
    "--group",
    "groups",
    multiple=True,
    metavar="NAME",
    help="Take only this group (region) of patches; may be given several times.",
)
@click.option(
    "--weld",
    "tolerance",
    type=click.FloatRange(min=0.0),
    metavar="LENGTH",
    help="Join edges of loose patches that are no farther apart than this, in the file's unit.",
)
@click.option(
    "--deviation",
    type=click.FloatRange(min=0.0, min_open=True),
    metavar="LENGTH",
    help="Refine a mesh until its patches lie no farther from its Catmull-Clark surface than this, "
    "in the file's unit; inf does not refine it.",
)
@click.option(
    "--interpolate",
    is_flag=True,
    help="Let the surface of a mesh run through its vertices, rather than smooth them; it "
    "suits meshes whose vertices lie on the body.",
)
@click.option(
    "--from",
    "source_format",
    type=click.Choice(list(FORMATS)),
    help="Format of ATLAS, in place of the one of its extension.",
)
@click.option(
    "--format",
    "target_format",
    type=click.Choice([name for name, form in FORMATS.items() if form.write]),
    help="Format of FILE, in place of the one of its extension.",
)
def convert(
    atlas: str,
    output: Path,
    unit: str | None,
    upright: bool,
    groups: tuple[str, ...],
    tolerance: float | None,
    deviation: float | None,
    interpolate: bool,
    source_format: str | None,
    target_format: str | None,
) -> None:
    """Read ATLAS and write it in another format.

    B-splines become Bezier patches, loose patches are joined, and the quads of a mesh of polygons
    become patches of its Catmull-Clark surface; `bodymeasure docs formats` lists the
    formats.

    --file-unit is the unit of ATLAS's coordinates, --unit that of the coordinates in FILE.

    --up and --front say where up and the front are in ATLAS. They correct the axes that an atlas
    has already; the coordinates stay, unless --upright turns them.
    """
    target = format_of(output, target_format, writing=True)
    require_writable(output)
    source = path_of_atlas(atlas)
    # An approximation that its own file states was made when the mesh was first read.
    from_mesh = "approximation" not in format_of(source, source_format).keeps
    if from_mesh and output.exists() and output.samefile(source):
        raise InputError(f"{output}: is the file to convert, which would be lost; give another one")
    loaded = load_atlas(
        atlas,
        corrected=True,
        group=groups,
        tolerance=tolerance,
        deviation=deviation,
        interpolate=interpolate,
        format=source_format,
    )
    sentences = approximation_sentences(loaded)
    if unit is not None:
        loaded = loaded.converted(unit)
    if upright:
        loaded = loaded.turned(Axes())
    write_atlas(loaded, output, format=target_format)
    summary = summarize(loaded)
    RESULTS.print(
        Text(
            f"{output}: {counted(len(loaded), 'patch', 'patches')}, "
            f"{counted(summary.seams, 'seam')}, {counted(summary.parts, 'part')}, in {loaded.unit}"
        ),
        soft_wrap=True,
    )
    for sentence in sentences:
        RESULTS.print(Text(sentence), soft_wrap=True)
    found = loaded.approximation
    shrunk = (
        found is not None
        and found.kind is ApproximationKind.SMOOTHED
        and found.mesh_lengths > SHRUNK
    )
    if from_mesh and shrunk:
        print_note("--interpolate lets the surface run through the vertices of the mesh instead.")
    lost = _lost(loaded, target.keeps)
    if lost:
        print_note(f"{target.title} cannot hold {', '.join(lost)}; the file lacks these.")


def _lost(atlas: Atlas, keeps: frozenset[str]) -> list[str]:
    """Return what an atlas has that a format does not hold."""
    has_names = any(name != f"patch {i}" for i, name in enumerate(atlas.patch_names))
    there = {
        "unit": (f"its unit ({atlas.unit}) and axes", True),
        "names": ("the names of its patches", has_names),
        "regions": ("its regions", any(atlas.regions)),
        "faces": ("the parameters of the faces of its file", atlas.faces is not None),
        "approximation": (
            "how well its patches approximate their surface",
            atlas.approximation is not None,
        ),
        "scan": ("how well it follows the scan that it was fitted to", atlas.scan is not None),
        "given": (counted(len(atlas.given), "given length"), bool(atlas.given)),
        "landmarks": (counted(len(atlas.landmarks), "landmark"), bool(atlas.landmarks)),
    }
    return [words for what, (words, has) in there.items() if has and what not in keeps]

"""`bodymeasure fit`."""

import time
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.text import Text

from bodymeasure.cli.commands import EXIT_CODES
from bodymeasure.cli.console import print_files, print_note, print_table
from bodymeasure.cli.fitting.batch import Batch, NamedScan, named_scans, print_failures
from bodymeasure.cli.fitting.files import write_fit
from bodymeasure.cli.fitting.scans import fitted, require_fit
from bodymeasure.cli.options import (
    no_pictures_option,
    picks_option,
    several_scans_argument,
    topology_option,
)
from bodymeasure.cli.tables import facts_table, new_table
from bodymeasure.errors import InputError
from bodymeasure.files import output_folder, require_writable

if TYPE_CHECKING:
    from rich.table import Table

    from bodymeasure.atlas import Atlas

EXIT_FAILED = 1
# The number of names that are listed; the page has all.
NAMED = 6


@click.command(epilog=EXIT_CODES)
@several_scans_argument
@picks_option
@topology_option
@click.option(
    "--save-topology",
    "topology_file",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Write the correspondence of the mesh to an .npz file, by which --topology FILE maps all "
    "bodies with the same vertices and faces. Best made from the mean body of a model.",
)
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    metavar="FILE|FOLDER",
    help="The .atlas file to write, or a folder for it; with several meshes, a folder.  "
    "[default: the mesh's name with .atlas, here]",
)
@click.option("--no-page", is_flag=True, help="Leave out the page of each fit.")
@no_pictures_option
def fit(
    meshes: tuple[str, ...],
    picks: Path | None,
    topology_file: Path | None,
    output: Path | None,
    no_page: bool,
    no_pictures: bool,
) -> int:
    """Fit a body to MESH, a triangle mesh in STL, PLY, OBJ, OFF or GLB.

    The result is an atlas with landmarks in the pose of the scan, which all other commands take,
    and a page beside it that shows how well the body follows the scan and where it cannot.
    `bodymeasure chart MESH` does this first by itself.

    --file-unit is needed where the format has no unit. Up and the front are found if not given.

    Several meshes go into a folder, with fits.csv, one row for each. What cannot be fitted is
    listed with the reason; the exit code is 1 then. A second run skips what is done with the same
    input and settings.
    """
    begin = time.perf_counter()
    page, pictures = not no_page, not (no_page or no_pictures)
    require_fit(page=page, pictures=pictures)
    scans = named_scans(meshes)
    if len(scans) > 1:
        if picks is not None:
            raise click.UsageError("--landmarks are the picks of one body; fit it by itself.")
        if topology_file is not None:
            raise click.UsageError("--save-topology takes one body of the model; fit it by itself.")
        return _several(scans, Path() if output is None else output, page, pictures)
    scan = scans[0]
    path = Path(f"{scan.name}.atlas") if output is None else output
    if path.suffix.lower() != ".atlas":
        if path.suffix and not path.is_dir():
            raise InputError(f"{path}: expected a name that ends in .atlas, or a folder")
        path = path / f"{scan.name}.atlas"
    if topology_file is not None:
        check_topology_file(topology_file, scan.path)
    with output_folder(path.parent):
        require_writable(path)
        body = fitted(scan.path, picks)
        if topology_file is not None:
            from bodymeasure.fit import save_topology

            save_topology(topology_file, scan.path, body)
        files = write_fit(body, path, page=page, pictures=pictures)
        if topology_file is not None:
            files = (*files, topology_file)
    print_table(fit_table(body.atlas, time.perf_counter() - begin))
    print_files(files)
    for sentence in body.warnings:
        print_note(sentence)
    return 0


def check_topology_file(path: Path, mesh: Path) -> None:
    """Refuse, before any work, what would fail when the correspondence is written.

    Raises
    ------
    InputError
        If the mesh's format does not number vertices, or the file's name does not end in .npz or it
        is not writable.
    """
    from bodymeasure.fit.topology import read_polygons, require_npz

    require_npz(path)
    require_writable(path)
    read_polygons(mesh)


def _several(scans: list[NamedScan], folder: Path, page: bool, pictures: bool) -> int:
    from bodymeasure.cli.fitting.batch import fits_csv

    with output_folder(folder):
        batch = Batch(folder, page=page, pictures=pictures)
        table = new_table(
            "scan", "distance, mm", "covered", "uncovered", "result", words=("result",)
        )
        for number, scan in enumerate(scans, start=1):
            print_note(f"{number} of {len(scans)}: {scan.path}", style="dim")
            atlas = batch.fit(scan)
            table.add_row(Text(scan.name), *_row(atlas), batch.result(scan.name))
        if not batch.fitted:
            raise InputError("no body could be fitted:" + batch.listed_failures())
        files = fits_csv(batch, folder)
    print_table(table)
    print_files(files)
    print_failures(batch)
    return EXIT_FAILED if batch.failures else 0


def _row(atlas: "Atlas | None") -> tuple[str, str, str]:
    scan = None if atlas is None else atlas.scan
    if scan is None:
        return "", "", ""
    return (
        f"{1e3 * scan.rms:.2f}",
        f"{100.0 * scan.coverage.mean():.1f} %",
        str(len(scan.uncovered)),
    )


def fit_table(atlas: "Atlas", seconds: float) -> "Table":
    """Return the facts of a fit that a reader wants to know first."""
    scan = atlas.scan
    assert scan is not None
    table = facts_table(atlas.name)
    table.add_row("distance from the scan", f"{1e3 * scan.rms:.2f} mm (root mean square)")
    bare = [atlas.patch_names[patch] for patch in scan.uncovered]
    covered = f"{100.0 * scan.coverage.mean():.1f} % of the body"
    table.add_row("covered by the scan", Text(covered, "yellow" if bare else "green"))
    if bare:
        more = f" and {len(bare) - NAMED} more" if len(bare) > NAMED else ""
        table.add_row("", Text(f"without scan: {', '.join(bare[:NAMED])}{more}", "yellow"))
    counts: dict[str, int] = {}
    for found in scan.landmarks.values():
        counts[found.origin.value] = counts.get(found.origin.value, 0) + 1
    table.add_row("landmarks", ", ".join(f"{count} {how}" for how, count in counts.items()))
    off = [found.uncertainty for found in scan.landmarks.values()]
    if off:
        table.add_row("", f"{1e3 * min(off):.1f} to {1e3 * max(off):.1f} mm uncertain")
    for number, sentence in enumerate(scan.done):
        table.add_row("" if number else "done", Text(sentence))
    table.add_row("time", f"{seconds:.1f} s")
    return table

"""The files of a pattern: its page, its drawings, and what programs read."""

from collections.abc import Callable, Iterable
from contextlib import ExitStack
from pathlib import Path

from bodymeasure.arguments import file_path, require_kind
from bodymeasure.errors import InputError
from bodymeasure.files import output_folder, write_all
from bodymeasure.pattern import (
    PAPERS,
    GradedPattern,
    Pattern,
    pattern_dxf,
    pattern_garmentcode,
    pattern_json,
    pattern_pdf,
    pattern_svg,
    strain_svg,
)
from bodymeasure.report.patterns.page import render_pattern
from bodymeasure.threads import one_blas_thread
from bodymeasure.wording import hint

# What can be asked for, and the file that it is.
FORMATS = {
    "html": "pattern.html",
    "svg": "pattern.svg",
    "pdf": "pattern.pdf",
    "dxf": "pattern.dxf",
    "garmentcode": "garmentcode.json",
    "strain": "strain.svg",
    "json": "pattern.json",
}


@one_blas_thread()
def write_pattern(
    pattern: Pattern | GradedPattern,
    folder: Path | str,
    *,
    formats: Iterable[str] | None = None,
    allowance: float = 10.0,
    paper: str = "a4",
    pictures: bool = True,
) -> tuple[Path, ...]:
    """Write the files of a pattern: a page, drawings to cut by, and what programs read.

    All files are computed before the first is written, and all are written or none.

    Parameters
    ----------
    pattern : Pattern or GradedPattern
        Of several sizes, the files of each go into a folder in `folder` by the size's name, and the
        drawings in `folder` itself have all sizes over each other.
    folder : Path or str
        Made if it is not there; files of these names in it are replaced.
    formats : iterable of str, optional
        Which files: ``html``, ``svg``, ``pdf``, ``dxf``, ``garmentcode``, ``strain`` and ``json``;
        all of them if not given.
    allowance : float
        Of seams, in millimeters, where their panels do not say otherwise.
    paper : {"a4", "letter", "a0"}
        That of the PDF file.
    pictures : bool
        Whether the page shows the panels on the body.

    Returns
    -------
    tuple of Path
        The files.

    Raises
    ------
    InputError
        If a format or a paper is unknown, or a file cannot be written.
    MissingExtraError
        If a package is missing that a format needs.

    Examples
    --------
    >>> import tempfile
    >>> import bodymeasure as bm
    >>> pattern = bm.make_pattern(bm.load_sample("female_average"), "skirt")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     files = bm.write_pattern(pattern, folder, formats=("svg", "dxf"))
    >>> [file.name for file in files]
    ['pattern.svg', 'pattern.dxf']
    """
    if not isinstance(pattern, GradedPattern):
        require_kind(pattern, Pattern, "pattern", "what make_pattern or grade_pattern returns")
    target = file_path(folder, "the folder")
    with ExitStack() as stack:
        for each in _folders(pattern, target):
            stack.enter_context(output_folder(each))
        contents = pattern_files(
            pattern, formats=formats, allowance=allowance, paper=paper, pictures=pictures
        )
        files = {target / name: content for name, content in contents.items()}
        write_all(files)
    return tuple(files)


def _folders(pattern: Pattern | GradedPattern, target: Path) -> tuple[Path, ...]:
    """Return the folders of a pattern: one for each of several sizes is in that of the drawings."""
    sizes = pattern.patterns if isinstance(pattern, GradedPattern) else {}
    for size in sizes:
        if not size or Path(size).name != size:
            raise InputError(f"the size {size!r} cannot name a folder; use letters and digits")
    return target, *(target / size for size in sizes)


def pattern_files(
    pattern: Pattern | GradedPattern,
    *,
    formats: Iterable[str] | None = None,
    allowance: float = 10.0,
    paper: str = "a4",
    pictures: bool = True,
) -> dict[str, bytes]:
    """Return the files of a pattern by their names, as `write_pattern` writes them."""
    wanted = checked_formats(formats)
    if paper not in PAPERS:
        raise InputError(f"no paper is named {paper!r}; {hint(str(paper), PAPERS)}")
    if not isinstance(allowance, int | float) or not 0.0 <= allowance <= 200.0:
        raise InputError(f"allowance is {allowance!r}; expected millimeters, 0 to 200")
    drawn: dict[str, Callable[[Pattern | GradedPattern], bytes]] = {
        "svg": lambda each: pattern_svg(each, allowance=allowance).encode(),
        "pdf": lambda each: pattern_pdf(each, allowance=allowance, paper=paper),
        "dxf": lambda each: pattern_dxf(each, allowance=allowance),
    }
    of_one: dict[str, Callable[[Pattern], bytes]] = {
        **drawn,
        "html": lambda each: _page(each, wanted, allowance, pictures=pictures),
        "garmentcode": pattern_garmentcode,
        "strain": lambda each: strain_svg(each).encode(),
        "json": lambda each: pattern_json(each, allowance=allowance),
    }
    if not isinstance(pattern, GradedPattern):
        return {FORMATS[name]: of_one[name](pattern) for name in wanted}
    found = {FORMATS[name]: drawn[name](pattern) for name in wanted if name in drawn}
    for size, each in pattern.patterns.items():
        found |= {f"{size}/{FORMATS[name]}": of_one[name](each) for name in wanted}
    return found


def checked_formats(formats: Iterable[str] | None) -> tuple[str, ...]:
    """Return the names of formats in the order in which they are written; all of them for None.

    Raises
    ------
    InputError
        If one is unknown.
    """
    names = tuple(FORMATS) if formats is None else tuple(formats)
    for name in names:
        if name not in FORMATS:
            raise InputError(f"no format is named {name!r}; {hint(str(name), tuple(FORMATS))}")
    return tuple(name for name in FORMATS if name in names)


def _page(pattern: Pattern, wanted: tuple[str, ...], allowance: float, *, pictures: bool) -> bytes:
    drawn = None
    if pictures:
        # Slow imports, which a page without pictures does not need.
        from bodymeasure.scene.panels.pictures import panel_pictures

        drawn = panel_pictures(pattern)
    beside = tuple(FORMATS[name] for name in wanted if name != "html")
    return render_pattern(pattern, drawn, allowance=allowance, files=beside)

"""Writing the files of a report, a chart, a reproduction or a benchmark."""

from collections.abc import Mapping
from pathlib import Path

from bodymeasure.arguments import file_path
from bodymeasure.files import make_folder, write_all


def write_files(folder: Path | str, contents: Mapping[str, bytes]) -> tuple[Path, ...]:
    """Write files that belong together into a folder: all of them or none.

    Parameters
    ----------
    folder : Path or str
        Made if it is not there; files of the same names in it are replaced.
    contents : mapping of str to bytes
        The content of each file by its name.

    Returns
    -------
    tuple of Path
        The files, in the order of `contents`.

    Raises
    ------
    InputError
        If the folder cannot be made or written to, or the disk is full.
    """
    folder = file_path(folder, "the folder")
    paths = {folder / name: content for name, content in contents.items()}
    make_folder(folder)
    write_all(paths)
    return tuple(paths)

"""Files of correspondences, ``.npz``: the edges of a topology, and the map from its vertices.

The arrays are `edges`, shape (k, 2); `indptr`, `indices` and `weights`, the rows of a sparse matrix
with a row for each point of our mesh that the map gives; and `header`, a text with everything else
in JSON. Nothing is unpickled, and no coordinates of the model are in it.
"""

import io
from os import PathLike
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

from bodymeasure.arguments import file_path
from bodymeasure.errors import InputError
from bodymeasure.files import read_bytes, write_bytes
from bodymeasure.fit.model import body_model
from bodymeasure.fit.topology.correspondence import Gives, Topology
from bodymeasure.npz_arrays import npz_arrays

FORMAT = "bodymeasure topology"
VERSION = 1
_KINDS = {"header": "U", "edges": "iu", "indptr": "iu", "indices": "iu", "weights": "f"}
# The sums of the rows' weights, which are stored with single precision, are 1 within this.
SUM = 1e-4


class _Header(msgspec.Struct, forbid_unknown_fields=True):
    format: str
    version: int
    name: str
    source: str
    gives: Gives
    count: int
    accuracy: float


def read_topology(path: str | PathLike[str]) -> Topology:
    """Read a correspondence, to map many bodies with it.

    Parameters
    ----------
    path : path-like
        A file that `save_topology` wrote.

    Returns
    -------
    Topology

    Raises
    ------
    InputError
        If the file is missing, damaged or another kind of file.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> import bodymeasure as bm
    >>> from bodymeasure.fit.model import body_model
    >>> mesh = (body_model().mean, body_model().quads)
    >>> fitted = bm.map_body(mesh, "hm08 faces", file_unit="m")
    >>> with TemporaryDirectory() as folder:
    ...     bm.save_topology(Path(folder, "model.npz"), mesh, fitted)
    ...     topology = bm.read_topology(Path(folder, "model.npz"))
    >>> topology.name, topology.count
    ('model', 13380)
    """
    path = file_path(path)
    arrays = npz_arrays(read_bytes(path), str(path), _KINDS)
    try:
        header = msgspec.json.decode(str(arrays["header"][()]).encode(), type=_Header)
    except (msgspec.DecodeError, UnicodeError) as error:
        raise InputError(f"{path}: its header is wrong: {error}") from None
    if (header.format, header.version) != (FORMAT, VERSION):
        raise InputError(
            f"{path}: has format {header.format!r}, version {header.version}; this bodymeasure "
            f"reads {FORMAT!r}, version {VERSION}; make it again with --save-topology"
        )
    fault = _fault(arrays, header.count, _rows(header.gives))
    if fault:
        raise InputError(f"{path}: {fault}; the file is damaged, make it again")
    shape = (_rows(header.gives), header.count)
    weights, indices, indptr = (arrays[name] for name in ("weights", "indices", "indptr"))
    rows = (weights.astype(np.float64), indices.astype(np.int64), indptr.astype(np.int64))
    return Topology(
        header.name,
        arrays["edges"].astype(np.int64),
        csr_matrix(rows, shape=shape),
        header.gives,
        header.source,
        header.accuracy,
    )


def write_topology(path: Path, topology: Topology) -> None:
    """Write a correspondence.

    Raises
    ------
    InputError
        If the name does not end in ``.npz``, or the file cannot be written.
    """
    require_npz(path)
    points = topology.points
    header = _Header(
        format=FORMAT,
        version=VERSION,
        name=topology.name,
        source=topology.source,
        gives=topology.gives,
        count=topology.count,
        accuracy=topology.accuracy,
    )
    buffer = io.BytesIO()
    np.savez_compressed(
        buffer,
        header=np.array(msgspec.json.encode(header).decode()),
        edges=topology.edges.astype(np.uint32),
        indptr=points.indptr.astype(np.uint32),
        indices=points.indices.astype(np.uint32),
        weights=points.data.astype(np.float32),
    )
    write_bytes(path, buffer.getvalue())


def require_npz(path: Path) -> None:
    """Refuse another kind of file than correspondences are written to.

    Raises
    ------
    InputError
        If the name does not end in ``.npz``.
    """
    if path.suffix.lower() != ".npz":
        raise InputError(f"{path}: a topology is written to a file whose name ends in .npz")


def _rows(gives: Gives) -> int:
    """Return how many points of our mesh a map gives."""
    model = body_model()
    return len(model.mean) + (len(model.quads) if gives is Gives.SAMPLES else 0)


def _fault(arrays: dict[str, NDArray[Any]], count: int, rows: int) -> str:
    """Return what is wrong with the arrays, or nothing."""
    edges, indptr, indices = (arrays[name] for name in ("edges", "indptr", "indices"))
    weights = arrays["weights"]
    if edges.ndim != 2 or edges.shape[1] != 2 or not len(edges):
        return f"edges have shape {edges.shape}; expected (k, 2)"
    if indptr.shape != (rows + 1,) or weights.ndim != 1 or indices.shape != weights.shape:
        return (
            f"indptr, indices and weights have shapes {indptr.shape}, {indices.shape} and "
            f"{weights.shape}; expected ({rows + 1},) and twice the same number"
        )
    if indptr[0] != 0 or indptr[-1] != len(weights) or (np.diff(indptr.astype(np.int64)) < 1).any():
        return "the rows of the map do not follow each other"
    if count < 1 or max(int(edges.max()), int(indices.max())) >= count:
        return f"it refers to vertices beyond the {count} that it has"
    if min(int(edges.min()), int(indices.min())) < 0:
        return "it refers to vertices by negative numbers"
    sums = np.add.reduceat(weights.astype(np.float64), indptr[:-1].astype(np.int64))
    if not np.abs(sums - 1.0).max() < SUM:
        return "the weights of a vertex do not add up to 1"
    return ""

"""Messages for a page that is mailed: as exact as what is drawn, and no larger."""

import base64
import gzip

import numpy as np
from bodymeasure.viewer.content.wire import packed, unpacked

from bodymeasure._typing import Array

# The step of coordinates as a part of the body's size: on a body, a sixtieth of a millimeter, far
# below how far the triangles are off the surface. It and that of normals are powers of two, so that
# most digits of the rounded numbers are zeros, of which a packed file takes no notice.
POSITION_STEP = 2.0**-16
NORMAL_STEP = 2.0**-8
# Higher levels of compression take four times as long for a fiftieth of the size.
LEVEL = 6


def compact(message: bytes, size: float) -> str:
    """Return a message with rounded coordinates as text for a page.

    Parameters
    ----------
    message : bytes
        As `bodymeasure.viewer.content.wire.packed` makes it.
    size : float
        Size of the body in the message's unit.

    Returns
    -------
    str
        A gzip file in base64.
    """
    header, arrays = unpacked(message)
    del header["arrays"]
    step = POSITION_STEP * 2.0 ** np.floor(np.log2(size)) if size > 0.0 else POSITION_STEP
    rounded = {
        name: array
        if array.dtype.kind != "f"
        else _rounded(array, NORMAL_STEP if name.endswith("normals") else step)
        for name, array in arrays.items()
    }
    # Without the time, so that the same page is the same file.
    return base64.b64encode(gzip.compress(packed(header, rounded), LEVEL, mtime=0)).decode()


def _rounded(values: Array, step: float) -> Array:
    return np.asarray(step * np.round(values.astype(np.float64) / step))

"""Many small linear systems, of which some may be singular."""

import numpy as np

from bodymeasure._typing import Array


def solved(matrix: Array, right: Array) -> Array:
    """Return the solutions of systems; not numbers where a system is exactly singular.

    Parameters
    ----------
    matrix : ndarray, shape (systems, n, n)
    right : ndarray, shape (systems, n)

    Returns
    -------
    ndarray, shape (systems, n)
    """
    try:
        return np.asarray(np.linalg.solve(matrix, right[..., None])[..., 0])
    except np.linalg.LinAlgError:
        solution = np.full_like(right, np.nan)
    # One singular system stops the others.
    for number, (rows, side) in enumerate(zip(matrix, right, strict=True)):
        try:
            solution[number] = np.linalg.solve(rows, side)
        except np.linalg.LinAlgError:
            continue
    return solution

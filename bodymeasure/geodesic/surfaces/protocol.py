"""What the solver needs of a surface: its derivatives."""

from typing import Protocol

from bodymeasure._typing import Array, Ints

# The derivatives in a jet, in order: (times by u, times by v).
JET = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3))
# The number of derivatives up to each order.
JET_SIZE = (1, 3, 6, 10)


class Surface(Protocol):
    """A batch of surfaces, one for each geodesic problem."""

    def jet(self, parameters: Array, order: int) -> Array:
        """Return the derivatives up to an order of at most 3.

        Parameters
        ----------
        parameters : ndarray, shape (problems, k, 2)
        order : int

        Returns
        -------
        ndarray, shape (derivatives, 3, problems, k)
            The derivatives, in the order of `JET`. The positions may have any origin.
        """

    def positions(self, parameters: Array) -> Array:
        """Return points, shape (problems, k, 3), with any origin."""

    def magnitude(self, parameters: Array) -> Array:
        """Return the size of the terms of S_u and S_v, to which rounding errors are relative.

        Parameters
        ----------
        parameters : ndarray, shape (problems, k, 2)

        Returns
        -------
        ndarray, shape (2, problems, k)
            The size of the terms that are summed, plus that of the change that a rounding of the
            parameters makes.
        """

    def take(self, problems: Ints) -> "Surface":
        """Return the surfaces of some of the problems."""

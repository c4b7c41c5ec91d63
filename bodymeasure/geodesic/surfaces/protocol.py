"""What the solver needs of a surface: its derivatives."""

from typing import Protocol

from bodymeasure._typing import Array, Ints

# Order of the derivatives in a jet: (times by u, times by v).
JET = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3))
# Number of derivatives up to each order.
JET_SIZE = (1, 3, 6, 10)


class Surface(Protocol):
    """A batch of surfaces, one for each geodesic problem."""

    def jet(self, parameters: Array, order: int) -> Array:
        """Derivatives up to an order of at most 3.

        Parameters
        ----------
        parameters : ndarray, shape (problems, k, 2)
        order : int

        Returns
        -------
        ndarray, shape (derivatives, 3, problems, k)
            In the order of `JET`. The origin of the positions is any.
        """

    def positions(self, parameters: Array) -> Array:
        """Points, shape (problems, k, 3). The origin is any."""

    def magnitude(self, parameters: Array) -> Array:
        """The size of what S_u and S_v are calculated from: what rounding errors are relative to.

        Parameters
        ----------
        parameters : ndarray, shape (problems, k, 2)

        Returns
        -------
        ndarray, shape (2, problems, k)
            Of the terms that are summed up, and of the change by a rounding of the parameters
            as a part of that.
        """

    def take(self, problems: Ints) -> "Surface":
        """The surfaces of some of the problems."""

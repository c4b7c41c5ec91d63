"""What lengths may be compared with, apart from the slow imports of what compares them."""

from typing import Literal

Check = Literal["flips", "libigl"]
"""Which distances lengths are compared with: those of edge flips, or libigl's alone."""

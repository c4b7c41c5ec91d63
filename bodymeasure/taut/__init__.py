"""The tape drawn taut over the body."""

from bodymeasure.taut.status import TautStatus
from bodymeasure.taut.tape import TautTape, taut_tape

__all__ = ["TautStatus", "TautTape", "taut_tape"]

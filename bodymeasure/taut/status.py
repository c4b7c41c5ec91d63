"""How a taut tape ended."""

from enum import Enum


class TautStatus(Enum):
    """The outcome for one tape; each value is a sentence that says what to do."""

    CONVERGED = "The tape is taut; its length holds to the stated error."
    WITHOUT_CONTACT = (
        "The tape is taut and its length holds to the stated error, but the path along the skin "
        "has no length that can be trusted, so that the gap is unknown; its own status says why."
    )
    NO_PATH = (
        "No path along the skin was found to draw taut: the points' parts meet in single points "
        "only; join the patches along whole edges."
    )
    INACCURATE = (
        "The tape came to rest, but the estimated error of its length is more than 1e-4 of it, so "
        "that the length, which `raw_length` holds, is not to be trusted; look near the tape with "
        "`bodymeasure check` for folds and sharp kinks, or hold it at a point between."
    )
    NOT_CONVERGED = (
        "The tape did not come to rest; check the atlas near it with `bodymeasure check` for folds "
        "and sharp kinks, or hold it at a point between."
    )

    @property
    def has_length(self) -> bool:
        """Whether there is a length that can be trusted."""
        return self in (TautStatus.CONVERGED, TautStatus.WITHOUT_CONTACT)

    @property
    def sentence(self) -> str:
        """The status in words for the user."""
        return self.value

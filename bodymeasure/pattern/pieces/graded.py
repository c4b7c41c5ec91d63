"""Graded patterns: the same panels on the bodies of several sizes."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from bodymeasure.arguments import require_kind, require_progress, shown
from bodymeasure.atlas import Atlas
from bodymeasure.atlas.atlas import require_atlas
from bodymeasure.errors import InputError
from bodymeasure.pattern.definitions.panels import PatternDefinitions
from bodymeasure.pattern.pieces.make import STEP, checked_definitions, make_pattern
from bodymeasure.pattern.pieces.pattern import Pattern
from bodymeasure.threads import one_blas_thread
from bodymeasure.wording import counted


@dataclass(frozen=True, eq=False)
class GradedPattern:
    """The pieces of one set of panels in several sizes.

    Parameters
    ----------
    definitions : PatternDefinitions
    patterns : dict of str to Pattern
        The pattern of each size, by the size's name, in the order in which they were given.
    """

    definitions: PatternDefinitions
    patterns: dict[str, Pattern]

    @property
    def sizes(self) -> tuple[str, ...]:
        """The names of the sizes."""
        return tuple(self.patterns)

    def __getitem__(self, size: str) -> Pattern:
        """The pattern of a size.

        Raises
        ------
        KeyError
            If there is none.
        """
        return self.patterns[size]

    @property
    def is_sound(self) -> bool:
        """Whether the patterns of all sizes are."""
        return all(each.is_sound for each in self.patterns.values())

    @property
    def warnings(self) -> tuple[str, ...]:
        """What there is to look at, with the names of the sizes."""
        return tuple(
            f"{size}, {words}" for size, each in self.patterns.items() for words in each.warnings
        )

    def __repr__(self) -> str:
        pieces = counted(len(self.definitions.panel), "piece")
        sizes = counted(len(self.patterns), "size")
        return f"<GradedPattern {self.definitions.name!r}: {pieces} in {sizes}>"


@one_blas_thread()
def grade_pattern(
    bodies: Mapping[str, Atlas],
    definitions: PatternDefinitions | str | Path = "bodice",
    *,
    ease: Mapping[str, float] | None = None,
    bridge: bool | None = None,
    step: float = STEP,
    progress: Callable[[int, int], None] | None = None,
) -> GradedPattern:
    """Make the flat pieces of one set of panels on the bodies of several sizes.

    No rule moves points from size to size: each size is cut on its own body, whatever its layout of
    patches, as long as it has the landmarks that the panels name. So each fits as the first one
    does.

    Parameters
    ----------
    bodies : mapping of str to Atlas
        The body of each size, by the size's name.
    definitions : PatternDefinitions, str or Path
        What `load_pattern` returns, or what it takes.
    ease : mapping of str to float, optional
    bridge : bool, optional
    step : float
        As in `make_pattern`.
    progress : callable, optional
        Called with the number of pieces done so far, and the number of all.

    Returns
    -------
    GradedPattern

    Raises
    ------
    InputError
        As `make_pattern`; the message begins with the size.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> bodies = {"36": bm.load_sample("female_average"), "46": bm.load_sample("female_heavy")}
    >>> graded = bm.grade_pattern(bodies, "skirt")
    >>> graded
    <GradedPattern 'Straight skirt': 2 pieces in 2 sizes>
    >>> small, large = (each["skirt back"].edge("waist") for each in graded.patterns.values())
    >>> large.length > small.length
    True
    """
    _check_bodies(bodies)
    require_progress(progress)
    definitions = checked_definitions(definitions)
    patterns: dict[str, Pattern] = {}
    count = len(definitions.panel)

    def advanced(done: int, _all: int) -> None:
        if progress is not None:
            progress(count * len(patterns) + done, count * len(bodies))

    for size, body in bodies.items():
        try:
            patterns[size] = make_pattern(
                body, definitions, ease=ease, bridge=bridge, step=step, progress=advanced
            )
        except InputError as error:
            raise InputError(f"size {size!r}: {error}") from error
    return GradedPattern(definitions, patterns)


def _check_bodies(bodies: Mapping[str, Atlas]) -> None:
    if not isinstance(bodies, Mapping):
        raise InputError(
            f"bodies is {shown(bodies)}; expected a mapping of names of sizes to atlases"
        )
    if not bodies:
        raise InputError("bodies is empty; expected the body of one size or more")
    for size, body in bodies.items():
        require_kind(size, str, "a size", "its name, a str")
        require_atlas(body)

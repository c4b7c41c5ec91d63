"""How far a fit has come."""

from collections.abc import Callable

# Takes the part of a step that is done, from 0 to 1.
Report = Callable[[float], None]
# Takes the name of a step and the part of the whole that is done.
Progress = Callable[[str, float], None]
# The steps, and the part of the time that is over at the end of each.
STEPS = {
    "reading": 0.05,
    "finding the body": 0.4,
    "shape and pose": 0.55,
    "following the surface": 0.95,
    "checking": 1.0,
}


def reporter(progress: Progress | None, step: str) -> Report:
    """Return what a step calls with the part of it that is done."""
    names = list(STEPS)
    before = STEPS[names[names.index(step) - 1]] if step != names[0] else 0.0

    def report(part: float) -> None:
        if progress is not None:
            progress(step, before + part * (STEPS[step] - before))

    return report

"""The chart of one body, with a progress bar."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from bodymeasure.cli.console import progress_bar
from bodymeasure.errors import InputError

if TYPE_CHECKING:
    from bodymeasure.atlas import Atlas
    from bodymeasure.chart import Chart, Definitions


def measured_chart(
    atlas: "Atlas",
    definitions: "Definitions",
    *,
    only: Sequence[str] = (),
    sensitivity: bool = False,
    despite_errors: bool = False,
) -> "Chart":
    """Measure a body, with a progress bar.

    Raises
    ------
    InputError
        If the set of definitions is empty.
    """
    from bodymeasure.chart import both_sides, measure_chart, restricted

    total = len(both_sides(restricted(definitions, only)[0].measurement))
    if not total:
        raise InputError(f"the set {definitions.name!r} defines no measurement; add one to it")
    with progress_bar("measuring", total) as progress:
        return measure_chart(
            atlas,
            definitions,
            only=only,
            sensitivity=sensitivity,
            progress=lambda done, _total: progress(done),
            despite_errors=despite_errors,
        )

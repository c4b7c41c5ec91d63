"""A chart of measurements. Reports and pictures show it and compute no geometry again."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field

from bodymeasure.atlas import Atlas, AtlasPoint
from bodymeasure.chart.definitions import Definitions
from bodymeasure.chart.kinds.base import Measured


@dataclass(frozen=True, eq=False, repr=False)
class Chart:
    """All measurements of a body; ``chart["waist_girth"]`` is the one of that key.

    Parameters
    ----------
    atlas : Atlas
    definitions : Definitions
        Those that were needed: where only some measurements were asked for, what their formulas
        and landmarks take is among them.
    landmarks : mapping of str to AtlasPoint
        The atlas's landmarks, and those that rules gave.
    missing_landmarks : mapping of str to str
        The landmarks that rules could not give, each with the reason.
    measured : tuple of Measured
        In the order of the definitions.
    seconds : float
        The time that the measuring took.
    versions : mapping of str to str
        The versions of the packages that can change a number.
    landmark_uncertainty : mapping of str to float
        On a body that was fitted to a scan: the root mean square distance of each landmark from the
        place where it belongs, in the atlas's unit.
    only : tuple of str
        The keys and presets that were asked for; none if all of the set were.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> from bodymeasure.chart import Definitions
    >>> from bodymeasure.chart.kinds import HeightMeasure
    >>> knee = HeightMeasure(key="knee", name="Knee height", at="patella point left")
    >>> definitions = Definitions(name="Knees", measurement=(knee,))
    >>> chart = bm.measure_chart(bm.load_sample("female_average"), definitions)
    >>> chart
    <Chart of 'Average female body, 160.5 cm': 1 measured>
    >>> chart["knee"]
    <Measured knee: 0.46834 m (error 1e-15), measured>
    """

    atlas: Atlas
    definitions: Definitions
    landmarks: Mapping[str, AtlasPoint]
    missing_landmarks: Mapping[str, str]
    measured: tuple[Measured, ...]
    seconds: float = 0.0
    versions: Mapping[str, str] = field(default_factory=dict)
    landmark_uncertainty: Mapping[str, float] = field(default_factory=dict)
    only: tuple[str, ...] = ()

    def __getitem__(self, key: str) -> Measured:
        """The measurement of that key.

        Raises
        ------
        KeyError
            If there is none.
        """
        for item in self.measured:
            if item.definition.key == key:
                return item
        raise KeyError(key)

    def __repr__(self) -> str:
        counts = Counter(item.outcome.value for item in self.measured)
        outcomes = ", ".join(f"{count} {outcome}" for outcome, count in counts.items())
        return f"<Chart of {self.atlas.name!r}: {outcomes or 'no measurements'}>"

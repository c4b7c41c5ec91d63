"""The kinds of measurements: one file each, and one line here that registers it."""

from bodymeasure.chart.kinds.base import MeasurementDefinition
from bodymeasure.chart.kinds.formula import FormulaMeasure as FormulaMeasure
from bodymeasure.chart.kinds.girths.extreme_girth import ExtremeGirthMeasure as ExtremeGirthMeasure
from bodymeasure.chart.kinds.girths.girth import GirthMeasure as GirthMeasure
from bodymeasure.chart.kinds.girths.girth_arc import GirthArcMeasure as GirthArcMeasure
from bodymeasure.chart.kinds.girths.limb_girth import LimbGirthMeasure as LimbGirthMeasure
from bodymeasure.chart.kinds.girths.tilted_girth import TiltedGirthMeasure as TiltedGirthMeasure
from bodymeasure.chart.kinds.given import GivenMeasure as GivenMeasure
from bodymeasure.chart.kinds.straight.breadth import BreadthMeasure as BreadthMeasure
from bodymeasure.chart.kinds.straight.chord import ChordMeasure as ChordMeasure
from bodymeasure.chart.kinds.straight.depth import DepthMeasure as DepthMeasure
from bodymeasure.chart.kinds.straight.height import HeightMeasure as HeightMeasure
from bodymeasure.chart.kinds.surface.closed import ClosedMeasure as ClosedMeasure
from bodymeasure.chart.kinds.surface.drop import DropMeasure as DropMeasure
from bodymeasure.chart.kinds.surface.over import OverMeasure as OverMeasure
from bodymeasure.chart.kinds.surface.path import PathMeasure as PathMeasure

# The imports above are the registry: the kinds by the words that stand for them in files.
KINDS: dict[str, type[MeasurementDefinition]] = {
    kind.tag(): kind for kind in MeasurementDefinition.__subclasses__()
}

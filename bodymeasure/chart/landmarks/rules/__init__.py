"""The rules for landmarks: one file each, and one line here that registers it."""

from bodymeasure.chart.landmarks.rules.at_height import AtHeight as AtHeight
from bodymeasure.chart.landmarks.rules.base import LandmarkRule
from bodymeasure.chart.landmarks.rules.between import Between as Between
from bodymeasure.chart.landmarks.rules.boundary import Boundary as Boundary
from bodymeasure.chart.landmarks.rules.farthest import Farthest as Farthest
from bodymeasure.chart.landmarks.rules.fork import Fork as Fork
from bodymeasure.chart.landmarks.rules.girth_level import GirthLevel as GirthLevel
from bodymeasure.chart.landmarks.rules.hollow import Hollow as Hollow
from bodymeasure.chart.landmarks.rules.level import Level as Level
from bodymeasure.chart.landmarks.rules.median import Median as Median
from bodymeasure.chart.landmarks.rules.prominent import Prominent as Prominent

# The imports above are the registry: the rules by the words that stand for them in files.
RULES: dict[str, type[LandmarkRule]] = {rule.tag(): rule for rule in LandmarkRule.__subclasses__()}

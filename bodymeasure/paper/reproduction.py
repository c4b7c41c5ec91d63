"""A reproduction: the settings of a run, and all of its tables."""

from dataclasses import dataclass

from bodymeasure.errors import InputError
from bodymeasure.paper.data.random_patches import GROUP_SIZE
from bodymeasure.paper.tables.table import Table

# The year of the paper.
SEED = 2007
# The body, and the reading that goes on to the tables of speed, scaling and what lies beyond.
BODY = "female_average"
CHOSEN = "grid 0.6"
# The steps by which patches of the body are taken, and the patches of a group in a quick run, which
# only shows that everything works.
BODY_STEP, QUICK_BODY_STEP = 4, 24
QUICK_GROUP_SIZE = 3


@dataclass(frozen=True)
class Settings:
    """The settings of a run.

    Parameters
    ----------
    seed : int
        At least 0.
    quick : bool
        Whether to take few patches and few settings.
    processes : int
        Worker processes, at least 1.

    Raises
    ------
    InputError
        If a number is too small.
    """

    seed: int = SEED
    quick: bool = False
    processes: int = 1

    def __post_init__(self) -> None:
        if self.seed < 0:
            raise InputError(f"seed is {self.seed}; expected a whole number of at least 0")
        if self.processes < 1:
            raise InputError(f"processes is {self.processes}; expected at least 1")

    @property
    def group_size(self) -> int:
        """Patches of a group: the paper's 250, but for a quick run."""
        return QUICK_GROUP_SIZE if self.quick else GROUP_SIZE

    @property
    def body_step(self) -> int:
        """The step by which patches of the body are taken."""
        return QUICK_BODY_STEP if self.quick else BODY_STEP


@dataclass(frozen=True)
class Reproduction:
    """All tables of a run, with what is needed to repeat it."""

    settings: Settings
    tables: tuple[Table, ...]
    versions: dict[str, str]
    seconds: dict[str, float]

    def table(self, name: str) -> Table:
        """Return a table by its name."""
        return next(table for table in self.tables if table.name == name)

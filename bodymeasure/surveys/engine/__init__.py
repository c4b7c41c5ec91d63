"""The engines of a survey: this process, worker processes, or a cluster."""

from collections.abc import Callable, Iterator

from bodymeasure.surveys.engine.batches import Answer, Batch, Work, batch_size
from bodymeasure.surveys.engine.cluster import Cluster, require_distributed
from bodymeasure.surveys.engine.here import Here
from bodymeasure.surveys.engine.pool import Pool

Engine = Callable[[Iterator[Batch], Work], Iterator[Answer]]
"""Takes batches, and yields the rows of each in any order; whatever has been taken is answered."""

__all__ = [
    "Answer",
    "Batch",
    "Cluster",
    "Engine",
    "Here",
    "Pool",
    "Work",
    "batch_size",
    "require_distributed",
]

"""The survey in this process, one body after another."""

from collections.abc import Iterator

from bodymeasure.surveys.engine.batches import Answer, Batch, Work


class Here:
    """Measures in this process."""

    def __call__(self, batches: Iterator[Batch], work: Work) -> Iterator[Answer]:
        """Yield the rows of each batch."""
        for batch in batches:
            yield Answer(batch, work.rows(batch.bodies))

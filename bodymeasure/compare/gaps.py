"""What only one of two sources has a value of, said once for all subjects."""

from collections.abc import Mapping, Sequence

from bodymeasure.compare.readings import Reading

# The number of names that a note lists; the others are counted.
NAMED = 8


class Gaps:
    """The measurements that only one of two sources has, by what is said of them.

    Parameters
    ----------
    names : tuple of str
        The names of the sources.
    """

    def __init__(self, names: tuple[str, str]) -> None:
        self._names = names
        # The subjects without a measurement, by the words about it and its key.
        self._absent: dict[tuple[str, str], list[str]] = {}
        self._valueless: dict[tuple[str, str, str], list[str]] = {}

    def add(self, subject: str, a: Mapping[str, Reading], b: Mapping[str, Reading]) -> None:
        """Note what one of two readings of a subject has no value of."""
        for has, lacks, where in ((a, b, self._names[1]), (b, a, self._names[0])):
            for key, reading in has.items():
                if reading.value is None:
                    continue
                if key not in lacks:
                    self._absent.setdefault((where, key), []).append(subject)
                elif lacks[key].value is None:
                    reason = lacks[key].reason
                    self._valueless.setdefault((where, key, reason), []).append(subject)

    def notes(self, count: int) -> list[str]:
        """Return the notes; measurements that the same subjects lack are put together.

        Parameters
        ----------
        count : int
            The number of subjects that are compared.
        """
        together: dict[tuple[str, tuple[str, ...]], list[str]] = {}
        for (where, key), subjects in self._absent.items():
            together.setdefault((where, tuple(subjects)), []).append(key)
        notes = [
            f"not in {where}: {named(keys, 'measurement')}{_of(subjects, count)}"
            for (where, subjects), keys in together.items()
        ]
        for (where, key, reason), subjects in self._valueless.items():
            notes.append(f"no value in {where}: {key} ({reason}){_of(subjects, count)}")
        return notes


def _of(subjects: Sequence[str], count: int) -> str:
    """Return whose measurements a note is about; empty if there is a single subject."""
    if count == 1:
        return ""
    return (
        f"; all {count} subjects" if len(subjects) == count else f"; {named(subjects, 'subject')}"
    )


def named(words: Sequence[str], noun: str) -> str:
    """Return the first of some names, and how many more there are."""
    more = len(words) - NAMED
    listed = ", ".join(words[:NAMED])
    plural = noun if more == 1 else f"{noun}s"
    return listed if more <= 0 else f"{listed} and {more} more {plural}"

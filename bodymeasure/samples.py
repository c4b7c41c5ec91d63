"""The sample atlases that come with bodymeasure."""

from dataclasses import dataclass
from pathlib import Path

from bodymeasure.arguments import require_kind
from bodymeasure.atlas import Atlas
from bodymeasure.errors import InputError
from bodymeasure.formats import read_atlas
from bodymeasure.wording import nearest


@dataclass(frozen=True)
class Sample:
    """A sample's name, what it shows in one line, and its file."""

    name: str
    description: str
    path: Path


def load_sample(name: str) -> Atlas:
    """Read a sample atlas.

    Parameters
    ----------
    name : str
        One of `sample_names`; ``bodymeasure samples`` lists them with a description.

    Returns
    -------
    Atlas

    Raises
    ------
    InputError
        If there is no sample of that name; the message lists those that there are.

    Examples
    --------
    >>> atlas = load_sample("female_average")
    >>> len(atlas), atlas.unit
    (376, <Unit.M: 'm'>)
    """
    return read_atlas(sample_path(name))


def sample_names() -> tuple[str, ...]:
    """Return the names of all samples, in alphabetical order.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> bm.sample_names()[:3]
    ('enneper', 'female_average', 'female_full_bust')
    """
    return tuple(sorted(path.stem for path in _folder().glob("*.atlas")))


def sample_path(name: str) -> Path:
    """Return the file of a sample.

    Raises
    ------
    InputError
        If there is no sample of that name.
    """
    names = sample_names()
    require_kind(name, str, "the name", "that of a sample")
    if name not in names:
        near = nearest(name, names)
        hint = f"did you mean {near!r}? " if near else ""
        raise InputError(f"no sample is named {name!r}; {hint}There are: {', '.join(names)}")
    return _folder() / f"{name}.atlas"


def samples() -> tuple[Sample, ...]:
    """Return all samples with a description, in alphabetical order."""
    result = []
    for name in sample_names():
        atlas = load_sample(name)
        count = f"{len(atlas)} patch{'es' if len(atlas) > 1 else ''}"
        result.append(Sample(name, f"{atlas.name}; {count}, in {atlas.unit}", sample_path(name)))
    return tuple(result)


def _folder() -> Path:
    """Return the folder of the samples: in the installed package, or at the top of the checkout."""
    installed = Path(__file__).parent / "sample_patches"
    if installed.is_dir():
        return installed
    return Path(__file__).parents[1] / "sample_patches"

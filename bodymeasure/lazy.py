"""Public names of a package that are loaded when they are first asked for."""

from collections.abc import Callable, Sequence
from importlib import import_module


def loader(package: str, names: Sequence[str], homes: Sequence[str]) -> Callable[[str], object]:
    """Return the function `__getattr__` of a package.

    Parameters
    ----------
    package : str
        Its ``__name__``.
    names : sequence of str
        The public names, of which some are not loaded yet.
    homes : sequence of str
        The modules in the package that have them, in the order in which they are looked through.

    Examples
    --------
    >>> from bodymeasure.lazy import loader
    >>> loader("bodymeasure", ["hint"], ["wording"])("hint").__name__
    'hint'
    """

    def load(name: str) -> object:
        """Load a public name when it is first asked for."""
        for home in homes if name in names else ():
            module = import_module(f"{package}.{home}")
            if hasattr(module, name):
                return getattr(module, name)
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    return load

"""Errors that a user can mend: each message names the culprit, what was expected and the remedy."""


class BodymeasureError(Exception):
    """Base of all errors that bodymeasure raises on purpose."""


class InputError(BodymeasureError, ValueError):
    """An argument or a file cannot be measured: a bad file, shape, value, unit or name."""


class FitError(InputError):
    """A mesh is not one of a body that the model of bodies can be fitted to."""


class TriangleMeshError(InputError):
    """A file holds a triangle mesh where an atlas is asked for; a body may be fitted to it."""


class MissingUnitError(InputError):
    """A file does not say the unit of its coordinates, and none was given."""


class MissingExtraError(BodymeasureError, ImportError):
    """A feature needs a package that an optional extra installs."""

    def __init__(self, feature: str, package: str, extra: str) -> None:
        super().__init__(
            f"{feature} needs the package {package!r}, which is not installed; install it with: "
            f"pip install 'bodymeasure[{extra}]'"
        )


class ReadWarning(UserWarning):
    """A file was not read completely, or not exactly as it is."""


class ConvergenceError(BodymeasureError, ArithmeticError):
    """A geodesic has no length that can be trusted, and the caller did not ask for statuses."""

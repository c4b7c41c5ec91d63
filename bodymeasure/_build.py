"""Packages that stand beside this one in the checkout, added when a distribution is built."""

from typing import Any

from setuptools import find_packages
from setuptools.command.build_py import build_py

BESIDE = ("sample_patches", "viewer")


class BuildPy(build_py):  # type: ignore[misc]  # setuptools has no types
    """Build the packages that were found, and those beside them under the one import name."""

    def finalize_options(self) -> None:
        """Add the packages beside; where they are is said by ``package-dir``."""
        packages: list[Any] = list(self.distribution.packages or [])
        for folder in BESIDE:
            inner = [f"{folder}.{name}" for name in find_packages(folder)]
            packages += [f"bodymeasure.{name}" for name in (folder, *inner)]
        self.distribution.packages = sorted(set(packages))
        super().finalize_options()

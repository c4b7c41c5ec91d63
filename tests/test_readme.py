"""README is short, its example runs, and its table of commands is whole."""

import re
from pathlib import Path

import pytest

import bodymeasure as bm
from bodymeasure.cli.commands import COMMANDS

README = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")


def test_it_is_short_enough_to_be_read_to_the_end() -> None:
    assert len(README.splitlines()) <= 120


def test_the_python_example_runs(capsys: pytest.CaptureFixture[str]) -> None:
    (example,) = re.findall(r"^```python\n(.*?)^```", README, flags=re.MULTILINE | re.DOTALL)
    code = [line for line in example.splitlines() if line and not line.startswith("import")]
    assert len(code) <= 10
    exec(example, {})
    lengths, sentence, error, oblique = capsys.readouterr().out.splitlines()
    assert lengths.endswith(" m")
    assert sentence == bm.Status.CONVERGED.sentence
    assert float(error) > 0.0
    assert re.fullmatch(r"0\.\d+ \+- \S+", oblique)


def test_every_command_is_listed_and_every_listed_command_exists() -> None:
    listed = set(re.findall(r"^\| `bodymeasure (\w+)", README, flags=re.MULTILINE))
    assert listed == set(COMMANDS)

"""Other libraries' files, read without a process of their own."""

import subprocess
from types import SimpleNamespace

import pytest

from bodymeasure.formats.foreign import cad_worker, process, rhino_worker

WORKERS = {"cad_worker.py": cad_worker.main, "rhino_worker.py": rhino_worker.main}


@pytest.fixture
def _in_this_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """Read sound files in this process, since another takes long to load the library."""

    def run(command: list[str], **_: object) -> "subprocess.CompletedProcess[bytes]":
        *_python, worker, file, result = command
        main = next(main for name, main in WORKERS.items() if worker.endswith(name))
        return subprocess.CompletedProcess(command, main(file, result))

    # The limit is the process's own, and the tests need more.
    monkeypatch.setattr(rhino_worker, "_limit_memory", lambda: None)
    monkeypatch.setattr(process, "subprocess", SimpleNamespace(run=run))

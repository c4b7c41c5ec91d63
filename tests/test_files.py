import errno
import os
import stat
from pathlib import Path

import pytest

from bodymeasure.errors import InputError
from bodymeasure.files import (
    make_folder,
    output_folder,
    read_bytes,
    require_writable,
    write_bytes,
)


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_what_is_written_is_read(tmp_path: Path) -> None:
    path = tmp_path / "file"
    for content in (b"one", b"\0\xff" * 1000, b""):
        write_bytes(path, content)
        assert read_bytes(path) == content
    assert names(tmp_path) == ["file"]


def test_files_get_the_mode_that_others_get(tmp_path: Path) -> None:
    write_bytes(tmp_path / "ours", b"")
    (tmp_path / "plain").write_bytes(b"")
    modes = [stat.S_IMODE((tmp_path / name).stat().st_mode) for name in ("ours", "plain")]
    assert modes[0] == modes[1]


def test_a_long_name_is_no_trouble(tmp_path: Path) -> None:
    path = tmp_path / ("x" * 255)
    write_bytes(path, b"one")
    assert read_bytes(path) == b"one"


@pytest.mark.parametrize("existing", [None, b"old"])
@pytest.mark.parametrize(
    "fault",
    [OSError(errno.ENOSPC, os.strerror(errno.ENOSPC)), KeyboardInterrupt(), MemoryError()],
    ids=["disk full", "interrupt", "no memory"],
)
@pytest.mark.parametrize("call", ["fsync", "fdopen", "replace"])
def test_a_write_that_fails_leaves_all_as_it_was(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    existing: bytes | None,
    fault: BaseException,
    call: str,
) -> None:
    path = tmp_path / "file"
    if existing is not None:
        path.write_bytes(existing)

    def fail(*_: object, **__: object) -> None:
        raise fault

    with monkeypatch.context() as patch:
        patch.setattr(Path if call == "replace" else os, call, fail)
        if isinstance(fault, OSError):
            with pytest.raises(InputError, match=r"file: cannot be written \(No space left"):
                write_bytes(path, b"new")
        else:
            with pytest.raises(type(fault)):
                write_bytes(path, b"new")
    assert names(tmp_path) == ([] if existing is None else ["file"])
    assert existing is None or path.read_bytes() == existing


def test_a_full_device_is_reported() -> None:
    full = Path("/dev/full")
    if not full.exists():
        pytest.skip("this system has no /dev/full")
    with pytest.raises(InputError, match=r"/dev/full: cannot be written .*disk with room"):
        write_bytes(full, b"x")
    assert full.is_char_device()


def test_a_pipe_stays_a_pipe(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        write_bytes(pipe, b"through")
        assert os.read(reader, 100) == b"through"
    finally:
        os.close(reader)
    assert pipe.is_fifo()


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    target, link = tmp_path / "folder" / "target", tmp_path / "link"
    target.write_bytes(b"old")
    link.symlink_to(target)
    write_bytes(link, b"new")
    assert link.is_symlink()
    assert target.read_bytes() == b"new"
    assert names(tmp_path / "folder") == ["target"]


def test_places_that_cannot_be_written_are_reported(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"")
    (tmp_path / "folder").mkdir()
    for path, reason in (
        (tmp_path / "gone" / "file", "No such file or directory"),
        (tmp_path / "file" / "below", "Not a directory"),
        (tmp_path / "folder", "Is a directory"),
    ):
        with pytest.raises(InputError, match=rf"{path}: cannot be written \({reason}\); choose"):
            write_bytes(path, b"x")
    assert names(tmp_path) == ["file", "folder"]


def test_places_that_cannot_be_read_are_reported(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"")
    with pytest.raises(InputError, match=r"gone: no such file; check the path"):
        read_bytes(tmp_path / "gone")
    with pytest.raises(InputError, match=r"is a directory; give the file inside it"):
        read_bytes(tmp_path)
    with pytest.raises(InputError, match=r"below: cannot be read \(Not a directory\)"):
        read_bytes(tmp_path / "file" / "below")


def test_folders_are_made_with_their_parents(tmp_path: Path) -> None:
    for _ in range(2):
        make_folder(tmp_path / "a" / "b")
    assert (tmp_path / "a" / "b").is_dir()


def test_a_folder_that_cannot_be_made_is_reported(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"")
    for path in (tmp_path / "file", tmp_path / "file" / "below"):
        with pytest.raises(InputError, match=rf"{path}: cannot be written"):
            make_folder(path)


def fail_in(folder: Path, fault: type[BaseException], leave: str = "") -> None:
    """Fail during work for which a folder was made, and leave a file in it or not."""
    with output_folder(folder):
        assert folder.is_dir()
        if leave:
            (folder / leave).write_bytes(b"mine")
        raise fault


@pytest.mark.parametrize("fault", [KeyboardInterrupt, ValueError])
def test_folders_made_for_work_that_failed_are_removed(
    tmp_path: Path, fault: type[BaseException]
) -> None:
    (tmp_path / "a").mkdir()
    with pytest.raises(fault):
        fail_in(tmp_path / "a" / "b" / "c", fault)
    assert names(tmp_path / "a") == []


def test_folders_are_kept_that_were_there_or_hold_something(tmp_path: Path) -> None:
    with output_folder(tmp_path / "done" / "well"):
        pass
    with pytest.raises(InterruptedError):
        fail_in(tmp_path / "done" / "well", InterruptedError)
    assert (tmp_path / "done" / "well").is_dir()
    with pytest.raises(InterruptedError):
        fail_in(tmp_path / "new" / "folder", InterruptedError, leave="file")
    assert names(tmp_path / "new" / "folder") == ["file"]


def test_whether_a_file_can_be_written_is_known_before(tmp_path: Path) -> None:
    path = tmp_path / "file"
    require_writable(path)
    assert names(tmp_path) == []
    path.write_bytes(b"old")
    require_writable(path)
    assert path.read_bytes() == b"old"
    for bad in (tmp_path, tmp_path / "gone" / "file", path / "below", tmp_path / ("x" * 300)):
        with pytest.raises(InputError, match=rf"{bad}: cannot be written \("):
            require_writable(bad)

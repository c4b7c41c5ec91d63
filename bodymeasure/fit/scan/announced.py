"""Whether files hold what they announce, which trimesh does not check: they may be cut off."""

import json
from pathlib import Path
from typing import Any

from bodymeasure.errors import InputError

_HEADER_ENDS = b"end_header"
_GLB_HEADER, _CHUNK_HEADER = 12, 8
# Extensions of glTF under which a mesh cannot be read without a decoder.
_PACKED = ("KHR_draco_mesh_compression", "EXT_meshopt_compression")


def require_ply(content: bytes, path: Path) -> int:
    """Return the number of faces that a PLY file announces, and refuse text that is cut off.

    Binary files of another length than announced are refused by trimesh.

    Raises
    ------
    InputError
        If it is no PLY file, or has fewer lines than it announces.
    """
    end = content.find(_HEADER_ENDS)
    if content[:3].lower() != b"ply" or end < 0:
        raise InputError(f"{path}: has no header of a PLY file; export it again")
    lines = [line.split() for line in content[:end].splitlines()]
    counts = {
        line[1]: int(line[2])
        for line in lines
        if len(line) == 3 and line[0] == b"element" and line[2].isdigit()
    }
    if any(line[:2] == [b"format", b"ascii"] for line in lines):
        rows = content[end:].rstrip().count(b"\n")
        _require_lines(path, rows, sum(counts.values()))
    return counts.get(b"face", 0)


def require_off(content: bytes, path: Path) -> int:
    """Return the number of faces that an OFF file announces, and refuse one that is cut off.

    Raises
    ------
    InputError
        If it is no OFF file, or has fewer lines than it announces.
    """
    lines = [line.partition(b"#")[0].split() for line in content.splitlines()]
    lines = [line for line in lines if line]
    words = [word for line in lines[:2] for word in line]
    if not lines or not lines[0][0].upper().endswith(b"OFF"):
        raise InputError(f"{path}: does not begin with OFF; expected an OFF file")
    counts = words[1:3]
    if len(counts) < 2 or not all(word.isdigit() for word in counts):
        raise InputError(f"{path}: does not say how many vertices and faces follow after OFF")
    first = 1 if len(lines[0]) > 1 else 2
    _require_lines(path, len(lines) - first, int(counts[0]) + int(counts[1]))
    return int(counts[1])


def require_gltf(content: bytes, path: Path, most: int) -> tuple[str, ...]:
    """Refuse glTF that is compressed or announces more than `most` numbers; return what to note.

    Raises
    ------
    InputError
        The message says how to export the file.
    """
    header = _gltf_header(content, path)
    packed = [each for each in _list(header, "extensionsUsed") if each in _PACKED]
    if packed:
        raise InputError(
            f"{path}: is compressed ({packed[0]}); export it again without compression"
        )
    for accessor in _list(header, "accessors"):
        count = accessor.get("count") if isinstance(accessor, dict) else None
        if not isinstance(count, int) or not 0 <= count <= most:
            raise InputError(
                f"{path}: an accessor announces {count} items; expected {most:,} at most; export "
                "the file again"
            )
    notes = []
    if _list(header, "skins"):
        notes.append("The file has a skeleton: the mesh is taken in the pose in which it is kept.")
    return tuple(notes)


def _gltf_header(content: bytes, path: Path) -> dict[str, Any]:
    text = content
    if path.suffix.lower() == ".glb":
        start = _GLB_HEADER + _CHUNK_HEADER
        length = int.from_bytes(content[_GLB_HEADER : _GLB_HEADER + 4], "little")
        if content[:4] != b"glTF" or len(content) < start + length:
            raise InputError(f"{path}: is no GLB file, or cut off; export it again")
        text = content[start : start + length]
    try:
        header = json.loads(text)
    except (ValueError, RecursionError):
        header = None
    if not isinstance(header, dict):
        raise InputError(f"{path}: does not hold the JSON of a glTF file; export it again")
    return header


def _list(header: dict[str, Any], key: str) -> list[Any]:
    value = header.get(key, [])
    return value if isinstance(value, list) else []


def _require_lines(path: Path, there: int, announced: int) -> None:
    if there < announced:
        raise InputError(
            f"{path}: announces {announced:,} lines of vertices and faces and has {there:,}; it is "
            "cut off, export it again"
        )

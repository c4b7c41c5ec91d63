"""Patterns as specifications of GarmentCode: panels with stitches, for programs that sew them."""

import json
import re
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from bodymeasure._typing import Array
from bodymeasure.pattern.files.sewn import WholePanel, sewn_cubics, whole_panels
from bodymeasure.pattern.pieces.pattern import Pattern

# Centimeters in a meter, and for a millimeter.
UNITS, CENTIMETERS = 100, 0.1
# In centimeters: how far from the skin a panel is placed.
AWAY = 5.0
# A curve of which the inner control points are this near to its chord, as parts of it, is a line.
STRAIGHT = 1e-9


def pattern_garmentcode(pattern: Pattern) -> bytes:
    """Return a specification of GarmentCode, in JSON: whole panels in centimeters, and stitches.

    Pieces on the fold are unfolded, and pieces for one side of the body come with their mirror
    images. Darts are open and sewn shut. Edges are cubics as long as on the skin; both sides of a
    seam have the same number of them, sewn one to one. Of seams that have an edge in common, only
    the first is sewn, since GarmentCode sews an edge to one other.

    Parameters
    ----------
    pattern : Pattern

    Notes
    -----
    The format is that of M. Korosteleva and O. Sorkine-Hornung, "GarmentCode: programming
    parametric sewing patterns", ACM Transactions on Graphics 42 (2023), as the module
    ``pygarment.pattern.core`` of its repository reads it.
    """
    panels = whole_panels(pattern)
    names = _names([panel.name for panel in panels])
    cubics = sewn_cubics(panels)
    written: dict[str, Any] = {}
    # The edges of each seam by its sides, each with where on the seam it begins.
    seams: dict[tuple[str, ...], dict[int, list[tuple[float, str, int]]]] = {}
    for number, (name, panel) in enumerate(zip(names, panels, strict=True)):
        sides = [cubics[number, place] for place in range(len(panel.sides))]
        written[name], firsts = _panel(panel, sides)
        count = sum(len(parts) for parts in sides)
        for side, first, parts in zip(panel.sides, firsts, sides, strict=True):
            edges = [(first + row) % count for row in range(len(parts))]
            if side.place.runs_back:
                edges = edges[::-1]
            if side.place.seam:
                entries = seams.setdefault(side.place.seam, {}).setdefault(side.place.side, [])
                entries += [(side.place.start, name, edge) for edge in edges]
    specification = {
        "pattern": {"panels": written, "stitches": _stitches(seams), "panel_order": names},
        "parameters": {},
        "parameter_order": [],
        "properties": {
            "curvature_coords": "relative",
            "normalize_panel_translation": False,
            "normalized_edge_loops": True,
            "units_in_meter": UNITS,
        },
    }
    return json.dumps(specification, indent=1).encode() + b"\n"


def _panel(panel: WholePanel, sides: list[list[Array]]) -> tuple[dict[str, Any], list[int]]:
    """Return a panel as GarmentCode has it, and the number of the first edge of each side."""
    # Loops of edges begin at the vertex that is nearest to the lower left corner, by convention.
    flat = [cubic for parts in sides for cubic in parts]
    corners = np.stack([cubic[0] for cubic in flat])
    first = int(np.linalg.norm(corners - corners.min(axis=0), axis=1).argmin())
    count = len(flat)
    edges = []
    for number in range(count):
        cubic = flat[(first + number) % count]
        edge: dict[str, Any] = {"endpoints": [number, (number + 1) % count]}
        inner = _relative(cubic)
        if np.abs(inner[:, 1]).max() > STRAIGHT:
            edge["curvature"] = {"type": "cubic", "params": inner.tolist()}
        edges.append(edge)
    rotation, translation = _placed(panel)
    record = {
        "translation": translation.tolist(),
        "rotation": rotation.tolist(),
        "vertices": (CENTIMETERS * np.roll(corners, -first, axis=0)).tolist(),
        "edges": edges,
    }
    starts = np.cumsum([0, *(len(parts) for parts in sides[:-1])])
    return record, ((starts - first) % count).tolist()


def _relative(cubic: Array) -> Array:
    """Return the inner control points in the frame in which the chord is (1, 0)."""
    chord = cubic[3] - cubic[0]
    frame = np.stack([chord, [-chord[1], chord[0]]]) / (chord @ chord)
    return np.asarray((cubic[1:3] - cubic[0]) @ frame.T)


def _placed(panel: WholePanel) -> tuple[Array, Array]:
    """Return the angles, in degrees, and the place that bring a panel before its part of the skin.

    GarmentCode's axes point to the wearer's left, up and to the front, and it turns a panel about
    the first, the second and the third of them in turn.
    """
    flat = CENTIMETERS * np.pad(panel.flat, ((0, 0), (0, 1)))
    skin = CENTIMETERS * panel.skin
    middle, place = flat.mean(axis=0), skin.mean(axis=0)
    u, _, v = np.linalg.svd((skin - place).T @ (flat - middle))
    # The panel has no thickness, so that its normal is what the other two axes leave.
    turn = u @ np.diag([1.0, 1.0, np.linalg.det(u @ v)]) @ v
    angles = Rotation.from_matrix(turn).as_euler("xyz", degrees=True)
    # Panels are seen from outside, so that their third axis points away from the body.
    return angles, place - turn @ middle + AWAY * turn[:, 2]


def _stitches(
    seams: dict[tuple[str, ...], dict[int, list[tuple[float, str, int]]]],
) -> list[Any]:
    """Return what is sewn to what: the first edge of one side to the first one of the other."""
    stitches = []
    for sides in seams.values():
        # What the other side of the body has no partner for stays open.
        if len(sides) != 2:
            continue
        # Sorting keeps the order of the edges of a part.
        both = (sorted(sides[row], key=lambda entry: entry[0]) for row in (0, 1))
        stitches += [
            [{"panel": name, "edge": edge} for _, name, edge in pair]
            for pair in zip(*both, strict=True)
        ]
    return stitches


def _names(names: list[str]) -> list[str]:
    """Return different names in letters and digits, which name files and objects in 3D programs."""
    found: list[str] = []
    for name in names:
        stem = re.sub(r"[^0-9A-Za-z]+", "_", name).strip("_") or "panel"
        number, wanted = 2, stem
        while wanted in found:
            number, wanted = number + 1, f"{stem}_{number}"
        found.append(wanted)
    return found

"""Curves as text: chains of points in OBJ, all that is known in JSON, a drawing in SVG."""

import json
from collections.abc import Sequence
from xml.sax.saxutils import quoteattr

import numpy as np

from bodymeasure.atlas import Axes, Unit
from bodymeasure.mesh.curves.curve import Curve

# Points for each cubic segment, where a format has straight pieces only.
PER_SEGMENT = 8
# The width of lines in a drawing, and the room around them, in parts of its size.
_WIDTH, _ROOM = 0.002, 0.02


def to_obj(curves: Sequence[Curve]) -> bytes:
    """Return curves as chains of points in a Wavefront OBJ file."""
    lines, before = [], 0
    for curve in curves:
        points = curve.points(PER_SEGMENT)
        lines.append(f"o {' '.join(curve.name.split())}")
        lines += (f"v {x!r} {y!r} {z!r}" for x, y, z in points.tolist())
        numbers = range(before + 1, before + len(points) + 1)
        lines.append(f"l {' '.join(map(str, numbers))}")
        before += len(points)
    return ("\n".join(lines) + "\n").encode()


def to_json(curves: Sequence[Curve], unit: Unit) -> bytes:
    """Return curves as JSON: what is known of each, its spline and points along it."""
    content = {
        "schema": "bodymeasure paths",
        "version": 1,
        "unit": unit.value,
        "paths": [
            {
                "name": curve.name,
                **{key: value for key, value in curve.facts.items() if value == value},
                "degree": curve.degree,
                "knots": np.repeat(curve.breaks, curve.multiplicities).tolist(),
                "control_points": curve.control_points.tolist(),
                "points": curve.points(PER_SEGMENT).tolist(),
            }
            for curve in curves
        ],
    }
    return json.dumps(content, ensure_ascii=False, indent=1).encode() + b"\n"


def to_svg(curves: Sequence[Curve], unit: Unit, axes: Axes) -> bytes:
    """Return the front view of curves as a drawing at full size, in millimeters."""
    scale = unit.meters / Unit.MM.meters
    across = np.stack([axes.left_vector, -axes.up_vector], axis=1)
    flat = [scale * curve.control_points @ across for curve in curves]
    every = np.concatenate(flat) if flat else np.zeros((1, 2))
    size = float(np.ptp(every, axis=0).max()) or 1.0
    low = every.min(axis=0) - _ROOM * size
    width, height = (np.ptp(every, axis=0) + 2.0 * _ROOM * size).tolist()
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.4f}mm" height="{height:.4f}mm" '
        f'viewBox="{low[0]:.4f} {low[1]:.4f} {width:.4f} {height:.4f}" fill="none" '
        f'stroke="black" stroke-width="{_WIDTH * size:.4f}">'
    ]
    for curve, points in zip(curves, flat, strict=True):
        step = "C" if curve.degree == 3 else "L"
        words = " ".join(f"{x:.5f},{y:.5f}" for x, y in points[1:].tolist())
        start = f"{points[0, 0]:.5f},{points[0, 1]:.5f}"
        lines.append(f'<path id={quoteattr(curve.name)} d="M {start} {step} {words}"/>')
    return ("\n".join([*lines, "</svg>"]) + "\n").encode()

"""The check of an atlas: what is wrong with its geometry."""

from functools import lru_cache

import numpy as np

from bodymeasure._typing import Bools, Ints
from bodymeasure.atlas.atlas import Atlas, require_atlas
from bodymeasure.atlas.check.degeneracy import Degeneracy, degeneracy_findings, find_degeneracy
from bodymeasure.atlas.check.finding import Finding, FindingKind, Severity
from bodymeasure.atlas.check.folds import fold_findings, normal_cones
from bodymeasure.atlas.check.gaps import (
    FreeEdges,
    NearSeams,
    free_edges,
    near_seams,
    t_junctions,
    welded_index,
)
from bodymeasure.atlas.check.stance import stance_findings
from bodymeasure.atlas.seams import EDGES, edge_table
from bodymeasure.atlas.size import require_size
from bodymeasure.atlas.topology.joins import kink_angles, parts, seams_of, turned_patches
from bodymeasure.bezier import project
from bodymeasure.threads import one_blas_thread

# Degrees. Fitted bodies have seams within 2 nearly everywhere; paths bend visibly from here on.
KINK = 15.0


@one_blas_thread()
def check_atlas(atlas: Atlas) -> tuple[Finding, ...]:
    """Return the faults of an atlas's geometry and of its landmarks' places, errors first.

    Parameters
    ----------
    atlas : Atlas

    Returns
    -------
    tuple of Finding
        Empty if there is nothing to say. Errors: directions, sides, an order or a size that the
        landmarks of a body contradict, patches without area or folded over, seams with a gap, more
        than two patches on an edge. Warnings: edges or corners that collapse, points
        without a normal, seams that are not joined by index, T-junctions, patches that face
        against their neighbors, kinked seams, separate parts. Open boundaries are no fault.

    Raises
    ------
    InputError
        If the atlas is so large or so small that squares of its areas are no numbers.

    Examples
    --------
    >>> import bodymeasure as bm
    >>> body = bm.load_sample("female_average")
    >>> findings = bm.check_atlas(body)
    >>> [(finding.kind.value, finding.severity.value) for finding in findings[:1]]
    [('kinked seam', 'warning')]
    """
    require_atlas(atlas)
    return _findings(atlas)


# Atlases do not change; commands check one as they read it, and again for what they write.
@lru_cache(maxsize=4)
def _findings(atlas: Atlas) -> tuple[Finding, ...]:
    control_points = atlas.control_points
    require_size(project(control_points).reshape(-1, 3), atlas.unit)
    cones = normal_cones(control_points)
    degeneracy = find_degeneracy(project(control_points), cones.largest)
    findings = degeneracy_findings(atlas, degeneracy)
    findings += fold_findings(atlas, cones, degeneracy)
    findings += stance_findings(atlas)

    # A patch without area has no sides worth joining.
    collapsed = degeneracy.edges | degeneracy.patches[:, None]
    free = free_edges(control_points, atlas.index, collapsed)
    near = near_seams(free)
    findings += _gap_findings(atlas, free, near)
    # Everything else is checked as if edges that coincide were joined.
    index = welded_index(atlas.index, free, near)
    findings += _t_junction_findings(atlas, index, collapsed, free, near)
    findings += _join_findings(atlas, index, degeneracy)
    order = {kind: number for number, kind in enumerate(FindingKind)}
    return tuple(
        sorted(findings, key=lambda f: (f.severity != Severity.ERROR, order[f.kind], f.patches))
    )


def _side(atlas: Atlas, patch: int, side: int) -> str:
    return f"edge {EDGES[side].name} of patch {atlas.patch_names[patch]!r}"


def _gap_findings(atlas: Atlas, free: FreeEdges, near: NearSeams) -> list[Finding]:
    findings = []
    speeds = ", with the same ratios of weights" if atlas.is_rational else ""
    for pair in np.flatnonzero(~near.coincide):
        ends = near.first[pair], near.second[pair]
        first, second = (_side(atlas, free.patch[end], free.side[end]) for end in ends)
        patches = tuple(int(free.patch[end]) for end in ends)
        findings.append(
            Finding(
                Severity.ERROR,
                FindingKind.SEAM_GAP,
                patches,
                f"{first} and {second} nearly meet but leave a gap of up to "
                f"{near.distance[pair]:.3g} {atlas.unit}; expected one shared edge; let both "
                f"patches refer to the same control points{speeds}",
            )
        )
    pairs = np.flatnonzero(near.coincide)
    if len(pairs):
        ends = near.first[pairs], near.second[pairs]
        first, second = (_side(atlas, free.patch[end[0]], free.side[end[0]]) for end in ends)
        count = f"{len(pairs)} seam is" if len(pairs) == 1 else f"{len(pairs)} seams are"
        findings.append(
            Finding(
                Severity.WARNING,
                FindingKind.UNJOINED_SEAM,
                tuple(np.unique(free.patch[np.concatenate(ends)]).tolist()),
                f"{count} not joined by index, though the control points coincide (the first: "
                f"{first} and {second}); expected patches to refer to the same control points; "
                "weld them, so that paths can cross",
            )
        )
    return findings


def _t_junction_findings(
    atlas: Atlas,
    index: Ints,
    collapsed: Bools,
    free: FreeEdges,
    near: NearSeams,
) -> list[Finding]:
    gaps = ~near.coincide
    reported = np.concatenate([near.first[gaps], near.second[gaps]])
    hidden = collapsed.copy()
    hidden[free.patch[reported], free.side[reported]] = True
    edges = free_edges(atlas.control_points, index, hidden)
    findings = []
    for edge, other in zip(*t_junctions(edges), strict=True):
        patches = int(edges.patch[edge]), int(edges.patch[other])
        findings.append(
            Finding(
                Severity.WARNING,
                FindingKind.T_JUNCTION,
                patches,
                f"{_side(atlas, patches[0], edges.side[edge])} is touched in its middle by an end "
                f"of {_side(atlas, patches[1], edges.side[other])}; expected patches to meet along "
                "whole edges; split the patch there",
            )
        )
    return findings


def _join_findings(atlas: Atlas, index: Ints, degeneracy: Degeneracy) -> list[Finding]:
    """Findings on seams, of an atlas joined as in `index`."""
    collapsed = degeneracy.edges | degeneracy.patches[:, None]
    table = edge_table(index)
    names = atlas.patch_names
    findings = []
    sides = np.where(collapsed, 0, table.sides[table.edge])
    for edge in np.unique(table.edge[sides > 2]):
        patches, numbers = np.nonzero(table.edge == edge)
        listed = ", ".join(
            _side(atlas, p, s) for p, s in zip(patches.tolist(), numbers.tolist(), strict=True)
        )
        findings.append(
            Finding(
                Severity.ERROR,
                FindingKind.NON_MANIFOLD_SEAM,
                tuple(np.unique(patches).tolist()),
                f"{len(patches)} patches meet along one edge: {listed}; expected at most two; "
                "remove or separate the others",
            )
        )
    seams = seams_of(table, collapsed)
    turned, one_sided = turned_patches(seams, len(atlas))
    findings += [
        Finding(
            Severity.WARNING,
            FindingKind.ORIENTATION,
            (int(patch),),
            f"patch {names[patch]!r} faces against its neighbors: its normal points to the other "
            "side of the surface; expected all to face one way; reverse the rows of its "
            "control points",
        )
        for patch in turned
    ]
    findings += [
        Finding(
            Severity.WARNING,
            FindingKind.ORIENTATION,
            tuple(part.tolist()),
            f"the {len(part)} patches joined to patch {names[part[0]]!r} form a surface with one "
            "side only, as a Moebius band; expected an inside and an outside; look for a seam that "
            "joins the wrong edges or joins them reversed",
        )
        for part in one_sided
    ]
    angles = kink_angles(atlas.control_points, seams)
    for seam in np.flatnonzero(angles > KINK):
        first, second = seams.patch[seam]
        findings.append(
            Finding(
                Severity.WARNING,
                FindingKind.KINKED_SEAM,
                (int(first), int(second)),
                f"the normal jumps by {angles[seam]:.0f} degrees between "
                f"{_side(atlas, first, seams.side[seam, 0])} and "
                f"{_side(atlas, second, seams.side[seam, 1])}; expected at most {KINK:.0f} on a "
                "smooth body; lengths are right, but paths bend at the seam",
            )
        )
    part = parts(seams, len(atlas))
    if part.max() > 0:
        findings.append(_parts_finding(atlas, part))
    return findings


def _parts_finding(atlas: Atlas, part: Ints) -> Finding:
    _, first, sizes = np.unique(part, return_index=True, return_counts=True)
    order = np.argsort(-sizes, kind="stable")
    listed = ", ".join(
        f"{sizes[i]} with patch {atlas.patch_names[first[i]]!r}" for i in order[:_PARTS_LISTED]
    )
    more = ", ..." if len(sizes) > _PARTS_LISTED else ""
    return Finding(
        Severity.WARNING,
        FindingKind.SEPARATE_PARTS,
        tuple(np.sort(first).tolist()),
        f"the atlas falls into {len(sizes)} parts that share no seam ({listed}{more}); a body is "
        "one part; join the parts, or measure each for itself",
    )


# Parts named in a message; the rest is counted.
_PARTS_LISTED = 3

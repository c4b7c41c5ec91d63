// Numbers of vertices. A patch is a grid of (segments + 1)^2 of them, patch after patch, so that a
// vertex number gives patch, u and v by division, and no list of triangles has to be sent.

/** The triangles over every `stride`-th vertex, turned so that they face as the normals do. */
export function triangles({ patches, segments, stride, positions, normals }) {
  const side = segments + 1;
  const cells = segments / stride;
  const index = new Uint32Array(patches * cells * cells * 6);
  let at = 0;
  for (let patch = 0; patch < patches; patch++) {
    const first = patch * side * side;
    const flipped = facesAway(first, side, segments, positions, normals);
    for (let i = 0; i < segments; i += stride) {
      for (let j = 0; j < segments; j += stride) {
        const a = first + i * side + j;
        const b = a + stride * side;
        const c = a + stride;
        const d = b + stride;
        const corners = flipped ? [a, d, b, a, c, d] : [a, b, d, a, d, c];
        for (const corner of corners) index[at++] = corner;
      }
    }
  }
  return index;
}

/** Whether the triangles of a patch look away from its normals, judged in its middle. */
function facesAway(first, side, segments, positions, normals) {
  const middle = Math.floor(segments / 2);
  const a = 3 * (first + middle * side + middle);
  const b = a + 3 * side;
  const c = a + 3;
  const along = [0, 1, 2].map((k) => positions[b + k] - positions[a + k]);
  const across = [0, 1, 2].map((k) => positions[c + k] - positions[a + k]);
  const normal = [
    along[1] * across[2] - along[2] * across[1],
    along[2] * across[0] - along[0] * across[2],
    along[0] * across[1] - along[1] * across[0],
  ];
  return normal[0] * normals[a] + normal[1] * normals[a + 1] + normal[2] * normals[a + 2] < 0;
}

/** The (patch, u, v) of a vertex. */
export function locationOf(vertex, segments) {
  const side = segments + 1;
  const patch = Math.floor(vertex / (side * side));
  const rest = vertex - patch * side * side;
  return [patch, Math.floor(rest / side) / segments, (rest % side) / segments];
}

/** A value at (patch, u, v) between the four vertices around it, for arrays of `width` numbers. */
export function interpolate(data, [patch, u, v], segments, width = 3) {
  const side = segments + 1;
  const x = Math.min(Math.max(u, 0), 1) * segments;
  const y = Math.min(Math.max(v, 0), 1) * segments;
  const i = Math.min(Math.floor(x), segments - 1);
  const j = Math.min(Math.floor(y), segments - 1);
  const [p, q] = [x - i, y - j];
  const a = patch * side * side + i * side + j;
  const corners = [a, a + side, a + 1, a + side + 1];
  const weights = [(1 - p) * (1 - q), p * (1 - q), (1 - p) * q, p * q];
  const value = new Array(width).fill(0);
  corners.forEach((corner, n) => {
    for (let k = 0; k < width; k++) value[k] += weights[n] * data[width * corner + k];
  });
  return value;
}

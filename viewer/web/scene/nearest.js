// Which of many lines lies under the pointer.

/** The line of (k, m, 3) nearest to a point, within a reach: {line, sample, part}, or null. */
export function nearestLine({ data, shape }, point, reach) {
  const [count, samples] = shape;
  let best = null;
  let least = reach * reach;
  for (let line = 0; line < count; line++) {
    for (let sample = 0; sample < samples - 1; sample++) {
      const at = 3 * (line * samples + sample);
      const [square, part] = fromSegment(data, at, point);
      if (square < least) [best, least] = [{ line, sample, part }, square];
    }
  }
  return best;
}

/** The square of a point's distance from a segment, and where on it the nearest point is. */
function fromSegment(data, at, point) {
  let along = 0;
  let size = 0;
  for (let k = 0; k < 3; k++) {
    const way = data[at + 3 + k] - data[at + k];
    along += way * (point[k] - data[at + k]);
    size += way * way;
  }
  const part = size > 0 ? Math.min(1, Math.max(0, along / size)) : 0;
  let square = 0;
  for (let k = 0; k < 3; k++) {
    const off = data[at + k] + part * (data[at + 3 + k] - data[at + k]) - point[k];
    square += off * off;
  }
  return [square, part];
}

// Which lines and names stand in the scene for the rows of the list.
import { LANDMARK_COLOR, LIT_COLOR, NO_LENGTH_COLOR } from "../model/colors.js";
import { tapeColors } from "../model/tape_colors.js";
import { formatLength, formatValue } from "../model/units.js";
import { lifted } from "./lines.js";

export class TapeLines {
  #raised = new WeakMap();
  #last = new Map();
  #ofChart = new WeakMap();

  constructor(app, viewport) {
    this.app = app;
    this.viewport = viewport;
    this.extra = [];
    // Where each drawn row lies, for finding it under the pointer: {id, points}.
    this.places = [];
  }

  /** The points of a result, off the surface, made once for each. */
  #points(result) {
    if (!this.#raised.has(result)) {
      const points = (result.points ?? []).flat();
      const normals = (result.normals ?? []).flat();
      const closing = result.closed && points.length > 3;
      if (closing && points.slice(0, 3).some((value, k) => value !== points[points.length - 3 + k])) {
        points.push(...points.slice(0, 3));
        normals.push(...normals.slice(0, 3));
      }
      this.#raised.set(result, lifted(points, normals, this.viewport.lift));
    }
    return this.#raised.get(result);
  }

  /** The lines of the chart's tapes: {points, through} by the tape's number. */
  #chartTapes(chart) {
    if (!this.#ofChart.has(chart)) {
      const { tape_points: places, tape_normals: normals } = chart.arrays;
      const lines = (chart.header.tapes ?? []).map((tape) => {
        const cut = (array) => array.data.subarray(3 * tape.first, 3 * (tape.first + tape.count));
        let points = lifted(cut(places), normals && !tape.through_body ? cut(normals) : null, this.viewport.lift);
        if (tape.closed) points = new Float32Array([...points, ...points.subarray(0, 3)]);
        return { points, through: Boolean(tape.through_body) };
      });
      this.#ofChart.set(chart, lines);
    }
    return this.#ofChart.get(chart);
  }

  /** Draw the rows as they are now. */
  update() {
    const { app } = this;
    if (!app.header) return;
    const { theme } = app.settings;
    const layers = app.settings.get("layers");
    const lines = [];
    const labels = [];
    this.places = [];
    const { items } = app;
    const colors = tapeColors(app, items);
    for (const item of items) {
      const lit = item.id === app.lit || item.id === app.selected;
      if (!(item.visible || lit)) continue;
      const mine = item.source === "tape";
      const color = colors.of(item);
      const parts = mine ? this.#ofTape(item) : layers.tapes || lit ? this.#ofMeasurement(item) : [];
      parts.forEach((part, n) => {
        const dashed = part.through ? this.viewport.radius * 0.01 : 0;
        const line = { id: `${item.id}/${n}`, points: part.points, dashed, through: part.through, lit: lit || mine };
        const tint = item.failed ? NO_LENGTH_COLOR : color;
        // What is lit lies over the others, which need not be drawn anew for it.
        const batched = !mine && !part.through && item.visible && layers.tapes;
        if (batched) lines.push({ ...line, color: tint, width: 2, batched });
        if (batched && lit) lines.push({ ...line, id: `${line.id}/lit`, color: LIT_COLOR[theme], width: 4.5 });
        if (!batched) lines.push({ ...line, color: lit && !item.failed ? LIT_COLOR[theme] : tint, width: lit ? 4.5 : mine ? 3.5 : 2 });
        this.places.push({ id: item.id, points: part.points });
      });
      const anchor = this.#anchor(parts);
      const named = lit || (mine && layers.labels);
      if (anchor && named) {
        const value = item.waiting ? "…" : item.failed ? "no length" : formatValue(item, app.unit);
        labels.push({
          id: item.id,
          anchor,
          text: `${item.name}  ${value}`,
          tone: lit ? "lit" : "",
          onClick: () => app.select(item.id),
          onHover: (over) => app.light(over ? item.id : null),
        });
      }
    }
    this.#forget();
    if (layers.landmarks && layers.names) labels.push(...this.#landmarkNames());
    labels.push(...this.extra.flatMap((one) => one.labels ?? []));
    this.viewport.lines.set([...lines, ...this.extra.flatMap((one) => one.lines ?? [])]);
    this.viewport.labels.set(labels);
    this.#updateSecond(items, colors);
  }

  /** The same measurements on the body beside this one, in the colors of what they are there. */
  #updateSecond(items, colors) {
    const { app, viewport } = this;
    if (!viewport.second.surface) return;
    const layers = app.settings.get("layers");
    const lines = [];
    const chart = app.otherChart;
    if (chart) {
      const others = new Map(app.besideItems.map((one) => [one.id, one]));
      const tapes = this.#chartTapes(chart);
      for (const item of items) {
        const lit = item.id === app.lit || item.id === app.selected;
        if (item.source !== "chart" || !(lit || (item.visible && layers.tapes))) continue;
        const other = others.get(item.id);
        (other?.measurement.tapes ?? []).forEach((number, n) => {
          const { points, through } = tapes[number];
          const line = { id: `${item.id}/${n}`, points, dashed: through ? viewport.radius * 0.01 : 0, through };
          if (lit) lines.push({ ...line, color: LIT_COLOR[app.settings.theme], width: 4.5 });
          else lines.push({ ...line, color: colors.of(other), width: 2, batched: !through });
        });
      }
    }
    viewport.second.update(lines, { landmarks: layers.landmarks, color: LANDMARK_COLOR });
  }

  /** What is drawn of a tape: while it is measured anew, what was measured last. */
  #ofTape(item) {
    const known = item.result?.points ? item.result : item.waiting ? this.#last.get(item.id) : null;
    if (item.result?.points) this.#last.set(item.id, item.result);
    if (!known) return [{ points: this.#straight(item.tape), through: true }].filter(({ points }) => points.length > 3);
    return [{ points: this.#points(known), through: Boolean(known.through) }];
  }

  /** A tape without a length is still to be seen: as the straight line between its points. */
  #straight(tape) {
    return new Float32Array(tape.locations.flatMap((location) => this.app.placeOf(location) ?? []));
  }

  #forget() {
    const tapes = new Set(this.app.sheet.tapes.map((tape) => tape.id));
    for (const id of this.#last.keys()) if (!tapes.has(id)) this.#last.delete(id);
  }

  #ofMeasurement(item) {
    const tapes = this.#chartTapes(this.app.chart);
    return (item.measurement.tapes ?? []).map((number) => tapes[number]).filter(Boolean);
  }

  /** Half along the longest part, where a name belongs. */
  #anchor(parts) {
    const longest = parts.reduce((best, part) => (part.points.length > (best?.length ?? 0) ? part.points : best), null);
    if (!longest || longest.length < 3) return null;
    const number = Math.floor(longest.length / 6);
    const at = [...longest.subarray(3 * number, 3 * number + 3)];
    // Of a straight line with two ends, half way.
    if (longest.length === 6) return [0, 1, 2].map((k) => (longest[k] + longest[3 + k]) / 2);
    return at;
  }

  #landmarkNames() {
    return this.app.landmarks.map((landmark) => ({
      id: `landmark:${landmark.name}`,
      anchor: landmark.position,
      text: landmark.name,
      tone: "quiet",
      onClick: () => this.app.emit("landmark", landmark.name),
    }));
  }

  /** The row whose line lies nearest to a point of the body, within a reach, or null. */
  nearest(point, reach) {
    let best = null;
    let least = reach * reach;
    for (const { id, points } of this.places) {
      for (let i = 0; i < points.length; i += 3) {
        const square = (points[i] - point[0]) ** 2 + (points[i + 1] - point[1]) ** 2 + (points[i + 2] - point[2]) ** 2;
        if (square < least) [best, least] = [id, square];
      }
    }
    return best;
  }

  /** Points and normals of a row, for flying there. */
  extent(id) {
    const points = this.places
      .filter((place) => place.id === id)
      .flatMap((place) => Array.from({ length: place.points.length / 3 }, (_, n) => [...place.points.subarray(3 * n, 3 * n + 3)]));
    const { result, measurement } = this.app.item(id) ?? {};
    let normals = result?.normals ?? [];
    if (measurement && this.app.chart?.arrays.tape_normals) {
      const data = this.app.chart.arrays.tape_normals.data;
      normals = (measurement.tapes ?? []).flatMap((number) => {
        const { first, count } = this.app.chart.header.tapes[number];
        return Array.from({ length: count }, (_, n) => [...data.subarray(3 * (first + n), 3 * (first + n) + 3)]);
      });
    }
    return { points, normals };
  }
}

/** The words beside a rubber band. */
export function bandLabel(band, preview, unit) {
  const straight = `${formatLength(band.straight, unit)} straight`;
  if (!preview || !Number.isFinite(preview.length)) return straight;
  return `${formatLength(preview.length, unit)}  (${straight})`;
}

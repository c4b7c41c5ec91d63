// The lines of tapes, kept in step with a list of what should be drawn: a line that is not in the
// list any more is released, and one that did not change is left alone. A chart has two hundred
// tapes; those of them that nobody points at are one object, since each object costs time.
import { Color } from "three";
import { fatLine, fatSegments, release, segmentsOf, thinSegments } from "./lines.js";

// While the view moves, every so many points of the many lines are drawn: some 2 cm apart on a body.
const COARSE = 4;

/** Segments and colors of several lines, one after the other, with every `step`-th of their points. */
function joined(lines, step) {
  const parts = lines.map(({ points }) => {
    const few = every(points, step);
    return segmentsOf(few, 1, few.length / 3);
  });
  const total = parts.reduce((sum, part) => sum + part.length, 0);
  const segments = new Float32Array(total);
  const colors = new Float32Array(total);
  let at = 0;
  parts.forEach((part, n) => {
    segments.set(part, at);
    const color = new Color(lines[n].color).toArray();
    for (let i = 0; i < part.length; i++) colors[at + i] = color[i % 3];
    at += part.length;
  });
  return { segments, colors };
}

/** Every so many points of a line, and its last, so that a closed one stays closed. */
function every(points, step) {
  const count = points.length / 3;
  if (step === 1 || count <= 2 * step) return points;
  const kept = [];
  for (let n = 0; n < count - 1; n += step) kept.push(...points.subarray(3 * n, 3 * n + 3));
  kept.push(...points.subarray(-3));
  return new Float32Array(kept);
}

export class Lines {
  #drawn = new Map();
  #batch = { signature: "", ids: [], fat: null, thin: null };
  #coarse = false;

  constructor(scene, stage) {
    this.scene = scene;
    this.stage = stage;
  }

  /** Draw exactly these: {id, points (flat), color, width, dashed, through, batched, lit}. */
  set(lines) {
    const kept = new Set();
    const whole = lines.filter((line) => line.points.length >= 6);
    this.#setBatch(whole.filter((line) => line.batched));
    for (const line of whole) {
      if (line.batched) continue;
      kept.add(line.id);
      const drawn = this.#drawn.get(line.id);
      if (drawn && drawn.points === line.points && drawn.dashed === line.dashed) {
        drawn.object.material.color.set(line.color);
        drawn.object.material.linewidth = line.width;
        drawn.lit = line.lit;
        continue;
      }
      release(drawn?.object);
      const object = fatLine(line.points, line);
      object.userData.id = line.id;
      this.scene.add(object);
      this.#drawn.set(line.id, { points: line.points, dashed: line.dashed, lit: line.lit, object });
    }
    for (const [id, { object }] of this.#drawn) {
      if (kept.has(id)) continue;
      release(object);
      this.#drawn.delete(id);
    }
    this.stage.invalidate();
  }

  #setBatch(lines) {
    const signature = lines.map((line) => `${line.id} ${line.color}`).join("\n");
    const first = lines[0]?.points;
    if (signature === this.#batch.signature && first === this.#batch.first) return;
    release(this.#batch.fat);
    release(this.#batch.thin);
    this.#batch = { signature, first, ids: lines.map((line) => line.id), fat: null, thin: null };
    if (!lines.length) return;
    const whole = joined(lines, 1);
    const few = joined(lines, COARSE);
    this.#batch.fat = fatSegments(whole.segments, { colors: whole.colors, width: lines[0].width });
    this.#batch.thin = thinSegments(few.segments, { colors: few.colors });
    this.scene.add(this.#batch.fat, this.#batch.thin);
    this.setCoarse(this.#coarse);
  }

  /**
   * While the view moves and drawing is slow, the many lines are thin and have fewer points, and
   * dashes, which cost most, wait.
   */
  setCoarse(coarse) {
    this.#coarse = coarse;
    for (const { object, dashed, lit } of this.#drawn.values()) object.visible = !coarse || lit || !dashed;
    const { fat, thin } = this.#batch;
    if (!fat) return;
    fat.visible = !coarse;
    thin.visible = coarse;
  }

  get ids() {
    return [...this.#drawn.keys(), ...this.#batch.ids];
  }

  clear() {
    this.set([]);
  }
}

// The lines of tapes, kept in step with a list of what should be drawn: a line that is not in the
// list any more is released, and one that did not change is left alone. A chart has two hundred
// tapes; those of them that nobody points at are one object, since each object costs time.
import { Color } from "three";
import { fatLine, fatSegments, release, segmentsOf, thinSegments } from "./lines.js";

export class Lines {
  #drawn = new Map();
  #batch = { signature: "", ids: [], fat: null, thin: null };
  #coarse = false;

  constructor(scene, stage) {
    this.scene = scene;
    this.stage = stage;
  }

  /** Draw exactly these: {id, points (flat), color, width, dashed, through, batched}. */
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
        continue;
      }
      release(drawn?.object);
      const object = fatLine(line.points, line);
      object.userData.id = line.id;
      this.scene.add(object);
      this.#drawn.set(line.id, { points: line.points, dashed: line.dashed, object });
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
    const parts = lines.map((line) => segmentsOf(line.points, 1, line.points.length / 3));
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
    this.#batch.fat = fatSegments(segments, { colors, width: lines[0].width });
    this.#batch.thin = thinSegments(segments, { colors });
    this.scene.add(this.#batch.fat, this.#batch.thin);
    this.setCoarse(this.#coarse);
  }

  /** While the view moves and drawing is slow, the many lines are thin. */
  setCoarse(coarse) {
    this.#coarse = coarse;
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

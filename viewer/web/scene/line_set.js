// The fat lines of tapes, kept in step with a list of what should be drawn: a line that is not in
// the list any more is released, and one that did not change is left alone.
import { fatLine, release } from "./lines.js";

export class Lines {
  #drawn = new Map();

  constructor(scene, stage) {
    this.scene = scene;
    this.stage = stage;
  }

  /** Draw exactly these: {id, points (flat), color, width, dashed, through}. */
  set(lines) {
    const kept = new Set();
    for (const line of lines) {
      if (line.points.length < 6) continue;
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

  get ids() {
    return [...this.#drawn.keys()];
  }

  clear() {
    this.set([]);
  }
}

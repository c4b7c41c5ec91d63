// What can be laid over the body: seams, control nets, diagonals, boundary curves, landmarks. Each is
// fetched when it is first asked for.
import { colorValues, scaleOf, toScale } from "../model/colors.js";
import { NO_ARRAY } from "../transport/bm1.js";
import { fatSegments, lifted, release, segmentsOf, thinSegments } from "./lines.js";
import { nearestLine } from "./nearest.js";

const FETCHED = ["nets", "diagonals", "boundary"];

export class Layers {
  #objects = {};
  #data = {};
  // What is under way for this body: an answer about the one before comes too late.
  #busy = new Set();
  #coarse = false;

  constructor(app, viewport) {
    this.app = app;
    this.viewport = viewport;
    this.seamField = null;
    // What the legend shows of the lines: the scale, or null.
    this.scale = null;
  }

  /** Forget the layers of the body before. */
  reset() {
    this.clear();
    this.#data = {};
    this.#busy = new Set();
    this.#data.seams = {
      points: this.app.arrays.seams ?? NO_ARRAY,
      normals: this.app.arrays.seam_normals ?? NO_ARRAY,
    };
    this.update();
  }

  clear() {
    for (const name of Object.keys(this.#objects)) this.#drop(name);
  }

  #drop(name) {
    release(this.#objects[name]);
    delete this.#objects[name];
  }

  /** Draw the layers that are wanted now, and fetch what is not here yet. */
  update() {
    const wanted = this.app.settings.get("layers");
    for (const name of ["seams", ...FETCHED]) {
      if (!wanted[name] || !this.app.header) this.#drop(name);
      else if (this.#data[name] && !this.#lacksDifferences(name)) this.#draw(name);
      else this.#fetch(name);
    }
    this.#applyCoarse();
    this.viewport.stage.invalidate();
  }

  /** Differences from the mesh take a minute, so they are asked for when they are wanted. */
  #lacksDifferences(name) {
    return name === "diagonals" && this.#wantsDifferences && !this.#data[name].compared;
  }

  get #wantsDifferences() {
    return this.app.settings.get("lines") === "difference" && this.app.transport.can.measure;
  }

  async #fetch(name) {
    const busy = this.#busy;
    if (busy.has(name)) return;
    busy.add(name);
    const { app } = this;
    const stays = () => busy === this.#busy;
    try {
      const compared = name === "diagonals" && this.#wantsDifferences;
      const ask = () => app.transport.layer(app.bodyId, name, compared);
      const { header, arrays } = await app.during(`Computing: ${name}…`, ask, { long: compared });
      if (stays()) this.#data[name] = { points: arrays.points, normals: arrays.normals, items: header.items ?? [], compared };
    } catch (error) {
      if (stays()) {
        app.settings.setLayer(name, false);
        app.fail(error);
      }
    } finally {
      busy.delete(name);
    }
    if (!stays()) return;
    // What was chosen meanwhile may want more than was asked for.
    this.update();
    app.emit("layers");
  }

  #draw(name) {
    this.#drop(name);
    const { points, normals, items } = this.#data[name];
    const [count, samples] = points.shape;
    if (!count) return;
    const dark = this.app.settings.theme === "dark";
    const raised = lifted(points.data, normals?.data, this.viewport.lift);
    const segments = segmentsOf(raised, count, samples);
    let object;
    if (name === "seams") {
      object = this.seamField
        ? fatSegments(segments, { colors: this.#seamColors(count, samples), width: 2.5 })
        : thinSegments(segments, { color: "#4a4640", opacity: dark ? 0.45 : 0.3 });
    } else if (name === "nets") {
      object = thinSegments(segments, { color: dark ? "#8fb8d8" : "#3d6f94", opacity: 0.6 });
    } else if (name === "boundary") {
      object = fatSegments(segments, { color: dark ? "#d08a4a" : "#a85a1a", width: 2.5 });
    } else {
      object = fatSegments(segments, { colors: this.#lineColors(items, count, samples), width: 2 });
    }
    object.userData.layer = name;
    this.#objects[name] = object;
    this.viewport.stage.scene.add(object);
  }

  /** Color the seams by a value a sample, or draw them plainly with null. */
  setSeamField(field) {
    if (!field && !this.seamField) return;
    this.seamField = field;
    this.update();
  }

  #seamColors(count, samples) {
    const { values } = this.seamField;
    const each = new Float32Array(3 * values.length);
    colorValues(values, this.seamField, each);
    return segmentsOf(each, count, samples);
  }

  /** The value of the seam within reach of a point; undefined where there is no seam. */
  seamValue(point, reach) {
    const near = this.seamField && this.nearest("seams", point, reach);
    if (!near) return undefined;
    const { values } = this.seamField;
    const first = near.line * this.#data.seams.points.shape[1] + near.sample;
    // Where one of both is missing, so is what lies between.
    return near.part > 0 ? values[first] + near.part * (values[first + 1] - values[first]) : values[first];
  }

  /** The line of a layer within reach of a point: {line, sample, part}, or null. */
  nearest(name, point, reach) {
    return this.#data[name] ? nearestLine(this.#data[name].points, point, reach) : null;
  }

  /** The colors of the diagonals by what the user chose, and their scale for the legend. */
  #lineColors(items, count, samples) {
    const key = this.app.settings.get("lines");
    const values = items.map((item) => toScale(key, { length: item.length, error: item.error_estimate, difference: item.difference, proven: Number(item.proven) }[key]));
    this.scale = scaleOf(key, values);
    const each = new Float32Array(3 * count);
    colorValues(values, this.scale, each);
    const colors = new Float32Array(count * (samples - 1) * 6);
    for (let n = 0; n < colors.length / 3; n++) {
      const line = Math.floor(n / (2 * (samples - 1)));
      colors.set(each.subarray(3 * line, 3 * line + 3), 3 * n);
    }
    return colors;
  }

  /** The records of a layer that is here, for naming what is under the pointer. */
  items(name) {
    return this.#data[name]?.items ?? [];
  }

  shown(name) {
    return Boolean(this.#objects[name]);
  }

  setCoarse(coarse) {
    this.#coarse = coarse;
    this.#applyCoarse();
  }

  #applyCoarse() {
    for (const name of ["seams", "nets", "diagonals"]) {
      if (this.#objects[name]) this.#objects[name].visible = !this.#coarse;
    }
  }
}

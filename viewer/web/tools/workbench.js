// Joins the scene, the pointer and the tools: what a hover shows, what a click does, what is drawn.
import { LANDMARK_COLOR, LIT_COLOR, TAPE_COLOR } from "../model/colors.js";
import { placeWords } from "../model/items.js";
import { TapeLines, bandLabel } from "../scene/tape_lines.js";
import { Handles } from "./handles.js";
import { GirthTool, LandmarkTool, LookTool, LoopTool, placeLandmark } from "./other_tools.js";
import { Picker } from "./picker.js";
import { Pointer } from "./pointer.js";
import { TapeTool } from "./tape_tool.js";

// The pointer rests this long, in milliseconds, before the length up to it is asked for.
const PREVIEW = 160;

export class Workbench {
  #preview = null;
  #timer = 0;

  constructor(app, viewport) {
    this.app = app;
    this.viewport = viewport;
    this.picker = new Picker(app, viewport);
    this.tapes = new TapeLines(app, viewport);
    this.handles = new Handles(app, viewport, this.picker, {
      onPress: (press) => this.press(press),
      onHover: (hit) => this.hover(hit),
    });
    const tools = [LookTool, TapeTool, GirthTool, LoopTool, LandmarkTool].map((Tool) => new Tool(app, viewport));
    this.tools = Object.fromEntries(tools.map((tool) => [tool.name, tool]));
    this.tool = this.tools.tape;
    this.hit = null;
    this.landmark = null;
    new Pointer(viewport.stage.canvas, {
      onHover: ({ x, y, alt }) => this.hover(this.picker.at(x, y, { snap: !alt })),
      onClick: (press) => this.press(press),
      onDouble: ({ x, y }) => this.pivot(x, y),
      onLeave: () => this.hover(null),
    });
    for (const name of ["sheet", "results", "chart", "selection", "lit", "settings", "layers", "compare"]) {
      app.on(name, () => this.update());
    }
    app.on("body", () => this.use(this.tool.name));
    app.on("landmark", (name) => this.selectLandmark(name));
    app.on("selection", ({ fly }) => fly && this.fly(app.selected));
  }

  use(name) {
    this.tool.cancel?.();
    this.tool = this.tools[name];
    this.#preview = null;
    this.app.emit("tool", name);
    this.update();
  }

  press({ x, y, alt = false, shift = false }) {
    const hit = this.picker.at(x, y, { snap: !alt });
    if (!hit) {
      if (this.tool.name === "look") this.app.select(null);
      else this.app.emit("message", { text: "That point is off the body. Click on the body itself.", tone: "note" });
      return;
    }
    if (hit.side) {
      this.app.emit("message", { text: "Measure on the body at the left; the other one is there to compare.", tone: "note" });
      return;
    }
    if (this.tool.name === "look") {
      if (hit.snap === "landmark") this.app.emit("landmark", hit.name);
      else this.app.select(this.#row(hit));
    } else if (this.#mayMeasure()) {
      this.tool.click(hit, { shift });
    }
    this.#preview = null;
    this.hit = hit;
    this.app.emit("tool", this.tool.name);
    this.update();
  }

  /** An exported page has nobody to ask; there a tape is its straight distance. */
  #mayMeasure() {
    if (this.app.transport.can.measure || this.tool.name === "tape") return true;
    this.app.emit("message", { text: "This page stands alone: it shows points and straight distances, and cannot measure.", tone: "note" });
    return false;
  }

  #row(hit) {
    return this.tapes.nearest(hit.point, this.viewport.reach);
  }

  hover(hit) {
    this.hit = hit;
    const row = hit && !hit.side ? this.#row(hit) : null;
    this.app.light(row);
    this.app.emit("hover", hit && { ...hit, row, words: this.#words(hit) });
    this.#preview = null;
    clearTimeout(this.#timer);
    if (this.tool.points?.length) {
      if (hit && this.app.transport.can.measure) this.#timer = setTimeout(() => this.#measurePreview(), PREVIEW);
      this.update();
    } else if (hit?.snap || this.ring) this.update();
  }

  async #measurePreview() {
    const preview = this.tool.preview?.(this.hit);
    // Lengths that were asked for come first.
    if (!preview || this.app.measuring.busy) return;
    const { hit } = this;
    const question = this.app.sheet.question(preview);
    try {
      const result = this.app.sheet.result(preview) ?? (await this.app.measuring.request(preview));
      if (result.superseded) return;
      this.app.sheet.keep(preview, result, question);
      if (hit === this.hit && this.tool.points?.length) this.#preview = result;
      this.update();
    } catch {
      // The click itself will say what is wrong.
    }
  }

  /** What is under the pointer, in words. */
  #words(hit) {
    const header = hit.side ? this.app.other.header : this.app.header;
    const words = [hit.snap === "landmark" ? hit.name : placeWords(hit.location, header)];
    if (hit.snap === "corner") words.push("corner of the patch");
    if (hit.side) words.unshift(header.name);
    return words;
  }

  pivot(x, y) {
    // The first of the two clicks may have begun a tape.
    if (this.tool.points?.length === 1) this.tool.cancel();
    const hit = this.picker.at(x, y, { snap: false });
    if (hit) this.viewport.stage.rig.fly({ ...this.viewport.stage.rig.view, target: hit.point });
    this.update();
  }

  fly(id) {
    const { points, normals } = this.tapes.extent(id);
    if (points.length) this.viewport.frame(points, normals);
  }

  selectLandmark(name) {
    this.landmark = name;
    this.update();
  }

  /** Leave what is half made, then the tool, then the selection: one thing each time. */
  escape() {
    if (!this.tool.cancel?.()) {
      if (this.app.selected || this.landmark) {
        this.app.select(null);
        this.landmark = null;
        this.app.emit("landmark", null);
      } else if (this.tool.name !== "look") this.use("look");
    }
    this.#preview = null;
    this.app.emit("tool", this.tool.name);
    this.update();
  }

  /** Draw everything that is not the body. */
  update() {
    const { app, viewport } = this;
    if (!app.header || !viewport.surface) return;
    const { theme } = app.settings;
    this.tapes.extra = [];
    const band = this.tool.band?.(this.hit);
    if (band && band.places.length > 1) this.tapes.extra.push(this.#band(band, theme));
    this.tapes.update();
    this.ring = Boolean(this.hit?.snap);
    viewport.dots.set(this.#dots(theme));
    this.handles.set(this.#handles());
    viewport.stage.invalidate();
  }

  #band({ places, straight }, theme) {
    const flat = new Float32Array(places.flat());
    const lines = [
      { id: "band", points: flat, color: TAPE_COLOR[theme], width: 2, dashed: this.viewport.radius * 0.008, through: true, lit: true },
    ];
    if (this.#preview?.points) {
      lines.push({ id: "preview", points: new Float32Array(this.#preview.points.flat()), color: TAPE_COLOR[theme], width: 2.5, dashed: 0, through: false });
    }
    const text = bandLabel({ straight }, this.#preview, this.app.unit);
    return { lines, labels: [{ id: "band", anchor: places.at(-1), text, tone: "lit" }] };
  }

  #dots(theme) {
    const { app } = this;
    const dots = [];
    if (app.settings.get("layers").landmarks) {
      for (const one of app.landmarks) {
        const lit = one.name === this.landmark || (this.hit?.snap === "landmark" && this.hit.name === one.name);
        dots.push({ position: one.position, color: lit ? LIT_COLOR[theme] : one.edited ? "#8a4fa3" : LANDMARK_COLOR, size: lit ? 15 : 9 });
      }
    }
    for (const point of this.tool.points ?? []) dots.push({ position: point.point, color: LIT_COLOR[theme], size: 11 });
    if (this.hit && !this.hit.side && this.tool.name !== "look" && this.hit.snap !== "landmark") {
      dots.push({ position: this.hit.point, color: this.hit.snap ? LIT_COLOR[theme] : TAPE_COLOR[theme], size: this.hit.snap ? 14 : 8 });
    }
    return dots;
  }

  #handles() {
    const { app } = this;
    const handles = [];
    const tape = app.sheet.tape(app.selected);
    if (tape?.visible) {
      tape.locations.forEach((location, n) => {
        const last = tape.locations.length - 1;
        const what = n === 0 ? "Start" : n === last ? "End" : `Point ${n} on the way`;
        handles.push({
          key: `${tape.id}-${n}`,
          label: `${what} of ${tape.name}; drag it, or move it with the arrow keys`,
          at: () => app.placeOf(app.sheet.tape(tape.id)?.locations[n] ?? location),
          move: (hit, first) => {
            const locations = app.sheet.tape(tape.id).locations.map((one, k) => (k === n ? hit.location : one));
            if (JSON.stringify(locations) === JSON.stringify(app.sheet.tape(tape.id).locations)) return;
            app.sheet.change(tape.id, { locations }, { step: first });
          },
        });
      });
    }
    const landmark = app.landmarks.find((one) => one.name === this.landmark);
    if (landmark && app.transport.can.measure) {
      handles.push({
        key: "landmark",
        label: `${landmark.name}; drag it, or move it with the arrow keys`,
        at: () => app.landmarks.find((one) => one.name === landmark.name)?.position,
        move: (hit, first) => {
          // Onto itself it would never move away.
          if (!Array.isArray(hit.location)) return;
          const moved = { ...app.sheet.landmarks, [landmark.name]: { location: hit.location, position: hit.point } };
          app.sheet.setLandmarks(moved, { step: first });
        },
        end: () => {
          const { location, position } = app.sheet.landmarks[landmark.name] ?? {};
          if (location) this.#settle(landmark.name, location, position);
        },
      });
    }
    return handles;
  }

  /** After a drag, stand where the smooth surface is; no step of its own. */
  async #settle(name, location) {
    const answer = await this.app.try(() => this.app.transport.point(this.app.bodyId, location));
    if (!answer || this.app.sheet.landmarks[name]?.location !== location) return;
    const landmarks = { ...this.app.sheet.landmarks, [name]: { location, position: answer.position } };
    this.app.sheet.setLandmarks(landmarks, { step: false });
  }

  /** Put the mirror image of a landmark on the other side. */
  async mirror(name) {
    const landmark = this.app.landmarks.find((one) => one.name === name);
    const other = otherSide(name);
    if (!landmark || !other) return;
    await this.app.try(async () => {
      const answer = await this.app.transport.mirror(this.app.bodyId, landmark.location);
      await placeLandmark(this.app, other, answer.location, answer.position);
      this.app.emit("landmark", other);
    });
  }
}

/** The name of a landmark on the other side, or null for one in the middle. */
export function otherSide(name) {
  if (/\bleft\b/.test(name)) return name.replace(/\bleft\b/, "right");
  if (/\bright\b/.test(name)) return name.replace(/\bright\b/, "left");
  return null;
}

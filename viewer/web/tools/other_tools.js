// Tools of one click: looking, girths, closed loops, landmarks.
import { addTape } from "./tape_tool.js";

export class LookTool {
  name = "look";
  hint = "Drag to turn, wheel to zoom, right-drag to move. Click a tape to select it.";
  click() {}
}

export class GirthTool {
  name = "girth";
  hint = "Click at the height of the girth.";

  constructor(app) {
    this.app = app;
  }

  click(hit) {
    addTape(this.app, { mode: "girth", kind: "taut", title: "Girth", locations: [hit.location] });
  }
}

export class LoopTool {
  name = "loop";
  hint = "Click a point; the shortest closed loop around the body from there is measured.";

  constructor(app) {
    this.app = app;
  }

  click(hit) {
    addTape(this.app, { mode: "closed", kind: "contact", title: "Loop", locations: [hit.location] });
  }
}

export class LandmarkTool {
  name = "landmark";

  constructor(app) {
    this.app = app;
    this.target = null;
  }

  get hint() {
    return this.target ? `Click where the ${this.target} is.` : "Click to place a landmark, then name it.";
  }

  async click(hit) {
    if (hit.snap === "landmark" && !this.target) {
      this.app.emit("landmark", hit.name);
      return;
    }
    const location = Array.isArray(hit.location) ? hit.location : this.#locationOf(hit);
    const name = this.target ?? this.#freeName();
    const unnamed = !this.target;
    this.target = this.#next(name);
    await placeLandmark(this.app, name, location, hit.point);
    this.app.emit("landmark", name);
    if (unnamed) this.app.emit("name-landmark", name);
  }

  #locationOf(hit) {
    return this.app.landmarks.find((one) => one.name === hit.location)?.location ?? hit.location;
  }

  /** The next one that is lacking, so that a body can be clicked through from top to bottom. */
  #next(name) {
    if (!this.target) return null;
    const lacking = this.app.lacking.map((one) => one.name);
    const at = lacking.indexOf(name);
    return lacking.filter((one) => one !== name)[Math.max(0, at)] ?? null;
  }

  #freeName() {
    const names = new Set(this.app.landmarks.map((one) => one.name));
    let number = 1;
    while (names.has(`landmark ${number}`)) number++;
    return `landmark ${number}`;
  }

  cancel() {
    const had = this.target !== null;
    this.target = null;
    return had;
  }
}

/** Put a landmark where the program says the smooth surface is. */
export async function placeLandmark(app, name, location, point) {
  await app.try(async () => {
    const position = app.transport.can.measure
      ? (await app.transport.point(app.bodyId, location)).position
      : point;
    app.sheet.setLandmark(name, { location, position });
  });
}

// The tape: two clicks, or more with points on the way, and a rubber band in between.

// Clicks nearer than this, in pixels, are one click twice.
const SLIP = 5;

export class TapeTool {
  name = "tape";
  points = [];

  constructor(app, viewport) {
    this.app = app;
    this.viewport = viewport;
  }

  get hint() {
    if (!this.points.length) return "Click where the tape begins.";
    const via = this.app.settings.get("via");
    if (!via) return "Click where it ends. Shift-click adds a point on the way.";
    return this.points.length < 2 ? "Click the next point." : "Click the next point; Enter ends the tape.";
  }

  click(hit, { shift = false } = {}) {
    const last = this.points.at(-1);
    if (last && this.#same(last, hit)) return false;
    this.points.push(hit);
    const goesOn = this.app.settings.get("via") || shift;
    if (this.points.length >= 2 && !goesOn) this.finish();
    return true;
  }

  #same(a, b) {
    if (JSON.stringify(a.location) === JSON.stringify(b.location)) return true;
    const [p, q] = [a, b].map((one) => this.viewport.stage.project(one.point));
    return Math.hypot(p.x - q.x, p.y - q.y) < SLIP;
  }

  finish() {
    if (this.points.length >= 2) {
      const locations = this.points.map((point) => point.location);
      this.points = [];
      addTape(this.app, { mode: "path", kind: "contact", title: "Tape", locations });
    }
    this.points = [];
  }

  back() {
    this.points.pop();
  }

  cancel() {
    const had = this.points.length > 0;
    this.points = [];
    return had;
  }

  /** The rubber band: through the points so far to the pointer. */
  band(hit) {
    if (!this.points.length) return null;
    const places = [...this.points, ...(hit ? [hit] : [])].map((one) => one.point);
    let straight = 0;
    for (let i = 1; i < places.length; i++) {
      straight += Math.hypot(...places[i].map((value, k) => value - places[i - 1][k]));
    }
    return { places, straight };
  }

  /** What a click at the pointer would measure, to be shown before it. */
  preview(hit) {
    if (!this.points.length || !hit || this.#same(this.points.at(-1), hit)) return null;
    const locations = [...this.points, hit].map((one) => one.location);
    return { id: "preview", mode: "path", kind: "contact", locations };
  }
}

/** Put a tape on the list and select it. */
export function addTape(app, tape) {
  const named = tape.locations.every((one) => typeof one === "string");
  const name = named && tape.mode === "path" ? { name: tape.locations.join(" to ") } : {};
  const whole = app.sheet.add({ ...tape, ...name });
  app.select(whole.id);
  return whole;
}

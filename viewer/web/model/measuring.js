// Asking for lengths. One question is under way at a time, and of each tape only the newest waits:
// while an end is dragged, the tape follows as fast as the program measures, and never lags behind.

export class Measuring {
  #waiting = new Map();
  #running = false;
  #serial = 0;

  constructor(app) {
    this.app = app;
  }

  get busy() {
    return this.#running;
  }

  /** Ask for the result of a tape, unless it is known. */
  ask(tape) {
    if (this.app.sheet.result(tape)) return;
    if (!this.app.transport.can.measure) {
      this.app.sheet.keep(tape, this.#straight(tape));
      return;
    }
    this.#waiting.set(tape.id, tape);
    this.#run();
  }

  /** Ask for the tapes that have no result yet, as after going back or after a reconnection. */
  askAll() {
    for (const tape of this.app.sheet.tapes) this.ask(tape);
  }

  /** Without the program, what the page knows itself: the straight distance. */
  #straight({ locations }) {
    const points = locations.map((location) => this.app.placeOf(location));
    let length = 0;
    for (let i = 1; i < points.length; i++) {
      length += Math.hypot(...points[i].map((value, k) => value - points[i - 1][k]));
    }
    const words = "The straight distance. This page stands alone and cannot measure along the body.";
    return { length, words, straight: length, points, through: true };
  }

  async #run() {
    if (this.#running) return;
    this.#running = true;
    this.app.emitter.emit("busy", true);
    try {
      while (this.#waiting.size) {
        const [id, tape] = this.#waiting.entries().next().value;
        this.#waiting.delete(id);
        await this.#measure(tape);
      }
    } finally {
      this.#running = false;
      this.app.emitter.emit("busy", false);
    }
  }

  async #measure(tape) {
    const { app } = this;
    try {
      const result = await this.request(tape);
      if (!result.superseded) app.sheet.keep(tape, result);
      else if (app.sheet.tape(tape.id)) this.#waiting.set(tape.id, app.sheet.tape(tape.id));
    } catch (error) {
      // Nobody answered: the question stays open and is asked again after the reconnection.
      if (error.gone) app.emitter.emit("gone", error.message);
      else app.sheet.keep(tape, { error: error.message, length: null });
    }
  }

  /** Send the question of a tape. */
  request({ mode, kind, locations }) {
    const { transport, bodyId, sheet } = this.app;
    const places = locations.map(sheet.resolve);
    const serial = ++this.#serial;
    if (mode === "girth") return transport.girth(bodyId, { serial, location: places[0], kind });
    if (mode === "closed") return transport.closed(bodyId, { serial, location: places[0] });
    return transport.path(bodyId, { serial, locations: places, kind });
  }
}

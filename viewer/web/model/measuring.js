// Asking for lengths. One question is under way at a time, and of each tape only the newest waits:
// while an end is dragged, the tape follows as fast as the program measures, and never lags behind.

// What answers a failure that is the program's, not the library's, is asked again once: a question
// that the process does not survive would otherwise end it for ever.
const MOST_TRIES = 2;
// The library itself has answered, with a sentence that stays true.
const LIBRARY = 422;

export class Measuring {
  #waiting = new Map();
  #tries = new Map();
  #restarts = 0;
  #running = false;
  #serial = 0;

  constructor(app) {
    this.app = app;
    app.on("body", () => {
      this.#waiting.clear();
      this.#tries.clear();
    });
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

  /** Ask again what has failed, as after the program that measures was started again. */
  askAgain() {
    this.#restarts++;
    this.app.sheet.forgetFailed((question) => (this.#tries.get(question) ?? 0) < MOST_TRIES);
    this.askAll();
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
    const question = app.sheet.question(tape);
    const restarts = this.#restarts;
    try {
      const result = await this.request(tape);
      if (!result.superseded) app.sheet.keep(tape, result, question);
      else if (app.sheet.tape(tape.id)) this.#waiting.set(tape.id, app.sheet.tape(tape.id));
    } catch (error) {
      // Nobody answered: the question stays open and is asked again after the reconnection.
      if (error.gone) app.emitter.emit("gone", error.message);
      else {
        this.#tries.set(question, (this.#tries.get(question) ?? 0) + 1);
        const passing = error.status !== LIBRARY;
        app.sheet.keep(tape, { error: error.message, length: null, passing }, question);
        // The news of the new start may be faster than the answer that tells of the end.
        if (restarts !== this.#restarts) this.askAgain();
      }
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

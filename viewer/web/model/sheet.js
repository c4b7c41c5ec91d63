// What the user made: tapes and landmarks, with undo and redo. A state is never changed, only
// replaced, so that going back is to show an older one; results are kept beside it by what was
// asked, so that going back asks nothing again.

// More steps than anybody goes back; without a limit a day of dragging would fill the memory.
const MOST_STEPS = 200;
const MOST_RESULTS = 60;

const EMPTY = { tapes: [], landmarks: {}, last: 0 };

export class Sheet {
  #past = [];
  #future = [];
  #results = new Map();

  /**
   * `resolve` says where a landmark is by name, since the same name may be moved; `about` says which
   * body is measured, and which version of it.
   */
  constructor(emitter, resolve, about) {
    this.emitter = emitter;
    this.resolve = resolve;
    this.about = about;
    this.state = EMPTY;
  }

  get tapes() {
    return this.state.tapes;
  }

  /** Landmarks that were moved or added, by name; null for one that was removed. */
  get landmarks() {
    return this.state.landmarks;
  }

  tape(id) {
    return this.state.tapes.find((tape) => tape.id === id);
  }

  #replace(state, step = true) {
    if (step) {
      this.#past.push(this.state);
      if (this.#past.length > MOST_STEPS) this.#past.shift();
      this.#future = [];
    }
    this.state = state;
    this.emitter.emit("sheet");
  }

  add(tape) {
    const last = this.state.last + 1;
    const whole = { id: `tape-${last}`, name: `${tape.title} ${last}`, visible: true, ...tape };
    this.#replace({ ...this.state, last, tapes: [...this.state.tapes, whole] });
    return whole;
  }

  /** Change a tape; `step: false` while something is dragged, which is undone as a whole. */
  change(id, changes, { step = true } = {}) {
    const tapes = this.state.tapes.map((tape) => (tape.id === id ? { ...tape, ...changes } : tape));
    this.#replace({ ...this.state, tapes }, step);
  }

  /** Remember where a drag began, as one step. */
  mark() {
    this.#replace(this.state);
  }

  remove(id) {
    this.#replace({ ...this.state, tapes: this.state.tapes.filter((tape) => tape.id !== id) });
  }

  setLandmark(name, location) {
    this.#replace({ ...this.state, landmarks: { ...this.state.landmarks, [name]: location } });
  }

  setLandmarks(landmarks, { step = true } = {}) {
    this.#replace({ ...this.state, landmarks }, step);
  }

  /** Give a landmark another name, also in the tapes that lie at it; `landmarks` are those after it. */
  renameLandmark(old, name, landmarks) {
    const named = (location) => (location === old ? name : location);
    const tapes = this.state.tapes.map((tape) => {
      if (!tape.locations.includes(old)) return tape;
      const locations = tape.locations.map(named);
      // A tape that has its name from its landmarks follows these.
      const title = tape.name === tape.locations.join(" to ") ? locations.join(" to ") : tape.name;
      return { ...tape, locations, name: title };
    });
    this.#replace({ ...this.state, tapes, landmarks });
  }

  /** Take a landmark off; tapes that lie at it stay where they are. */
  removeLandmark(name, location, landmarks) {
    const tapes = this.state.tapes.map((tape) => ({ ...tape, locations: tape.locations.map((one) => (one === name ? location : one)) }));
    this.#replace({ ...this.state, tapes, landmarks });
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  undo() {
    if (!this.canUndo) return false;
    this.#future.push(this.state);
    this.state = this.#past.pop();
    this.emitter.emit("sheet");
    return true;
  }

  redo() {
    if (!this.canRedo) return false;
    this.#past.push(this.state);
    this.state = this.#future.pop();
    this.emitter.emit("sheet");
    return true;
  }

  /** Take the place of all that was, as when a body is opened. */
  load({ tapes = [], landmarks = {}, last = 0 } = {}) {
    this.#past = [];
    this.#future = [];
    this.state = { tapes, landmarks, last };
    this.emitter.emit("sheet");
  }

  /** Go on over a body that was read again, with the landmarks that were saved as its own. */
  refresh(saved) {
    const kept = Object.entries(this.state.landmarks).filter(
      ([name, edit]) => !(name in saved) || JSON.stringify(edit?.location ?? null) !== JSON.stringify(saved[name]),
    );
    this.#replace({ ...this.state, landmarks: Object.fromEntries(kept) }, false);
  }

  /** What is asked for a tape; two tapes that ask the same have the same answer. */
  question({ mode, kind, locations }) {
    return JSON.stringify([this.about(), mode, kind, locations.map(this.resolve)]);
  }

  result(tape) {
    return this.#results.get(this.question(tape));
  }

  /** Keep an answer; the question is the one that was asked, since what it is about may change. */
  keep(tape, result, question = this.question(tape)) {
    this.#results.delete(question);
    this.#results.set(question, result);
    if (this.#results.size > MOST_RESULTS) this.#forget();
    this.emitter.emit("results", tape.id);
  }

  /** Drop the oldest answers that no tape shows. */
  #forget() {
    const shown = new Set(this.state.tapes.map((tape) => this.question(tape)));
    for (const question of this.#results.keys()) {
      if (this.#results.size <= MOST_RESULTS / 2) return;
      if (!shown.has(question)) this.#results.delete(question);
    }
  }

  forgetResults() {
    this.#results.clear();
  }

  /** Forget failures that may pass, of the questions that are to be asked again. */
  forgetFailed(again) {
    for (const [question, { passing }] of this.#results) {
      if (passing && again(question)) this.#results.delete(question);
    }
  }
}

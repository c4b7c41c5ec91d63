// The viewer as a whole: what is open, what is selected, and who draws it. The parts do not know
// each other; they listen to what the app says has changed.
import { Emitter } from "./model/emitter.js";
import { chartItems, tapeItem } from "./model/items.js";
import { Measuring } from "./model/measuring.js";
import { MeshCheck } from "./model/mesh_check.js";
import { memory, Settings } from "./model/settings.js";
import { Sheet } from "./model/sheet.js";
import { soundSheet } from "./model/tape_files.js";
import { interpolate } from "./scene/grid.js";
import { Failure } from "./transport/failure.js";

// The answer to what the user has stopped.
const STOPPED = 409;
const TAKING = "Taking the measurements…";

export class App {
  // What the page waits for, in words; and how often a body was chosen.
  #awaited = [];
  #choice = 0;

  constructor(root, transport, options = {}) {
    this.root = root;
    this.transport = transport;
    this.options = options;
    this.emitter = new Emitter();
    this.settings = new Settings(this.emitter, options.settings);
    const about = () => [this.bodyId, this.header?.version];
    this.sheet = new Sheet(this.emitter, (location) => this.resolve(location), about);
    this.measuring = new Measuring(this);
    this.meshCheck = new MeshCheck(this);
    this.bodyId = "0";
    this.header = null;
    this.chart = null;
    this.otherChart = null;
    this.other = null;
    this.hiddenKeys = new Set();
    this.selected = null;
    this.lit = null;
    this.reopened = false;
    this.taking = null;
    this.on("sheet", () => this.#keep());
    this.on("sheet", () => this.measuring.askAll());
  }

  on(name, listener) {
    return this.emitter.on(name, listener);
  }

  emit(name, value) {
    this.emitter.emit(name, value);
  }

  get unit() {
    return this.header && this.header.unit === "" ? "" : this.settings.get("unit");
  }

  /** Fetch a body and make it the one that is measured. */
  async open(id = "0") {
    const choice = ++this.#choice;
    const answer = await this.transport.body(id);
    // Of two that were chosen, the later one is shown, whichever comes first.
    if (choice === this.#choice) this.#show(id, answer);
  }

  #show(id, { header, arrays }) {
    this.bodyId = header.id ?? id;
    this.header = header;
    this.arrays = arrays;
    this.chart = null;
    this.otherChart = null;
    this.other = null;
    this.hiddenKeys.clear();
    this.selected = null;
    this.taking = null;
    this.sheet.forgetResults();
    this.emit("body");
    this.sheet.load(this.#kept());
  }

  /**
   * Read the body again, as when its file changed; tapes stay and are measured anew. `saved` are the
   * changes of landmarks that are the body's own now.
   */
  async reopen({ saved = {} } = {}) {
    const { bodyId } = this;
    const { header, arrays } = await this.transport.body(bodyId);
    if (this.bodyId !== bodyId) return;
    // A program that was started again may have another body, which has tapes of its own.
    if (header.place !== this.header.place) {
      this.#show(bodyId, { header, arrays });
      return;
    }
    const sameLayout = header.layout === this.header.layout;
    Object.assign(this, { header, arrays, chart: null, otherChart: null });
    this.sheet.forgetResults();
    this.reopened = true;
    try {
      this.emit("body");
    } finally {
      this.reopened = false;
    }
    this.emit("chart");
    // On another layout, old places may be none.
    if (sameLayout) this.sheet.refresh(saved);
    else this.sheet.load(soundSheet(this.sheet.state, header.patches));
  }

  get #place() {
    const { layout, place } = this.header;
    // The cells of a notebook share the memory of their page.
    return ["bodymeasure-sheet", this.options.key, layout, place].filter(Boolean).join("-");
  }

  #keep() {
    if (!this.header) return;
    const { tapes, landmarks, last } = this.sheet.state;
    try {
      memory()?.setItem(this.#place, JSON.stringify({ tapes, landmarks, last }));
    } catch {
      // A full memory costs the tapes after a reload, nothing now.
    }
  }

  #kept() {
    try {
      return soundSheet(JSON.parse(memory()?.getItem(this.#place) ?? "{}"), this.header.patches);
    } catch {
      return {};
    }
  }

  /** All landmarks as they are now: the body's own, with those that were moved, added or removed. */
  get landmarks() {
    const edits = this.sheet.landmarks;
    const own = (this.header?.landmarks ?? []).filter((one) => edits[one.name] !== null);
    const names = new Set(own.map((one) => one.name));
    const edited = own.map((one) => (edits[one.name] ? { ...one, ...edits[one.name], edited: true } : one));
    const added = Object.entries(edits)
      .filter(([name, edit]) => edit && !names.has(name))
      .map(([name, edit]) => ({ name, ...edit, origin: "clicked", edited: true }));
    return [...edited, ...added];
  }

  /** Landmarks that the chart wants and nobody gave. */
  get lacking() {
    const given = new Set(this.landmarks.map((one) => one.name));
    return (this.header?.lacking ?? []).filter((one) => !given.has(one.name));
  }

  /** The place that a landmark was moved to, since the program knows only the body's own. */
  resolve(location) {
    if (typeof location !== "string") return location;
    return this.sheet.landmarks[location]?.location ?? location;
  }

  /** The point of the body where a location is, that of a landmark by its name; or undefined. */
  locationOf(location) {
    return typeof location === "string" ? this.landmarks.find((one) => one.name === location)?.location : location;
  }

  /** Where a location is: a landmark's place, or a point of the drawn surface. */
  placeOf(location) {
    if (typeof location !== "string") return interpolate(this.arrays.positions.data, location, this.header.segments);
    return this.landmarks.find((one) => one.name === location)?.position;
  }

  /** What to send as landmarks: those that differ from the body's own, or null. */
  get landmarkChanges() {
    const changes = Object.entries(this.sheet.landmarks);
    if (!changes.length) return null;
    return Object.fromEntries(changes.map(([name, edit]) => [name, edit ? edit.location : null]));
  }

  /** The rows of the list. */
  get items() {
    const tapes = this.sheet.tapes.map((tape) => tapeItem(tape, this.sheet.result(tape)));
    const chart = this.chart ? chartItems(this.chart.header, this.hiddenKeys, this.otherChart?.header) : [];
    return [...tapes, ...chart];
  }

  /** The same measurements of the body that this one is compared with. */
  get besideItems() {
    if (!this.chart || !this.otherChart) return [];
    return chartItems(this.otherChart.header, this.hiddenKeys).map((item) => ({ ...item, beside: true }));
  }

  item(id) {
    return id ? this.items.find((item) => item.id === id) : undefined;
  }

  select(id, { fly = false } = {}) {
    this.selected = id;
    this.emit("selection", { fly });
  }

  light(id) {
    if (this.lit === id) return;
    this.lit = id;
    this.emit("lit");
  }

  /** Show or hide rows. */
  show(items, visible) {
    for (const item of items) {
      if (item.source === "tape") this.sheet.change(item.id, { visible });
      else if (visible) this.hiddenKeys.delete(item.measurement.key);
      else this.hiddenKeys.add(item.measurement.key);
    }
    this.emit("chart");
  }

  /** Take the measurements of a set on the body with its landmarks as they are now. */
  async takeChart(set) {
    const { bodyId, header: { version } } = this;
    // A chart takes a while, in which another body may be opened, or this one be read again.
    const stays = () => this.bodyId === bodyId && this.header.version === version;
    const changes = this.landmarkChanges;
    const taking = {};
    this.taking = taking;
    this.emit("chart");
    try {
      const chosen = set ?? this.header.sets?.[0]?.key ?? "default";
      const chart = await this.during(TAKING, () => this.transport.chart(bodyId, chosen, changes), { long: true });
      if (!stays()) return;
      this.chart = chart;
      this.chartSet = chosen;
      this.chartLandmarks = changes;
      this.#hideStraight();
      if (this.other) await this.takeOtherChart();
    } finally {
      if (this.taking === taking) this.taking = null;
      this.emit("chart");
    }
  }

  /** Take the same measurements on the body that this one is compared with. */
  async takeOtherChart() {
    const { chart, other, chartSet } = this;
    if (!chart || !other) return;
    const otherChart = await this.during(TAKING, () => this.transport.chart(other.header.id, chartSet, null), { long: true });
    if (this.chart !== chart || this.other !== other) return;
    this.otherChart = otherChart;
    this.emit("chart");
  }

  /** Heights and breadths are straight lines beside the body; all at once they would be a fence. */
  #hideStraight() {
    const { measurements, tapes } = this.chart.header;
    this.hiddenKeys = new Set(
      measurements
        .filter((one) => one.tapes?.length && one.tapes.every((number) => tapes[number].through_body))
        .map((one) => one.key),
    );
  }

  /** Whether landmarks were changed since the chart was taken. */
  get chartIsOld() {
    return Boolean(this.chart) && JSON.stringify(this.chartLandmarks) !== JSON.stringify(this.landmarkChanges);
  }

  /** Tell the user of something that went wrong, in the sentence that came with it. */
  fail(error) {
    if (error instanceof Failure && error.gone) this.emit("gone", error.message);
    else {
      const sentence = error instanceof Failure ? error.message : `The page failed: ${error.message}`;
      const tone = error.status === STOPPED ? "note" : "bad";
      this.emit("message", { text: sentence, tone });
      if (!(error instanceof Failure)) console.error(error);
    }
  }

  say(text) {
    this.emit("message", { text, tone: "good" });
  }

  /**
   * Say that the page waits until something has ended, whoever still wants it then. What takes
   * `long` can be stopped, and the program tells how far it is.
   */
  async during(words, action, { long = false } = {}) {
    const awaited = { words, long };
    this.#awaited.push(awaited);
    this.emit("progress", awaited);
    try {
      return await action();
    } finally {
      this.#awaited = this.#awaited.filter((one) => one !== awaited);
      this.emit("progress", this.#awaited.at(-1) ?? null);
    }
  }

  /** Show how far something long is; news that come after its end are none. */
  tellProgress({ done, total, words }) {
    const long = this.#awaited.findLast((one) => one.long);
    if (long) this.emit("progress", done < total ? { done, total, words, long: true } : long);
  }

  /** Run something that may fail, and tell the user if it does. */
  async try(action) {
    try {
      return await action();
    } catch (error) {
      this.fail(error);
      return undefined;
    }
  }
}

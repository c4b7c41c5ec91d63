// How much the lengths of paths differ from those over triangles. It takes a second a tape, so it is
// asked for when somebody wants to see it.

export class MeshCheck {
  #known = new Map();
  #running = null;

  constructor(app) {
    this.app = app;
    app.on("body", () => {
      this.#known.clear();
      this.#running = null;
    });
    for (const name of ["settings", "results", "chart", "sheet", "body"]) app.on(name, () => this.#ask());
  }

  /** The relative difference of a row's length along the skin from the mesh's; undefined if unknown. */
  of(item) {
    const path = this.#path(item);
    const length = path && this.#known.get(JSON.stringify(path.places));
    return Number.isFinite(length) ? (path.length - length) / length : undefined;
  }

  /** The points of a row that is a path, and its length along the skin; null of any other. */
  #path({ tape, result, measurement }) {
    const { app } = this;
    if (tape) {
      if (tape.mode !== "path" || tape.kind !== "contact" || !Number.isFinite(result?.length)) return null;
      const places = tape.locations.map((one) => app.locationOf(one));
      return places.every(Boolean) ? { places, length: result.length } : null;
    }
    const { through = [], contact } = measurement;
    if (through.length < 2 || !Number.isFinite(contact)) return null;
    const named = new Map((app.chart?.header.landmarks ?? []).map((one) => [one.name, one.location]));
    const places = through.map((name) => named.get(name));
    return places.every(Boolean) ? { places, length: contact } : null;
  }

  async #ask() {
    const { app } = this;
    if (this.#running || app.settings.get("tapes") !== "difference" || !app.transport.can.measure || !app.header) return;
    const paths = app.items.map((item) => this.#path(item)?.places).filter(Boolean);
    const tapes = paths.filter((places) => !this.#known.has(JSON.stringify(places)));
    if (!tapes.length) return;
    const running = {};
    this.#running = running;
    try {
      const { bodyId } = app;
      const ask = () => app.transport.mesh(bodyId, tapes);
      const { lengths } = await app.during("Measuring on the mesh…", ask, { long: true });
      if (this.#running !== running) return;
      tapes.forEach((places, n) => this.#known.set(JSON.stringify(places), lengths[n]));
    } catch (error) {
      if (this.#running !== running) return;
      // Who stopped it, or cannot have it, is not asked to wait again.
      app.settings.set("tapes", "group");
      app.fail(error);
    } finally {
      if (this.#running === running) {
        this.#running = null;
        app.emit("chart");
      }
    }
  }
}

// Coloring the body by a quantity, and a second body: beside this one, or as the distance to it.
import { openFile } from "./opening.js";

/** Labels of the program are written as within a sentence. */
export function sentenceCase(text) {
  return text.slice(0, 1).toUpperCase() + text.slice(1);
}

export function comparing(app, viewport) {
  let key = "none";
  let beside = true;
  // What was asked for last, which `key` becomes when its answer is here.
  let asked = "none";
  // How often colors, and bodies, were chosen: an answer that comes after a newer choice changes
  // nothing.
  let colored = 0;
  let chosen = 0;
  const fields = new Map();

  const show = (field) => {
    viewport?.surface?.setField(field);
    viewport?.stage.invalidate();
    app.emit("field");
  };

  const color = (wanted) =>
    app.try(async () => {
      const choice = ++colored;
      const stays = () => choice === colored;
      asked = wanted;
      try {
        const field = wanted === "none" ? null : await fieldOf(wanted, stays);
        if (!stays()) return;
        key = wanted;
        // A quantity of the seams colors these, and leaves the body plain.
        const ofSeams = field?.per === "seam";
        seams(ofSeams ? field : null);
        show(ofSeams ? null : field);
        if (ofSeams) app.settings.setLayer("seams", true);
      } catch (error) {
        if (!stays()) return;
        asked = key;
        throw error;
      }
    }).finally(() => app.emit("field"));

  const fieldOf = async (wanted, stays) => {
    const against = wanted === "distance" ? app.other.header.id : undefined;
    const place = placeOf(wanted);
    if (!fields.has(place)) {
      const ask = () => app.transport.quantity(app.bodyId, wanted, against);
      const { header, arrays } = await app.during("Computing the colors…", ask);
      if (stays()) fields.set(place, { ...header, label: sentenceCase(header.label), values: arrays.values.data });
    }
    return fields.get(place);
  };

  const placeOf = (wanted) => `${app.bodyId}/${wanted}/${wanted === "distance" ? app.other?.header.id : ""}`;

  const seams = (field) => viewport?.layers.setSeamField(field);

  const setBeside = (wanted) => {
    beside = wanted;
    if (beside) {
      viewport?.second.show(app.other);
      if (asked === "distance") color("none");
    } else {
      viewport?.second.clear();
      color("distance");
    }
    viewport?.frameAll();
    app.emit("compare");
  };

  const endCompare = () => {
    chosen++;
    if (asked === "distance") color("none");
    app.other = null;
    app.otherChart = null;
    viewport?.second.clear();
    app.emit("compare");
    app.emit("chart");
  };

  /** Put a body that the program has open beside this one. */
  const put = async (id, choice) => {
    const other = await app.transport.body(id);
    if (choice !== chosen) return;
    other.header.id = id;
    // It knows all that are open, of which it may be the newest.
    app.header.bodies = other.header.bodies ?? app.header.bodies;
    Object.assign(app, { other, otherChart: null });
    setBeside(true);
    app.emit("chart");
    await app.takeOtherChart();
  };

  const compareWith = (id) => app.try(() => put(id, ++chosen));

  const compare = (file) =>
    app.try(async () => {
      const choice = ++chosen;
      const bring = async () => {
        const { id } = await openFile(app, file);
        if (choice === chosen) await put(id, choice);
      };
      try {
        await app.during(`Opening ${file.name}…`, bring);
      } catch (error) {
        if (choice === chosen) throw error;
      }
    });

  app.on("body", () => {
    fields.clear();
    colored++;
    asked = "none";
    // The same body, read again, stays beside the other.
    if (!app.reopened) chosen++;
    key = "none";
    seams(null);
    if (!app.other) viewport?.second.clear();
    app.emit("field");
    app.emit("compare");
  });
  // What is drawn of it, its distance and its chart are all those of its older form.
  app.on("otherchanged", () => {
    fields.clear();
    compareWith(app.other.header.id);
  });
  const current = () => fields.get(placeOf(key));
  return {
    color,
    compare,
    compareWith,
    setBeside,
    endCompare,
    beside: () => beside,
    colorKey: () => key,
    field: () => current() ?? null,
    /** The value under the pointer; undefined where there is none to tell. */
    valueAt: ({ location, point }) => {
      const place = app.locationOf(location);
      if (current()?.per === "seam") return viewport.layers.seamValue(point, viewport.reach);
      return place && (viewport.surface.value(place) ?? undefined);
    },
  };
}

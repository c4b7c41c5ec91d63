// Coloring the body by a quantity, and a second body: beside this one, or as the distance to it.

/** Labels of the program are written as within a sentence. */
export function sentenceCase(text) {
  return text.slice(0, 1).toUpperCase() + text.slice(1);
}

export function comparing(app, viewport) {
  let key = "none";
  let beside = true;
  const fields = new Map();

  const show = (field) => {
    viewport?.surface?.setField(field);
    viewport?.stage.invalidate();
    app.emit("field");
  };

  const color = (wanted) =>
    app.try(async () => {
      if (wanted === "none") {
        key = wanted;
        seams(null);
        show(null);
        return;
      }
      const place = `${app.bodyId}/${wanted}/${wanted === "distance" ? app.other.header.id : ""}`;
      if (!fields.has(place)) {
        app.emit("progress", { words: "Computing the colors…" });
        try {
          const against = wanted === "distance" ? app.other.header.id : undefined;
          const { header, arrays } = await app.transport.quantity(app.bodyId, wanted, against);
          fields.set(place, { ...header, label: sentenceCase(header.label), values: arrays.values.data });
        } finally {
          app.emit("progress", null);
        }
      }
      key = wanted;
      const field = fields.get(place);
      // A quantity of the seams colors these, and leaves the body plain.
      seams(field.per === "seam" ? field : null);
      show(field.per === "seam" ? null : field);
      if (field.per === "seam") app.settings.setLayer("seams", true);
    }).finally(() => app.emit("field"));

  const seams = (field) => viewport?.layers.setSeamField(field);

  const setBeside = (wanted) => {
    beside = wanted;
    if (beside) {
      viewport?.second.show(app.other);
      if (key === "distance") color("none");
    } else {
      viewport?.second.clear();
      color("distance");
    }
    viewport?.frameAll();
    app.emit("compare");
  };

  const endCompare = () => {
    if (key === "distance") color("none");
    app.other = null;
    app.otherChart = null;
    viewport?.second.clear();
    app.emit("compare");
    app.emit("chart");
  };

  /** Put a body that the program has open beside this one. */
  const put = async (id) => {
    app.other = await app.transport.body(id);
    app.other.header.id = id;
    if (app.chart) app.otherChart = await app.transport.chart(id, app.chartSet, null);
    setBeside(true);
    app.emit("chart");
  };

  const compareWith = (id) => app.try(() => put(id));

  const compare = (file) =>
    app.try(async () => {
      app.emit("progress", { words: `Opening ${file.name}…` });
      try {
        const { id } = await app.transport.open(file);
        await put(id);
      } finally {
        app.emit("progress", null);
      }
    });

  app.on("body", () => {
    fields.clear();
    key = "none";
    seams(null);
    if (!app.other) viewport?.second.clear();
    app.emit("field");
    app.emit("compare");
  });
  const current = () => fields.get(`${app.bodyId}/${key}/${key === "distance" ? app.other?.header.id : ""}`);
  return {
    color,
    compare,
    compareWith,
    setBeside,
    endCompare,
    beside: () => beside,
    colorKey: () => key,
    field: () => current() ?? null,
    valueAt: (location) => viewport?.surface.value(location) ?? viewport?.layers.seamValue(location),
  };
}

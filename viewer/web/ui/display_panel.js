// What is drawn over the body, by what it is colored, and a second body to compare with.
import { sentenceCase } from "../compare.js";
import { h } from "./dom.js";

const LAYERS = [
  ["seams", "Seams"],
  ["landmarks", "Landmarks"],
  ["names", "Names of landmarks"],
  ["tapes", "Tapes of the chart"],
  ["labels", "Names of my tapes"],
  ["diagonals", "Diagonals of patches"],
  ["boundary", "Boundary curves"],
  ["nets", "Control nets"],
];

export function displayPanel(app, actions) {
  const layers = h("div", { class: "checks" });
  const color = h("select", { "aria-label": "Color the body by", "data-testid": "color", onChange: () => actions.color(color.value) });
  const lines = h(
    "select",
    { "aria-label": "Color the diagonals by", "data-testid": "lines", onChange: () => app.settings.set("lines", lines.value) },
    [["length", "Length"], ["difference", "Difference from the mesh"], ["error", "Error estimate"], ["proven", "Proven shortest"]].map(([key, label]) => h("option", { value: key }, label)),
  );
  const tapes = h(
    "select",
    { "aria-label": "Color the tapes by", "data-testid": "tapes", onChange: () => app.settings.set("tapes", tapes.value) },
    [
      ["group", "Group"],
      ["length", "Length"],
      ["error", "Error estimate"],
      ...(app.transport.can.measure ? [["difference", "Difference from the mesh"]] : []),
    ].map(([key, label]) => h("option", { value: key }, label)),
  );
  const snap = check("Snap to landmarks and corners", "snap", () => app.settings.set("snap", snap.input.checked));
  const via = check("Tapes with points on the way", "via", () => app.settings.set("via", via.input.checked));
  const compare = h("div", { class: "compare" });
  const element = h(
    "section",
    { class: "page" },
    h(
      "div",
      { class: "scroll pad" },
      h("h2", {}, "Layers"),
      layers,
      h("h2", {}, "Colors"),
      h("label", { class: "field" }, h("span", {}, "Body"), color),
      h("label", { class: "field" }, h("span", {}, "Tapes"), tapes),
      h("label", { class: "field" }, h("span", {}, "Diagonals"), lines),
      h("h2", {}, "Tools"),
      h("div", { class: "checks" }, snap.label, via.label),
      app.transport.can.open ? [h("h2", {}, "Compare"), compare] : "",
    ),
  );

  const draw = () => {
    if (!app.header) return;
    const shown = app.settings.get("layers");
    const known = app.transport.layers ?? app.header.layers ?? [];
    const possible = LAYERS.filter(([key]) => !["nets", "diagonals", "boundary"].includes(key) || known.includes(key));
    layers.replaceChildren(
      ...possible.map(([key, label]) => {
        const one = check(label, `layer-${key}`, () => app.settings.setLayer(key, one.input.checked));
        one.input.checked = shown[key];
        return one.label;
      }),
    );
    const quantities = app.transport.can.measure ? (app.header.quantities ?? []).filter(({ key }) => key !== "distance" || app.other) : [];
    color.replaceChildren(h("option", { value: "none" }, "Plain"), ...quantities.map(({ key, label }) => h("option", { value: key }, sentenceCase(label))));
    color.value = actions.colorKey();
    color.disabled = !quantities.length;
    tapes.value = app.settings.get("tapes");
    lines.value = app.settings.get("lines");
    lines.disabled = !shown.diagonals;
    snap.input.checked = app.settings.get("snap");
    via.input.checked = app.settings.get("via");
    drawCompare();
  };

  const drawCompare = () => {
    const file = h("input", { type: "file", class: "hidden", tabindex: "-1", "aria-label": "File of the second body", "data-testid": "compare-file", onChange: () => file.files[0] && actions.compare(file.files[0]) });
    const choose = h("button", { type: "button", class: "button", "data-testid": "compare", onClick: () => file.click() }, app.other ? "Compare with another…" : "Compare with a body…");
    const others = (app.header.bodies ?? []).filter(({ id }) => id !== app.bodyId && id !== app.other?.header.id);
    const open = h("select", { "aria-label": "Body to compare with", "data-testid": "compare-open", onChange: () => open.value && actions.compareWith(open.value) }, h("option", { value: "" }, "One that is open…"), others.map(({ id, name }) => h("option", { value: id }, name)));
    const known = others.length ? open : "";
    if (!app.other) {
      compare.replaceChildren(h("p", { class: "soft small" }, "A second body stands beside this one under the same view, and the list shows how their measurements differ."), known, choose, file);
      return;
    }
    const same = app.other.header.layout === app.header.layout;
    compare.replaceChildren(
      h("p", {}, h("strong", {}, app.other.header.name)),
      same ? "" : h("p", { class: "soft small" }, "Its patches are laid out in another way, so the two cannot be compared point by point."),
      h("div", { class: "segments", role: "group", "aria-label": "How to compare" },
        h("button", { type: "button", "aria-pressed": String(Boolean(actions.beside())), "data-testid": "beside", onClick: () => actions.setBeside(true) }, "Side by side"),
        h("button", { type: "button", disabled: !same, "aria-pressed": String(!actions.beside()), "data-testid": "by-distance", onClick: () => actions.setBeside(false) }, "Color by distance"),
      ),
      known,
      h("div", { class: "row" }, choose, h("button", { type: "button", class: "button", "data-testid": "compare-end", onClick: actions.endCompare }, "End"), file),
    );
  };
  for (const name of ["body", "settings", "field", "compare", "layers"]) app.on(name, draw);
  return element;
}

function check(text, id, onChange) {
  const input = h("input", { type: "checkbox", "data-testid": id, onChange });
  return { input, label: h("label", { class: "check" }, input, h("span", {}, text)) };
}

// What the list says while it is empty, and the way from a body to its chart.
import { h } from "./dom.js";

export function invitation(app) {
  if (!app.header) return [];
  const parts = [];
  if (app.chartIsOld) {
    parts.push(
      h("div", { class: "card note" }, h("p", {}, "Landmarks were changed since these measurements were taken."), h("button", { type: "button", class: "button primary", "data-testid": "chart-again", disabled: Boolean(app.taking), onClick: () => app.try(() => app.takeChart(app.chartSet)) }, "Take them again")),
    );
  }
  if (app.chart || !app.transport.can.chart) {
    if (!app.items.length) parts.push(h("p", { class: "soft" }, "Click two points on the body for the distance between them."));
    return parts;
  }
  const sets = app.header.sets ?? [];
  const set = h("select", { "aria-label": "Set of measurements", "data-testid": "set" }, sets.map(({ key, label }) => h("option", { value: key }, label)));
  const lacking = app.lacking.length;
  const why = app.header.can?.chart === false
    ? "A chart needs landmarks that this body lacks. Place them under Landmarks, then take the chart."
    : "Girths, lengths and widths of this body, taken at its landmarks.";
  parts.push(
    h(
      "div",
      { class: "card" },
      app.sheet.tapes.length ? "" : h("p", {}, h("strong", {}, "Click two points"), " on the body: the tape between them lands here."),
      h("p", { class: "soft" }, why, lacking && app.header.can?.chart !== false ? ` ${lacking} landmarks are lacking; what needs them says so.` : ""),
      sets.length > 1 ? h("label", { class: "field" }, h("span", {}, "Set"), set) : "",
      h("button", { type: "button", class: "button primary", "data-testid": "take-chart", disabled: Boolean(app.taking), onClick: () => app.try(() => app.takeChart(set.value || undefined)) }, "Take the measurements"),
    ),
  );
  return parts;
}

// What lies over the scene: the hint, the views, what is under the pointer, the legend, progress.
import { colorOf, gradient } from "../model/colors.js";
import { formatError, formatLength, formatValue } from "../model/units.js";
import { sentenceCase } from "../compare.js";
import { h, iconButton } from "./dom.js";

const VIEW_BUTTONS = [
  ["front", "Front", "1"],
  ["back", "Back", "2"],
  ["left", "Left", "3"],
  ["right", "Right", "4"],
  ["top", "Top", "5"],
];

export function overlays(app, host, actions) {
  const hint = h("p", { class: "hint", "data-testid": "hint" });
  const readout = h("div", { class: "readout", "data-testid": "readout", hidden: true });
  const legend = h("div", { class: "legend", role: "img", hidden: true, "data-testid": "legend" });
  const progress = h("div", { class: "progress", role: "status", hidden: true, "data-testid": "progress" });
  const projection = iconButton("cube", "Perspective", actions.projection, { keys: "O", "aria-pressed": "false", "data-testid": "projection" });
  const views = h(
    "div",
    { class: "views", role: "toolbar", "aria-label": "Views" },
    VIEW_BUTTONS.map(([name, label, key]) =>
      h("button", { type: "button", title: `${label} (${key})`, "aria-keyshortcuts": key, "data-testid": `view-${name}`, onClick: () => actions.view(name) }, label),
    ),
    iconButton("frame", "Show all", actions.frameAll, { keys: "Home", "data-testid": "frame-all" }),
    projection,
  );
  const crosshair = h("div", { class: "crosshair", "aria-hidden": "true", "data-testid": "crosshair" });
  host.append(hint, views, readout, legend, progress, crosshair);

  app.on("hint", (text) => {
    hint.textContent = text;
    hint.hidden = !text;
  });
  app.on("settings", () => projection.setAttribute("aria-pressed", String(app.settings.get("projection") === "perspective")));
  app.on("progress", (state) => {
    progress.hidden = !state;
    if (!state) return;
    const part = state.total ? h("progress", { value: state.done, max: state.total, "aria-label": state.words }) : h("span", { class: "spinner", "aria-hidden": "true" });
    progress.replaceChildren(part, h("span", {}, sentenceCase(state.words)));
  });
  app.on("hover", (hit) => {
    readout.hidden = !hit;
    if (hit) readout.replaceChildren(...readoutLines(app, hit, actions).map((line) => h("span", {}, line)));
  });
  const updateLegend = () => showLegend(app, legend, actions);
  for (const name of ["field", "layers", "settings", "body"]) app.on(name, updateLegend);
}

function readoutLines(app, hit, actions) {
  const lines = [hit.words.filter(Boolean).join(" · ")];
  // With nobody to ask for lengths, where a point is is what a page can say of it.
  if (!app.transport.can.measure && hit.point) lines.push(positionText(hit.point, app.unit));
  if (hit.row) {
    const item = app.item(hit.row);
    if (item) lines.push(`${item.name}: ${formatValue(item, app.unit)}`);
  }
  const field = actions.field();
  if (field && !hit.side && Array.isArray(hit.location)) lines.push(`${field.label}: ${fieldText(field, actions.valueAt(hit.location), app.unit)}`);
  for (const item of actions.linesOf(hit.location)) {
    const difference = Number.isFinite(item.difference) ? `, ${item.difference.toExponential(1)} from the mesh` : "";
    lines.push(`${item.name}: ${formatLength(item.length ?? NaN, app.unit)} ${formatError(item.error_estimate ?? NaN, app.unit)}${difference}`);
  }
  return lines;
}

/** A position in words: the page's axes are the body's left, up and front. */
function positionText([left, up, front], unit) {
  const along = (value, positive, negative) => `${formatLength(Math.abs(value), unit)} ${value < 0 ? negative : positive}`;
  return [along(left, "left", "right"), along(up, "up", "down"), along(front, "front", "back")].join(", ");
}

export function fieldText(field, value, unit) {
  if (!Number.isFinite(value)) return "not known";
  // Distances are lengths; curvatures have units of their own.
  if (field.unit === "m") return formatLength(value, unit);
  return `${Number(value.toPrecision(3))} ${field.unit ?? ""}`.trim();
}

function showLegend(app, legend, actions) {
  const field = actions.field();
  const scale = field ?? actions.lineScale();
  legend.hidden = !scale;
  if (!scale) return;
  const title = field ? field.label : { length: "Length of diagonals", difference: "Difference from the mesh", error: "Error estimate" }[scale.key];
  const end = (value) => {
    if (field) return fieldText(field, value, app.unit);
    if (scale.key === "length") return formatLength(value, app.unit);
    const power = 10 ** value;
    return scale.key === "error" ? formatError(power, app.unit).replace("± ", "") : power.toExponential(0);
  };
  const bar = h("div", { class: "legend-bar" });
  bar.style.background = gradient(scale.scale);
  const middle = scale.scale === "diverging" ? end((scale.low + scale.high) / 2) : "";
  legend.setAttribute("aria-label", `Colors: ${title}, from ${end(scale.low)} to ${end(scale.high)}`);
  legend.replaceChildren(
    h("div", { class: "legend-title" }, title),
    bar,
    h("div", { class: "legend-ends" }, h("span", {}, end(scale.low)), h("span", {}, middle), h("span", {}, end(scale.high))),
    field?.words ? h("div", { class: "legend-words" }, field.words) : "",
  );
}

export { colorOf };

// What lies over the scene: the hint, the views, what is under the pointer, the legend, progress.
import { gradient } from "../model/colors.js";
import { tapeColors } from "../model/tape_colors.js";
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
  // What takes a minute can be stopped; the rest is over before a hand is there. The button stays
  // the same while the numbers change, so that it can be pressed.
  const stop = h("button", { type: "button", class: "button", "data-testid": "stop", onClick: () => app.try(() => app.transport.stop()) }, "Stop");
  const state = h("span", { class: "progress-state" });
  progress.append(state, stop);
  app.on("progress", (news) => {
    progress.hidden = !news;
    if (!news) return;
    stop.hidden = !(app.transport.can.stop && news.long);
    const part = news.total ? h("progress", { value: news.done, max: news.total, "aria-label": news.words }) : h("span", { class: "spinner", "aria-hidden": "true" });
    state.replaceChildren(part, h("span", {}, sentenceCase(news.words)));
  });
  app.on("hover", (hit) => {
    readout.hidden = !hit;
    if (hit) readout.replaceChildren(...readoutLines(app, hit, actions).map((line) => h("span", {}, line)));
  });
  const updateLegend = () => showLegend(app, legend, actions);
  for (const name of ["field", "layers", "settings", "body", "chart", "sheet", "results"]) app.on(name, updateLegend);
}

function readoutLines(app, hit, actions) {
  const lines = [hit.words.filter(Boolean).join(" · ")];
  // With nobody to ask for lengths, where a point is is what a page can say of it.
  if (!app.transport.can.measure && hit.point) lines.push(positionText(hit.point, app.unit));
  if (hit.row) {
    const item = app.item(hit.row);
    const difference = item && app.meshCheck.of(item);
    const words = difference === undefined ? "" : `, ${difference.toExponential(1)} from the mesh`;
    if (item) lines.push(`${item.name}: ${formatValue(item, app.unit)}${words}`);
  }
  const field = hit.side ? null : actions.field();
  const value = field && actions.valueAt(hit);
  if (field && value !== undefined) lines.push(`${field.label}: ${fieldText(field, value, app.unit)}`);
  for (const item of hit.side ? [] : actions.linesOf(hit)) {
    const difference = Number.isFinite(item.difference) ? `, ${item.difference.toExponential(1)} from the mesh` : "";
    lines.push(`${item.name}: ${formatLength(item.length ?? NaN, app.unit)} ${formatError(item.error_estimate ?? NaN, app.unit)}${difference}${item.proven ? ", proven to be the shortest" : ""}`);
  }
  return lines;
}

/** A position in words: the page's axes are the body's left, up and front. */
function positionText([left, up, front], unit) {
  const along = (value, positive, negative) => `${formatLength(Math.abs(value), unit)} ${value < 0 ? negative : positive}`;
  return [along(left, "left", "right"), along(up, "up", "down"), along(front, "front", "back")].join(", ");
}

export function fieldText(field, value, unit) {
  // Where the body ends, no other patch makes an angle.
  if (!Number.isFinite(value)) return field.per === "seam" ? "none" : "not known";
  // Distances are lengths; curvatures have units of their own.
  if (field.unit === "m") return formatLength(value, unit);
  return `${Number(value.toPrecision(3))} ${field.unit ?? ""}`.trim();
}

const TITLES = { length: "Length of", difference: "Difference from the mesh, of", error: "Error estimate of", proven: "Proven to be the shortest on their patches:" };

/** What the colors mean: of the body or its seams, of tapes, of diagonals. */
function showLegend(app, legend, actions) {
  const field = actions.field();
  const tapes = app.header && tapeColors(app).scale;
  const lines = actions.lineScale();
  const scales = [
    field && { ...field, title: field.label, end: (value) => fieldText(field, value, app.unit) },
    tapes && !tapes.empty && { ...tapes, title: `${TITLES[tapes.key]} tapes`, end: (value) => lineText(tapes.key, value, app.unit) },
    lines && { ...lines, title: `${TITLES[lines.key]} diagonals`, end: (value) => lineText(lines.key, value, app.unit) },
  ].filter(Boolean);
  legend.hidden = !scales.length;
  const told = scales.map(({ title, low, high, end }) => `${title}, from ${end(low)} to ${end(high)}`);
  legend.setAttribute("aria-label", `Colors: ${told.join("; ")}`);
  legend.replaceChildren(...scales.map(legendOf));
}

function legendOf({ title, scale, low, high, end, words }) {
  const bar = h("div", { class: "legend-bar" });
  bar.style.background = gradient(scale);
  const middle = scale === "diverging" ? end((low + high) / 2) : "";
  return h(
    "div",
    { class: "legend-scale" },
    h("div", { class: "legend-title" }, title),
    bar,
    h("div", { class: "legend-ends" }, h("span", {}, end(low)), h("span", {}, middle), h("span", {}, end(high))),
    words ? h("div", { class: "legend-words" }, words) : "",
  );
}

/** A value of a line as it stands on its scale, where errors and differences are logarithms. */
function lineText(key, value, unit) {
  if (key === "length") return formatLength(value, unit);
  if (key === "proven") return value > 0 ? "proven" : "not proven";
  const power = 10 ** value;
  return key === "error" ? formatError(power, unit).replace("± ", "") : power.toExponential(0);
}

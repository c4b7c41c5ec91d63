// Ways out: the list as a file or for a spreadsheet, the scene as a picture, and ways in.
import { digitsFor, plainLength, UNITS } from "../model/units.js";
import { betweenLandmarks } from "./between.js";
import { copyText } from "./details.js";
import { download, h } from "./dom.js";

const FORMATS = [
  ["csv", "Chart as CSV"],
  ["json", "Chart as JSON"],
  ["smis", "Chart for SeamlyMe (.smis)"],
  ["freesewing", "Chart for FreeSewing"],
];

export function exportMenu(app, actions) {
  const file = h("input", { type: "file" });
  file.addEventListener("change", () => file.files[0] && actions.open(file.files[0]));
  const chart = app.chart && app.transport.can.export;
  return [
    ...(app.transport.can.open ? [["Open a file…", () => file.click(), "menu-open"], null] : []),
    ...(app.header.bodies ?? []).filter(({ id }) => id !== app.bodyId).map(({ id, name }) => [`Go to ${name}`, () => app.try(() => app.open(id)), `menu-body-${id}`]),
    ["Tape between landmarks…", () => betweenLandmarks(app), "menu-between"],
    null,
    ["Copy the list", () => app.try(() => copyTable(app)), "menu-copy"],
    ["List as CSV", () => download(`${fileName(app)}.csv`, `\ufeff${table(app, ",")}`), "menu-csv"],
    ["My tapes as a file", () => download(`${fileName(app)}.tapes.json`, tapesFile(app)), "menu-tapes"],
    ...(chart ? FORMATS.map(([format, label]) => [label, () => app.try(() => exported(app, format)), `menu-${format}`]) : []),
    null,
    ["Picture of the scene", actions.picture, "menu-picture"],
    ["Keys and help", actions.help, "menu-help"],
  ];
}

async function exported(app, format) {
  const request = {
    format,
    set: app.chartSet,
    // Of the chart that is shown, whatever was moved since.
    landmarks: app.chartLandmarks,
    unit: { in: "inch", mm: "mm" }[app.unit] ?? "cm",
  };
  // Where another chart is under way, or this one was forgotten, it takes as long as that.
  const ask = () => app.transport.exportFile(app.bodyId, request);
  const { name, content } = await app.during("Writing the file…", ask, { long: true });
  download(name, content);
}

function fileName(app) {
  return (app.header.name || "body").toLowerCase().replace(/[^a-z0-9]+/g, "_").replace(/^_|_$/g, "") || "body";
}

/** The list with a row a line; numbers without units, as spreadsheets want them. */
export function table(app, separator) {
  const unit = app.unit ? UNITS[app.unit].label : "own unit";
  const head = ["name", "group", "side", `value (${unit}, or degrees)`, `error estimate (${unit}, or degrees)`, "status", "ISO 8559-1"];
  const number = (item, value) => {
    if (!Number.isFinite(value)) return "";
    return item.kind === "length" ? plainLength(value, app.unit, digitsFor(item.error, app.unit)) : String(Number(value.toFixed(4)));
  };
  // Errors span decades, and none is 0 that is only small.
  const error = ({ kind, error: size }) => {
    if (!Number.isFinite(size)) return "";
    const { perMeter } = UNITS[app.unit] ?? { perMeter: 1 };
    return (kind === "length" ? size * perMeter : size).toPrecision(2);
  };
  const rows = app.items.map((item) => [item.name, item.group, item.side, number(item, item.value), error(item), item.words, [item.codes.iso ?? ""].flat().join(" ")]);
  return [head, ...rows].map((row) => row.map((cell) => escaped(String(cell), separator)).join(separator)).join("\r\n");
}

const NUMBER = /^-?\d+(\.\d+)?$/;

/** Quoted where needed; what a spreadsheet would take for a formula is kept from being one. */
function escaped(cell, separator) {
  const safe = /^[-+=@\t\r]/.test(cell) && !NUMBER.test(cell) ? `'${cell}` : cell;
  if (separator === "\t") return safe.replace(/[\t\r\n]+/g, " ");
  return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

async function copyTable(app) {
  await copyText(table(app, "\t"));
  app.say(`Copied ${app.items.length} rows; paste them into a spreadsheet.`);
}

const FORMAT = "bodymeasure tapes";

function tapesFile(app) {
  const tapes = app.sheet.tapes.map((tape) => ({ ...tape, length: app.sheet.result(tape)?.length ?? null }));
  return JSON.stringify({ format: FORMAT, version: 1, body: app.header.name, layout: app.header.layout, unit: app.header.unit === "" ? "" : "m", tapes }, null, 2);
}

/** The tapes in a dropped file, or null when it is another file. */
export function readTapes(text) {
  let content;
  try {
    content = JSON.parse(text);
  } catch {
    return null;
  }
  return content?.format === FORMAT && Array.isArray(content.tapes) ? content : null;
}

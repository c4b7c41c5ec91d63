// The selected row in full: its value to take away, how far to trust it, and what can be done with it.
import { MINE, placeWords } from "../model/items.js";
import { digitsFor, formatErrorOf, formatLength, formatValue, plainLength } from "../model/units.js";
import { h, icon, iconButton } from "./dom.js";

export function details(app, actions) {
  const element = h("section", { class: "details", "aria-label": "The selected measurement", "data-testid": "details", hidden: true });

  const draw = () => {
    const item = app.item(app.selected);
    element.hidden = !item;
    if (!item) return;
    // While its name is typed, the field must not be taken away.
    if (element.contains(document.activeElement) && document.activeElement.tagName === "INPUT") return;
    const focused = document.activeElement?.dataset?.testid;
    element.replaceChildren(...(item.source === "tape" ? ofTape(app, item, actions) : ofMeasurement(app, item, actions)));
    if (focused) element.querySelector(`[data-testid="${focused}"]`)?.focus();
  };
  for (const name of ["sheet", "results", "chart", "selection", "settings", "body"]) app.on(name, draw);
  return element;
}

function headOf(app, item, actions, title) {
  return h(
    "div",
    { class: "details-head" },
    title,
    iconButton("frame", "Fly there", () => actions.fly(item.id), { keys: "F" }),
    item.source === "tape" ? iconButton("trash", `Delete ${item.name}`, () => actions.remove(item.id), { keys: "Delete", "data-testid": "delete" }) : "",
    iconButton("close", "Close", () => app.select(null)),
  );
}

function valueOf(app, item) {
  const exact = item.kind === "length" && app.unit !== "in" ? digitsFor(item.error, app.unit) : undefined;
  const text = item.waiting
    ? "Measuring…"
    : item.failed ? "No length" : item.kind === "length" ? formatLength(item.value, app.unit, exact) : formatValue(item, app.unit);
  const plainly = () => (item.kind === "length" ? plainLength(item.value, app.unit, app.unit === "in" ? 4 : exact) : String(item.value));
  const copied = () => {
    const plain = plainly();
    app.try(async () => {
      await copyText(plain);
      app.say(`Copied ${plain}.`);
    });
  };
  return h(
    "div",
    { class: "big" },
    h("output", { class: item.failed ? "value bad" : "value", "data-testid": "length" }, text),
    item.failed || item.waiting ? "" : h("span", { class: "error", "data-testid": "error" }, errorOf(app, item, plainly)),
    item.failed || item.waiting ? "" : iconButton("copy", "Copy the value", copied, { "data-testid": "copy" }),
  );
}

/** The error; a sixteenth of an inch is far more than it, so there it stands with a decimal. */
function errorOf(app, item, plainly) {
  const error = item.error === null ? "" : formatErrorOf(item, item.error, app.unit);
  return app.unit === "in" && item.kind === "length" ? `${plainly()} ${error}`.trim() : error;
}

/** Copy text; pages from files may have no clipboard, and say so. */
export async function copyText(text) {
  if (!navigator.clipboard) throw new Error("this browser gives no clipboard to this page; mark the number and copy it");
  await navigator.clipboard.writeText(text);
}

function fact(term, ...description) {
  return [h("dt", {}, term), h("dd", {}, ...description)];
}

/** The parts of the error, where a scan has one. */
function errorFacts(app, item, title) {
  if (item.failed || !item.uncertainty) return [];
  const part = (size) => formatErrorOf(item, size ?? NaN, app.unit);
  return [fact(title, part(item.uncertainty)), fact("Of the computation", part(item.computed))];
}

function ofTape(app, item, actions) {
  const { tape, result } = item;
  const name = h("input", { class: "name", value: tape.name, "aria-label": "Name of the tape", "data-testid": "name", maxlength: "100" });
  name.addEventListener("change", () => app.sheet.change(tape.id, { name: name.value.trim() || tape.name }));
  name.addEventListener("keydown", (event) => {
    event.stopPropagation();
    if (event.key === "Enter" || event.key === "Escape") {
      if (event.key === "Escape") name.value = tape.name;
      name.blur();
    }
  });
  const facts = [];
  const known = result && !result.error;
  if (known && Number.isFinite(result.straight) && tape.mode === "path") facts.push(fact("Straight", formatLength(result.straight, app.unit)));
  const other = app.sheet.result({ ...tape, kind: tape.kind === "taut" ? "contact" : "taut" });
  if (other && Number.isFinite(other.length)) {
    facts.push(fact(tape.kind === "taut" ? "Along the skin" : "Taut", formatLength(other.length, app.unit)));
  }
  const gap = [result, other].find((one) => Number.isFinite(one?.gap))?.gap;
  if (Number.isFinite(gap)) facts.push(fact("Taut is shorter by", formatLength(Math.abs(gap), app.unit)));
  facts.push(...errorFacts(app, item, "From the scanned surface"));
  facts.push(fact(tape.mode === "path" ? "From, to" : "At", tape.locations.map((location) => placeWords(location, app.header)).join(" → ")));
  const kinds =
    app.transport.can.measure && tape.mode !== "closed"
      ? h(
          "div",
          { class: "segments", role: "group", "aria-label": "How the tape lies" },
          [["contact", "On the skin"], ["taut", "Taut"]].map(([kind, label]) =>
            h("button", { type: "button", "aria-pressed": String(tape.kind === kind), "data-testid": `kind-${kind}`, onClick: () => app.sheet.change(tape.id, { kind }) }, label),
          ),
        )
      : "";
  return [
    headOf(app, item, actions, name),
    valueOf(app, item),
    item.words ? h("p", { class: item.failed ? "words bad" : "words", "data-testid": "words" }, item.words) : "",
    kinds,
    h("dl", {}, facts.flat()),
  ];
}

function ofMeasurement(app, item, actions) {
  const facts = [];
  if (item.other !== null && item.other !== undefined) facts.push(fact(app.other.header.name, formatValue({ ...item, value: item.other }, app.unit)));
  const { contact, taut } = item.measurement;
  if (Number.isFinite(contact) && Number.isFinite(taut)) {
    facts.push(fact("On the skin", formatLength(contact, app.unit)), fact("Taut", formatLength(taut, app.unit)));
  }
  facts.push(...errorFacts(app, item, "From scan and landmarks"));
  for (const [system, codes] of Object.entries(item.codes)) {
    const text = [codes].flat().filter(Boolean).join(", ");
    if (text) facts.push(fact(SYSTEMS[system] ?? system, text));
  }
  if (item.landmarks?.length) facts.push(fact("Landmarks", item.landmarks.join(", ")));
  return [
    headOf(app, item, actions, h("h2", { class: "name" }, item.name)),
    valueOf(app, item),
    item.words ? h("p", { class: item.failed ? "words bad" : "words", "data-testid": "words" }, item.words) : "",
    item.definition ? h("p", { class: "definition" }, item.definition) : "",
    h("dl", {}, facts.flat()),
  ];
}

const SYSTEMS = { iso: "ISO 8559-1", seamly: "Seamly2D", seamlyme: "SeamlyMe", freesewing: "FreeSewing", garmentcode: "GarmentCode" };

export { MINE, icon };

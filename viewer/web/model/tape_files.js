// Tapes that come from elsewhere, from a file or the tab's memory: what is none is not let in, since
// one wrong number would stop everything that draws it.

// As many as the program takes in a request, and as long names.
const MOST_POINTS = 50;
const MOST_LETTERS = 200;
const MODES = ["path", "girth", "closed"];
const KINDS = ["contact", "taut"];

const isText = (value) => typeof value === "string" && value.length > 0 && value.length <= MOST_LETTERS;
const isObject = (value) => typeof value === "object" && value !== null && !Array.isArray(value);
const isPart = (value) => Number.isFinite(value) && value >= 0 && value <= 1;

/** Whether something is a point of a body with that many patches. */
function isPlace(value, patches) {
  if (!Array.isArray(value) || value.length !== 3) return false;
  const [patch, u, v] = value;
  return Number.isInteger(patch) && patch >= 0 && patch < patches && isPart(u) && isPart(v);
}

/** The tape in some content, with nothing else that stands there; null if it is none. */
export function soundTape(content, patches) {
  if (!isObject(content)) return null;
  const { name, title = "Tape", mode, kind, locations, visible } = content;
  if (!isText(name) || !isText(title) || !MODES.includes(mode) || !KINDS.includes(kind)) return null;
  if (!Array.isArray(locations) || locations.length > MOST_POINTS) return null;
  if (mode === "path" ? locations.length < 2 : locations.length !== 1) return null;
  if (!locations.every((one) => isText(one) || isPlace(one, patches))) return null;
  return { name, title, mode, kind, locations, visible: visible !== false };
}

function isEdit(edit, patches) {
  if (edit === null) return true;
  if (!isObject(edit) || !isPlace(edit.location, patches)) return false;
  return Array.isArray(edit.position) && edit.position.length === 3 && edit.position.every(Number.isFinite);
}

/** A sheet as far as it is one: of what was kept, all that a body with that many patches can show. */
export function soundSheet(content, patches) {
  if (!isObject(content)) return {};
  const kept = Array.isArray(content.tapes) ? content.tapes : [];
  const ids = new Set();
  const tapes = [];
  let last = Number.isInteger(content.last) && content.last > 0 ? content.last : 0;
  for (const one of kept) {
    const tape = soundTape(one, patches);
    const number = Number(/^tape-(\d{1,9})$/.exec(one?.id)?.[1] ?? NaN);
    if (!tape || Number.isNaN(number) || ids.has(one.id)) continue;
    ids.add(one.id);
    // The next tape must not take the name of one that is there.
    last = Math.max(last, number);
    tapes.push({ id: one.id, ...tape });
  }
  const edits = Object.entries(isObject(content.landmarks) ? content.landmarks : {});
  const landmarks = Object.fromEntries(edits.filter(([name, edit]) => isText(name) && isEdit(edit, patches)));
  return { tapes, landmarks, last };
}

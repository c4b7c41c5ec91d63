// Opening a file: a body, or tapes that were saved from this page.
import { soundTape } from "./model/tape_files.js";
import { h } from "./ui/dom.js";
import { showDialog } from "./ui/dialog.js";
import { readTapes } from "./ui/export_menu.js";

// Files of tapes are small; larger ones are not even looked into.
const MOST_TAPES = 2_000_000;

/** Open a file as a body; of one that does not say its unit, the user does. Returns {id, warnings}. */
export async function openFile(app, file) {
  try {
    return await app.transport.open(file);
  } catch (error) {
    if (error.wants !== "unit") throw error;
    const unit = await askUnit(app.root, file.name);
    if (!unit) throw error;
    return app.transport.open(file, unit);
  }
}

export function opening(app) {
  let opened = 0;

  const openTapes = (file, { tapes, layout, body }) => {
    if (layout && layout !== app.header.layout) {
      app.emit("message", { text: `These tapes belong to ${body || "another body"}, whose patches are laid out in another way. Open that body first.`, tone: "bad" });
      return;
    }
    const sound = tapes.map((tape) => soundTape(tape, app.header.patches));
    const wrong = sound.indexOf(null);
    if (wrong >= 0) {
      app.emit("message", { text: `${file.name}: tape number ${wrong + 1} is none of this body: a name, a mode (path, girth or closed), a kind (contact or taut) and its locations are expected. Nothing was opened; save the tapes once more from the page.`, tone: "bad" });
      return;
    }
    for (const tape of sound) app.sheet.add(tape);
    app.say(`Opened ${tapes.length} tapes.`);
  };

  const openBody = async (file) => {
    const choice = ++opened;
    await app.during(`Opening ${file.name}…`, async () => {
      const { id } = await openFile(app, file);
      // Of two files that were dropped, the later one is shown, whichever is read first.
      if (choice === opened) await app.open(id);
    });
  };

  return (file) =>
    app.try(async () => {
      if (file.name.endsWith(".json") && file.size < MOST_TAPES) {
        const tapes = readTapes(await file.text());
        if (tapes) {
          openTapes(file, tapes);
          return;
        }
      }
      await openBody(file);
    });
}

/** Some formats do not say their unit; the user may know it. */
function askUnit(root, name) {
  return new Promise((resolve) => {
    const dialog = showDialog(
      root,
      "In which unit is this file?",
      h("p", {}, `${name} does not say it, and lengths need it.`),
      h("div", { class: "row form" }, ["mm", "cm", "m", "inch"].map((unit) => h("button", { type: "button", class: "button", "data-testid": `unit-${unit}`, onClick: () => { resolve(unit); dialog.close(); } }, unit))),
    );
    dialog.addEventListener("close", () => resolve(null));
  });
}

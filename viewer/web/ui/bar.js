// The bar on top: what is open, the tools, undo, the unit, and what is rarely needed behind a menu.
import { UNITS } from "../model/units.js";
import { h, icon, iconButton } from "./dom.js";
import { showMenu } from "./menu.js";

const TOOLS = [
  ["look", "Look", "V"],
  ["tape", "Tape", "T"],
  ["girth", "Girth", "G"],
  ["loop", "Loop", "L"],
  ["landmark", "Landmark", "M"],
];
// An exported page has nobody to ask for what these measure.
const NEED_PROGRAM = ["girth", "loop", "landmark"];

export function bar(app, place, actions) {
  const title = h("h1", { class: "title" }, "bodymeasure");
  const sub = h("p", { class: "sub" });
  const tools = TOOLS.filter(([name]) => app.transport.can.measure || !NEED_PROGRAM.includes(name)).map(([name, label, key]) =>
    h(
      "button",
      {
        type: "button",
        class: "tool",
        "aria-pressed": "false",
        "aria-keyshortcuts": key,
        title: `${label} (${key})`,
        "data-tool": name,
        "data-testid": `tool-${name}`,
        onClick: () => actions.use(name),
      },
      icon(name),
      h("span", {}, label),
    ),
  );
  const undo = iconButton("undo", "Undo", () => app.sheet.undo(), { keys: "Ctrl+Z", "data-testid": "undo" });
  const redo = iconButton("redo", "Redo", () => app.sheet.redo(), { keys: "Ctrl+Shift+Z", "data-testid": "redo" });
  const unit = h(
    "select",
    { class: "unit", "aria-label": "Unit", "data-testid": "unit", onChange: () => app.settings.set("unit", unit.value) },
    Object.entries(UNITS).map(([key, { label }]) => h("option", { value: key }, label)),
  );
  const theme = iconButton("moon", "Dark", () => app.settings.set("theme", app.settings.theme === "dark" ? "light" : "dark"), { "data-testid": "theme" });
  const more = iconButton("more", "More", () => showMenu(more, actions.menu()), { "aria-haspopup": "menu", "data-testid": "more" });
  const help = iconButton("help", "Keys and help", actions.help, { keys: "?", "data-testid": "help" });

  place.append(
    h("div", { class: "brand" }, logo(), h("div", { class: "names" }, title, sub)),
    h("div", { class: "tools", role: "toolbar", "aria-label": "Tools" }, tools),
    h("div", { class: "actions" }, undo, redo, unit, theme, help, more),
  );

  const update = () => {
    if (app.header) {
      title.textContent = app.header.name || "Body";
      title.title = app.header.name;
      const { patches, file } = app.header;
      const name = (file || "").split(/[\\/]/).pop();
      sub.textContent = [name, `${patches} ${patches === 1 ? "patch" : "patches"}`, app.header.unit === "" ? "unit not known" : ""].filter(Boolean).join(" · ");
      sub.title = file ?? "";
    }
    undo.disabled = !app.sheet.canUndo;
    redo.disabled = !app.sheet.canRedo;
    unit.value = app.settings.get("unit");
    unit.disabled = app.header?.unit === "";
    const dark = app.settings.theme === "dark";
    theme.replaceChildren(icon(dark ? "sun" : "moon"));
    theme.setAttribute("aria-label", dark ? "Light colors" : "Dark colors");
    theme.title = dark ? "Light colors" : "Dark colors";
  };
  app.on("tool", (name) => {
    for (const tool of tools) tool.setAttribute("aria-pressed", String(tool.dataset.tool === name));
  });
  for (const name of ["body", "sheet", "settings"]) app.on(name, update);
  update();
}

/** A tape around a body, as on the page's icon. */
function logo() {
  const svg = icon("girth");
  svg.setAttribute("class", "icon logo");
  return svg;
}

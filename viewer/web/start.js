// Puts the viewer into an element: makes the parts, joins them, and opens the body.
import { App } from "./app.js";
import { comparing } from "./compare.js";
import { connection } from "./connection.js";
import { keepViewInLink } from "./link.js";
import { opening } from "./opening.js";
import { graphics } from "./scene/graphics.js";
import { VIEWS } from "./scene/rig.js";
import { Viewport } from "./scene/viewport.js";
import { testing } from "./testing.js";
import { Workbench } from "./tools/workbench.js";
import { bar } from "./ui/bar.js";
import { details } from "./ui/details.js";
import { displayPanel } from "./ui/display_panel.js";
import { h, download } from "./ui/dom.js";
import { dropZone } from "./ui/drop.js";
import { exportMenu } from "./ui/export_menu.js";
import { showHelp } from "./ui/help.js";
import { invitation } from "./ui/invitation.js";
import { keys } from "./ui/keys.js";
import { landmarksPanel } from "./ui/landmarks_panel.js";
import { layout } from "./ui/layout.js";
import { list } from "./ui/list.js";
import { messages } from "./ui/messages.js";
import { overlays } from "./ui/overlays.js";
import { panel } from "./ui/panel.js";

const NO_GRAPHICS =
  "This browser cannot draw the body: WebGL is switched off or not there. The list, the measurements and the files work all the same.";
const LOST = "The graphics card took the picture away. It comes back by itself; if not, reload the page.";
// A picture for print has twice the pixels of the screen.
const PICTURE_SCALE = 2;

/** Start a viewer in an element; returns {app, actions, ready, stop}. */
export function startViewer(root, transport, options = {}) {
  const app = new App(root, transport, options);
  const parts = layout(root);
  const kind = graphics();
  let viewport = null;
  let workbench = null;
  if (kind !== "none") {
    viewport = new Viewport(app, parts.host, { software: kind === "software" });
    workbench = new Workbench(app, viewport);
    viewport.stage.onContext = (lost) => app.emit("lasting", ["context", lost ? LOST : null]);
  } else {
    parts.host.append(h("div", { class: "nothing", "data-testid": "no-graphics" }, h("p", {}, NO_GRAPHICS)));
  }
  const actions = makeActions(app, viewport, workbench);

  messages(app, parts);
  bar(app, parts.bar, actions);
  // Before the legend is drawn, which shows the scale of the lines as they are colored then.
  const themed = () => {
    root.dataset.theme = app.settings.theme;
    viewport?.setTheme(app.settings.theme);
  };
  app.on("settings", themed);
  if (viewport) overlays(app, parts.host, actions);
  const rows = list(app, actions);
  actions.search = () => {
    actions.showPage("list");
    rows.focusSearch();
  };
  rows.element.append(details(app, actions));
  actions.showPage = panel(parts.panel, [
    ["list", "Measurements", rows.element],
    ["landmarks", "Landmarks", landmarksPanel(app, workbench, actions)],
    ["display", "Display", displayPanel(app, actions)],
  ]);
  const pages = options.alone ? document : root;
  const stopKeys = keys(pages, app, parts.host, actions);
  if (transport.can.open) dropZone(root, actions.open);

  const dark = matchMedia("(prefers-color-scheme: dark)");
  dark.addEventListener("change", themed);
  root.dataset.theme = app.settings.theme;
  app.on("settings", () => {
    if (viewport && viewport.stage.rig.projection !== app.settings.get("projection")) {
      viewport.stage.rig.setProjection(app.settings.get("projection"));
    }
  });
  app.on("body", () => {
    viewport?.setBody({ keepView: app.reopened });
    document.title = options.alone ? `${app.header.name} · bodymeasure` : document.title;
    for (const warning of app.header.warnings ?? []) app.emit("message", { text: warning, tone: "note" });
  });
  app.on("tool", (name) => {
    // Names in the scene are pressed only where nothing is measured by pressing.
    root.dataset.tool = name;
    app.emit("hint", workbench?.tool.hint ?? "");
  });

  const stopConnection = connection(app);
  testing(app, viewport, workbench, options);
  const ready = begin(app, viewport, workbench, parts);
  // Within another page, the address is that page's.
  let stopLink = () => {};
  if (viewport && options.alone && window.parent === window) {
    ready.then(() => (stopLink = keepViewInLink(app, viewport.stage)), () => {});
  }
  const stop = () => {
    stopKeys();
    stopLink();
    stopConnection();
    dark.removeEventListener("change", themed);
    transport.end?.();
    viewport?.dispose();
    app.emitter.clear();
    root.replaceChildren();
  };
  return { app, actions, ready, stop };
}

async function begin(app, viewport, workbench, parts) {
  try {
    await app.during("Opening the body…", () => app.open(app.options.body ?? "0"));
  } catch (error) {
    parts.host.append(h("div", { class: "nothing" }, h("p", {}, error.message)));
    throw error;
  }
  workbench?.use(app.options.tool ?? (app.header.start?.chart ? "look" : "tape"));
  if (viewport) await new Promise((resolve) => viewport.stage.afterFrame.push(resolve));
  for (const layer of app.header.start?.layers ?? []) {
    // A finished report has the differences already, which are what it is opened for.
    if (layer === "diagonals") app.settings.set("lines", "difference");
    app.settings.setLayer(layer, true);
  }
  const wanted = app.header.start?.chart ?? app.options.chart;
  if (wanted && app.transport.can.chart) app.try(() => app.takeChart(typeof wanted === "string" ? wanted : undefined));
}

function makeActions(app, viewport, workbench) {
  const compared = comparing(app, viewport);
  const actions = {
    ...compared,
    rig: viewport?.stage.rig,
    use: (name) => workbench?.use(name),
    view: (name) => viewport?.viewFrom(VIEWS[name]),
    frameAll: () => viewport?.frameAll(),
    projection: () =>
      app.settings.set("projection", app.settings.get("projection") === "perspective" ? "orthographic" : "perspective"),
    help: () => showHelp(app.root),
    menu: () => exportMenu(app, actions),
    escape: () => workbench?.escape(),
    finish: () => {
      if (!workbench?.tool.finish || workbench.tool.points.length < 2) return false;
      workbench.tool.finish();
      app.emit("tool", workbench.tool.name);
      workbench.update();
      return true;
    },
    back: () => {
      if (!workbench?.tool.points?.length) return false;
      workbench.tool.back();
      app.emit("tool", workbench.tool.name);
      workbench.update();
      return true;
    },
    hoverAt: (x, y) => workbench.hover(workbench.picker.at(x, y)),
    pressAt: (x, y, shift) => workbench.press({ x, y, shift }),
    fly: (id) => (id ? workbench?.fly(id) : viewport?.frameAll()),
    flyTo: (landmark) => {
      const normal = Array.isArray(landmark.location) ? viewport?.surface.normal(landmark.location) : null;
      viewport?.frame([landmark.position], normal ? [normal] : []);
    },
    flyToPatch: (patch) => {
      const corners = [[0, 0], [0, 1], [1, 0], [1, 1]].map(([u, v]) => [patch, u, v]);
      if (viewport && patch >= 0 && patch < app.header.patches) {
        viewport.frame(corners.map((place) => viewport.surface.position(place)), corners.map((place) => viewport.surface.normal(place)));
      }
    },
    hide: () => {
      const item = app.item(app.selected);
      if (item) app.show([item], !item.visible);
    },
    remove: (id) => {
      if (!app.sheet.tape(id)) return;
      app.sheet.remove(id);
      if (app.selected === id) app.select(null);
    },
    invitation: () => invitation(app),
    picture: () =>
      app.try(async () => {
        const background = app.settings.theme === "dark" ? "#15191d" : "#ffffff";
        download("body.png", await viewport.stage.picture(PICTURE_SCALE, background));
      }),
    // Both diagonals of the patch under the pointer, and the boundary curve that it is on.
    linesOf: ({ location, point }) => {
      const { layers } = viewport;
      const place = app.locationOf(location);
      const own = layers.shown("diagonals") && place ? layers.items("diagonals").filter((item) => item.patch === place[0]) : [];
      const near = layers.shown("boundary") ? layers.nearest("boundary", point, viewport.reach) : null;
      return near ? [layers.items("boundary")[near.line], ...own] : own;
    },
    lineScale: () => (viewport?.layers.shown("diagonals") ? viewport.layers.scale : null),
  };
  actions.open = opening(app, actions);
  return actions;
}

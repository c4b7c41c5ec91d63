// The bundle's entry, one for all three uses: it starts by itself on a page that was made for it, be
// it the server's or a file, and exports what anywidget asks for in a notebook.
import { listenToFrame } from "./framed.js";
import { startViewer } from "./start.js";
import { embeddedTransport } from "./transport/embedded.js";
import { notebookTransport } from "./transport/notebook.js";
import { serverTransport } from "./transport/server.js";

const root = typeof document === "undefined" ? null : document.getElementById("bodymeasure");
if (root) {
  const transport = embeddedTransport() ?? serverTransport();
  const { app, actions, ready } = startViewer(root, transport, { alone: true, ...transport.options });
  if (window.parent !== window) ready.then(() => listenToFrame(app, actions), () => {});
  // The page itself shows what went wrong; the console is for who looks into it.
  ready.catch((error) => console.warn(error));
}

/** Show the viewer in a cell of a notebook. */
function render({ model, el }) {
  const cell = document.createElement("div");
  cell.style.height = `${model.get("height") ?? 620}px`;
  // JupyterLab takes letters for commands, of which x would cut the cell away, unless what has the
  // focus itself says not to.
  cell.addEventListener("focusin", ({ target }) => target.setAttribute("data-lm-suppress-shortcuts", "true"));
  el.append(cell);
  const transport = notebookTransport(model);
  const { ready, stop } = startViewer(cell, transport, { alone: false, ...transport.options });
  ready.catch((error) => console.warn(error));
  return stop;
}

export { startViewer };
export default { render };

// Dialogs, by the browser's own element, which keeps the focus inside and closes on Esc.
import { h, iconButton, unique } from "./dom.js";

/** Show a dialog with a title; returns it. */
export function showDialog(root, title, ...content) {
  const name = unique("title");
  const close = iconButton("close", "Close", () => dialog.close());
  const dialog = h(
    "dialog",
    { class: "dialog", "aria-labelledby": name },
    h("div", { class: "dialog-head" }, h("h2", { id: name }, title), close),
    ...content,
  );
  dialog.addEventListener("close", () => dialog.remove());
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  dialog.addEventListener("keydown", (event) => event.stopPropagation());
  root.append(dialog);
  dialog.showModal();
  return dialog;
}

// A file dropped anywhere on the page is opened.
import { h } from "./dom.js";

export function dropZone(root, onFile) {
  const cover = h("div", { class: "drop", hidden: true, "aria-hidden": "true" }, h("p", {}, "Drop the file to open it"));
  root.append(cover);
  const isFile = (event) => [...(event.dataTransfer?.types ?? [])].includes("Files");
  root.addEventListener("dragover", (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    cover.hidden = false;
  });
  root.addEventListener("dragleave", (event) => {
    if (!root.contains(event.relatedTarget)) cover.hidden = true;
  });
  root.addEventListener("drop", (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    cover.hidden = true;
    if (event.dataTransfer.files[0]) onFile(event.dataTransfer.files[0]);
  });
}

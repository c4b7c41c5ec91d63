// The page's skeleton. Every part fills its own place and knows nothing of the others.
import { h } from "./dom.js";

export function layout(root) {
  const parts = {
    bar: h("header", { class: "bar" }),
    host: h("div", {
      class: "scene",
      tabindex: "0",
      role: "application",
      "aria-label": "The body. Arrow keys turn it, W A S D move the crosshair, Enter clicks there, question mark lists all keys.",
      "data-testid": "scene",
    }),
    panel: h("aside", { class: "panel", "aria-label": "Measurements, landmarks and display" }),
    messages: h("div", { class: "messages", role: "status", "aria-live": "polite", "data-testid": "messages" }),
    banner: h("div", { class: "banner", role: "alert", hidden: true, "data-testid": "banner" }),
  };
  const stage = h("main", { class: "stage" }, parts.host);
  root.classList.add("bm");
  root.replaceChildren(parts.bar, parts.banner, h("div", { class: "work" }, stage, parts.panel), parts.messages);
  return parts;
}

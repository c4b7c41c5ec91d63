// Sentences for the user: passing ones at the bottom, and one on top for what lasts.
import { h, iconButton } from "./dom.js";

// Long enough to read a sentence twice; what went wrong stays until it is closed.
const READ = 6000;
const MOST = 3;

export function messages(app, { messages: place, banner }) {
  app.on("message", ({ text, tone }) => {
    for (const other of [...place.children]) if (other.dataset.text === text) other.remove();
    const message = h("div", { class: `message ${tone}`, "data-text": text }, h("p", {}, text), iconButton("close", "Close this message", () => message.remove()));
    place.append(message);
    while (place.children.length > MOST) place.firstChild.remove();
    if (tone !== "bad") setTimeout(() => message.remove(), READ);
  });

  const lasting = new Map();
  const show = () => {
    const text = [...lasting.values()].at(-1);
    banner.hidden = !text;
    banner.textContent = text ?? "";
  };
  /** Say something as long as it holds; null when it is over. */
  app.on("lasting", ([name, text]) => {
    if (text) lasting.set(name, text);
    else lasting.delete(name);
    show();
  });
}

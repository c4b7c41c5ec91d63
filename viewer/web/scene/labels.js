// Names and values in the scene, as elements of the page: sharp, selectable, read aloud. They are
// moved by transforms, pushed apart where they overlap, and dimmed where the body hides their place.
import { h } from "../ui/dom.js";

const GAP = 3;

export class Labels {
  #labels = new Map();

  constructor(host, stage, hidden) {
    this.layer = h("div", { class: "labels", "aria-hidden": "false" });
    host.append(this.layer);
    this.stage = stage;
    this.hidden = hidden;
    stage.afterFrame.push(() => this.place());
  }

  /** Show exactly these: {id, anchor, text, tone, onClick, onEnter, onLeave}. */
  set(labels) {
    const kept = new Set(labels.map((label) => label.id));
    for (const [id, { element }] of this.#labels) {
      if (kept.has(id)) continue;
      element.remove();
      this.#labels.delete(id);
    }
    for (const label of labels) {
      let entry = this.#labels.get(label.id);
      if (!entry) {
        const element = h("div", { class: "label", "data-testid": `label-${label.id}` });
        this.layer.append(element);
        entry = { element };
        element.addEventListener("click", () => entry.label.onClick?.());
        element.addEventListener("pointerenter", () => entry.label.onHover?.(true));
        element.addEventListener("pointerleave", () => entry.label.onHover?.(false));
        this.#labels.set(label.id, entry);
      }
      if (entry.element.textContent !== label.text) {
        entry.element.textContent = label.text;
        entry.size = null;
      }
      entry.element.className = `label ${label.tone ?? ""} ${label.onClick ? "live" : ""}`;
      entry.label = label;
    }
    this.stage.invalidate();
  }

  place() {
    const [width, height] = this.stage.size;
    const entries = [];
    for (const entry of this.#labels.values()) {
      const { x, y, depth } = this.stage.project(entry.label.anchor);
      const shown = depth < 1 && x > 0 && x < width && y > 0 && y < height;
      entry.element.hidden = !shown;
      if (!shown) continue;
      // Measured once a text: asking for a size in every frame would lay out the page each time.
      entry.size ??= [entry.element.offsetWidth, entry.element.offsetHeight];
      const [w, t] = entry.size;
      entries.push({ entry, x: Math.max(2, Math.min(x + 10, width - w - 2)), y: y - t / 2, w, t });
    }
    entries.sort((a, b) => a.y - b.y);
    const placed = [];
    for (const one of entries) {
      for (const other of placed) {
        const beside = one.x + one.w < other.x || other.x + other.w < one.x;
        if (!beside && one.y < other.y + other.t + GAP && one.y + one.t + GAP > other.y) {
          one.y = other.y + other.t + GAP;
        }
      }
      placed.push(one);
      const { entry } = one;
      entry.element.style.transform = `translate(${Math.round(one.x)}px, ${Math.round(one.y)}px)`;
      // Rays cost more than a frame's worth while the view moves.
      if (!this.stage.moving) {
        entry.element.classList.toggle("behind", this.hidden(entry.label.anchor));
      }
    }
  }
}

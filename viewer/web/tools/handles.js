// The ends of the selected tape, and landmarks, as things to take hold of: dragged by the pointer, or
// moved by the arrow keys. They stand on the body and never leave it.
import { h } from "../ui/dom.js";

// One press of an arrow key, in pixels; with Shift one pixel.
const STEP = 8;
// Up to this many pixels a press on a handle is no drag.
const STILL = 4;

export class Handles {
  #handles = [];

  /** A press that did not become a drag, and a hover, are the body's: `onPress` and `onHover`. */
  constructor(app, viewport, picker, { onPress, onHover }) {
    this.onPress = onPress;
    this.onHover = onHover;
    this.app = app;
    this.viewport = viewport;
    this.picker = picker;
    this.layer = h("div", { class: "handles" });
    viewport.host.append(this.layer);
    viewport.stage.afterFrame.push(() => this.place());
    this.dragged = null;
  }

  /** Show handles: {key, label, at() -> point, move(hit, first), end()}. */
  set(handles) {
    const same =
      handles.length === this.#handles.length && handles.every((one, n) => one.key === this.#handles[n].handle.key);
    if (same) {
      // Kept as elements, since one of them may be under the finger or have the focus.
      handles.forEach((handle, n) => {
        this.#handles[n].handle = handle;
        this.#handles[n].element.setAttribute("aria-label", handle.label);
      });
      this.place();
      return;
    }
    this.layer.replaceChildren();
    this.#handles = handles.map((handle) => this.#make(handle));
    this.place();
  }

  #make(handle) {
    const element = h("button", {
      type: "button",
      class: "handle",
      "aria-label": handle.label,
      title: handle.label,
      "data-testid": `handle-${handle.key}`,
    });
    const entry = { handle, element };
    const at = (event) => {
      const { left, top } = this.viewport.stage.canvas.getBoundingClientRect();
      return this.picker.at(event.clientX - left, event.clientY - top, { snap: !event.altKey });
    };
    element.addEventListener("pointerdown", (event) => {
      event.preventDefault();
      element.setPointerCapture(event.pointerId);
      this.dragged = entry;
      entry.first = true;
      [entry.x, entry.y] = [event.clientX, event.clientY];
    });
    element.addEventListener("pointermove", (event) => {
      if (this.dragged !== entry) {
        if (!event.buttons) this.onHover(at(event));
        return;
      }
      const moved = Math.hypot(event.clientX - entry.x, event.clientY - entry.y);
      if (entry.first && moved < STILL) return;
      const hit = at(event);
      // Off the body the point stays where it was last.
      if (!hit || hit.side) return;
      entry.handle.move(hit, entry.first);
      entry.first = false;
    });
    const end = () => {
      if (this.dragged !== entry) return false;
      this.dragged = null;
      if (!entry.first) entry.handle.end?.();
      return entry.first;
    };
    element.addEventListener("pointerup", (event) => {
      if (!end()) return;
      const { left, top } = this.viewport.stage.canvas.getBoundingClientRect();
      this.onPress({ x: event.clientX - left, y: event.clientY - top, alt: event.altKey, shift: event.shiftKey });
    });
    element.addEventListener("pointercancel", end);
    element.addEventListener("keydown", (event) => {
      const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [];
      if (x === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      const step = event.shiftKey ? 1 : STEP;
      const place = this.viewport.stage.project(entry.handle.at());
      const hit = this.picker.at(place.x + x * step, place.y + y * step, { snap: false });
      if (!hit) return;
      entry.handle.move(hit, true);
      entry.handle.end?.();
    });
    this.layer.append(element);
    return entry;
  }

  place() {
    for (const { handle, element } of this.#handles) {
      const point = handle.at();
      element.hidden = !point;
      if (!point) continue;
      const { x, y } = this.viewport.stage.project(point);
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
      if (!this.viewport.stage.moving) element.classList.toggle("behind", this.viewport.hidden(point));
    }
  }
}

// Presses and moves in the scene. A press that moved is a turn of the view, never a click.

// Up to this many pixels between press and release count as a click; hands are not still.
const STILL = 4;

export class Pointer {
  #down = null;
  #frame = 0;

  constructor(canvas, { onHover, onClick, onDouble, onLeave }) {
    this.canvas = canvas;
    this.touches = 0;
    const place = (event) => {
      const { left, top } = canvas.getBoundingClientRect();
      return { x: event.clientX - left, y: event.clientY - top };
    };
    canvas.addEventListener("pointerdown", (event) => {
      this.touches++;
      this.#down = event.button === 0 && this.touches === 1 ? place(event) : null;
    });
    canvas.addEventListener("pointercancel", () => (this.touches = Math.max(0, this.touches - 1)));
    canvas.addEventListener("pointerup", (event) => {
      this.touches = Math.max(0, this.touches - 1);
      const { x, y } = place(event);
      const down = this.#down;
      this.#down = null;
      if (!down || Math.hypot(x - down.x, y - down.y) >= STILL) return;
      onClick({ x, y, alt: event.altKey, shift: event.shiftKey });
    });
    canvas.addEventListener("dblclick", (event) => onDouble(place(event)));
    canvas.addEventListener("pointermove", (event) => {
      // While a button is held the view turns, and a finger has no hover.
      if (event.buttons || event.pointerType === "touch") return;
      const { x, y } = place(event);
      cancelAnimationFrame(this.#frame);
      // Once a frame is enough; mice report several times as often.
      this.#frame = requestAnimationFrame(() => onHover({ x, y, alt: event.altKey }));
    });
    canvas.addEventListener("pointerleave", () => {
      cancelAnimationFrame(this.#frame);
      onLeave();
    });
  }
}

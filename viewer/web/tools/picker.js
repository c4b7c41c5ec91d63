// From a pixel to a place on the body, drawn to landmarks and to corners of patches when near.

// How near a landmark counts as near, in pixels, and a corner, of which there are many more.
const REACH = 13;
const CORNER = 6;
// Corners of patches that are smaller than this on the screen would leave nothing else to click.
const LARGE = 36;

export class Picker {
  constructor(app, viewport) {
    this.app = app;
    this.viewport = viewport;
  }

  /** What is under a pixel: {location, point, normal, snap, name, side}, or null off the body. */
  at(x, y, { snap = true } = {}) {
    const hit = this.viewport.pickAt(x, y);
    if (!hit) return null;
    const surface = hit.side ? this.viewport.second.surface : this.viewport.surface;
    const plain = { ...hit, normal: surface.normal(hit.location), snap: null, name: "" };
    if (hit.side || !snap || !this.app.settings.get("snap")) return plain;
    return this.#landmark(plain, x, y) ?? this.#corner(plain, x, y) ?? plain;
  }

  #pixels(point, x, y) {
    const place = this.viewport.stage.project(point);
    return Math.hypot(place.x - x, place.y - y);
  }

  #landmark(hit, x, y) {
    if (!this.app.settings.get("layers").landmarks) return null;
    let best = null;
    let least = REACH;
    for (const landmark of this.app.landmarks) {
      const pixels = this.#pixels(landmark.position, x, y);
      // One on the far side of the body is near on the screen only.
      if (pixels < least && !this.viewport.hidden(landmark.position)) [best, least] = [landmark, pixels];
    }
    if (!best) return null;
    const normal = Array.isArray(best.location) ? this.viewport.surface.normal(best.location) : hit.normal;
    return { ...hit, location: best.name, point: best.position, normal, snap: "landmark", name: best.name };
  }

  #corner(hit, x, y) {
    const [patch, u, v] = hit.location;
    const location = [patch, Math.round(u), Math.round(v)];
    const { surface } = this.viewport;
    const point = surface.position(location);
    if (this.#pixels(point, x, y) > CORNER || this.viewport.hidden(point)) return null;
    const sides = [[1 - location[1], location[2]], [location[1], 1 - location[2]]];
    const large = sides.every(([p, q]) => this.#pixels(surface.position([patch, p, q]), x, y) > LARGE);
    if (!large) return null;
    return { ...hit, location, point, normal: surface.normal(location), snap: "corner", name: "corner of a patch" };
  }
}

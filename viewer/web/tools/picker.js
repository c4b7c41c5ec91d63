// From a pixel to a place on the body, drawn to landmarks and to corners of patches when near.

// How near counts as near, in pixels.
const REACH = 13;

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

  #near(point, hit, x, y) {
    const place = this.viewport.stage.project(point);
    const pixels = Math.hypot(place.x - x, place.y - y);
    // A landmark on the far side of the body may be near on the screen only.
    const apart = Math.hypot(...point.map((value, k) => value - hit.point[k]));
    return pixels < REACH && apart < 4 * REACH * this.viewport.stage.pixelAt() ? pixels : Infinity;
  }

  #landmark(hit, x, y) {
    if (!this.app.settings.get("layers").landmarks) return null;
    let best = null;
    let least = Infinity;
    for (const landmark of this.app.landmarks) {
      const pixels = this.#near(landmark.position, hit, x, y);
      if (pixels < least) [best, least] = [landmark, pixels];
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
    if (this.#near(point, hit, x, y) === Infinity) return null;
    return { ...hit, location, point, normal: surface.normal(location), snap: "corner", name: "corner of a patch" };
  }
}

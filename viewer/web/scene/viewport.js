// The scene of a body on the page: which body, layers, lines and labels stand on the stage.
import { Vector3 } from "three";
import { Dots } from "./dots.js";
import { Labels } from "./labels.js";
import { Layers } from "./layers.js";
import { Lines } from "./line_set.js";
import { Stage } from "./stage.js";
import { Surface } from "./surface.js";
import { Second } from "./second.js";

// While the view moves and drawing is slow, every second vertex is drawn.
const COARSE = 2;
// A point counts as hidden when the body stands this part of its size before it.
const BEHIND = 4e-3;
// A line is under the pointer within this many pixels.
const REACH = 7;

function cornersOf([low, high]) {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((n) => [0, 1, 2].map((k) => ((n >> k) & 1 ? high : low)[k]));
}

export class Viewport {
  constructor(app, host, { software }) {
    this.app = app;
    this.host = host;
    this.software = software;
    this.stage = new Stage(host, { software });
    this.surface = null;
    this.dots = new Dots();
    this.stage.scene.add(this.dots.object);
    this.lines = new Lines(this.stage.scene, this.stage);
    this.layers = new Layers(app, this);
    this.labels = new Labels(host, this.stage, (point) => this.hidden(point));
    this.second = new Second(app, this);
    this.stage.onQuality.push((coarse) => this.#quality(coarse));
    this.stage.beforeFrame.push(() => {
      for (const dots of [this.dots, this.second.surface && this.second.dots]) {
        if (dots) dots.material.uniforms.ratio.value = this.stage.renderer.getPixelRatio();
      }
    });
  }

  /** Show the app's body in place of the one before. */
  setBody({ keepView = false } = {}) {
    const { app, stage } = this;
    const view = keepView ? stage.rig.view : null;
    if (this.surface) {
      stage.scene.remove(this.surface.object);
      this.surface.dispose();
    }
    this.surface = new Surface({ header: app.header, arrays: app.arrays }, { software: this.software });
    this.surface.setTheme(app.settings.theme);
    stage.scene.add(this.surface.object);
    const { center, radius } = this.surface.geometry.boundingSphere;
    this.center = center;
    this.radius = radius || 1;
    stage.rig.radius = this.radius;
    this.layers.reset();
    if (app.settings.get("projection") !== stage.rig.projection) {
      stage.rig.setProjection(app.settings.get("projection"));
    }
    stage.rig.view = view ?? stage.rig.framing(this.corners, { theta: 0, phi: Math.PI / 2 });
    // The tree for picking comes after the first picture, which is what is waited for.
    const prepare = () => !stage.disposed && this.surface?.prepare();
    setTimeout(() => (window.requestIdleCallback ?? ((run) => run()))(prepare, { timeout: 500 }), 50);
  }

  /** The corners of the box around the body. */
  get corners() {
    return cornersOf(this.app.header.bounds);
  }

  /** How far from a point of the body a line is still under the pointer, in meters. */
  get reach() {
    return REACH * this.stage.pixelAt();
  }

  get lift() {
    return this.radius * 6e-4;
  }

  setTheme(theme) {
    this.surface?.setTheme(theme);
    this.second.setTheme(theme);
    this.layers.update();
    this.stage.invalidate();
  }

  #quality(coarse) {
    this.surface?.setStride(coarse ? COARSE : 1);
    this.second.setCoarse(coarse ? COARSE : 1);
    this.layers.setCoarse(coarse);
    this.lines.setCoarse(coarse);
  }

  /** What lies under a point of the host, in its pixels: {location, point, side} or null. */
  pickAt(x, y) {
    const { ray, side } = this.stage.rayAt(x, y);
    const surface = side ? this.second.surface : this.surface;
    const hit = surface?.pick(ray);
    return hit ? { ...hit, side } : null;
  }

  /** Whether the body stands before a point. */
  hidden(point) {
    if (!this.surface) return false;
    const { x, y } = this.stage.project(point);
    const { ray } = this.stage.rayAt(x, y);
    const hit = this.surface.pick(ray);
    if (!hit) return false;
    const distance = ray.direction.dot(new Vector3().fromArray(point).sub(ray.origin));
    return hit.distance < distance - BEHIND * this.radius;
  }

  /** Fly to a side of the body. */
  viewFrom(direction) {
    const { rig } = this.stage;
    // Of two bodies, both are to be seen whole.
    const { offset, bounds } = this.second;
    const beside = bounds ? cornersOf(bounds).map((corner) => corner.map((value, k) => value + offset.getComponent(k))) : [];
    rig.fly(rig.framing([...this.corners, ...beside], direction));
  }

  frameAll() {
    this.viewFrom(this.stage.rig.view);
  }

  /** Fly to points, from the side that their normals look to. */
  frame(points, normals) {
    const { rig } = this.stage;
    const view = rig.view;
    const mean = [0, 0, 0];
    for (const normal of normals ?? []) normal.forEach((value, k) => (mean[k] += value / normals.length));
    let { theta, phi } = view;
    // A loop's normals cancel out; then the side does not matter, and the view stays.
    if (Math.hypot(...mean) > 0.3) {
      theta = Math.atan2(mean[0], mean[2]);
      phi = Math.PI / 2 - Math.max(-0.5, Math.min(0.5, Math.asin(mean[1] / Math.hypot(...mean))));
    }
    const framed = rig.framing(points, { theta, phi });
    // Not nearer than a fifth of the body, which would show nothing to know the place by.
    rig.fly({ ...framed, height: Math.max(framed.height * 1.5, this.radius * 0.45) });
  }

  dispose() {
    this.surface?.dispose();
    this.second.clear();
    this.lines.clear();
    this.layers.clear();
    this.dots.dispose();
    this.stage.dispose();
  }
}

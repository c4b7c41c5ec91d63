// The camera: two projections of one view, turned about a target, with y always up. A view is
// {target, theta, phi, height}: where it looks, from where, and how many meters fit into the height.
import { OrthographicCamera, PerspectiveCamera, Spherical, Vector3, MOUSE } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

// A long lens: a body in perspective that still looks like the body in orthographic view.
const FIELD = 24;
// Room around, as a factor, and above for the hint, in pixels.
const MARGIN = 1.17;
const HINT = 54;
const FLIGHT = 350;
// From exactly above, what is up on the screen would be undecided.
const NEARLY_TOP = 1e-3;

export const VIEWS = {
  front: { theta: 0, phi: Math.PI / 2 },
  back: { theta: Math.PI, phi: Math.PI / 2 },
  left: { theta: Math.PI / 2, phi: Math.PI / 2 },
  right: { theta: -Math.PI / 2, phi: Math.PI / 2 },
  top: { theta: 0, phi: NEARLY_TOP },
};

export class Rig {
  #flight = 0;

  constructor(element, onChange) {
    this.orthographic = new OrthographicCamera();
    this.perspective = new PerspectiveCamera(FIELD);
    this.camera = this.orthographic;
    this.radius = 1;
    this.aspect = 1;
    // The part of the width that nothing lies over.
    this.room = 1;
    this.margin = MARGIN;
    this.onChange = onChange;
    this.controls = new OrbitControls(this.camera, element);
    this.controls.zoomToCursor = true;
    this.controls.enableDamping = false;
    this.controls.mouseButtons = { LEFT: MOUSE.ROTATE, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.PAN };
    this.controls.addEventListener("change", () => onChange());
    this.controls.addEventListener("start", () => cancelAnimationFrame(this.#flight));
  }

  get projection() {
    return this.camera === this.orthographic ? "orthographic" : "perspective";
  }

  get view() {
    const { target } = this.controls;
    const offset = new Vector3().subVectors(this.camera.position, target);
    const place = new Spherical().setFromVector3(offset);
    const height =
      this.camera === this.orthographic
        ? (this.camera.top - this.camera.bottom) / this.camera.zoom
        : 2 * place.radius * Math.tan((FIELD * Math.PI) / 360);
    return { target: target.toArray(), theta: place.theta, phi: place.phi, height };
  }

  set view({ target, theta, phi, height }) {
    const { camera, controls } = this;
    controls.target.fromArray(target);
    const far = 4 * this.radius;
    const distance =
      camera === this.orthographic ? far : height / (2 * Math.tan((FIELD * Math.PI) / 360));
    const offset = new Vector3().setFromSpherical(new Spherical(distance, phi, theta).makeSafe());
    camera.position.copy(controls.target).add(offset);
    if (camera === this.orthographic) {
      camera.zoom = 1;
      camera.top = height / 2;
      camera.bottom = -height / 2;
    }
    this.#fit();
    controls.update();
    this.onChange();
  }

  /** Keep the planes of the view around the body, and its width to the window's. */
  #fit() {
    const { camera, aspect, radius, controls } = this;
    if (camera === this.orthographic) {
      camera.right = camera.top * aspect;
      camera.left = -camera.right;
      [camera.near, camera.far] = [-4 * radius, 16 * radius];
    } else {
      const distance = camera.position.distanceTo(controls.target);
      camera.aspect = aspect;
      camera.near = Math.max(distance / 200, distance - 4 * radius);
      camera.far = distance + 8 * radius;
    }
    camera.updateProjectionMatrix();
  }

  /** Before each frame: the wheel may have brought the camera elsewhere. */
  update() {
    if (this.camera === this.perspective) this.#fit();
    this.camera.updateMatrixWorld();
  }

  /** `room` is the part of the width that nothing lies over, `height` that of the scene in pixels. */
  resize(aspect, room, height) {
    this.aspect = aspect;
    this.room = room;
    // In a low scene the hint would lie over the head.
    this.margin = Math.max(MARGIN, height / Math.max(height - 2 * HINT, height / 2));
    this.#fit();
  }

  setProjection(name) {
    const { view } = this;
    this.camera = this[name];
    this.controls.object = this.camera;
    this.view = view;
  }

  /** The view from a side in which all points fit. */
  framing(points, { theta, phi } = this.view) {
    const back = new Vector3().setFromSpherical(new Spherical(1, phi, theta).makeSafe());
    const right = new Vector3(0, 1, 0).cross(back).normalize();
    const up = new Vector3().crossVectors(back, right);
    const axes = [right, up, back];
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (const point of points) {
      axes.forEach((axis, k) => {
        const place = axis.x * point[0] + axis.y * point[1] + axis.z * point[2];
        low[k] = Math.min(low[k], place);
        high[k] = Math.max(high[k], place);
      });
    }
    const target = new Vector3();
    axes.forEach((axis, k) => target.addScaledVector(axis, (low[k] + high[k]) / 2));
    const wide = (high[0] - low[0]) / (this.aspect * this.room);
    let height = Math.max((high[1] - low[1]) * this.margin, wide * MARGIN);
    // What is nearer than the target looks larger in perspective.
    if (this.camera === this.perspective) height += (high[2] - low[2]) * 0.25;
    return { target: target.toArray(), theta, phi, height: height || this.radius };
  }

  /** Go to a view, on the way of a quarter of a second; at once for who asked for less motion. */
  fly(view) {
    cancelAnimationFrame(this.#flight);
    const from = this.view;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches || document.hidden) {
      this.view = view;
      return;
    }
    // The short way round.
    const turn = Math.atan2(Math.sin(view.theta - from.theta), Math.cos(view.theta - from.theta));
    const begin = performance.now();
    const step = (now) => {
      const time = Math.min(1, Math.max(0, (now - begin) / FLIGHT));
      const part = time * time * (3 - 2 * time);
      const mix = (a, b) => a + (b - a) * part;
      this.view = {
        target: from.target.map((value, k) => mix(value, view.target[k])),
        theta: from.theta + turn * part,
        phi: mix(from.phi, view.phi),
        height: from.height * (view.height / from.height) ** part,
      };
      if (time < 1) this.#flight = requestAnimationFrame(step);
    };
    this.#flight = requestAnimationFrame(step);
  }

  turn(right, down) {
    const { theta, phi, ...rest } = this.view;
    const limited = Math.min(Math.PI - NEARLY_TOP, Math.max(NEARLY_TOP, phi + down));
    this.view = { ...rest, theta: theta + right, phi: limited };
  }

  zoom(factor) {
    this.view = { ...this.view, height: this.view.height / factor };
  }

  /** Move the view by parts of its height. */
  pan(right, up) {
    const { target, height, ...rest } = this.view;
    const move = new Vector3(right * height, up * height, 0).applyQuaternion(this.camera.quaternion);
    this.view = { ...rest, height, target: new Vector3().fromArray(target).add(move).toArray() };
  }

  dispose() {
    cancelAnimationFrame(this.#flight);
    this.controls.dispose();
  }
}

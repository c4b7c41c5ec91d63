// The drawing itself. A frame is drawn only when something changed, coarser while the view moves
// where drawing is slow, and at full quality once it rests.
import { AmbientLight, Color, DirectionalLight, HemisphereLight, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { Rig } from "./rig.js";

// The view rests when nothing moved it for this long, in milliseconds.
const REST = 150;
const LONGEST_REST = 600;
// A frame that takes longer is felt while turning, so it is drawn coarser.
const SLOW_FRAME = 33;
const MOST_RATIO = 2;
// Buttons lie over the right side, in pixels; as much stays free at the left.
const COVERED = 120;

export class Stage {
  #wanted = 0;
  #rest = 0;
  #moved = 0;
  #background = null;

  constructor(host, { software }) {
    this.software = software;
    this.host = host;
    this.renderer = new WebGLRenderer({ antialias: !software, alpha: true, powerPreference: "high-performance" });
    this.canvas = this.renderer.domElement;
    this.canvas.setAttribute("data-testid", "canvas");
    host.prepend(this.canvas);
    this.scene = new Scene();
    // A second body stands in a scene of its own, beside the first, under the same camera.
    this.second = null;
    this.light = addLights(this.scene);
    this.rig = new Rig(this.canvas, () => this.move());
    this.moving = false;
    this.slow = software;
    this.frames = 0;
    this.lost = false;
    this.beforeFrame = [];
    this.afterFrame = [];
    this.onQuality = [];
    this.onRest = [];
    this.ray = new Raycaster();
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(host);
    this.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.lost = true;
      this.onContext?.(true);
    });
    this.canvas.addEventListener("webglcontextrestored", () => {
      this.lost = false;
      this.onContext?.(false);
      // Restored contexts are blank until somebody draws.
      this.invalidate();
    });
    this.resize();
  }

  get ratio() {
    const full = Math.min(devicePixelRatio || 1, MOST_RATIO);
    return this.coarse ? Math.min(full, 0.5) : full;
  }

  get coarse() {
    return this.moving && this.slow;
  }

  /** The width and height of one view, in pixels of the page. */
  get size() {
    const { clientWidth, clientHeight } = this.host;
    return [Math.max(1, this.second ? clientWidth / 2 : clientWidth), Math.max(1, clientHeight)];
  }

  resize() {
    const { clientWidth, clientHeight } = this.host;
    if (!clientWidth || !clientHeight) return;
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    const [width, height] = this.size;
    this.rig.resize(width / height, Math.max(0.6, 1 - COVERED / width), height);
    this.invalidate();
  }

  /** Ask for one frame. */
  invalidate() {
    if (this.#wanted || this.disposed) return;
    this.#wanted = requestAnimationFrame(() => {
      this.#wanted = 0;
      this.draw();
    });
  }

  /** The view moved: draw, coarser if need be, and at full quality when it rests. */
  move() {
    clearTimeout(this.#rest);
    const now = performance.now();
    // A busy machine moves in jerks; a frame of full quality in between would hold it up further.
    const pause = this.moving ? Math.min(LONGEST_REST, Math.max(REST, 3 * (now - this.#moved))) : REST;
    this.#moved = now;
    this.#rest = setTimeout(() => this.#setMoving(false), pause);
    this.#setMoving(true);
    this.invalidate();
  }

  #setMoving(moving) {
    if (this.moving === moving) return;
    this.moving = moving;
    const ratio = this.renderer.getPixelRatio();
    if (ratio !== this.ratio) this.renderer.setPixelRatio(this.ratio);
    for (const listener of this.onQuality) listener(this.coarse);
    if (!moving) for (const listener of this.onRest) listener();
    this.invalidate();
  }

  draw() {
    if (this.lost || this.disposed) return;
    const begin = performance.now();
    this.rig.update();
    for (const listener of this.beforeFrame) listener();
    this.#render();
    // A card that is slow with this body is treated as the processor is.
    if (this.moving && !this.slow && performance.now() - begin > SLOW_FRAME) this.slow = true;
    this.frames++;
    for (const listener of this.afterFrame) listener();
  }

  #render() {
    const { renderer, scene, second, rig } = this;
    const { clientWidth, clientHeight } = this.host;
    this.light.position.copy(rig.camera.position).sub(rig.controls.target);
    keyLight(this.light, rig.camera);
    if (!second) {
      renderer.setScissorTest(false);
      renderer.setViewport(0, 0, clientWidth, clientHeight);
      renderer.render(scene, rig.camera);
      return;
    }
    const half = clientWidth / 2;
    renderer.setScissorTest(true);
    [scene, second].forEach((one, n) => {
      renderer.setViewport(n * half, 0, half, clientHeight);
      renderer.setScissor(n * half, 0, half, clientHeight);
      keyLight(one.userData.key, rig.camera);
      renderer.render(one, rig.camera);
    });
  }

  /** Show a second scene beside the first, or only the first with null. */
  setSecond(scene) {
    this.second = scene;
    if (scene) addLights(scene);
    this.resize();
  }

  /** Where a point of the body is on the host, in its pixels; `depth` is over 1 behind the viewer. */
  project(point) {
    const [width, height] = this.size;
    const place = new Vector3().fromArray(point).project(this.rig.camera);
    return { x: ((place.x + 1) / 2) * width, y: ((1 - place.y) / 2) * height, depth: place.z };
  }

  /** The ray under a point of the host; `side` is 1 over the second body. */
  rayAt(x, y) {
    const [width, height] = this.size;
    const side = this.second && x > width ? 1 : 0;
    const place = new Vector2(((x - side * width) / width) * 2 - 1, 1 - (y / height) * 2);
    this.rig.camera.updateMatrixWorld();
    this.ray.setFromCamera(place, this.rig.camera);
    return { ray: this.ray.ray, side };
  }

  /** How many meters a pixel is at a point. */
  pixelAt() {
    return this.rig.view.height / this.size[1];
  }

  /** The scene as a picture, `scale` times as large as on the screen. */
  async picture(scale, background) {
    const { renderer, scene } = this;
    const ratio = renderer.getPixelRatio();
    this.#background = scene.background;
    scene.background = new Color(background);
    if (this.second) this.second.background = scene.background;
    renderer.setPixelRatio(Math.min(devicePixelRatio || 1, MOST_RATIO) * scale);
    // A canvas is empty a moment after it was drawn, so both happen in one task.
    this.draw();
    const blob = new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
    scene.background = this.#background;
    if (this.second) this.second.background = null;
    renderer.setPixelRatio(ratio);
    this.invalidate();
    return blob;
  }

  dispose() {
    this.disposed = true;
    cancelAnimationFrame(this.#wanted);
    clearTimeout(this.#rest);
    this.observer.disconnect();
    this.rig.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
    this.canvas.remove();
  }
}

/** A soft sky and one lamp that goes with the viewer, so that the same side is always lit. */
function addLights(scene) {
  if (scene.userData.key) return scene.userData.key;
  scene.add(new AmbientLight("#ffffff", 0.55), new HemisphereLight("#ffffff", "#8d8379", 1.15));
  const key = new DirectionalLight("#fffaf2", 1.75);
  scene.add(key, key.target);
  scene.userData.key = key;
  return key;
}

function keyLight(light, camera) {
  // Over the viewer's left shoulder.
  light.position.set(-0.45, 0.65, 1).applyQuaternion(camera.quaternion);
  light.target.position.set(0, 0, 0);
}

// A second body beside the first, in a scene of its own, under the same camera.
import { Group, Scene } from "three";
import { h } from "../ui/dom.js";
import { Dots } from "./dots.js";
import { Lines } from "./line_set.js";
import { lifted, release, segmentsOf, thinSegments } from "./lines.js";
import { Surface } from "./surface.js";

export class Second {
  constructor(app, viewport) {
    this.app = app;
    this.viewport = viewport;
    this.surface = null;
    this.bounds = null;
    this.lines = null;
    this.name = h("p", { class: "second-name", hidden: true, "data-testid": "second-name" });
    viewport.host.append(this.name);
  }

  show({ header, arrays }) {
    this.clear();
    const scene = new Scene();
    this.surface = new Surface({ header, arrays }, { software: this.viewport.software });
    this.surface.setTheme(this.app.settings.theme);
    // Bodies may stand anywhere in their files; beside each other they share their middle and floor.
    const [low, high] = header.bounds;
    const [first, last] = this.app.header.bounds;
    const middle = (k) => (first[k] + last[k] - low[k] - high[k]) / 2;
    this.surface.object.position.set(middle(0), first[1] - low[1], middle(2));
    this.surface.object.updateMatrixWorld();
    this.offset = this.surface.object.position;
    this.bounds = header.bounds;
    scene.add(this.surface.object);
    if (arrays.seams?.shape[0]) {
      const [count, samples] = arrays.seams.shape;
      const raised = lifted(arrays.seams.data, arrays.seam_normals?.data, this.viewport.lift);
      this.seams = thinSegments(segmentsOf(raised, count, samples), { color: "#4a4640", opacity: 0.3 });
      // It moves with the body that it lies on.
      this.surface.object.add(this.seams);
    }
    // Its landmarks and tapes stand with it, wherever it stands.
    const group = new Group();
    group.position.copy(this.offset);
    this.dots = new Dots();
    group.add(this.dots.object);
    this.lines = new Lines(group, this.viewport.stage);
    scene.add(group);
    this.landmarks = header.landmarks ?? [];
    this.name.textContent = header.name;
    this.name.hidden = false;
    const pick = this.surface.pick.bind(this.surface);
    this.surface.pick = (ray) => {
      const moved = ray.clone();
      moved.origin.sub(this.offset);
      return pick(moved);
    };
    this.viewport.stage.setSecond(scene);
  }

  /** Draw its tapes, and its landmarks where they are wanted. */
  update(lines, { landmarks, color }) {
    if (!this.surface) return;
    this.lines.set(lines);
    this.colors = Object.fromEntries(lines.map(({ id, color: own }) => [id, own]));
    this.dots.set(landmarks ? this.landmarks.map(({ position }) => ({ position, color, size: 9 })) : []);
  }

  setCoarse(stride) {
    this.surface?.setStride(stride);
    this.lines?.setCoarse(stride !== 1);
    if (this.seams) this.seams.visible = stride === 1;
  }

  setTheme(theme) {
    this.surface?.setTheme(theme);
  }

  clear() {
    if (!this.surface) return;
    release(this.seams);
    this.seams = null;
    this.lines.clear();
    this.lines = null;
    this.dots.dispose();
    this.name.hidden = true;
    this.surface.dispose();
    this.surface = null;
    this.bounds = null;
    this.viewport.stage.setSecond(null);
  }
}

// The body's surface: drawn, colored and picked.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshLambertMaterial, MeshStandardMaterial, Vector3 } from "three";
import { MeshBVH } from "three-mesh-bvh";
import { colorValues } from "../model/colors.js";
import { interpolate, locationOf, triangles } from "./grid.js";

export const CLAY = { light: "#d8cfc4", dark: "#b9b0a6" };

export class Surface {
  #tree = null;
  #field = null;

  constructor({ header, arrays }, { software }) {
    this.header = header;
    this.segments = header.segments;
    this.positions = arrays.positions.data;
    this.normals = arrays.normals.data;
    this.indices = {};
    this.geometry = new BufferGeometry();
    this.geometry.setAttribute("position", new BufferAttribute(this.positions, 3));
    this.geometry.setAttribute("normal", new BufferAttribute(this.normals, 3));
    // Lines lie on the surface; without the offset they sink into it in places.
    const settings = { side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    this.material = software
      ? new MeshLambertMaterial(settings)
      : new MeshStandardMaterial({ ...settings, roughness: 0.82, metalness: 0 });
    this.object = new Mesh(this.geometry, this.material);
    this.setStride(1);
    this.geometry.computeBoundingSphere();
  }

  /** Draw every `stride`-th vertex: the coarser lists are for frames while the view moves. */
  setStride(stride) {
    const whole = this.segments % stride === 0 ? stride : 1;
    this.indices[whole] ??= new BufferAttribute(this.#triangles(whole), 1);
    this.geometry.setIndex(this.indices[whole]);
  }

  #triangles(stride) {
    const { positions, normals, segments } = this;
    return triangles({ patches: this.header.patches, segments, stride, positions, normals });
  }

  setTheme(theme) {
    this.theme = theme;
    if (!this.#field) this.material.color.set(CLAY[theme]);
  }

  /** Color by a value a vertex, or plainly with null. */
  setField(field) {
    this.#field = field;
    if (field) {
      const colors = new Float32Array(this.positions.length);
      colorValues(field.values, field, colors);
      this.geometry.setAttribute("color", new BufferAttribute(colors, 3));
      this.material.color.set("#ffffff");
    } else {
      this.geometry.deleteAttribute("color");
      this.material.color.set(CLAY[this.theme]);
    }
    this.material.vertexColors = Boolean(field);
    this.material.needsUpdate = true;
  }

  get field() {
    return this.#field;
  }

  /** The tree for picking. It takes half a second, so it is asked for after the first picture. */
  prepare() {
    if (this.#tree) return;
    // A geometry of its own, never drawn: the drawn one changes its list while the view moves.
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.geometry.getAttribute("position"));
    geometry.setIndex(this.indices[1]);
    // Indirect, so that it does not sort the list: the numbers say where a hit is.
    this.#tree = new MeshBVH(geometry, { indirect: true });
  }

  /** Where a ray first meets the body: {location, point, distance}, or null. */
  pick(ray) {
    this.prepare();
    const hit = this.#tree.raycastFirst(ray, DoubleSide);
    if (!hit) return null;
    const { a, b, c } = hit.face;
    const weights = barycentric(hit.point, ...[a, b, c].map((vertex) => this.#vertex(vertex)));
    const [patch, u, v] = [a, b, c].reduce(
      (sum, vertex, n) => {
        const [number, x, y] = locationOf(vertex, this.segments);
        return [number, sum[1] + weights[n] * x, sum[2] + weights[n] * y];
      },
      [0, 0, 0],
    );
    const within = (value) => Math.min(1, Math.max(0, value));
    return { location: [patch, within(u), within(v)], point: hit.point.toArray(), distance: hit.distance };
  }

  #vertex(number) {
    return new Vector3().fromArray(this.positions, 3 * number);
  }

  position(location) {
    return interpolate(this.positions, location, this.segments);
  }

  normal(location) {
    const normal = interpolate(this.normals, location, this.segments);
    const size = Math.hypot(...normal) || 1;
    return normal.map((value) => value / size);
  }

  /** The value of the field at a location, or undefined. */
  value(location) {
    return this.#field && interpolate(this.#field.values, location, this.segments, 1)[0];
  }

  dispose() {
    this.geometry.dispose();
    this.material.dispose();
    this.#tree = null;
  }
}

function barycentric(point, a, b, c) {
  const [ab, ac, ap] = [b.clone().sub(a), c.clone().sub(a), point.clone().sub(a)];
  const [d00, d01, d11] = [ab.dot(ab), ab.dot(ac), ac.dot(ac)];
  const [d20, d21] = [ap.dot(ab), ap.dot(ac)];
  const scale = d00 * d11 - d01 * d01;
  // A triangle of a collapsed edge has no area; its first corner is as good as any.
  if (!(scale > 0)) return [1, 0, 0];
  const v = (d11 * d20 - d01 * d21) / scale;
  const w = (d00 * d21 - d01 * d20) / scale;
  return [1 - v - w, v, w];
}

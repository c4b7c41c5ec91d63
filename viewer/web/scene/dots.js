// Landmarks as round dots of a fixed size in pixels, hidden where the body is before them.
import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial } from "three";

const VERTEX = `
attribute vec3 color;
attribute float size;
uniform float ratio;
varying vec3 tint;
void main() {
  tint = color;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  // A little towards the viewer, since half of each dot lies inside the body.
  gl_Position.z -= 2e-3 * gl_Position.w;
  gl_PointSize = size * ratio;
}`;
const FRAGMENT = `
uniform vec3 rim;
varying vec3 tint;
void main() {
  float radius = 2.0 * length(gl_PointCoord - 0.5);
  if (radius > 1.0) discard;
  gl_FragColor = vec4(radius > 0.68 ? rim : tint, 1.0);
  #include <colorspace_fragment>
}`;

export class Dots {
  constructor() {
    this.material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ratio: { value: 1 }, rim: { value: new Color("#ffffff") } },
    });
    this.object = new Points(new BufferGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 4;
    this.object.visible = false;
  }

  /** Show dots: {position, color, size} each. */
  set(dots) {
    this.object.geometry.dispose();
    const geometry = new BufferGeometry();
    const positions = new Float32Array(dots.flatMap((dot) => dot.position));
    const colors = new Float32Array(dots.flatMap((dot) => new Color(dot.color).toArray()));
    const sizes = new Float32Array(dots.map((dot) => dot.size ?? 9));
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("color", new BufferAttribute(colors, 3));
    geometry.setAttribute("size", new BufferAttribute(sizes, 1));
    this.object.geometry = geometry;
    this.count = dots.length;
    this.object.visible = dots.length > 0;
  }

  dispose() {
    this.object.geometry.dispose();
    this.material.dispose();
  }
}

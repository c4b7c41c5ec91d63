// Lines on the body. What is measured is drawn in pixels of width, so that it stays crisp at every
// zoom; seams and nets, of which there are thousands, with the card's own thin lines.
import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

const TOWARDS_VIEWER = { polygonOffset: true, polygonOffsetFactor: -4, polygonOffsetUnits: -4 };

/** Points moved along their normals; both as flat arrays. */
export function lifted(points, normals, lift) {
  const result = new Float32Array(points);
  if (normals?.length === points.length) {
    for (let i = 0; i < result.length; i++) result[i] += lift * normals[i];
  }
  return result;
}

/** Ends of segments of several lines, (k, m, 3), one after the other. */
export function segmentsOf(points, lines, samples) {
  const result = new Float32Array(lines * (samples - 1) * 6);
  let at = 0;
  for (let line = 0; line < lines; line++) {
    for (let i = 0; i < samples - 1; i++) {
      const from = 3 * (line * samples + i);
      result.set(points.subarray(from, from + 6), at);
      at += 6;
    }
  }
  return result;
}

/** A fat line through points. */
export function fatLine(points, { color, width = 3, dashed = 0, through = false }) {
  const geometry = new LineGeometry().setPositions(points);
  const material = new LineMaterial({ color, linewidth: width, ...TOWARDS_VIEWER });
  const line = new Line2(geometry, material);
  if (dashed) {
    material.dashed = true;
    material.dashSize = dashed;
    material.gapSize = dashed * 0.8;
    line.computeLineDistances();
  }
  if (through) material.depthTest = false;
  line.renderOrder = through ? 3 : 2;
  return line;
}

/** Many fat segments as one object, with a color each when `colors` is given. */
export function fatSegments(segments, { color = "#ffffff", colors, width = 2 }) {
  const geometry = new LineSegmentsGeometry().setPositions(segments);
  if (colors) geometry.setColors(colors);
  const material = new LineMaterial({ color, linewidth: width, vertexColors: Boolean(colors), ...TOWARDS_VIEWER });
  const lines = new LineSegments2(geometry, material);
  lines.renderOrder = 1;
  return lines;
}

/** Many thin segments as one object. */
export function thinSegments(segments, { color = "#ffffff", colors, opacity = 1 }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(segments, 3));
  if (colors) geometry.setAttribute("color", new BufferAttribute(colors, 3));
  const settings = { color, opacity, transparent: opacity < 1, vertexColors: Boolean(colors) };
  const material = new LineBasicMaterial(settings);
  // The offset of polygons does nothing for lines, so these are brought forward in the shader.
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace(
      "#include <fog_vertex>",
      "#include <fog_vertex>\n  gl_Position.z -= 4e-4 * gl_Position.w;",
    );
  };
  return new LineSegments(geometry, material);
}

/** Give back what a drawn object holds on the card. */
export function release(object) {
  if (!object) return;
  object.removeFromParent();
  object.traverse((part) => {
    part.geometry?.dispose();
    part.material?.dispose();
  });
}

// Colors of values and of groups. The maps are those of the pictures in the reports, so that a
// color means the same in both.
import { Color, SRGBColorSpace } from "three";

const MAPS = {
  // viridis, from its pale to its dark end: large values stand out on a pale body.
  sequential: [
    "#d8e219", "#a5db36", "#6ece58", "#35b779", "#1f9e89", "#26828e", "#31688e", "#3e4989", "#482878", "#440154",
  ],
  // blue, pale, red; safe for color-blind readers.
  diverging: [
    "#2166ac", "#4393c3", "#92c5de", "#d1e5f0", "#f2efec", "#fddbc7", "#f4a582", "#d6604d", "#b2182b",
  ],
};

// Colors of groups of measurements: dark enough for thin lines on a pale body, bright enough on a
// dark page, and told apart by color-blind readers when neighbors.
const GROUPS = {
  light: ["#1f6fae", "#b3541e", "#2a7f4f", "#8a4fa3", "#a8385a", "#5f6b12", "#0f7f8c", "#7a5230", "#4b56b8", "#94443c"],
  dark: ["#2f8ad0", "#d0682c", "#2f9e63", "#a868c4", "#cc4f74", "#87961f", "#1b9fae", "#a5744a", "#6f7be0", "#c0604f"],
};

export const TAPE_COLOR = { light: "#0b5c8e", dark: "#0e6ea8" };
export const LIT_COLOR = { light: "#d9480f", dark: "#ff8f4d" };
export const LANDMARK_COLOR = "#2c3e50";
export const NO_LENGTH_COLOR = "#c2255c";

export function groupColor(number, theme) {
  const colors = GROUPS[theme] ?? GROUPS.light;
  return colors[number % colors.length];
}

const tables = new Map();
const STEPS = 256;

/** 256 colors of a map, in the linear space that the renderer computes in. */
function table(scale) {
  if (!tables.has(scale)) {
    const stops = (MAPS[scale] ?? MAPS.sequential).map((text) => new Color(text));
    const values = new Float32Array(STEPS * 3);
    const color = new Color();
    for (let i = 0; i < STEPS; i++) {
      const place = (i / (STEPS - 1)) * (stops.length - 1);
      const below = Math.min(Math.floor(place), stops.length - 2);
      // Mixed as the screen shows them, as the legend's gradient does.
      const [a, b] = [stops[below], stops[below + 1]].map((stop) => stop.clone().convertLinearToSRGB());
      color.copy(a).lerp(b, place - below);
      color.setRGB(color.r, color.g, color.b, SRGBColorSpace).toArray(values, 3 * i);
    }
    tables.set(scale, values);
  }
  return tables.get(scale);
}

/** Write the color of each value into `target` (three numbers a value); gray where there is none. */
export function colorValues(values, { low, high, scale }, target) {
  const colors = table(scale);
  const factor = (STEPS - 1) / (high - low || 1);
  for (let i = 0; i < values.length; i++) {
    const place = Math.round((values[i] - low) * factor);
    const step = 3 * Math.min(STEPS - 1, Math.max(0, place));
    const known = Number.isFinite(values[i]);
    for (let k = 0; k < 3; k++) target[3 * i + k] = known ? colors[step + k] : 0.35;
  }
}

/** The color of one value, as styles and the renderer take it. */
export function colorOf(value, field) {
  const target = new Float32Array(3);
  colorValues([value], field, target);
  return `#${new Color(...target).getHexString()}`;
}

/** Where a value stands on a scale: differences and errors span decades, so by their logarithm. */
export function toScale(key, value) {
  if (!Number.isFinite(value)) return NaN;
  return key === "length" || key === "proven" ? value : Math.log10(Math.max(Math.abs(value), 1e-16));
}

/** The scale of what stands on it, but for the outermost hundredths. */
export function scaleOf(key, places) {
  // What is proven or not has two colors, even where all of it is.
  if (key === "proven") return { key, low: 0, high: 1, scale: "sequential", empty: !places.some(Number.isFinite) };
  const known = places.filter(Number.isFinite).sort((a, b) => a - b);
  const at = (part) => known[Math.round(part * (known.length - 1))] ?? 0;
  return { key, low: at(0.01), high: at(0.99), scale: "sequential", empty: !known.length };
}

export function gradient(scale) {
  return `linear-gradient(to right, ${(MAPS[scale] ?? MAPS.sequential).join(", ")})`;
}

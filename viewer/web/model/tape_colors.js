// The colors of rows, the same in the list and in the scene: by group, or by a value of theirs.
import { colorOf, groupColor, scaleOf, TAPE_COLOR, toScale } from "./colors.js";

/** {scale, of(item)} for the rows as they are now; `scale` is null where groups have the colors. */
export function tapeColors(app, items = app.items) {
  const { theme } = app.settings;
  const key = app.settings.get("tapes");
  if (key === "group" || !items.length) {
    const groups = [...new Set(items.filter((item) => item.source === "chart").map((item) => item.group))];
    const of = (item) => (item.source === "tape" ? TAPE_COLOR[theme] : groupColor(groups.indexOf(item.group), theme));
    return { scale: null, of };
  }
  // Of the body beside, no tape is held against a mesh.
  const difference = (item) => (item.beside ? undefined : app.meshCheck.of(item));
  const value = (item) => ({ length: item.value, error: item.error, difference: difference(item) })[key];
  const place = (item) => (item.kind === "length" ? toScale(key, value(item) ?? NaN) : NaN);
  const scale = scaleOf(key, [...items, ...app.besideItems].map(place));
  return { scale, of: (item) => colorOf(place(item), scale) };
}

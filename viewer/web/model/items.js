// Rows of the list: the user's tapes and the chart's measurements in one shape.

export const MINE = "My tapes";

/** What a landmark's location is, for words: its name, or the patch that was clicked. */
export function placeWords(location, header) {
  if (typeof location === "string") return location;
  const [patch] = location;
  const name = header.patch_names?.[patch];
  const region = header.regions?.[header.patch_region?.[patch] ?? -1];
  return [region, name || `patch ${patch}`].filter(Boolean).join(", ");
}

/** What a scan leaves open counts as the error, where it is more than the computation's. */
function errorOf({ error_estimate: computed, uncertainty } = {}) {
  return Math.max(computed ?? 0, uncertainty ?? 0) || (computed ?? null);
}

/** A row for a tape of the user's. */
export function tapeItem(tape, result) {
  return {
    id: tape.id,
    source: "tape",
    name: tape.name,
    group: MINE,
    side: "",
    codes: {},
    kind: "length",
    value: result?.length ?? null,
    error: errorOf(result),
    computed: result?.error_estimate ?? null,
    uncertainty: result?.uncertainty ?? null,
    words: result?.error ?? result?.words ?? (result ? "" : "Measuring…"),
    failed: Boolean(result && (result.error || !Number.isFinite(result.length))),
    waiting: !result,
    visible: tape.visible,
    tape,
    result,
  };
}

/** Rows for a chart's measurements; `hidden` holds keys whose tapes are not drawn. */
export function chartItems(chart, hidden, other) {
  const others = new Map((other?.measurements ?? []).map((one) => [one.key, one]));
  return chart.measurements.map((one) => {
    const value = Number.isFinite(one.value) ? one.value : null;
    const second = others.get(one.key)?.value;
    return {
      id: `chart:${one.key}`,
      source: "chart",
      name: one.title,
      group: one.group || "Other",
      side: one.side ?? "",
      codes: one.codes ?? {},
      kind: one.kind ?? "length",
      value,
      error: errorOf({ error_estimate: one.error_estimate, uncertainty: one.input_uncertainty }),
      computed: one.error_estimate ?? null,
      uncertainty: one.input_uncertainty ?? null,
      words: one.reason ?? "",
      definition: one.definition ?? one.words ?? "",
      failed: value === null,
      waiting: false,
      visible: !hidden.has(one.key),
      difference: Number.isFinite(second) && value !== null ? second - value : null,
      other: Number.isFinite(second) ? second : null,
      landmarks: one.landmarks ?? [],
      measurement: one,
    };
  });
}

/** Whether a row has all the words that were typed, in its name, codes, group or landmarks. */
export function matches(item, words) {
  if (!words.length) return true;
  const codes = Object.values(item.codes).flat(2);
  const landmarks = item.landmarks ?? item.tape?.locations?.filter((one) => typeof one === "string") ?? [];
  const text = [item.name, item.group, item.side, ...codes, ...landmarks].join(" ").toLowerCase();
  return words.every((word) => text.includes(word));
}

/** The rows in the order that the list shows; without one, in groups as the chart has them. */
export function sorted(items, order) {
  if (!order) return items;
  const sign = order.down ? -1 : 1;
  const key = {
    name: (item) => item.name.toLowerCase(),
    value: (item) => item.value,
    error: (item) => item.error,
    difference: (item) => (item.difference === null || item.difference === undefined ? null : Math.abs(item.difference)),
  }[order.by];
  return [...items].sort((a, b) => {
    const [x, y] = [key(a), key(b)];
    // What has no value comes last either way.
    if (x === null || x === undefined) return y === null || y === undefined ? 0 : 1;
    if (y === null || y === undefined) return -1;
    return sign * (x < y ? -1 : x > y ? 1 : 0);
  });
}

// A page without a server: all that it shows stands in its own text.
import { decodeBase64, readBM1, unpacked } from "./bm1.js";
import { Failure } from "./failure.js";

const ALONE =
  "This page stands alone, without the program that measures. It shows what was measured when it was made.";

/** The transport of an exported page, or null where the page holds no data. */
export function embeddedTransport(place = document) {
  const element = place.getElementById("bodymeasure-data");
  if (!element) return null;
  const content = JSON.parse(element.textContent);
  const read = async (text) => readBM1(await unpacked(decodeBase64(text)));
  const refuse = async () => {
    throw new Failure(ALONE);
  };
  const layers = content.layers ?? {};
  return {
    options: content.options ?? {},
    layers: Object.keys(layers),
    can: { measure: false, chart: Boolean(content.chart), save: false, open: false, export: false },
    body: async () => read(content.body),
    layer: async (id, name) => (layers[name] ? read(layers[name]) : refuse()),
    quantity: refuse,
    path: refuse,
    girth: refuse,
    closed: refuse,
    mirror: refuse,
    point: refuse,
    chart: async () => (content.chart ? read(content.chart) : refuse()),
    exportFile: refuse,
    save: refuse,
    open: refuse,
    events: () => () => {},
  };
}

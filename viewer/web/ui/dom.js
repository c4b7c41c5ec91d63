// Elements without a framework. Text becomes text only: names come from files and may hold anything.

const SVG = "http://www.w3.org/2000/svg";

/** Make an element: attributes, `on...` listeners, and children that are elements or text. */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2).toLowerCase(), value);
    else if (name in PROPERTIES) element[name] = value;
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false));
  return element;
}

// A notebook may hold several viewers, each of which has loaded this program anew.
const own = Math.random().toString(36).slice(2, 10);
let last = 0;

/** An id that no other element of the page has. */
export function unique(name) {
  return `bm-${own}-${name}-${++last}`;
}

const PROPERTIES = { value: 1, checked: 1, indeterminate: 1 };

/** An icon of 20 by 20 from the `d` of its paths, drawn in the color of the text. */
export function icon(name) {
  const svg = document.createElementNS(SVG, "svg");
  for (const [key, value] of Object.entries({ viewBox: "0 0 20 20", class: "icon", "aria-hidden": "true" })) {
    svg.setAttribute(key, value);
  }
  for (const d of ICONS[name] ?? []) {
    const path = document.createElementNS(SVG, "path");
    path.setAttribute("d", d);
    svg.append(path);
  }
  return svg;
}

const ICONS = {
  look: ["M4 10a6 6 0 0 1 10.5-4M16 10a6 6 0 0 1-10.5 4", "M14.8 2.6V6.2H11.2", "M5.2 17.4V13.8H8.8"],
  tape: ["M3.5 15.5C8 15.5 6 5 10.5 5S13 9.5 16.5 4.5", "M3.5 13.6a1.9 1.9 0 1 0 .01 0", "M16.5 2.6a1.9 1.9 0 1 0 .01 0"],
  girth: ["M2.5 10c0-2 3.4-3.6 7.5-3.6s7.5 1.6 7.5 3.6-3.4 3.6-7.5 3.6-7.5-1.6-7.5-3.600z", "M10 13.600v-2M6 13v-1.800M14 13v-1.8"],
  loop: ["M10 3c4 0 6.5 3 6.5 7s-2.5 7-6.5 7-6.5-3-6.5-7 2.5-7 6.5-7z", "M10 1.500v3"],
  landmark: ["M10 2.500a5 5 0 0 1 5 5c0 3.5-5 10-5 10s-5-6.5-5-10a5 5 0 0 1 5-5z", "M10 5.800a1.7 1.7 0 1 0 .01 0"],
  undo: ["M7.5 4.5 4 8l3.5 3.5", "M4 8h7.500a4 4 0 0 1 0 8H8"],
  redo: ["M12.5 4.5 16 8l-3.5 3.5", "M16 8H8.500a4 4 0 0 0 0 8H12"],
  eye: ["M1.8 10s3-5.2 8.2-5.200S18.2 10 18.2 10s-3 5.2-8.2 5.200S1.8 10 1.8 10z", "M10 7.800a2.2 2.2 0 1 0 .01 0"],
  shut: ["M1.8 8.500s3 4.8 8.2 4.8 8.2-4.8 8.2-4.8", "M4 11.500l-1.3 1.800M10 13.300v2.300M16 11.500l1.3 1.8"],
  trash: ["M4 5.500h12M8 5.500V3.500h4v2M5.5 5.500l.7 11h7.600l.7-11"],
  copy: ["M7 7h9v9H7z", "M13 7V4H4v9h3"],
  sun: ["M10 6.500a3.5 3.5 0 1 0 .01 0", "M10 1.800v1.900M10 16.300v1.900M1.8 10h1.900M16.3 10h1.900M4.2 4.200l1.3 1.300M14.5 14.500l1.3 1.300M4.2 15.800l1.3-1.300M14.5 5.500l1.3-1.3"],
  moon: ["M16.5 11.800A7 7 0 0 1 8.2 3.500a7 7 0 1 0 8.3 8.300z"],
  help: ["M10 2.500a7.5 7.5 0 1 0 .01 0", "M7.8 8a2.2 2.2 0 1 1 3.2 2c-.7.4-1 .8-1 1.6", "M10 14.200v.1"],
  more: ["M3.5 5.5h13M3.5 10h13M3.5 14.5h13"],
  search: ["M9 3.500a5.5 5.5 0 1 0 .01 0", "M13 13l4 4"],
  close: ["M5 5l10 10M15 5 5 15"],
  frame: ["M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4"],
  cube: ["M10 2.5 16.5 6v8L10 17.5 3.5 14V6z", "M3.5 6 10 9.5 16.5 6M10 9.500v8"],
  pin: ["M10 2.500v15M2.5 10h15"],
  mirror: ["M10 2.500v15", "M7.5 6 3 14h4.500zM12.5 6l4.5 8h-4.500z"],
  plus: ["M10 4v12M4 10h12"],
  down: ["M5.5 8l4.5 4.500L14.5 8"],
  save: ["M10 3v9.500M6 9l4 4 4-4M3.5 16.500h13"],
};

/** A button with an icon, and a name for who does not see it. */
export function iconButton(name, label, onClick, more = {}) {
  const { keys, ...attributes } = more;
  return h(
    "button",
    {
      type: "button",
      class: "icon-button",
      "aria-label": label,
      title: keys ? `${label} (${keys})` : label,
      "aria-keyshortcuts": keys?.length === 1 ? keys : undefined,
      onClick,
      ...attributes,
    },
    icon(name),
  );
}

/** Offer a file for saving. */
export function download(name, content) {
  const blob = content instanceof Blob ? content : new Blob([content]);
  const link = h("a", { href: URL.createObjectURL(blob), download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

// How the user wants to see things. Kept for the tab, so that a reload changes nothing.

const KEPT = "bodymeasure-settings";

const STANDARD = {
  unit: "cm",
  theme: "auto",
  projection: "orthographic",
  layers: { seams: true, nets: false, diagonals: false, boundary: false, landmarks: true, names: false, tapes: true, labels: true },
  color: "none",
  lines: "length",
  tapes: "group",
  snap: true,
  via: false,
};

/** The tab's own memory; pages from files and notebooks may be refused it. */
export function memory() {
  try {
    return window.sessionStorage;
  } catch {
    return null;
  }
}

export class Settings {
  constructor(emitter, given = {}) {
    this.emitter = emitter;
    let kept = {};
    try {
      kept = JSON.parse(memory()?.getItem(KEPT) ?? "{}");
    } catch {
      // Whatever stands there is not ours; the standard serves.
    }
    const layers = { ...STANDARD.layers, ...given.layers, ...kept.layers };
    this.values = { ...STANDARD, ...given, ...kept, layers };
  }

  get(name) {
    return this.values[name];
  }

  set(name, value) {
    if (this.values[name] === value) return;
    this.values = { ...this.values, [name]: value };
    try {
      memory()?.setItem(KEPT, JSON.stringify(this.values));
    } catch {
      // A full memory costs the settings after a reload, nothing now.
    }
    this.emitter.emit("settings", name);
  }

  setLayer(name, shown) {
    this.set("layers", { ...this.values.layers, [name]: shown });
  }

  /** "light" or "dark", after the system's wish where none was chosen. */
  get theme() {
    if (this.values.theme !== "auto") return this.values.theme;
    return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  }
}

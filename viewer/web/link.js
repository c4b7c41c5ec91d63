// The view in the page's address, so that a reload, a bookmark and a link bring it back.

const PATTERN = /(?:^#|&)view=([^&]*)/;
const NUMBER = /^-?\d{1,4}(\.\d{1,6})?$/;

/** The view that the address holds: {theta, phi, height, target, projection}, or null. */
export function viewInLink() {
  const [projection, ...parts] = (PATTERN.exec(location.hash)?.[1] ?? "").split("_");
  if (!["orthographic", "perspective"].includes(projection)) return null;
  if (parts.length !== 6 || !parts.every((part) => NUMBER.test(part))) return null;
  const [theta, phi, height, ...target] = parts.map(Number);
  return height > 0 ? { projection, theta, phi, height, target } : null;
}

/** Write the view into the address whenever it rests. Returns how to stop. */
export function keepViewInLink(app, stage) {
  const show = () => {
    const wanted = viewInLink();
    if (!wanted) return;
    app.settings.set("projection", wanted.projection);
    stage.rig.view = wanted;
  };
  const write = () => {
    if (stage.moving || !app.header) return;
    const { theta, phi, height, target } = stage.rig.view;
    const numbers = [theta, phi, height, ...target].map((value) => value.toFixed(4));
    const rest = location.hash.replace(/^#/, "").split("&").filter((part) => part && !part.startsWith("view="));
    const hash = [...rest, `view=${[stage.rig.projection, ...numbers].join("_")}`].join("&");
    history.replaceState(null, "", `${location.pathname}${location.search}#${hash}`);
  };
  stage.onRest.push(write);
  addEventListener("hashchange", show);
  show();
  return () => removeEventListener("hashchange", show);
}

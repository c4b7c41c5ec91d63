// The keyboard. Letters work where nothing is typed; the scene's own keys where it has the focus.

const TOOLS = { v: "look", t: "tape", g: "girth", l: "loop", m: "landmark" };
const VIEWS = { 1: "front", 2: "back", 3: "left", 4: "right", 5: "top" };
const TURN = Math.PI / 24;
const STEP = 12;

export function keys(target, app, host, actions) {
  const crosshair = { x: 0.5, y: 0.5 };
  const element = host.querySelector(".crosshair");
  const place = () => {
    // Without a scene there is nothing to point at, and the list has the keys.
    if (!element) return;
    element.style.left = `${100 * crosshair.x}%`;
    element.style.top = `${100 * crosshair.y}%`;
  };
  place();

  const inScene = (event) => {
    const { rig } = actions;
    const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    const letters = { a: [-1, 0], d: [1, 0], w: [0, -1], s: [0, 1] }[event.key.toLowerCase()];
    const size = [host.clientWidth, host.clientHeight];
    if (arrows && event.shiftKey) rig?.pan(arrows[0] * 0.05, -arrows[1] * 0.05);
    else if (arrows) rig?.turn(arrows[0] * TURN, arrows[1] * TURN);
    else if (letters) {
      const step = event.shiftKey ? 1 : STEP;
      crosshair.x = Math.min(1, Math.max(0, crosshair.x + (letters[0] * step) / size[0]));
      crosshair.y = Math.min(1, Math.max(0, crosshair.y + (letters[1] * step) / size[1]));
      place();
      actions.hoverAt(crosshair.x * size[0], crosshair.y * size[1]);
    } else if (event.key === "Enter" || event.key === " ") {
      if (event.key === "Enter" && actions.finish()) return true;
      actions.pressAt(crosshair.x * size[0], crosshair.y * size[1], event.shiftKey);
    } else return false;
    return true;
  };

  const anywhere = (event) => {
    const key = event.key.toLowerCase();
    if (TOOLS[key] && !event.shiftKey) actions.use(TOOLS[key]);
    else if (VIEWS[event.key]) actions.view(VIEWS[event.key]);
    else if (event.key === "Home") actions.frameAll();
    else if (key === "f") actions.fly(app.selected);
    else if (key === "o") actions.projection();
    else if (key === "h") actions.hide();
    else if (event.key === "+" || event.key === "=") actions.rig?.zoom(1.2);
    else if (event.key === "-") actions.rig?.zoom(1 / 1.2);
    else if (event.key === "/") actions.search();
    else if (event.key === "?") actions.help();
    else if (event.key === "Escape") actions.escape();
    else if (event.key === "Enter") return actions.finish();
    else if (event.key === "Backspace") return actions.back();
    else if (event.key === "Delete") actions.remove(app.selected);
    else return false;
    return true;
  };

  const listener = (event) => {
    const typing = event.target.closest?.("input:not([type=checkbox]), textarea, select, [contenteditable]");
    if (typing || event.defaultPrevented) return;
    const key = event.key.toLowerCase();
    if ((event.ctrlKey || event.metaKey) && !event.altKey) {
      if (key === "z") event.shiftKey ? app.sheet.redo() : app.sheet.undo();
      else if (key === "y") app.sheet.redo();
      else return;
      event.preventDefault();
      return;
    }
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    // A focused button takes Enter and Space for itself.
    const onButton = event.target.closest?.("button, a, summary") && (event.key === "Enter" || event.key === " ");
    if (onButton) return;
    if ((element && event.target === host && inScene(event)) || anywhere(event)) event.preventDefault();
  };
  target.addEventListener("keydown", listener);
  return () => target.removeEventListener("keydown", listener);
}

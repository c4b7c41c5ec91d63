// A tape between two landmarks by their names: the same as two clicks, for who does not click.
import { addTape } from "../tools/tape_tool.js";
import { showDialog } from "./dialog.js";
import { h } from "./dom.js";

export function betweenLandmarks(app) {
  const names = app.landmarks.map((one) => one.name);
  if (names.length < 2) {
    app.emit("message", { text: "This body has fewer than two landmarks. Place some under Landmarks first.", tone: "note" });
    return;
  }
  const choice = (label, chosen) =>
    h("select", { "aria-label": label, "data-testid": `between-${label.toLowerCase()}` }, names.map((name, n) => h("option", { value: name, selected: n === chosen }, name)));
  const [from, to] = [choice("From", 0), choice("To", 1)];
  const measure = () => {
    dialog.close();
    if (from.value === to.value) app.emit("message", { text: "A tape needs two different landmarks.", tone: "note" });
    else addTape(app, { mode: "path", kind: "contact", title: "Tape", locations: [from.value, to.value] });
  };
  const dialog = showDialog(
    app.root,
    "Tape between landmarks",
    h(
      "div",
      { class: "form" },
      h("label", { class: "field" }, h("span", {}, "From"), from),
      h("label", { class: "field" }, h("span", {}, "To"), to),
      h("button", { type: "button", class: "button primary", "data-testid": "between-measure", onClick: measure }, "Measure"),
    ),
  );
}

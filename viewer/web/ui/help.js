// All keys and gestures on one page.
import { h } from "./dom.js";
import { showDialog } from "./dialog.js";

const SECTIONS = [
  ["Mouse and fingers", [
    ["Drag", "turn the body"],
    ["Right drag, or Shift and drag", "move it"],
    ["Wheel, or pinch", "zoom to the pointer"],
    ["Double click", "turn about that point"],
    ["Click, click", "a tape from here to there"],
    ["Shift-click", "a point on the way"],
    ["Alt", "no snapping while held"],
    ["Drag an end", "the tape follows"],
  ]],
  ["Tools", [["V", "look"], ["T", "tape"], ["G", "girth"], ["L", "closed loop"], ["M", "landmark"], ["Enter", "end a tape with points on the way"], ["Backspace", "take back the last point"], ["Esc", "leave what is half done"]]],
  ["View", [["1 2 3 4 5", "front, back, left, right, top"], ["Home", "show all"], ["F", "fly to what is selected"], ["O", "orthographic or perspective"], ["+ −", "zoom"], ["Arrows", "turn; with Shift move"], ["W A S D", "move the crosshair; Enter clicks there"]]],
  ["List", [["/", "search"], ["↑ ↓", "next row"], ["Enter", "select and fly there"], ["Space", "show or hide"], ["H", "hide what is selected"], ["Delete", "delete a tape"], ["Ctrl Z, Ctrl Shift Z", "undo, redo"], ["?", "this page"]]],
];

export function showHelp(root) {
  showDialog(
    root,
    "Keys and help",
    h(
      "div",
      { class: "help" },
      SECTIONS.map(([title, rows]) => h("section", {}, h("h3", {}, title), h("dl", {}, rows.map(([keys, what]) => [h("dt", {}, h("kbd", {}, keys)), h("dd", {}, what)])))),
    ),
  );
}

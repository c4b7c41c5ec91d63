// A small menu below a button, gone when anything else is pressed.
import { h } from "./dom.js";

/** Show entries [label, action, more?]; null makes a line. */
export function showMenu(button, entries) {
  const root = button.closest(".bm");
  const items = entries.map((entry) =>
    entry
      ? h("button", { type: "button", role: "menuitem", tabindex: "-1", "data-testid": entry[2], onClick: () => { close(); entry[1](); } }, entry[0])
      : h("hr"),
  );
  const menu = h("div", { class: "menu", role: "menu", "aria-label": button.getAttribute("aria-label") }, items);
  const buttons = items.filter((item) => item.tagName === "BUTTON");
  const close = () => {
    menu.remove();
    document.removeEventListener("pointerdown", outside, true);
    button.setAttribute("aria-expanded", "false");
    button.focus();
  };
  const outside = (event) => {
    if (!menu.contains(event.target)) close();
  };
  menu.addEventListener("keydown", (event) => {
    event.stopPropagation();
    const at = buttons.indexOf(document.activeElement);
    if (event.key === "Escape" || event.key === "Tab") close();
    else if (event.key === "ArrowDown") buttons[(at + 1) % buttons.length].focus();
    else if (event.key === "ArrowUp") buttons[(at - 1 + buttons.length) % buttons.length].focus();
    else return;
    event.preventDefault();
  });
  root.append(menu);
  const [frame, place] = [root.getBoundingClientRect(), button.getBoundingClientRect()];
  const right = Math.max(8, frame.right - place.right);
  menu.style.right = `${right}px`;
  // Upwards where there is no room below.
  if (place.bottom + menu.offsetHeight + 8 > frame.bottom) menu.style.bottom = `${frame.bottom - place.top + 4}px`;
  else menu.style.top = `${place.bottom - frame.top + 4}px`;
  button.setAttribute("aria-expanded", "true");
  document.addEventListener("pointerdown", outside, true);
  buttons[0]?.focus();
}

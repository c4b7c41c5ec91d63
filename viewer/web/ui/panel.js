// The panel at the side: three pages of it under tabs.
import { h, unique } from "./dom.js";

/** Make the tabs; `pages` is [[key, label, element]]. Returns how to show one. */
export function panel(place, pages) {
  const tabs = pages.map(([key, label, element], n) => {
    const id = unique(`tab-${key}`);
    element.id = unique(`page-${key}`);
    element.setAttribute("role", "tabpanel");
    element.setAttribute("aria-labelledby", id);
    return h(
      "button",
      { type: "button", role: "tab", id, "aria-controls": element.id, "data-testid": `tab-${key}`, onClick: () => show(n) },
      label,
    );
  });
  const show = (chosen) => {
    tabs.forEach((tab, n) => {
      tab.setAttribute("aria-selected", String(n === chosen));
      tab.tabIndex = n === chosen ? 0 : -1;
      pages[n][2].hidden = n !== chosen;
    });
  };
  const list = h("div", { class: "tabs", role: "tablist", "aria-label": "Panel" }, tabs);
  list.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const next = (tabs.indexOf(document.activeElement) + step + tabs.length) % tabs.length;
    show(next);
    tabs[next].focus();
  });
  place.append(list, ...pages.map(([, , element]) => element));
  show(0);
  return (key) => show(pages.findIndex(([name]) => name === key));
}

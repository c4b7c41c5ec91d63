// The list of tapes and measurements: searched, sorted, and one with the scene.
import { matches, sorted } from "../model/items.js";
import { tapeColors } from "../model/tape_colors.js";
import { formatErrorOf, formatLength, formatValue } from "../model/units.js";
import { h, icon, iconButton } from "./dom.js";

export function list(app, actions) {
  let order = null;
  let words = [];
  let current = null;
  const search = h("input", {
    type: "search",
    placeholder: "Search name, code, landmark",
    "aria-label": "Search measurements",
    "data-testid": "search",
    onInput: () => {
      words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
      draw();
    },
  });
  search.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      search.value = "";
      search.dispatchEvent(new Event("input"));
      search.blur();
    }
    event.stopPropagation();
  });
  const count = h("p", { class: "count", "data-testid": "count", "aria-live": "polite" });
  const table = h("table", { class: "list", "data-testid": "list" });
  const scroll = h("div", { class: "scroll" }, table);
  const empty = h("div", { class: "empty" });
  const element = h("section", { class: "page measurements" }, h("div", { class: "search" }, icon("search"), search), count, scroll, empty);

  const head = () => {
    const columns = [
      ["name", "Name"],
      ["value", "Value"],
      app.otherChart ? ["difference", "Differs"] : ["error", "Error"],
    ];
    return h(
      "thead",
      {},
      h(
        "tr",
        {},
        h("th", { class: "eye", scope: "col" }, h("span", { class: "hidden" }, "Shown")),
        columns.map(([by, label]) => {
          const sort = order?.by === by ? (order.down ? "descending" : "ascending") : "none";
          const button = h("button", { type: "button", "data-testid": `sort-${by}`, onClick: () => turn(by) }, label, h("span", { class: "arrow", "aria-hidden": "true" }, { ascending: " ↑", descending: " ↓", none: "" }[sort]));
          return h("th", { class: by === "name" ? "" : "number", scope: "col", "aria-sort": sort }, button);
        }),
      ),
    );
  };

  /** Up, down, and back to the groups. */
  const turn = (by) => {
    if (order?.by !== by) order = { by, down: by !== "name" };
    else if (order.down === (by !== "name")) order = { by, down: !order.down };
    else order = null;
    draw();
  };

  const row = (item, color) => {
    const eye = iconButton(item.visible ? "eye" : "shut", `${item.visible ? "Hide" : "Show"} ${item.name}`, (event) => {
      event.stopPropagation();
      app.show([item], !item.visible);
    }, { "aria-pressed": String(item.visible), tabindex: "-1" });
    const third = app.otherChart
      ? item.difference === null || item.difference === undefined ? "" : signed(item, app.unit)
      : item.failed || item.waiting || item.error === null ? "" : formatErrorOf(item, item.error, app.unit);
    const name = h("button", { type: "button", class: "row-name", tabindex: item.id === current ? "0" : "-1", "data-row": item.id, title: item.name }, swatch(color), h("span", {}, item.name));
    const value = item.waiting ? "…" : item.failed ? "no length" : formatValue(item, app.unit);
    const tr = h(
      "tr",
      { "data-id": item.id, "data-testid": `row-${item.id}`, class: [item.failed ? "failed" : "", item.visible ? "" : "off"].join(" ") },
      h("td", { class: "eye" }, eye),
      h("th", { scope: "row" }, name, item.side && !item.name.includes(item.side) ? h("span", { class: "side" }, item.side) : ""),
      h("td", { class: "number value", title: item.words }, value),
      h("td", { class: "number soft" }, third),
    );
    tr.addEventListener("pointerenter", () => app.light(item.id));
    tr.addEventListener("pointerleave", () => app.light(null));
    name.addEventListener("focus", () => app.light(item.id));
    name.addEventListener("blur", () => app.light(null));
    tr.addEventListener("click", (event) => {
      // Numbers can be marked and copied without anything flying away.
      if (String(getSelection())) return;
      if (event.target.closest(".eye")) return;
      current = item.id;
      app.select(item.id, { fly: true });
    });
    return tr;
  };

  const draw = () => {
    const focused = document.activeElement?.dataset?.row;
    const items = app.items.filter((item) => matches(item, words));
    const groups = [...new Set(app.items.map((item) => item.group))];
    const { of: color } = tapeColors(app);
    if (!items.some((item) => item.id === current)) current = items[0]?.id ?? null;
    const bodies = order
      ? [h("tbody", {}, sorted(items, order).map((item) => row(item, color(item))))]
      : groups.map((group) => {
          const members = items.filter((item) => item.group === group);
          if (!members.length) return null;
          const all = members.every((item) => item.visible);
          const eye = iconButton(all ? "eye" : "shut", `${all ? "Hide" : "Show"} all of ${group}`, () => app.show(members, !all), { "aria-pressed": String(all) });
          return h("tbody", {}, h("tr", { class: "group" }, h("td", { class: "eye" }, eye), h("th", { colspan: "3", scope: "rowgroup" }, h("div", {}, h("span", {}, group), h("span", { class: "number-of" }, String(members.length))))), members.map((item) => row(item, color(item))));
        });
    table.replaceChildren(h("caption", { class: "hidden" }, "Tapes and measurements"), head(), ...bodies.filter(Boolean));
    scroll.hidden = !app.items.length;
    const total = app.items.length;
    count.textContent = !total ? "" : words.length ? `${items.length} of ${total} found` : "";
    count.hidden = !count.textContent;
    empty.replaceChildren(...actions.invitation());
    mark();
    if (focused) table.querySelector(`[data-row="${CSS.escape(focused)}"]`)?.focus();
  };

  const mark = () => {
    for (const tr of table.querySelectorAll("tr[data-id]")) {
      tr.classList.toggle("lit", tr.dataset.id === app.lit);
      const chosen = tr.dataset.id === app.selected;
      tr.classList.toggle("selected", chosen);
      if (chosen) tr.setAttribute("aria-current", "true");
      else tr.removeAttribute("aria-current");
    }
  };

  table.addEventListener("keydown", (event) => {
    const rows = [...table.querySelectorAll("tr[data-id] .row-name")];
    const at = rows.indexOf(document.activeElement);
    if (at < 0) return;
    const item = app.item(document.activeElement.dataset.row);
    const go = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: rows.length - 1 }[event.key];
    if (go !== undefined) {
      rows[at].tabIndex = -1;
      const next = rows[Math.max(0, Math.min(rows.length - 1, go))];
      next.tabIndex = 0;
      current = next.dataset.row;
      next.focus();
    } else if (event.key === " ") app.show([item], !item.visible);
    else if (event.key === "Delete" && item.source === "tape") actions.remove(item.id);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });

  for (const name of ["sheet", "results", "chart", "body", "settings"]) app.on(name, draw);
  app.on("lit", mark);
  app.on("selection", () => {
    mark();
    const tr = table.querySelector("tr.selected");
    tr?.scrollIntoView({ block: "nearest" });
  });
  return { element, focusSearch: () => search.focus() };
}

function swatch(color) {
  const element = h("span", { class: "swatch", "aria-hidden": "true" });
  element.style.background = color;
  return element;
}

function signed(item, unit) {
  const sign = item.difference < 0 ? "−" : "+";
  if (item.kind === "angle") return `${sign}${Math.abs(item.difference).toFixed(1)}°`;
  return `${sign}${formatLength(Math.abs(item.difference), unit)}`;
}

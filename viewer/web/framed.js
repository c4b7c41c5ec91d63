// Within another page, such as a chart: that page says what is to be seen here. It may only choose
// among what this page holds.

/** Show what the page around this one asks for, and tell it once all of it is here. */
export function listenToFrame(app, actions) {
  addEventListener("message", ({ source, data }) => {
    if (source !== window.parent || data?.bodymeasure !== "show") return;
    if (typeof data.key === "string") {
      const item = app.items.find(({ measurement }) => measurement?.key === data.key);
      if (!item) return;
      app.show([item], true);
      app.select(item.id, { fly: true });
    } else if (Number.isInteger(data.patch)) actions.flyToPatch(data.patch);
  });
  let told = false;
  const tell = () => {
    if (told || (app.transport.can.chart && !app.chart)) return;
    told = true;
    window.parent.postMessage({ bodymeasure: "ready" }, "*");
  };
  app.on("chart", tell);
  tell();
}

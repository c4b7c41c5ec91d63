// Landmarks: those that the body has, those that its chart lacks, and saving them.
import { otherSide } from "../tools/workbench.js";
import { download, h, iconButton, unique } from "./dom.js";
import { showMenu } from "./menu.js";

export function landmarksPanel(app, workbench, actions) {
  const own = h("ul", { class: "landmarks", "data-testid": "landmarks" });
  const lacking = h("ul", { class: "landmarks lacking", "data-testid": "lacking" });
  const lackingHead = h("h2", {}, "Lacking for the chart");
  const lackingWords = h("p", { class: "soft small" }, "Choose one, then click where it is. The next one follows by itself.");
  const editor = h("div", { class: "editor" });
  const save = h("button", { type: "button", class: "button", "data-testid": "save-landmarks", "aria-haspopup": "menu", onClick: () => showMenu(save, saving(app)) }, "Save landmarks…");
  const add = h("button", { type: "button", class: "button", "data-testid": "add-landmark", onClick: () => { workbench.tools.landmark.target = null; actions.use("landmark"); } }, "Add by clicking");
  const names = h("datalist", { id: unique("lacking-names") });
  // Without a scene there is nothing to click.
  const foot = h("div", { class: "foot" }, app.transport.can.measure && workbench ? add : "", app.transport.can.save ? save : "");
  const element = h("section", { class: "page" }, h("div", { class: "scroll pad" }, h("h2", {}, "On this body"), own, lackingHead, lackingWords, lacking, names), editor, foot);

  const draw = () => {
    if (!app.header) return;
    own.replaceChildren(...app.landmarks.map((one) => entry(one)));
    if (!app.landmarks.length) own.append(h("li", { class: "soft small" }, "None yet."));
    const rest = app.lacking;
    lackingHead.hidden = lackingWords.hidden = lacking.hidden = !rest.length || !app.transport.can.measure || !workbench;
    lacking.replaceChildren(...rest.map((one) => lackingEntry(one)));
    names.replaceChildren(...rest.map((one) => h("option", { value: one.name })));
    save.disabled = !app.landmarks.length;
    drawEditor();
  };

  const entry = (landmark) => {
    const button = h("button", { type: "button", class: "landmark", "aria-pressed": String(landmark.name === workbench?.landmark), title: `${landmark.name}: fly there`, onClick: () => {
      app.emit("landmark", landmark.name);
      actions.flyTo(landmark);
    } }, h("span", { class: landmark.edited ? "dot edited" : "dot", "aria-hidden": "true" }), h("span", {}, landmark.name));
    return h("li", {}, button, landmark.edited ? h("span", { class: "soft small" }, "changed") : landmark.origin && landmark.origin !== "file" ? h("span", { class: "soft small" }, landmark.origin) : "");
  };

  const lackingEntry = ({ name, text }) =>
    h(
      "li",
      {},
      h("button", { type: "button", class: "landmark", title: text, "data-testid": `place-${name}`, "aria-pressed": String(workbench?.tools.landmark.target === name), onClick: () => {
        actions.use("landmark");
        workbench.tools.landmark.target = name;
        app.emit("tool", "landmark");
        draw();
      } }, h("span", { class: "dot none", "aria-hidden": "true" }), h("span", {}, name)),
      h("p", { class: "soft small" }, text),
    );

  const drawEditor = () => {
    const landmark = app.landmarks.find((one) => one.name === workbench?.landmark);
    editor.hidden = !landmark || !app.transport.can.measure;
    if (editor.hidden || editor.contains(document.activeElement) && document.activeElement.tagName === "INPUT") return;
    const name = h("input", { class: "name", value: landmark.name, list: names.id, "aria-label": "Name of the landmark", "data-testid": "landmark-name", maxlength: "100" });
    name.addEventListener("change", () => rename(landmark, name.value.trim()));
    name.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key === "Escape") name.value = landmark.name;
      if (event.key === "Escape" || event.key === "Enter") name.blur();
    });
    const other = otherSide(landmark.name);
    editor.replaceChildren(
      h("div", { class: "details-head" }, name, iconButton("trash", `Remove ${landmark.name}`, () => remove(landmark), { "data-testid": "remove-landmark" }), iconButton("close", "Close", () => app.emit("landmark", null))),
      h("p", { class: "soft small" }, "Drag it on the body to move it."),
      other ? h("button", { type: "button", class: "button", "data-testid": "mirror", onClick: () => workbench.mirror(landmark.name) }, `Mirror to the ${other}`) : "",
    );
  };

  const rename = (landmark, name) => {
    if (!name || name === landmark.name) return;
    if (app.landmarks.some((one) => one.name === name)) {
      app.emit("message", { text: `There is a landmark ${name} already. Choose another name, or remove that one first.`, tone: "bad" });
      return;
    }
    const { [landmark.name]: _, ...rest } = app.sheet.landmarks;
    // A landmark of the file is taken off by its old name; one that was clicked just has a new one.
    const inFile = app.header.landmarks.some((one) => one.name === landmark.name);
    const gone = inFile ? { [landmark.name]: null } : {};
    app.sheet.renameLandmark(landmark.name, name, { ...rest, ...gone, [name]: { location: landmark.location, position: landmark.position } });
    app.emit("landmark", name);
  };

  const remove = (landmark) => {
    const { [landmark.name]: _, ...rest } = app.sheet.landmarks;
    const inFile = app.header.landmarks.some((one) => one.name === landmark.name);
    app.sheet.removeLandmark(landmark.name, landmark.location, inFile ? { ...rest, [landmark.name]: null } : rest);
    app.emit("landmark", null);
  };

  for (const name of ["body", "sheet", "tool"]) app.on(name, draw);
  app.on("landmark", (name) => {
    draw();
    if (name) actions.showPage("landmarks");
  });
  app.on("name-landmark", () => {
    const field = editor.querySelector("input");
    field?.focus();
    field?.select();
  });
  return element;
}

function saving(app) {
  const save = (to) => () =>
    app.try(async () => {
      const { bodyId } = app;
      const saved = app.landmarkChanges ?? {};
      const answer = await app.transport.save(bodyId, { landmarks: saved, to });
      if (answer.saved) {
        if (app.bodyId === bodyId) await app.reopen({ saved });
        app.say(`Saved the landmarks in ${answer.saved}.`);
      } else {
        download(answer.name, answer.content);
        app.say(`Saved as ${answer.name}.`);
      }
    });
  return [
    ["As a file of picks", save("picks"), "save-picks"],
    ["In a copy of the atlas", save("atlas"), "save-atlas"],
    ...(app.header.can?.save_atlas ? [[`In ${app.header.file.split(/[\\/]/).pop()} itself`, save("file"), "save-file"]] : []),
  ];
}

// What tests and scripts may ask of a page: when it is ready, where a point of the body is on the
// screen, and what it holds.

import { Vector3 } from "three";

export function testing(app, viewport, workbench, options) {
  const handle = {
    ready: false,
    /** Where a point of the body is, in pixels of the page; null where it cannot be clicked,
     * unless hidden places count, too. */
    project(patch, u, v, { hidden = false } = {}) {
      const point = viewport.surface.position([patch, u, v]);
      const { x, y } = viewport.stage.project(point);
      const { left, top, right, bottom } = viewport.stage.canvas.getBoundingClientRect();
      const place = [left + x, top + y];
      if (hidden) return place;
      const outside = place[0] < left || place[0] > right || place[1] < top || place[1] > bottom;
      if (outside || viewport.hidden(point)) return null;
      // Buttons lie over the scene in places; what moves with the body does not count.
      const over = document.elementFromPoint(...place);
      return over === viewport.stage.canvas || over?.closest(".labels, .handles") ? place : null;
    },
    /** How much the body faces the viewer there: 1 fully, 0 at its outline, less on its far side. */
    facing(patch, u, v) {
      const normal = new Vector3(...viewport.surface.normal([patch, u, v]));
      const { position } = viewport.stage.rig.camera;
      const { target } = viewport.stage.rig.controls;
      return normal.dot(position.clone().sub(target).normalize());
    },
    state() {
      const { app: current, ...rest } = stateOf(app, viewport, workbench);
      return { ...current, ...rest };
    },
  };
  if (options.alone) window.bodymeasure = handle;
  app.testing = handle;
  app.on("body", () => {
    const finish = () => {
      handle.ready = true;
      // For who waits by selectors, since the page's policy allows no evaluation of texts.
      app.root.dataset.ready = "true";
    };
    if (!viewport) finish();
    else {
      const { afterFrame } = viewport.stage;
      const once = () => {
        afterFrame.splice(afterFrame.indexOf(once), 1);
        finish();
      };
      afterFrame.push(once);
    }
  });
}

function stateOf(app, viewport, workbench) {
  const stage = viewport?.stage;
  return {
    body: app.header?.name ?? null,
    id: app.bodyId,
    patches: app.header?.patches ?? 0,
    tapes: app.sheet.tapes.map((tape) => ({ ...tape, result: app.sheet.result(tape) ?? null })),
    landmarks: app.landmarks,
    selected: app.selected,
    lit: app.lit,
    tool: workbench?.tool.name ?? null,
    pending: workbench?.tool.points?.length ?? 0,
    busy: app.measuring.busy,
    chart: app.chart?.header.measurements.length ?? 0,
    view: stage?.rig.view ?? null,
    projection: stage?.rig.projection ?? null,
    frames: stage?.frames ?? 0,
    moving: stage?.moving ?? false,
    coarse: stage?.coarse ?? false,
    software: stage?.software ?? null,
    ratio: stage?.renderer.getPixelRatio() ?? null,
    triangles: stage?.renderer.info.render.triangles ?? 0,
    geometries: stage?.renderer.info.memory.geometries ?? 0,
    lines: viewport?.lines.ids ?? [],
    side: Boolean(stage?.second),
    second: viewport?.second.surface ? { lines: viewport.second.lines.ids, landmarks: viewport.second.dots.count, colors: viewport.second.colors } : null,
  };
}

// What the browser can draw with. Asked on a canvas of its own, since the real one must be made with
// the right settings at once.

/** "none", "software" (drawn by the processor) or "hardware". */
export function graphics() {
  const canvas = document.createElement("canvas");
  let context = null;
  try {
    context = canvas.getContext("webgl2");
  } catch {
    return "none";
  }
  if (!context) return "none";
  const debug = context.getExtension("WEBGL_debug_renderer_info");
  const name = debug ? String(context.getParameter(debug.UNMASKED_RENDERER_WEBGL)) : "";
  // Browsers allow few contexts at a time, so this one is given back.
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software/i.test(name) ? "software" : "hardware";
}

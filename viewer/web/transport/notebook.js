// Requests of the notebook's widget: messages to the kernel, told apart by a number. Large answers
// come as the message's buffers, since JSON would triple them.
import { readBM1 } from "./bm1.js";
import { Failure, KERNEL_GONE, KERNEL_SILENT } from "./failure.js";

// A kernel that is at another cell answers late; after so long, in milliseconds, the page says so.
const SILENCE = 15_000;
// By these the notebook tells that a kernel was restarted or has ended.
const ENDED = ["comm:close", "comm_live_update"];

/** The transport over an anywidget model. */
export function notebookTransport(model) {
  const waiting = new Map();
  let last = 0;
  let tell = () => {};
  let timer = 0;
  let silent = false;
  const watch = () => {
    clearTimeout(timer);
    if (!waiting.size) return;
    timer = setTimeout(() => {
      silent = true;
      tell({ silent: KERNEL_SILENT });
    }, SILENCE);
  };
  const ended = () => {
    for (const { reject } of waiting.values()) reject(new Failure(KERNEL_GONE, { gone: true }));
    waiting.clear();
    watch();
    tell({ silent: KERNEL_GONE });
  };
  for (const name of ENDED) model.on(name, ended);
  const receive = (message, buffers) => {
    const { resolve, reject } = waiting.get(message?.id) ?? {};
    if (!resolve) return;
    waiting.delete(message.id);
    watch();
    if (silent) tell({ silent: null });
    silent = false;
    if (message.error) reject(new Failure(message.error, { status: message.status ?? 422 }));
    else resolve({ message, buffers: buffers ?? [] });
  };
  model.on("msg:custom", receive);

  // The request itself is what the server takes, too, with its own name in `request`.
  const ask = (kind, request) =>
    new Promise((resolve, reject) => {
      const id = ++last;
      waiting.set(id, { resolve, reject });
      watch();
      try {
        model.send({ id, request: { request: kind, ...request } });
      } catch {
        ended();
      }
    });
  // Buffers arrive as views or as plain buffers, and at any offset; the arrays want their own.
  const bytes = (buffer) =>
    buffer instanceof ArrayBuffer
      ? buffer
      : buffer.buffer.slice(buffer.byteOffset, buffer.byteOffset + buffer.byteLength);
  const binary = async (kind, request) => {
    const { buffers } = await ask(kind, request);
    return readBM1(bytes(buffers[0]));
  };
  const object = async (kind, request) => (await ask(kind, request)).message.answer;
  const file = async (kind, request) => {
    const { message, buffers } = await ask(kind, request);
    // Landmarks that were saved into the body's own file are no file to download.
    if (message.answer) return message.answer;
    return { name: message.name, content: new Blob([bytes(buffers[0])]) };
  };
  const options = model.get("options") ?? {};
  return {
    options,
    can: { measure: true, chart: true, save: true, open: false, export: true, ...options.can },
    body: (body) => binary("body", { body }),
    layer: (body, name, compare) => binary("layer", { body, name, ...(compare ? { compare } : {}) }),
    quantity: (body, key, other) => binary("quantity", { body, key, ...(other ? { other } : {}) }),
    path: (body, request) => object("path", { body, ...request }),
    girth: (body, request) => object("girth", { body, ...request }),
    closed: (body, request) => object("closed", { body, ...request }),
    mesh: (body, tapes) => object("mesh", { body, tapes }),
    mirror: (body, location) => object("mirror", { body, location }),
    point: (body, location) => object("point", { body, location }),
    chart: (body, set, landmarks) => binary("chart", { body, set, landmarks }),
    exportFile: (body, request) => file("export", { body, ...request }),
    save: (body, request) => file("landmarks", { body, ...request }),
    open: async () => {
      throw new Failure("In a notebook, open another body with bm.show(path).");
    },
    events: (listener) => {
      tell = listener;
      return () => (tell = () => {});
    },
    end: () => {
      clearTimeout(timer);
      model.off("msg:custom", receive);
      for (const name of ENDED) model.off(name, ended);
    },
  };
}

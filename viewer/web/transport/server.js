// Requests to the server by fetch. Every request carries the token, which came in the fragment of
// the page's address and is never sent as part of one.
import { readBM1 } from "./bm1.js";
import { Failure, GONE, NOT_ALLOWED } from "./failure.js";

const KEPT = "bodymeasure-token";
// Pauses between attempts to reach a server that is gone, in milliseconds.
const PAUSES = [300, 600, 1200, 2500, 5000];
// The server says something every three seconds; one that is silent for so long has stopped, or the
// network is gone, which no connection tells by itself.
const SILENCE = 10_000;

/** Take the token out of the address, so that it lands in no bookmark and on no screenshot. */
function takeToken() {
  const match = /(?:^#|&)token=([^&]+)/.exec(location.hash);
  if (match) {
    sessionStorage.setItem(KEPT, match[1]);
    const rest = location.hash.slice(1).split("&").filter((part) => part && !part.startsWith("token="));
    history.replaceState(null, "", location.pathname + location.search + (rest.length ? `#${rest.join("&")}` : ""));
  }
  return sessionStorage.getItem(KEPT) ?? "";
}

export function serverTransport() {
  const token = takeToken();
  // The link of a program that was started again, opened in this tab, changes the fragment only.
  window.addEventListener("hashchange", () => {
    if (takeToken() !== token) location.reload();
  });
  // A tab is who asks: the newest request of a tab overtakes its older ones.
  const tab = crypto.getRandomValues(new Uint32Array(2)).join("-");

  // What is asked and not answered, so that nobody waits for ever for a server that has stopped.
  const open = new Set();
  const hangUp = () => open.forEach((one) => one.abort());

  async function ask(path, { body, json, headers = {}, signal } = {}) {
    const own = new AbortController();
    const options = { headers: { "X-Token": token, ...headers }, cache: "no-store", signal: signal ?? own.signal };
    if (!signal) open.add(own);
    if (json !== undefined) {
      options.body = JSON.stringify(json);
      options.headers["Content-Type"] = "application/json";
      options.method = "POST";
    } else if (body !== undefined) {
      options.body = body;
      options.method = "POST";
    }
    let answer;
    try {
      answer = await fetch(path, options);
    } catch (error) {
      if (signal?.aborted) throw error;
      throw new Failure(GONE, { gone: true });
    } finally {
      open.delete(own);
    }
    if (answer.ok) return answer;
    const { error: sentence, wants } = await answer.json().catch(() => ({}));
    const standard = answer.status === 403 ? NOT_ALLOWED : `The program answered ${answer.status}.`;
    throw new Failure(sentence || standard, { status: answer.status, wants });
  }
  const binary = async (...request) => {
    try {
      return readBM1(await (await ask(...request)).arrayBuffer());
    } catch (error) {
      // The connection can break within an answer as well.
      throw error instanceof Failure ? error : new Failure(GONE, { gone: true });
    }
  };
  const object = async (...request) => (await ask(...request)).json();
  const file = async (...request) => {
    const answer = await ask(...request);
    const name = decodeURIComponent(answer.headers.get("X-Filename") ?? "bodymeasure.txt");
    return { name, content: await answer.blob() };
  };
  const of = (id, more = "") => `?body=${encodeURIComponent(id ?? "0")}${more}`;
  const other = (id) => (id === undefined ? "" : `&other=${encodeURIComponent(id)}`);

  return {
    can: { measure: true, chart: true, save: true, open: true, export: true, stop: true },
    body: (id) => binary(`api/body${of(id)}`),
    layer: (id, name, compare) =>
      binary(`api/layer${of(id, `&name=${encodeURIComponent(name)}${compare ? "&compare=true" : ""}&tab=${tab}`)}`),
    quantity: (id, key, against) =>
      binary(`api/quantity${of(id, `&key=${encodeURIComponent(key)}${other(against)}`)}`),
    path: (id, request) => object(`api/path${of(id)}`, { json: { tab, ...request } }),
    girth: (id, request) => object(`api/girth${of(id)}`, { json: { tab, ...request } }),
    closed: (id, request) => object(`api/closed${of(id)}`, { json: { tab, ...request } }),
    mirror: (id, location) => object(`api/mirror${of(id)}`, { json: { location } }),
    point: (id, location) => object(`api/point${of(id)}`, { json: { location } }),
    chart: (id, set, landmarks) => binary(`api/chart${of(id)}`, { json: { set, landmarks, tab } }),
    mesh: (id, tapes) => object(`api/mesh${of(id)}`, { json: { tapes, tab } }),
    stop: () => object("api/stop", { json: { tab } }),
    exportFile: (id, request) => file(`api/export${of(id)}`, { json: { tab, ...request } }),
    save: async (id, request) => {
      const answer = await ask(`api/landmarks${of(id)}`, { json: request });
      if ((answer.headers.get("Content-Type") ?? "").includes("application/json")) {
        const content = await answer.clone().json();
        if (content.saved) return content;
      }
      const name = decodeURIComponent(answer.headers.get("X-Filename") ?? "landmarks.json");
      return { name, content: await answer.blob() };
    },
    open: (dropped, unit) =>
      object("api/open", {
        body: dropped,
        headers: {
          "X-Name": encodeURIComponent(dropped.name),
          ...(unit ? { "X-Unit": unit } : {}),
        },
      }),
    // How far another tab's chart is concerns that tab alone.
    events: (listener) =>
      listen(ask, hangUp, (news) => (!news.progress?.tab || news.progress.tab === tab) && listener(news)),
  };
}

/** Read the server's ticks and news, and connect again after it was gone. Returns how to stop. */
function listen(ask, hangUp, listener) {
  let stopped = false;
  let attempt = 0;
  let trying = new AbortController();
  let timer = 0;
  const heard = () => {
    clearTimeout(timer);
    timer = setTimeout(() => trying.abort(), SILENCE);
  };
  const once = async () => {
    trying = new AbortController();
    heard();
    try {
      const answer = await ask("api/events", { signal: trying.signal });
      await readLines(answer.body, (news) => {
        attempt = 0;
        listener(news);
      }, heard);
    } catch (error) {
      if (error instanceof Failure && error.status === 403) return error.message;
    } finally {
      clearTimeout(timer);
    }
    return null;
  };
  (async () => {
    while (!stopped) {
      const refused = await once();
      if (stopped) return;
      if (refused) {
        listener({ refused });
        return;
      }
      listener({ connected: false });
      hangUp();
      const pause = PAUSES[Math.min(attempt++, PAUSES.length - 1)];
      await new Promise((resolve) => setTimeout(resolve, pause));
    }
  })();
  return () => {
    stopped = true;
    trying.abort();
  };
}

async function readLines(stream, listener, heard) {
  const reader = stream.pipeThrough(new TextDecoderStream()).getReader();
  let rest = "";
  for (;;) {
    const { value, done } = await reader.read();
    heard();
    if (done) return;
    const lines = (rest + value).split("\n");
    rest = lines.pop();
    for (const line of lines) if (line.trim()) listener(JSON.parse(line));
  }
}

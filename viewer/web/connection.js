// Whether the program that measures is there, and the news it sends.
import { GONE } from "./transport/failure.js";

const CLOSED = "This body is not open any more in the program that measures. Drop its file on the page again.";

export function connection(app) {
  let lost = false;
  const gone = (text) => {
    lost = true;
    app.emit("lasting", ["gone", text]);
  };
  app.on("gone", gone);
  /** The program is there; it may have been started again, over another body. */
  const meet = async (bodies) => {
    const again = lost;
    lost = false;
    app.emit("lasting", ["gone", null]);
    if (again) app.say("Connected again.");
    const { header, bodyId } = app;
    if (!header) return;
    app.emit("lasting", ["closed", bodyId in bodies ? null : CLOSED]);
    if (!(bodyId in bodies)) return;
    if (bodies[bodyId] !== header.mark) {
      await app.reopen();
      app.say("The program has this body in another form now, and the page shows that one.");
    }
    // What was asked while nobody answered is asked now.
    if (again) app.measuring.askAgain();
  };
  app.on("body", () => app.emit("lasting", ["closed", null]));
  return app.transport.events((news) => {
    if (news.connected === false) gone(GONE);
    else if (news.refused) app.emit("lasting", ["gone", news.refused]);
    // A notebook's kernel that is at another cell, or has ended.
    else if ("silent" in news) app.emit("lasting", ["gone", news.silent]);
    if (news.bodies) app.try(() => meet(news.bodies));
    if (news.progress) app.tellProgress(news.progress);
    if (news.worker) {
      app.emit("message", { text: "The measuring process had to be started anew. What was under way is asked again.", tone: "note" });
      app.measuring.askAgain();
    }
    if (news.error) app.emit("message", { text: news.error, tone: "bad" });
    if (news.changed && app.other?.header.id === "0") app.emit("otherchanged");
    // The file that is looked after is that of the first body.
    if (news.changed && app.bodyId === "0") {
      app.try(async () => {
        await app.reopen();
        app.say("The file changed and was read again.");
      });
    }
  });
}

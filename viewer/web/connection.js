// Whether the program that measures is there, and the news it sends.
import { GONE } from "./transport/failure.js";

export function connection(app) {
  let lost = false;
  const gone = (text) => {
    lost = true;
    app.emit("lasting", ["gone", text]);
  };
  app.on("gone", gone);
  return app.transport.events((news) => {
    if (news.connected === false) gone(GONE);
    else if (news.refused) app.emit("lasting", ["gone", news.refused]);
    else if (news.connected && lost) {
      lost = false;
      app.emit("lasting", ["gone", null]);
      app.say("Connected again.");
      // What was asked while nobody answered is asked now.
      app.measuring.askAgain();
    }
    if (news.progress) app.emit("progress", news.progress.done >= news.progress.total ? null : news.progress);
    if (news.worker) {
      app.emit("message", { text: "The measuring process had to be started anew. What was under way is asked again.", tone: "note" });
      app.measuring.askAgain();
    }
    if (news.error) app.emit("message", { text: news.error, tone: "bad" });
    // The file that is looked after is that of the first body.
    if (news.changed && app.bodyId === "0") {
      app.try(async () => {
        await app.reopen();
        app.say("The file changed and was read again.");
      });
    }
  });
}

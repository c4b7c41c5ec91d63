// What goes wrong between the page and the program that measures, as sentences.

/** An answer that is a sentence for the user; `gone` says that nobody answered at all. */
export class Failure extends Error {
  constructor(sentence, { gone = false, status = 0 } = {}) {
    super(sentence);
    this.name = "Failure";
    this.gone = gone;
    this.status = status;
  }
}

export const GONE =
  "The program that measures does not answer. Your tapes are kept. Start it again at the same --port and open its new link in this tab; if it only paused, or BODYMEASURE_VIEW_TOKEN is set for it, this page connects again by itself.";
export const NOT_ALLOWED =
  "This page may not talk to the program that measures. Open it with the link that bodymeasure view printed.";

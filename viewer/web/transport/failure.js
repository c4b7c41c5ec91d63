// What goes wrong between the page and the program that measures, as sentences.

/**
 * An answer that is a sentence for the user; `gone` says that nobody answered at all, and `wants`
 * what is lacking that the user may know.
 */
export class Failure extends Error {
  constructor(sentence, { gone = false, status = 0, wants = "" } = {}) {
    super(sentence);
    this.name = "Failure";
    this.gone = gone;
    this.status = status;
    this.wants = wants;
  }
}

export const GONE =
  "The program that measures does not answer. Your tapes are kept. Start it again at the same --port and open its new link in this tab; if it only paused, or BODYMEASURE_VIEW_TOKEN is set for it, this page connects again by itself.";
export const KERNEL_GONE =
  "The notebook's kernel has ended, so that nothing can be measured in this cell. Your tapes are kept; run the cell again.";
export const KERNEL_SILENT =
  "The notebook's kernel does not answer. It is at another cell, and answers when that has ended, or it has ended itself; then run this cell again.";
export const NOT_ALLOWED =
  "This page may not talk to the program that measures. Open it with the link that bodymeasure view printed.";

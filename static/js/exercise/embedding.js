/**
 * An exercise in the frame of a SCORM package: what was typed comes from there, drafts and verdicts go there.
 *
 * The package says hello by answering "ready"; from then on messages go to its origin alone. Nothing is told that the
 * page that frames us could not ask the service for itself.
 *
 * @typedef {{points: number, max_points: number, complete: boolean, receipt: string | null, state: unknown}} Told
 */

const SUBJECT = "framewise.";

/** Whether the address says that a package frames this page. */
export function isPackaged() {
  return window.parent !== window && new URLSearchParams(location.search).get("embed") === "scorm";
}

export class PackageFrame {
  /** @type {string | null} */
  #origin = null;
  #pending = /** @type {Record<string, unknown>[]} */ ([]);

  /** @param {(state: any) => void} restore takes back what was typed on an earlier visit */
  constructor(restore) {
    window.addEventListener("message", (event) => {
      if (event.source !== window.parent || event.data?.subject !== `${SUBJECT}restore`) return;
      this.#origin = event.origin;
      if (event.data.state) restore(event.data.state);
      for (const message of this.#pending.splice(0)) this.#send(message);
    });
    window.parent.postMessage({ subject: `${SUBJECT}ready` }, "*");
  }

  /** @param {unknown} state */
  draft(state) {
    this.#send({ subject: `${SUBJECT}draft`, state });
  }

  /** @param {Told} told */
  verdict(told) {
    this.#send({ subject: `${SUBJECT}verdict`, ...told });
  }

  /** @param {Record<string, unknown>} message */
  #send(message) {
    if (this.#origin === null || this.#origin === "null") this.#pending.push(message);
    else window.parent.postMessage(message, this.#origin);
  }
}

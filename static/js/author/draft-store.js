/**
 * The draft in the browser: plain data with undo, kept with every change, and as text for a link.
 *
 * @typedef {{id: string, definition: Record<string, any>, statements: Record<string, string>}} Draft as the API takes it
 * @typedef {{draft: Draft | null, source: any}} Work the draft, and from what it was started, to go on drawing
 * @typedef {(string | number)[]} Path of a value inside the draft
 */

import { keep, recall } from "../storage.js";
import { UndoHistory } from "../undo.js";

/** Where the browser keeps the draft. */
export const KEPT = "author";
/** Compressed, a draft has some three thousand characters; what is far longer is no draft. */
const LONGEST_LINK = 200_000;

export class DraftStore extends EventTarget {
  #history = new UndoHistory(/** @type {Work} */ ({ draft: null, source: null }));

  get draft() {
    return this.#history.state.draft;
  }

  get source() {
    return this.#history.state.source;
  }

  get canUndo() {
    return this.#history.canUndo;
  }

  get canRedo() {
    return this.#history.canRedo;
  }

  /** What stands at a place of the draft. @param {Path} path @returns {any} */
  at(path) {
    return path.reduce((/** @type {any} */ node, step) => node?.[step], this.draft);
  }

  /** Puts a value at a place; undefined takes it away. Typing in one field is one step. @param {Path} path @param {unknown} value */
  set(path, value) {
    if (!this.draft || JSON.stringify(this.at(path)) === JSON.stringify(value)) return;
    this.#history.change({ draft: put(this.draft, path, value), source: this.source }, path.join("/"));
    this.#tell(false);
  }

  /** Takes a whole draft, or another robot for it. @param {Draft} draft @param {any} source @param {string} [tag] */
  load(draft, source, tag = "") {
    this.#history.change({ draft, source }, tag);
    this.#tell(true);
  }

  undo() {
    if (this.#history.undo()) this.#tell(true);
  }

  redo() {
    if (this.#history.redo()) this.#tell(true);
  }

  /** What was here last. */
  restore() {
    const work = workOf(recall(KEPT, null));
    if (work) {
      this.#history = new UndoHistory(work);
      this.#tell(true);
    }
    return Boolean(work);
  }

  /** Takes the draft that another tab has kept, as a step that can be taken back. */
  takeKept() {
    const work = workOf(recall(KEPT, null));
    if (work?.draft) this.load(work.draft, work.source);
  }

  /** @param {boolean} whole whether fields have to be filled anew */
  #tell(whole) {
    keep(KEPT, this.#history.state);
    this.dispatchEvent(new CustomEvent("draft", { detail: { whole } }));
  }
}

/** @param {any} node @param {Path} path @param {unknown} value @returns {any} */
function put(node, [step, ...rest], value) {
  const inner = rest.length ? put(node?.[step], rest, value) : value;
  if (Array.isArray(node)) return node.map((entry, i) => (i === step ? inner : entry));
  if (node === undefined && inner === undefined) return undefined;
  const next = { ...node, [step]: inner };
  if (inner === undefined) delete next[step];
  return rest.length && !Object.keys(next).length ? undefined : next;
}

/** Work from data that anybody may have written; what it means is for the API to judge. @param {any} data @returns {Work | null} */
function workOf(data) {
  const draft = data?.draft;
  const isTable = (/** @type {any} */ node) => typeof node === "object" && node !== null && !Array.isArray(node);
  if (!isTable(draft) || typeof draft.id !== "string") return null;
  if (!isTable(draft.definition) || !isTable(draft.statements)) return null;
  if (!Object.values(draft.statements).every((text) => typeof text === "string")) return null;
  return { draft, source: isTable(data.source) ? data.source : null };
}

/** The page's address with the draft in it. @param {string} address @param {Work} work */
export async function linkTo(address, { draft, source }) {
  const bytes = await through(
    new CompressionStream("deflate"),
    new TextEncoder().encode(JSON.stringify({ draft, source })),
  );
  const text = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  const url = new URL(address);
  url.hash = `draft=${text.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
  return url.href;
}

/** What an address's fragment holds, or null. @param {string} fragment @returns {Promise<Work | null>} */
export async function workIn(fragment) {
  const match = /^#draft=([\w-]+)$/.exec(fragment);
  if (!match || match[1].length > LONGEST_LINK) return null;
  try {
    const text = atob(match[1].replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(text, (character) => character.charCodeAt(0));
    return workOf(JSON.parse(new TextDecoder().decode(await through(new DecompressionStream("deflate"), bytes))));
  } catch {
    return null;
  }
}

/** @param {any} stream @param {Uint8Array} bytes */
async function through(stream, bytes) {
  const writer = stream.writable.getWriter();
  writer.write(bytes).catch(() => undefined);
  writer.close().catch(() => undefined);
  return new Uint8Array(await new Response(stream.readable).arrayBuffer());
}

/** Undo and redo of what is replaced as a whole and never changed; typing in one place is one step. */

const MOST_STEPS = 200;

/**
 * What keys pressed together ask for, if that is a step. On a keyboard of other letters, such as a Cyrillic one, the keys
 * where Latin ones have Z and Y mean the same, as in the browser's own fields.
 * @param {KeyboardEvent} event @returns {"undo" | "redo" | null}
 */
export function stepAsked({ key, code, ctrlKey, metaKey, altKey, shiftKey }) {
  if (!(ctrlKey || metaKey) || altKey) return null;
  const letter = /^[a-z]$/i.test(key) ? key.toLowerCase() : code.replace("Key", "").toLowerCase();
  if (letter === "y" || (letter === "z" && shiftKey)) return "redo";
  return letter === "z" ? "undo" : null;
}

/** @template State */
export class UndoHistory {
  /** @type {State[]} */
  #past = [];
  /** @type {State[]} */
  #future = [];
  #tag = "";

  /** @param {State} state */
  constructor(state) {
    this.state = state;
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** @param {State} state @param {string} [tag] steps with the same tag, one after another, are one step */
  change(state, tag = "") {
    if (state === this.state) return;
    if (!tag || tag !== this.#tag) {
      this.#past.push(this.state);
      if (this.#past.length > MOST_STEPS) this.#past.shift();
    }
    this.state = state;
    this.#tag = tag;
    this.#future = [];
  }

  /** Ends a run of typing. */
  settle() {
    this.#tag = "";
  }

  /** Returns whether there was a step to undo. */
  undo() {
    return this.#step(this.#past, this.#future);
  }

  /** Returns whether there was a step to redo. */
  redo() {
    return this.#step(this.#future, this.#past);
  }

  /** @param {State[]} from @param {State[]} to */
  #step(from, to) {
    if (!from.length) return false;
    to.push(this.state);
    this.state = /** @type {State} */ (from.pop());
    this.#tag = "";
    return true;
  }
}

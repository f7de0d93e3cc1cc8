/**
 * Where drafts live: the browser's storage, or memory where a frame or a private window forbids it.
 * What is kept in memory goes along to other pages of the tool through the address (see `carried`).
 */

const PREFIX = "framewise:";

/** @type {Map<string, string>} */
const memory = new Map();

/** @returns {Storage | null} */
function browserStorage() {
  try {
    const storage = window.localStorage;
    storage.setItem(`${PREFIX}probe`, "1");
    storage.removeItem(`${PREFIX}probe`);
    return storage;
  } catch {
    return null;
  }
}

const storage = typeof window === "undefined" ? null : browserStorage();

const TOLD = "told-that-nothing-lasts";
let tell = () => {};

/** Calls back once, when something can be kept in memory only. @param {() => void} listener */
export function whenNothingLasts(listener) {
  tell = () => {
    if (memory.has(TOLD)) return;
    memory.set(TOLD, "true");
    listener();
  };
}

/**
 * @template T
 * @param {string} key @param {T} otherwise
 * @returns {T}
 */
export function recall(key, otherwise) {
  const text = memory.get(key) ?? storage?.getItem(PREFIX + key);
  if (text === undefined || text === null) return otherwise;
  try {
    return JSON.parse(text);
  } catch {
    return otherwise;
  }
}

/** Keeps a value, at the least as long as the page is open; null forgets it. @param {string} key @param {unknown} value */
export function keep(key, value) {
  if (value === null) {
    memory.delete(key);
    storage?.removeItem(PREFIX + key);
    return;
  }
  const text = JSON.stringify(value);
  try {
    if (storage === null) throw new Error("no storage");
    storage.setItem(PREFIX + key, text);
    memory.delete(key);
  } catch {
    memory.set(key, text);
    tell();
  }
}

/**
 * Calls back when another tab of this browser keeps something else at a key.
 * @param {string} key @param {(value: any) => void} listener
 */
export function whenKeptElsewhere(key, listener) {
  window.addEventListener("storage", (event) => {
    if (event.key === PREFIX + key && event.newValue !== null) listener(recall(key, null));
  });
}

/** Keeps a value as long as the page is open, and for the pages that `carried` leads to. @param {string} key @param {string} value */
export function keepInMemory(key, value) {
  memory.set(key, JSON.stringify(value));
}

/** What only memory holds, as an address's fragment. @param {string} place the place on the other page that is gone to, or none */
export function carried(place = "") {
  if (memory.size === 0) return place && `#${place}`;
  return `#kept=${encodeURIComponent(JSON.stringify([...memory]))}${place && `&${place}`}`;
}

/**
 * Takes back what `carried` put into the address, and clears it there, readable or not. An address that somebody else
 * has made would sign its reader in as whoever made it: only a page of the tool may have led here (in a frame without an
 * origin no page is known by name).
 * @param {string} root the tool's own address
 */
export function takeCarried(root) {
  const match = /^#kept=([^&]*)(?:&(.*))?$/.exec(location.hash);
  if (!match) return;
  history.replaceState(history.state, "", location.pathname + location.search);
  if (match[2]) location.replace(`#${match[2]}`);
  if (window.origin !== "null" && !document.referrer.startsWith(root)) return;
  try {
    for (const [key, text] of JSON.parse(decodeURIComponent(match[1]))) memory.set(key, text);
  } catch {
    // an address that was cut off holds nothing that could be taken back
  }
}

/** Calls to the service: JSON in, JSON out, problems as errors, and never an answer out of order. */

/**
 * @typedef {{code: string, pointer: string, detail: string, params: Record<string, unknown>}} Fault
 *   one thing that is wrong: stable code, JSON pointer into the request, sentence in the reader's language
 */

/** An answer that says what is wrong (RFC 9457). */
export class Problem extends Error {
  /**
   * @param {number} status @param {Record<string, any>} body @param {string} [arrival] ticket of an answer to be sent again
   * @param {number} [wait] seconds after which the service asks to be called again
   */
  constructor(status, body, arrival = "", wait = 0) {
    super(body.detail || body.title || `HTTP ${status}`);
    this.name = "Problem";
    this.status = status;
    this.code = body.code || "";
    this.body = body;
    this.arrival = arrival;
    this.wait = wait;
    /** @type {Fault[]} */
    this.faults = body.errors?.length
      ? body.errors
      : [{ code: this.code, pointer: "", detail: this.message, params: {} }];
  }

  /** Whether it is not what was asked that is wrong: the service cannot answer now, or something before it has answered. */
  get passing() {
    return isPassing(this.status) || !this.code;
  }
}

/** @param {number} status */
export function isPassing(status) {
  return status >= 500 || status === TOO_MANY;
}

/** The service could not be reached. */
class Unreachable extends Error {
  /** @param {unknown} cause */
  constructor(cause) {
    super("unreachable", { cause });
    this.name = "Unreachable";
  }
}

const BUSY = 503;
const TOO_MANY = 429;
/** The field of a ticket that says when an answer came which could not be taken just then. */
const ARRIVAL = "Framewise-Arrival";
/** Seconds that a page waits by itself for an answer to what somebody did. */
const LONGEST_WAIT = 10;
/** Seconds before what draws itself is asked for again: at first, and at most. */
const FIRST_PAUSE = 2;
const LONGEST_PAUSE = 60;

/** Seconds that an answer asks callers to wait. @param {Response} answer */
export function waitOf({ headers }) {
  return Number(headers.get("Retry-After")) || 0;
}

/**
 * Milliseconds before a call that failed is made again: never less than the service asked for, longer with each
 * failure, and not the same for every page that was refused at once.
 * @param {number} failures how often it failed, from 1 @param {number} [wait] seconds that the service asked for
 */
export function pauseAfter(failures, wait = 0) {
  const grown = Math.min(FIRST_PAUSE * 2 ** (failures - 1), LONGEST_PAUSE);
  return spread(Math.max(wait, grown));
}

/** Seconds as milliseconds, up to half as many again. @param {number} seconds */
function spread(seconds) {
  return 1000 * seconds * (1 + Math.random() / 2);
}

export class Api {
  /** @param {string} base address of the API, with a slash at its end @param {string} language */
  constructor(base, language) {
    this.base = base;
    this.language = language;
    /** Token of a session, sent with every call; never a cookie. */
    this.token = "";
    /** Signed settings of the link that the page was opened by; its cookie may be blocked in a frame. */
    this.context = "";
    /** How often a call is made again by itself where the service was busy, after the time that it asked for. */
    this.patience = 0;
  }

  /** @param {string} path @param {{signal?: AbortSignal}} [options] @returns {Promise<any>} */
  get(path, options) {
    return this.#send("GET", path, undefined, options);
  }

  /**
   * @param {string} path @param {unknown} body @param {{signal?: AbortSignal, key?: string, arrival?: string, patience?: number}} [options]
   *   `key` makes a repeated call the call that it repeats (Idempotency-Key); `arrival` says since when it is tried
   * @returns {Promise<any>}
   */
  post(path, body, options) {
    return this.#send("POST", path, body, options);
  }

  /** A file that stands at a path, or is made of a body. @param {string} path @param {unknown} [body] @returns {Promise<Blob>} */
  file(path, body) {
    return this.#send(body === undefined ? "GET" : "POST", path, body, { file: true });
  }

  /** @param {string} path @param {unknown} body */
  put(path, body) {
    return this.#send("PUT", path, body);
  }

  /** @param {string} path */
  remove(path) {
    return this.#send("DELETE", path, undefined);
  }

  /** Address of something that is loaded by the browser itself, such as a figure. @param {string} path */
  address(path) {
    return `${this.base}${path}`;
  }

  /**
   * @param {string} method @param {string} path @param {unknown} body @param {{signal?: AbortSignal, key?: string, arrival?: string, patience?: number, file?: boolean}} [options]
   * @returns {Promise<any>}
   */
  async #send(method, path, body, { signal, key, arrival = "", patience = this.patience, file = false } = {}) {
    /** @type {Record<string, string>} */
    const headers = { Accept: file ? "*/*" : "application/json", "Accept-Language": this.language };
    if (body !== undefined) headers["Content-Type"] = "application/json";
    if (key) headers["Idempotency-Key"] = key;
    if (arrival) headers[ARRIVAL] = arrival;
    if (this.context) headers["X-Framewise-Context"] = this.context;
    if (this.token) headers.Authorization = `Bearer ${this.token}`;
    const content = body === undefined ? undefined : JSON.stringify(body);
    let answer, text;
    try {
      for (let left = patience; ; left -= 1) {
        answer = await fetch(this.base + path, { method, headers, signal, body: content, credentials: "omit" });
        const seconds = waitOf(answer);
        const ticket = answer.headers.get(ARRIVAL);
        if (ticket) headers[ARRIVAL] = ticket;
        if (answer.status !== BUSY || left <= 0 || !seconds) break;
        await new Promise((resolve) => setTimeout(resolve, spread(Math.min(seconds, LONGEST_WAIT))));
        signal?.throwIfAborted();
      }
      if (file && answer.ok) return await answer.blob();
      text = await answer.text();
    } catch (error) {
      if (error instanceof Error && error.name === "AbortError") throw error;
      throw new Unreachable(error);
    }
    let json = {};
    try {
      json = text ? JSON.parse(text) : {};
    } catch (error) {
      if (answer.ok) throw new Unreachable(error);
    }
    if (!answer.ok) throw new Problem(answer.status, json, headers[ARRIVAL], waitOf(answer));
    return json;
  }
}

/**
 * Runs only the latest of a series of calls: a new one aborts the one under way, and an answer that was
 * overtaken is dropped, whatever order answers arrive in.
 */
export class Latest {
  #number = 0;
  /** @type {AbortController | null} */
  #controller = null;

  /**
   * @template T
   * @param {(signal: AbortSignal) => Promise<T>} call
   * @returns {Promise<{value: T} | null>} the answer, or null if a later call was made in the meantime
   */
  async run(call) {
    this.cancel();
    const number = this.#number;
    this.#controller = new AbortController();
    try {
      const value = await call(this.#controller.signal);
      return number === this.#number ? { value } : null;
    } catch (error) {
      if (number !== this.#number) return null;
      throw error;
    }
  }

  /** Drops the call under way. */
  cancel() {
    this.#number += 1;
    this.#controller?.abort();
    this.#controller = null;
  }
}

/**
 * Runs calls one after another, and of those that come while one is under way only the last: while a slider
 * is dragged, answers keep coming and the final one is for the final value. An error counts if it is the last call's.
 */
export class Throttled {
  /** @type {(() => Promise<void>) | null} */
  #next = null;
  #running = false;

  /** @param {number} pause milliseconds between the end of one call and the start of the next */
  constructor(pause) {
    this.pause = pause;
  }

  /** @param {() => Promise<void>} call */
  async run(call) {
    this.#next = call;
    if (this.#running) return;
    this.#running = true;
    try {
      while (this.#next) {
        const current = this.#next;
        this.#next = null;
        try {
          await current();
        } catch (error) {
          if (!this.#next) throw error;
        }
        if (this.#next) await new Promise((resolve) => setTimeout(resolve, this.pause));
      }
    } finally {
      this.#running = false;
    }
  }
}

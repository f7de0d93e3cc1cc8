/**
 * Somebody who came from a course. The launch leaves a code in the address's fragment, which is exchanged once
 * for a token. The token is sent with every call; no cookie says who somebody is.
 */

import { Problem } from "../api.js";
import { el } from "../dom.js";
import { ownDirection, t } from "../i18n.js";
import { forgetFragment, pageAddress } from "../page.js";
import { problemNotice } from "../problem.js";
import { carried, keepInMemory, recall } from "../storage.js";

const KEPT = "framewise:session";
const TAKEN_ALONG = "session";
const RENEWED_EVERY = 20 * 60 * 1000;

let held = "";

/** The token, where a reload of this tab finds it; a blocked storage costs the reload, but not the way to other pages. */
const tab = {
  get() {
    try {
      return held || (sessionStorage.getItem(KEPT) ?? "");
    } catch {
      return held || recall(TAKEN_ALONG, "");
    }
  },
  /** @param {string} token */
  set(token) {
    held = token;
    try {
      sessionStorage.setItem(KEPT, token);
    } catch {
      keepInMemory(TAKEN_ALONG, token);
    }
  },
};

/**
 * The session of this page, or null if nobody is signed in.
 * @param {import("../api.js").Api} api @param {() => void} [ended] called if somebody was, and is no longer; a reload says so again
 * @returns {Promise<any>}
 */
export async function openSession(api, ended = () => {}) {
  await exchangeCode(api);
  api.token = tab.get();
  if (!api.token) return null;
  try {
    const told = await api.get("session");
    setInterval(() => document.visibilityState === "visible" && api.get("session").catch(() => null), RENEWED_EVERY);
    return told;
  } catch (error) {
    if (!isRefused(error)) throw error;
    api.token = "";
    ended();
    return null;
  }
}

/**
 * Exchanges the code in the address for a token. A code that the service could not be asked about stays in the address, for
 * another try; one that has been used takes the token's place, so that a reload says that nobody is signed in any longer.
 * @param {import("../api.js").Api} api
 */
async function exchangeCode(api) {
  const code = new URLSearchParams(location.hash.slice(1)).get("session");
  if (!code) return;
  try {
    tab.set((await api.post("session/open", { code })).token);
  } catch (error) {
    if (isRefused(error)) {
      if (!tab.get()) tab.set(code);
      forgetFragment("session");
    }
    throw error;
  }
  forgetFragment("session");
}

/** Whether the service does not know who somebody is: to ask it once more would change nothing. @param {unknown} error */
export function isRefused(error) {
  return error instanceof Problem && error.status === 401;
}

/** Goes to what is asked in the course now, with the student's values. @param {any} told what the service says of the session */
export function openAsked({ exercise, seed }) {
  const address = new URL(pageAddress(`exercises/${exercise}`));
  if (seed) address.searchParams.set("seed", seed);
  location.replace(address.href + carried());
}

/** What a page says that could not be opened. @param {unknown} error */
export function notOpened(error) {
  return problemNotice(error, isRefused(error) ? {} : { retry: () => location.reload() });
}

/** Who is signed in, and where. @param {any} told what the service says of the session */
export function signedIn({ person, course }) {
  const name = ownDirection(person.name ?? person.key.slice(0, 8));
  return t("session-signed-in", { name, course: ownDirection(course.title) });
}

/** What is said where nothing may be shown yet. @param {any} options */
export function receiptView({ attempt }) {
  return el("p", { role: "status", text: t("session-received", { attempt }) });
}

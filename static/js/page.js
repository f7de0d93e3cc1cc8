/** What every page starts with: addresses, messages, the language switch. */

import { Api } from "./api.js";
import { announce, el } from "./dom.js";
import { language, loadMessages, t } from "./i18n.js";
import { carried, takeCarried, whenKeptElsewhere, whenNothingLasts } from "./storage.js";

const { root: relativeRoot, messages, page: pageName, assets: relativeAssets } = document.documentElement.dataset;

/** Address of the service's root, ending in a slash. */
export const root = new URL(relativeRoot || "./", location.href).href;

/** Address of the folder that this version's files stand in, without a slash at its end. */
export const assets = new URL(relativeAssets || "./static/dev", location.href).href;

export const api = new Api(`${root}api/v1/`, language);
api.context = linkContext();

/**
 * The signed settings of the link by which somebody came to this tab, also on the pages that they go on to; a launch from a
 * course ends them.
 */
function linkContext() {
  const here = new URLSearchParams(location.search).get("context");
  const told = new URLSearchParams(location.hash.slice(1));
  try {
    if (here) sessionStorage.setItem("framewise:context", here);
    else if (told.has("session") || told.has("choice")) sessionStorage.removeItem("framewise:context");
    return here ?? sessionStorage.getItem("framewise:context") ?? "";
  } catch {
    return here ?? "";
  }
}

/** Address of another page, in the same language. @param {string} path relative to the root */
export function pageAddress(path) {
  const address = new URL(path, root);
  address.searchParams.set("lang", language);
  return address.href;
}

/**
 * Makes the page ready and runs it.
 * @param {() => void | Promise<void>} run
 */
export async function startPage(run) {
  takeCarried(root);
  if (window.self !== window.top) document.documentElement.classList.add("embedded");
  for (const link of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-nav]"))) {
    if (link.dataset.nav === pageName) link.setAttribute("aria-current", "page");
  }
  prepareLanguages();
  takeAlong();
  await loadTexts();
  whenNothingLasts(sayThatNothingLasts);
  await run();
  document.documentElement.dataset.ready = "true";
}

/** Loads the page's texts. Where they do not come, the page says so in those it was delivered with, until a new try is asked for. */
async function loadTexts() {
  try {
    await loadMessages(root, messages || "form");
  } catch (error) {
    const notice = document.getElementById("unloaded");
    if (!notice) throw error;
    notice.hidden = false;
    await new Promise((resolve) => notice.querySelector("button")?.addEventListener("click", resolve, { once: true }));
    document.getElementById("main")?.focus(); // the button is about to go
    notice.hidden = true;
    await loadTexts();
  }
}

/** Above the page, and read out: storage is blocked or full. */
function sayThatNothingLasts() {
  warnAbove(t("form-storage-blocked"));
}

/**
 * A warning above the page, which is read out and can be closed.
 * @param {string} text
 * @param {{text: string, run: () => void}} [action] what may be done about it, which closes the warning too
 * @returns {HTMLElement}
 */
export function warnAbove(text, action) {
  const button = (/** @type {string} */ name, run = () => {}) =>
    el("button", {
      type: "button",
      class: "quiet",
      text: name,
      onclick: () => {
        notice.remove();
        run();
      },
    });
  /** @type {HTMLElement} */
  const notice = el(
    "div",
    { class: "notice notice-warn row no-print" },
    el("span", { class: "grow", text }),
    action ? button(action.text, action.run) : null,
    button(t("form-close")),
  );
  document.querySelector("main")?.prepend(notice);
  announce(text);
  return notice;
}

/**
 * Whoever has one thing open in two tabs is told so once, where something is changed in the other, and may take that.
 * @param {string} key where the browser keeps it @param {string} text @param {() => void} take
 */
export function watchOtherTabs(key, text, take) {
  /** @type {HTMLElement | null} */
  let warning = null;
  whenKeptElsewhere(key, () => {
    if (!warning?.isConnected) warning = warnAbove(text, { text: t("form-other-tab-take"), run: take });
  });
}

/** The menu of languages: the place on the page stays; Escape and a click elsewhere close it. */
function prepareLanguages() {
  const menu = /** @type {HTMLDetailsElement | null} */ (document.getElementById("language"));
  if (!menu) return;
  menu.addEventListener("click", (event) => {
    const link = /** @type {Element} */ (event.target).closest("a");
    if (link) link.hash = location.hash;
  });
  menu.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !menu.open) return;
    menu.open = false;
    menu.querySelector("summary")?.focus();
  });
  document.addEventListener("click", (event) => {
    if (!menu.contains(/** @type {Node} */ (event.target))) menu.open = false;
  });
}

/** Takes a fragment whose content is here, and has been changed, out of the address: a reload would bring it back. @param {string} name */
export function forgetFragment(name) {
  if (location.hash.startsWith(`#${name}=`))
    history.replaceState(history.state, "", location.pathname + location.search);
}

/** Links to other pages of the tool take along what only memory holds; nobody can copy it from them later. */
function takeAlong() {
  document.addEventListener("click", (event) => {
    const link = /** @type {Element} */ (event.target).closest("a");
    if (!link || link.target || link.download || link.getAttribute("href")?.startsWith("#")) return;
    if (event.defaultPrevented || !link.href.startsWith(root) || link.href.startsWith(api.base)) return;
    const { hash } = link;
    link.hash = carried(hash.slice(1));
    setTimeout(() => {
      link.hash = hash;
    });
  });
}

const sheets = new Map();

/** Loads a style sheet once. @param {string} path below the assets' folder @returns {Promise<void>} */
export function loadStyle(path) {
  if (!sheets.has(path)) {
    sheets.set(
      path,
      new Promise((resolve, reject) => {
        const link = document.createElement("link");
        link.rel = "stylesheet";
        link.href = `${assets}/${path}`;
        link.addEventListener("load", () => resolve(undefined));
        link.addEventListener("error", () => reject(new Error(path)));
        document.head.append(link);
      }),
    );
  }
  return sheets.get(path);
}

/**
 * A library that is loaded with its style sheet when it is first wanted, and again after a failure.
 * @template Library
 * @param {() => Promise<Library>} load @param {string} style
 * @returns {() => Promise<Library>}
 */
export function loadedOnce(load, style) {
  /** @type {Promise<Library> | null} */
  let loading = null;
  return () => {
    loading ??= Promise.all([load(), loadStyle(style)]).then(
      ([library]) => library,
      (error) => {
        loading = null;
        throw error;
      },
    );
    return loading;
  };
}

/** Resolves when the browser has painted and is idle: the time to load what is heavy. */
export function whenIdle() {
  return new Promise((resolve) => {
    const idle = window.requestIdleCallback ?? ((run) => setTimeout(run, 200));
    requestAnimationFrame(() => idle(() => resolve(undefined), { timeout: 1500 }));
  });
}

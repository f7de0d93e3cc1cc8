/** Messages in the reader's language: the same Fluent files that the API answers with. */

import { FluentBundle, FluentResource } from "../vendor/fluent/bundle.js";

/** @type {FluentBundle | null} */
let bundle = null;

export const language = document.documentElement?.lang || "en";

/** Where texts are written as in one of several countries: for their plurals, dates and numbers. @type {Record<string, string>} */
const REGIONS = { en: "en-GB", pt: "pt-PT" };

const region = REGIONS[language] ?? language;

/** How dates and times are written. @param {Intl.DateTimeFormatOptions} options */
export function dates(options) {
  return new Intl.DateTimeFormat(region, options);
}

/**
 * Loads the messages of the page's language. Texts asked for before that come out as their ids.
 * @param {string} root address of the service's root
 * @param {string} files names of message files, joined by "+"
 */
export async function loadMessages(root, files) {
  const answer = await fetch(`${root}locales/${language}.ftl?files=${files}`);
  if (!answer.ok) throw new Error(`messages: HTTP ${answer.status}`);
  useMessages(await answer.text(), region);
}

/** Takes messages from text; what loadMessages does after loading. @param {string} text @param {string} locale */
function useMessages(text, locale) {
  bundle = new FluentBundle(locale, { useIsolating: false });
  bundle.addResource(new FluentResource(text));
}

/**
 * A message with its parameters in place.
 * @param {string} id @param {Record<string, string | number>} [parameters]
 * @returns {string}
 */
export function t(id, parameters) {
  const message = bundle?.getMessage(id);
  if (!bundle || !message?.value) return id;
  return bundle.formatPattern(message.value, parameters, []);
}

/** A name and what is said of it, with the colon of the language. @param {string} name @param {string | number} said */
export function named(name, said) {
  return t("form-named", { name, said: String(said) });
}

/** A name in its own direction, and not in that of the words beside it, if it is read from right to left. @param {string} name */
export function ownDirection(name) {
  return /[\p{Script=Hebrew}\p{Script=Arabic}\p{Script=Syriac}\p{Script=Thaana}\p{Script=Nko}]/u.test(name)
    ? `\u2068${name}\u2069`
    : name;
}

/** Whether there is such a message. @param {string} id */
export function knows(id) {
  return Boolean(bundle?.getMessage(id)?.value);
}

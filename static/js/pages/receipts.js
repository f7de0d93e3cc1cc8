/** A folder of receipts: dropped or pasted, verified by the service, and made a file for a gradebook. */

import { dataTable } from "../data-table.js";
import { el, fill } from "../dom.js";
import { pointsText } from "../exercise/progress.js";
import { dates, t } from "../i18n.js";
import { api, startPage } from "../page.js";
import { problemNotice } from "../problem.js";
import { saveFile } from "../save-file.js";

/** A compact JWS whose header begins {"alg":"EdDSA"; an Ed25519 signature has 64 bytes. */
const RECEIPT = /eyJhbGciOiJFZERTQSI[\w-]*\.[\w-]+\.[\w-]{86}/g;
/** How many one call verifies (service.routes.exercises.receipt_checks.MOST_RECEIPTS). */
const AT_ONCE = 1000;
/** Characters of a text that are sent (service.receipts.receipt.LONGEST). */
const LONGEST = 8192;
const FORMATS = ["csv", "moodle", "canvas"];

/** @param {string} id */
const $ = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** @typedef {{text: string, source: string}} Found a receipt, or what was taken for one, and the file it is from */

/**
 * Receipts in a text; a text without any stands for itself, so that the service says what is wrong with it.
 * @param {string} text @param {string} [source] @returns {Found[]}
 */
function receiptsIn(text, source = "") {
  const found = text.replace(/\s+/g, "").match(RECEIPT) ?? [text.trim().slice(0, LONGEST)];
  return found.filter(Boolean).map((each) => ({ text: each, source }));
}

/** Each once, however often its file was dropped. @param {Found[]} all */
function distinct(all) {
  return [...new Map(all.map((found) => [JSON.stringify(found), found])).values()];
}

function run() {
  const text = /** @type {HTMLTextAreaElement} */ ($("folder-text"));
  const files = /** @type {HTMLInputElement} */ ($("folder-files"));
  const place = $("folder-drop");
  const result = $("folder-result");
  /** @type {Found[]} */
  let dropped = [];
  /** @param {Iterable<File>} list */
  const read = async (list) => {
    const found = await Promise.all([...list].map(async (file) => receiptsIn(await file.text(), file.name)));
    dropped = [...dropped, ...found.flat()];
    await verify();
  };
  const verify = async () => {
    const receipts = distinct([...dropped, ...receiptsIn(text.value)]);
    if (!receipts.length) return fill(result, el("p", { class: "hint", text: t("receipts-none") }));
    try {
      const checked = [];
      for (const body of bodies(receipts)) checked.push(...(await api.post("receipts/verify", body)).receipts);
      fill(result, summary(checked, receipts));
    } catch (error) {
      fill(result, problemNotice(error));
    }
  };
  files.addEventListener("change", () => void read(files.files ?? []));
  place.addEventListener("dragover", (event) => event.preventDefault());
  place.addEventListener("drop", (event) => {
    event.preventDefault();
    void read(event.dataTransfer?.files ?? []);
  });
  $("folder-verify").addEventListener("click", () => void verify());
}

/** What is sent to have receipts verified, in as many calls as it takes. @param {Found[]} receipts */
function* bodies(receipts) {
  for (let at = 0; at < receipts.length; at += AT_ONCE)
    yield { receipts: receipts.slice(at, at + AT_ONCE).map(({ text }) => text) };
}

/** Saves what receipts say for a gradebook: a file for each call. @param {Found[]} receipts @param {string} format */
async function saveGradebook(receipts, format) {
  const calls = [...bodies(receipts)];
  for (const [i, body] of calls.entries()) {
    const part = calls.length > 1 ? `-${i + 1}` : "";
    saveFile(await api.file(`receipts/verify?format=${format}`, body), `framewise-${format}${part}.csv`);
  }
}

/** @param {any[]} checked @param {Found[]} receipts */
function summary(checked, receipts) {
  const valid = receipts.filter((_, i) => checked[i].valid);
  const columns = [
    t("receipts-name"),
    t("receipts-exercise"),
    t("receipts-points"),
    t("receipts-time"),
    t("receipts-settings"),
    t("receipts-said"),
  ];
  return [
    el("p", {
      text: t("receipts-found", { valid: checked.filter((entry) => entry.valid).length, all: checked.length }),
    }),
    el(
      "div",
      { class: "row" },
      FORMATS.map((format) =>
        el("button", {
          type: "button",
          onclick: () => saveGradebook(valid, format),
          text: t(`receipts-save-${format}`),
          disabled: !valid.length,
        }),
      ),
    ),
    dataTable(
      t("receipts-title"),
      columns,
      checked.map((entry, i) => row(entry, receipts[i])),
    ),
  ];
}

/** What a receipt says; one that is refused is named by its file. @param {any} entry @param {Found} found */
function row({ valid, message, repeated, name, exercise, points, max_points: most, issued, settings }, found) {
  const when = dates({ dateStyle: "medium", timeStyle: "short" });
  const said = valid ? t(repeated ? "receipts-repeated" : "receipts-genuine") : message;
  const tone = valid ? (repeated ? "warn" : "good") : "bad";
  return [
    name ?? (found.source || "–"),
    exercise ?? "–",
    valid ? pointsText(points, most) : "–",
    valid ? when.format(new Date(issued)) : "–",
    valid ? settingsText(settings) : "–",
    el("span", { class: tone === "bad" ? "receipt-refused" : `badge ${tone}`, text: said }),
  ];
}

/** What was in force: how much help, and whether by a lecturer's link. @param {any} settings */
function settingsText({ help, link }) {
  const level = t(`form-help-${help}`);
  return link ? `${level}; ${t("receipts-by-link")}` : level;
}

startPage(run);

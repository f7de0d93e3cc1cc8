/** A folder of receipts: dropped or pasted, verified by the service, and made a file for a gradebook. */

import { dataTable } from "../data-table.js";
import { el, fill } from "../dom.js";
import { pointsText } from "../exercise/progress.js";
import { save } from "../exercise/receipt-dialog.js";
import { dates, t } from "../i18n.js";
import { api, startPage } from "../page.js";
import { problemNotice } from "../problem.js";

/** A compact JWS whose header begins {"alg":"EdDSA"; an Ed25519 signature has 64 bytes. */
const RECEIPT = /eyJhbGciOiJFZERTQSI[\w-]*\.[\w-]+\.[\w-]{86}/g;
/** How many one call verifies (service.schemas.exercises.receipts.MOST_RECEIPTS). */
const AT_ONCE = 1000;
const FORMATS = ["csv", "moodle", "canvas"];

/** @param {string} id */
const $ = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

/** Receipts in a text; a text without any stands for itself, so that the service says what is wrong with it. @param {string} text */
function receiptsIn(text) {
  const found = text.replace(/\s+/g, "").match(RECEIPT);
  if (found) return found;
  return text.trim() ? [text.trim().slice(0, 8192)] : [];
}

function run() {
  const text = /** @type {HTMLTextAreaElement} */ ($("folder-text"));
  const files = /** @type {HTMLInputElement} */ ($("folder-files"));
  const place = $("folder-drop");
  const result = $("folder-result");
  /** @type {string[]} */
  let dropped = [];
  /** @param {Iterable<File>} list */
  const read = async (list) => {
    const texts = await Promise.all([...list].map((file) => file.text()));
    dropped = [...dropped, ...texts.flatMap(receiptsIn)];
    await verify();
  };
  const verify = async () => {
    const receipts = [...dropped, ...receiptsIn(text.value)];
    if (!receipts.length) return fill(result, el("p", { class: "hint", text: t("receipts-none") }));
    try {
      const checked = [];
      for (let at = 0; at < receipts.length; at += AT_ONCE) {
        const answer = await api.post("receipts/verify", { receipts: receipts.slice(at, at + AT_ONCE) });
        checked.push(...answer.receipts);
      }
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

/** @param {any[]} checked @param {string[]} receipts */
function summary(checked, receipts) {
  const valid = receipts.filter((_, i) => checked[i].valid).slice(0, AT_ONCE);
  const download = (/** @type {string} */ format) => async () =>
    save(await api.file(`receipts/verify?format=${format}`, { receipts: valid }), `framewise-${format}.csv`);
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
          onclick: download(format),
          text: t(`receipts-save-${format}`),
          disabled: !valid.length,
        }),
      ),
    ),
    dataTable(t("receipts-title"), columns, checked.map(row)),
  ];
}

/** @param {any} entry */
function row({ valid, message, repeated, name, exercise, points, max_points: most, issued, settings }) {
  const when = dates({ dateStyle: "medium", timeStyle: "short" });
  const said = valid ? t(repeated ? "receipts-repeated" : "receipts-genuine") : message;
  const tone = valid ? (repeated ? "warn" : "good") : "bad";
  return [
    name ?? "–",
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

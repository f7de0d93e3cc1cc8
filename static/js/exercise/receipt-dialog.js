/** A receipt of a verdict to hand in: text to paste, a QR code, and a page to print with the robot and the table. */

import { copyText } from "../clipboard.js";
import { announce, el, showDialog, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { problemNotice, telling } from "../problem.js";
import { saveFile } from "../save-file.js";
import { keep, recall } from "../storage.js";
import { pointsText } from "./progress.js";

/** @typedef {{request: Record<string, any>, state: any}} Handed what was judged, as it was sent */

/**
 * Asks for the name and shows the receipt.
 * @param {import("../api.js").Api} api @param {Wire.Exercise} exercise @param {Handed} handed
 */
export function openReceipt(api, exercise, { request }) {
  const id = uniqueId("receipt");
  const name = el("input", { id, type: "text", maxlength: 200, autocomplete: "name", value: recall("name", "") });
  const result = el("div", { class: "stack", role: "status" });
  const address = `exercises/${exercise.id}/receipts`;
  const body = () => ({ ...request, name: name.value.trim() });
  const take = telling(result, async () => {
    if (!name.value.trim()) return name.focus();
    keep("name", name.value.trim());
    result.replaceChildren(...shown(await api.post(address, body())));
  });
  /** @param {any} issued */
  const shown = ({ receipt, qr, points, max_points: most }) => {
    const text = el("textarea", { rows: 5, readonly: true, "aria-label": t("form-receipt-as-text") });
    text.value = receipt;
    const copy = async () =>
      announce(
        t((await copyText(receipt)) ? "form-copied" : "form-copy-failed", { format: t("form-receipt-as-text") }),
      );
    const print = async () => saveFile(await api.file(`${address}.pdf`, body()), `${exercise.id}.pdf`);
    const picture = el("img", {
      class: "receipt-qr",
      alt: t("form-receipt-qr"),
      src: `data:image/svg+xml,${encodeURIComponent(qr)}`,
    });
    return [
      el("p", {}, el("strong", { text: pointsText(points, most) })),
      text,
      el(
        "div",
        { class: "row" },
        el("button", { type: "button", onclick: copy, text: t("form-receipt-copy") }),
        el("button", {
          type: "button",
          onclick: () => print().catch((error) => result.append(problemNotice(error))),
          text: t("form-receipt-pdf"),
        }),
      ),
      picture,
    ];
  };
  const title = uniqueId("receipt");
  /** @type {HTMLDialogElement} */
  const dialog = el(
    "dialog",
    { class: "receipt-dialog", "aria-labelledby": title, onclose: () => dialog.remove() },
    el("h2", { id: title, text: t("form-receipt") }),
    el("p", { class: "hint", text: t("form-receipt-text") }),
    el(
      "form",
      { class: "row end", onsubmit: (event) => (event.preventDefault(), take()) },
      el("div", { class: "field" }, el("label", { for: id, text: t("form-receipt-name") }), name),
      el("button", { type: "submit", class: "primary", onclick: (event) => (event.preventDefault(), take()) }, [
        t("form-receipt"),
      ]),
    ),
    result,
    el("p", {}, el("button", { type: "button", onclick: () => dialog.close(), text: t("form-close") })),
  );
  showDialog(dialog);
}

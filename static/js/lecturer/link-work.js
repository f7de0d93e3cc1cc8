/** What a lecturer does with one link: look at it as a student, release grades, grade again, export. */

import { dataTable } from "../data-table.js";
import { el, fill } from "../dom.js";
import { t } from "../i18n.js";
import { percentOf } from "../numbers.js";
import { pageAddress } from "../page.js";
import { telling } from "../problem.js";
import { saveFile } from "../save-file.js";
import { studentName } from "./class-view.js";

/**
 * @param {import("../api.js").Api} api @param {any} link @param {any} settings
 * @param {{path: (rest: string) => string, changed: () => Promise<any>}} act the address of something of the link; what is
 *   done when grades have changed
 */
export function linkWork(api, link, { mode, feedback }, { path, changed }) {
  const said = el("div", { class: "stack", role: "status" });
  const wait = () => fill(said, el("p", { text: t("form-loading") })); // in the place of what would be pressed again
  const release = telling(said, async () => {
    wait();
    await api.post(path("release"), {});
    link.released = true;
    releasing.remove();
    fill(said, el("p", { text: t("lecturer-released") }));
  });
  const askFirst = async () =>
    fill(
      said,
      el("p", { class: "notice notice-warn", text: t("lecturer-release-sure") }),
      el(
        "div",
        {},
        el("button", { type: "button", class: "primary", onclick: release, text: t("lecturer-release-now") }),
      ),
    );
  const preview = async () => {
    const { exercise, code } = await api.post(path("preview"), {});
    const address = `${pageAddress(`exercises/${exercise}`)}#session=${code}`;
    const opened = el("a", { href: address, target: "_blank", rel: "noopener", text: t("lecturer-preview-open") });
    fill(said, el("p", {}, opened), el("p", { class: "hint", text: t("lecturer-preview-text") }));
    opened.focus();
  };
  const regrade = async (/** @type {string} */ scope) => {
    wait();
    const { run, changes, unread } = await api.post(path("regradings"), { scope });
    const apply = telling(said, async () => {
      wait();
      await api.post(path(`regradings/${run}/apply`), {});
      await changed();
      fill(said, el("p", { text: t("lecturer-applied") }));
    });
    const row = (/** @type {any} */ { before, ...entry }) => [studentName(entry), entry.number, percentOf(before)];
    const rows = changes.map((/** @type {any} */ entry) => [...row(entry), percentOf(entry.after)]);
    const kept = [t("lecturer-student"), t("lecturer-attempt"), t("lecturer-before")];
    const headings = [...kept, t("lecturer-after")];
    fill(
      said,
      changes.length ? dataTable(t("lecturer-changes"), headings, rows) : el("p", { text: t("lecturer-no-changes") }),
      changes.length
        ? el("button", { type: "button", class: "primary", onclick: apply, text: t("lecturer-apply") })
        : null,
      unread.length ? dataTable(t("lecturer-unread"), kept, unread.map(row)) : null,
    );
  };
  /** A file with every attempt; the token goes in a header, so that no address holds it. @param {string} ending */
  const exported = async (ending) => saveFile(await api.file(path(`export.${ending}`)), `attempts.${ending}`);
  /** @param {string} text @param {() => Promise<void>} work */
  const button = (text, work) => el("button", { type: "button", onclick: telling(said, work), text });
  const releasing = button(t("lecturer-release"), askFirst);
  const isWithheld = !link.released && (mode === "exam" || feedback !== "at_once");
  return el(
    "section",
    { class: "stack" },
    link.released ? el("p", { class: "hint", text: t("lecturer-released") }) : null,
    el(
      "p",
      { class: "row no-print" },
      button(t("lecturer-preview"), preview),
      isWithheld ? releasing : null,
      button(t("lecturer-regrade-counted"), () => regrade("counted")),
      button(t("lecturer-regrade-all"), () => regrade("all")),
      button("CSV", () => exported("csv")),
      button("JSON", () => exported("json")),
    ),
    said,
  );
}

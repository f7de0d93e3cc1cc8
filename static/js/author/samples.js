/** Answers with the judgement that is expected of them: part of the exercise's own tests. */

import { el } from "../dom.js";
import { rowsTable } from "../editor/rows-table.js";
import { t } from "../i18n.js";
import { choiceField, part, refill, textField } from "./fields.js";
import { entriesField, wordsField } from "./shapes.js";

const PATH = ["definition", "tests", "samples"];
const EXPECTED = ["correct", "incorrect", "invalid"];

/** @param {import("./draft-store.js").DraftStore} store */
export function samplesSection(store) {
  const element = el("div", { class: "stack" });
  const options = EXPECTED.map((value) => ({ value, label: t(`author-sample-${value}`) }));
  const fields = (/** @type {(string | number)[]} */ path, /** @type {any} */ sample) => [
    textField(store, t("author-sample-name"), [...path, "name"]),
    choiceField(store, t("author-sample-expect"), [...path, "expect"], options, "correct"),
    wordsField(store, t("author-sample-feedback"), [...path, "feedback"]),
    el("div", { dataset: { path: path.join("/"), whole: "" } }, rowsTable(sample)),
  ];
  const build = () =>
    refill(
      element,
      ...part("author-samples", true),
      entriesField(store, t("author-sample"), PATH, fields, () => ({
        name: t("author-sample-key"),
        expect: "correct",
        ...keyOf(store),
      })),
    );
  return { element, fill: build, show: () => undefined };
}

/** A sample as a student handed it in. @param {import("./draft-store.js").DraftStore} store @param {any} table @param {boolean} correct */
export function keepSample(store, table, correct) {
  const samples = store.at(PATH) ?? [];
  const sample = {
    name: `${t("author-sample")} ${samples.length + 1}`,
    expect: correct ? "correct" : "incorrect",
    ...table,
  };
  store.set(PATH, [...samples, sample]);
}

/** @param {import("./draft-store.js").DraftStore} store */
function keyOf(store) {
  const { convention, angle_unit, length_unit, rows } = store.at(["definition", "reference"]) ?? {
    convention: "standard",
    rows: [],
  };
  return { convention, ...(angle_unit ? { angle_unit } : {}), ...(length_unit ? { length_unit } : {}), rows };
}

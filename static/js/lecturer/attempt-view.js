/** One attempt: what was typed, what was found, and the robots of student and key in one picture. */

import { dataTable } from "../data-table.js";
import { el, fill } from "../dom.js";
import { bothRobots } from "../exercise/both-robots.js";
import { partView, verdictView } from "../exercise/verdict-view.js";
import { language, t } from "../i18n.js";
import { robotOf } from "../live-robot.js";
import { convertedValues } from "../units.js";

const CELLS = ["joint", "theta", "d", "a", "alpha"];

/** @param {import("../api.js").Api} api @param {HTMLElement} card @param {HTMLElement} place @param {any} attempt */
export async function showAttempt(api, card, place, attempt) {
  const { answer, report, person } = attempt;
  const when = new Intl.DateTimeFormat(language, { dateStyle: "medium", timeStyle: "medium" });
  const { table, ...others } = report.parts;
  const rows = (answer.table?.rows ?? []).map((/** @type {any} */ row, /** @type {number} */ i) => [
    i + 1,
    ...CELLS.map((cell) => String(row[cell] ?? "")),
  ]);
  card.hidden = false;
  fill(
    place,
    el(
      "p",
      { class: "row" },
      el("span", { text: person.slice(0, 8) }),
      el("span", { text: t("lecturer-attempt-number", { attempt: attempt.number }) }),
      el("time", { datetime: attempt.at, text: when.format(new Date(attempt.at)) }),
      el("span", { text: `${attempt.exercise} (${attempt.version})` }),
    ),
    answer.table
      ? dataTable(t("form-part-table"), [t("form-row-heading"), t("form-joint"), "θ", "d", "a", "α"], rows)
      : null,
    verdictView(report, { convention: answer.table?.convention ?? "standard", focusRow: null }),
    Object.values(others).map((/** @type {any} */ part) =>
      partView(part, t(`form-part-${part.kind.replaceAll("_", "-")}`), {
        nameOf: (where) => where.join(", "),
        goTo: () => undefined,
      }),
    ),
    el(
      "details",
      {},
      el("summary", { text: t("lecturer-as-sent") }),
      el("pre", { text: JSON.stringify(answer, null, 2) }),
    ),
  );
  card.focus({ preventScroll: true });
  card.scrollIntoView({ block: "start" });
  if (answer.table) await draw(api, place, attempt).catch((error) => console.warn(error));
}

/** @param {any} api @param {any} place @param {any} options */
async function draw(api, place, { answer, report, exercise: name, version, seed }) {
  const id = version.startsWith(`${name}-`) ? version : name; // the exercise as it was when this was handed in
  const values = seed ? `seed=${encodeURIComponent(seed)}&` : "";
  const exercise = await api.get(`exercises/${id}?${values}lang=${language}`);
  const { angle_unit: angle, length_unit: length } = answer.table;
  const units = { angle: exercise.angle_unit, length: exercise.length_unit };
  const kinds = new Map(
    exercise.dimensions.map((/** @type {any} */ { name, unit }) => [
      name,
      unit === exercise.length_unit ? "length" : "angle",
    ]),
  );
  const dimensions = convertedValues(exercise.parameters, (name) => kinds.get(name) ?? "length", units, {
    angle,
    length,
  });
  const drawn = await robotOf(api, answer.table, dimensions);
  if (!drawn) return;
  if (report.certificate && report.figure) {
    const both = bothRobots({
      figure: exercise.figure,
      own: drawn.model,
      certificate: report.certificate,
      units: { angle: report.angle_unit, length: report.length_unit },
      key: report.figure,
    });
    place.append(both.element);
    both.describe();
    return;
  }
  const scene = /** @type {any} */ (document.createElement("robot-scene"));
  scene.model = drawn.model;
  const figure = el("img", {
    class: "figure-paper",
    src: api.address(`exercises/${id}/figure.svg?${values}lang=${language}`),
    alt: exercise.figure.description,
    width: 480,
    height: 330,
  });
  place.append(el("div", { class: "row" }, scene, figure));
}

/** One attempt: what was typed, what was found, and the robots of student and key in one picture. */

import { Latest } from "../api.js";
import { dataTable } from "../data-table.js";
import { el, fill } from "../dom.js";
import { columnText } from "../editor/grid.js";
import { COLUMNS } from "../editor/model.js";
import { bothRobots } from "../exercise/both-robots.js";
import { partName } from "../exercise/progress.js";
import { partView, verdictView } from "../exercise/verdict-view.js";
import { dates, language, t } from "../i18n.js";
import { robotOf } from "../live-robot.js";
import { convertedValues } from "../units.js";

export class AttemptView {
  #latest = new Latest();

  /** @param {import("../api.js").Api} api @param {HTMLElement} card @param {HTMLElement} place in the card */
  constructor(api, card, place) {
    this.api = api;
    this.card = card;
    this.place = place;
  }

  /** Shows an attempt, unless another one was asked for before all of it was here. @param {number} id */
  async open(id) {
    const answer = await this.#latest.run(async (signal) => {
      const attempt = await this.api.get(`course/attempts/${id}`, { signal });
      const gone = { parts: [] }; // an exercise that is gone names no places
      const exercise = await this.api.get(pathOf(attempt), { signal }).catch(() => gone);
      return { attempt, exercise, ...(await import("../exercise/answer-card.js")) };
    });
    if (answer) await showAttempt(this.api, this.card, this.place, answer.value);
  }
}

/** @param {import("../api.js").Api} api @param {HTMLElement} card @param {HTMLElement} place @param {any} found */
async function showAttempt(api, card, place, { attempt, exercise, placeOf }) {
  const { answer, report, person } = attempt;
  const when = dates({ dateStyle: "medium", timeStyle: "medium" });
  const { table, ...others } = report.parts;
  const convention = /** @type {"standard" | "modified"} */ (answer.table?.convention ?? "standard");
  const cells = COLUMNS[convention];
  const rows = (answer.table?.rows ?? []).map((/** @type {any} */ row, /** @type {number} */ i) => [
    i + 1,
    row.joint ? t(`form-joint-${row.joint}`) : "",
    ...cells.map((cell) => String(row[cell] ?? "")),
  ]);
  const pictures = el("div");
  card.hidden = false;
  fill(
    place,
    el(
      "p",
      { class: "row" },
      el("span", { text: person.slice(0, 8) }),
      el("span", { text: t("lecturer-attempt-number", { attempt: attempt.number }) }),
      el("time", { datetime: attempt.at, text: when.format(new Date(attempt.at)) }),
      el("span", { text: `${exercise.title ?? attempt.exercise} (${attempt.version})` }),
    ),
    answer.table
      ? dataTable(
          t("form-table-caption", { convention: t(`form-convention-${convention}`) }),
          [t("form-row-heading"), t("form-joint"), ...cells.map((cell) => columnText(cell, convention))],
          rows,
          {
            captioned: true,
          },
        )
      : null,
    verdictView(report, {
      convention,
      rows: answer.table?.rows.length ?? 0,
      focusRow: null,
    }),
    Object.values(others).map((/** @type {any} */ part) =>
      partView(part, partName(part.kind), {
        placeOf: (where) =>
          placeOf(exercise.parts.find((/** @type {any} */ { kind }) => kind === part.kind) ?? { form: [] }, where),
        goTo: null,
      }),
    ),
    el(
      "details",
      {},
      el("summary", { text: t("lecturer-as-sent") }),
      el("pre", { text: JSON.stringify(answer, null, 2) }),
    ),
    pictures,
  );
  card.focus({ preventScroll: true });
  card.scrollIntoView({ block: "start" });
  if (answer.table && exercise.parameters)
    await draw(api, pictures, attempt, exercise).catch((error) => console.warn(error));
}

/** Where the exercise is as it was when this was handed in. @param {any} attempt @param {string} [file] of its folder */
function pathOf({ exercise, version, seed }, file = "") {
  const id = version.startsWith(`${exercise}-`) ? version : exercise;
  return `exercises/${id}${file}?${seed ? `seed=${encodeURIComponent(seed)}&` : ""}lang=${language}`;
}

/** @param {any} api @param {any} place @param {any} attempt @param {any} exercise */
async function draw(api, place, attempt, exercise) {
  const { answer, report } = attempt;
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
    src: api.address(pathOf(attempt, "/figure.svg")),
    alt: exercise.figure.description,
    width: 480,
    height: 330,
  });
  place.append(el("div", { class: "attempt-pictures" }, scene, figure));
}

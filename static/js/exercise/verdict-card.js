/** The card with the verdict: shown after an answer was judged, marked as old once something is typed. */

import { announce, el, fill } from "../dom.js";
import { t } from "../i18n.js";
import { api } from "../page.js";
import { telling } from "../problem.js";
import { placeOf } from "./answer-card.js";
import { bothRobots } from "./both-robots.js";
import { ghostRobot } from "./ghost.js";
import { partName, pointsText } from "./progress.js";
import { partView, verdictView, verdictWord } from "./verdict-view.js";

/** @typedef {Omit<import("../live-robot.js").Robot, "values">} Drawn a table's robot, as the verdict draws it */

export class VerdictCard {
  /** @type {ReturnType<typeof bothRobots> | null} */
  #moving = null;

  /** @param {HTMLElement} card @param {HTMLElement} place */
  constructor(card, place) {
    this.card = card;
    this.place = place;
  }

  /** Something was typed since. */
  outdated() {
    if (this.card.hidden || this.card.classList.contains("outdated")) return;
    this.card.classList.add("outdated");
    this.place.prepend(el("p", { class: "hint outdated-note", text: t("form-verdict-outdated") }));
  }

  /**
   * @param {any} graded
   * @param {{exercise: any, answer: import("./answer-card.js").AnswerCard, convention: string,
   *   table: any, drawn: Drawn | null, changed: boolean,
   *   later?: (() => Promise<{graded: any, drawn: Drawn | null}>) | null, further: HTMLElement | null, kind?: string, access?: import("./access.js").Access,
   *   receipt?: import("./receipt-dialog.js").Handed | null}} given convention and robot of the table that was handed in; whether
   *   something was typed since; what brings the picture of where the robot departs, if nobody has looked yet; what is said beyond the verdict; the part that was checked, if it was one alone
   */
  show(graded, { exercise, answer, convention, table, drawn, later, changed, further, kind, access, receipt }) {
    this.#moving?.stop();
    this.card.classList.remove("outdated");
    this.card.hidden = false;
    const { table: _table, ...others } = graded.parts;
    /** @param {any} row @param {any} cell */
    const focusRow = (row, cell) => answer.focusRow(row, cell);
    this.#moving = drawn ? together(graded, exercise, drawn) : null;
    const picture = el("div", {}, this.#moving?.element);
    if (later) this.#offer(picture, exercise, later);
    const reasons = el("div");
    if (drawn && graded.certificate) void addReasons(reasons, access, exercise, table, drawn);
    fill(
      this.place,
      verdictView(graded, { convention, rows: table?.rows.length ?? 0, focusRow }),
      further,
      picture,
      reasons,
      Object.values(others).map((report) =>
        partView(report, partName(report.kind), {
          placeOf: (where) => placeOf(partOf(exercise, report.kind), where),
          goTo: (where) => answer.focusPart(report.kind, where),
        }),
      ),
      receipt ? receiptButton(exercise, receipt) : null,
    );
    this.#moving?.describe();
    this.card.dataset.shown = String(Number(this.card.dataset.shown ?? 0) + 1);
    announce(`${verdictWord(graded)} ${pointsText(graded.total.points, graded.total.max_points)}`);
    if (changed) return this.outdated();
    this.card.focus({ preventScroll: true });
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const own = kind && kind !== "table" ? this.place.querySelector(`[data-kind="${kind}"]`) : null;
    (own ?? this.card).scrollIntoView({ block: "nearest", behavior: calm ? "auto" : "smooth" });
  }

  /**
   * Says where the picture would stand that it has not been drawn, and draws it for whoever wants to see it.
   * @param {HTMLElement} place @param {any} exercise @param {() => Promise<{graded: any, drawn: Drawn | null}>} later
   */
  #offer(place, exercise, later) {
    const problem = el("div");
    const draw = telling(problem, async () => {
      const { graded, drawn } = await later();
      if (!place.isConnected) return;
      this.#moving = drawn ? together(graded, exercise, drawn) : null;
      fill(place, this.#moving?.element ?? el("p", { class: "hint", text: t("form-ghost-none") }));
      this.#moving?.describe();
      place.tabIndex = -1;
      place.focus();
    });
    const button = el("button", { type: "button", onclick: draw, text: t("form-ghost-draw") });
    const text = el("span", { class: "grow", text: t("form-ghost-later") });
    fill(place, el("div", { class: "both no-print" }, el("div", { class: "notice row" }, text, button), problem));
  }
}

/**
 * The student's robot with the exercise's: moving as one after a right answer, as a ghost over it after a wrong one.
 * @param {Wire.Graded} graded @param {Wire.Exercise} exercise @param {Pick<import("../live-robot.js").Robot, "model" | "size">} drawn
 */
function together(graded, { figure }, { model, size }) {
  const { certificate, figure: key, departure, angle_unit: angle, length_unit: length } = graded;
  if (certificate && key) return bothRobots({ figure, own: model, certificate, units: { angle, length }, key });
  return departure ? ghostRobot({ figure, own: model, size, departure, length }) : null;
}

/** @param {Wire.Exercise} exercise @param {import("./receipt-dialog.js").Handed} handed */
function receiptButton(exercise, handed) {
  const problem = el("div");
  const open = telling(problem, async () => {
    const { openReceipt } = await import("./receipt-dialog.js");
    fill(problem);
    openReceipt(api, exercise, handed);
  });
  const button = el("button", { type: "button", onclick: open, text: t("form-receipt") });
  return el("div", { class: "stack no-print" }, el("p", {}, button), problem);
}

/**
 * What can be learned from a right answer; loaded when there is one.
 * @param {HTMLElement} place @param {import("./access.js").Access | undefined} access @param {Wire.Exercise} exercise @param {any} table
 * @param {Pick<import("../live-robot.js").Robot, "rows" | "size" | "parameters">} drawn
 */
async function addReasons(place, access, exercise, table, drawn) {
  const { reasonsList, secondTable } = await import("./reasons.js");
  const compares = access?.converts ?? true;
  const other = compares ? secondTable(api, table, exercise.policy, drawn.parameters) : null;
  fill(place, reasonsList(drawn.rows, table, drawn.size), other);
}

/** @param {Wire.Exercise} exercise @param {string} kind */
function partOf({ parts }, kind) {
  return parts.find((part) => part.kind === kind) ?? { kind, form: [] };
}

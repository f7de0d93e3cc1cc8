/** The card with the verdict: shown after an answer was judged, marked as old once something is typed. */

import { announce, el, fill } from "../dom.js";
import { t } from "../i18n.js";
import { placeName } from "./answer-card.js";
import { bothRobots } from "./both-robots.js";
import { partView, verdictView } from "./verdict-view.js";

export class VerdictCard {
  /** The student's robot as it is drawn, for the scene with both. @type {any} */
  ownRobot = null;
  /** @type {{stop: () => void} | null} */
  #both = null;

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

  /** @param {any} graded @param {{exercise: any, answer: import("./answer-card.js").AnswerCard}} given */
  show(graded, { exercise, answer }) {
    this.#both?.stop();
    this.card.classList.remove("outdated");
    this.card.hidden = false;
    const verdict = graded.table ?? graded;
    const parts = graded.parts?.filter?.(({ kind }) => kind !== "table") ?? [];
    const focusRow = (row, cell) => answer.focusRow(row, cell);
    const both = verdict.correct && verdict.certificate && this.ownRobot ? this.#bothRobots(verdict, exercise, answer) : null;
    this.#both = both;
    fill(
      this.place,
      verdictView(verdict, { convention: answer.convention, focusRow }),
      both?.element,
      parts.map((report) => partView(report, t(`form-part-${report.kind.replaceAll("_", "-")}`), (where) => placeName(report.kind, where))),
    );
    both?.describe();
    announce(`${t(verdict.correct ? "form-verdict-correct" : "form-verdict-wrong")} ${t("form-score", { score: Math.round(graded.score * 100) })}`);
    this.card.focus({ preventScroll: true });
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.card.scrollIntoView({ block: "nearest", behavior: calm ? "auto" : "smooth" });
  }

  #bothRobots(verdict, exercise, answer) {
    const { figure } = exercise;
    if (!figure.base) return null;
    return bothRobots({
      figure,
      own: this.ownRobot.model,
      certificate: verdict.certificate,
      world: figure.base,
      posture: figure.posture,
      degrees: answer.units.angle === "deg",
      types: figure.axes.map((axis) => axis.type),
    });
  }
}

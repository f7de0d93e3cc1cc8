/** The exercise tried while it is written: its own tests, right answers, wrong ones, and as a student. */

import { Latest, Problem } from "../api.js";
import { announce, el, fill, setAble } from "../dom.js";
import { rowsTable } from "../editor/rows-table.js";
import { language, t } from "../i18n.js";
import { pointsTold } from "../numbers.js";
import { problemNotice } from "../problem.js";
import { tick } from "./fields.js";
import { keepSample } from "./samples.js";

const SEEDS = [null, 1, 2];
/** Milliseconds without a change until a good draft is tested. */
const REST = 1500;

/** @typedef {import("./draft-store.js").DraftStore} DraftStore */

/** The self-test: runs by itself once the draft rests, the usual values first. */
export class SelfTest {
  #latest = new Latest();
  #start = 0;

  /** @param {import("../api.js").Api} api @param {DraftStore} store */
  constructor(api, store) {
    this.api = api;
    this.store = store;
    this.element = el("div", { class: "author-selftest", role: "status" });
  }

  /** The draft is good as it stands: runs unless it changes first. */
  soon() {
    clearTimeout(this.#start);
    this.#start = setTimeout(() => this.run(), REST);
  }

  /** The draft has changed: what was said of it holds no more. */
  outdated() {
    clearTimeout(this.#start);
    this.#latest.cancel();
    this.element.dataset.state = "waiting";
    fill(this.element, el("p", { class: "hint", text: t("author-test-waiting") }));
  }

  /** The draft is refused as it stands. */
  refused() {
    this.outdated();
    this.element.dataset.state = "refused";
    fill(this.element, el("p", { class: "hint", text: t("author-test-refused") }));
  }

  async run() {
    this.element.dataset.state = "running";
    fill(this.element, el("p", { class: "hint", text: t("author-test-running") }));
    try {
      const answer = await this.#latest.run(async (signal) => {
        const rounds = [];
        for (const seed of SEEDS) {
          const body = { draft: this.store.draft, ...(seed === null ? {} : { seed }) };
          rounds.push(await this.api.post("author/check", body, { signal }));
        }
        return rounds;
      });
      if (answer) this.#show(answer.value);
    } catch (error) {
      if (error instanceof Error && error.name === "AbortError") return;
      this.element.dataset.state = "failed";
      fill(this.element, problemNotice(error));
    }
  }

  /** @param {any[]} rounds */
  #show(rounds) {
    const passed = rounds.reduce((sum, round) => sum + round.passed, 0);
    const lines = (/** @type {string} */ name) => [
      ...new Set(rounds.flatMap((round) => round[name].map((/** @type {any} */ line) => line.message))),
    ];
    const failures = lines("failures");
    const list = (/** @type {string[]} */ texts) =>
      el(
        "ul",
        {},
        texts.map((text) => el("li", { text })),
      );
    this.element.dataset.state = failures.length ? "failed" : "passed";
    fill(
      this.element,
      el("p", {
        class: failures.length ? "notice notice-problem" : "notice notice-good",
        text: t(failures.length ? "author-test-failed" : "author-test-passed", { passed, failed: failures.length }),
      }),
      failures.length ? list(failures) : null,
      lines("warnings").length
        ? [el("p", { class: "hint", text: t("author-test-warnings") }), list(lines("warnings"))]
        : null,
    );
  }
}

/** Ten right answers that look different. @param {import("../api.js").Api} api @param {DraftStore} store */
export function rightAnswers(api, store) {
  return shownOnDemand(t("author-right"), async (place) => {
    const { answers } = await api.post("author/right-answers", { draft: store.draft, count: 10 });
    const wrong = answers.filter((/** @type {any} */ answer) => !answer.correct).length;
    fill(
      place,
      el("p", {
        class: wrong ? "notice notice-problem" : "notice notice-good",
        text: t("author-right-shown", { count: answers.length, wrong }),
      }),
      answers.map((/** @type {any} */ answer) => rowsTable(answer.table)),
    );
  });
}

/** The commonest wrong answers, what they earn, what is told, and the lecturer's own words on them. @param {import("../api.js").Api} api @param {DraftStore} store */
export function wrongAnswers(api, store) {
  return shownOnDemand(t("author-wrong"), async (place) => {
    const { answers } = await api.post("author/mistakes", { draft: store.draft });
    /** @type {Set<string>} */
    const remarked = new Set();
    fill(
      place,
      el("p", { class: "hint", text: t("author-wrong-hint") }),
      answers.map((/** @type {any} */ answer) => mistake(store, answer, remarked)),
    );
  });
}

/** @param {DraftStore} store @param {any} answer @param {Set<string>} remarked codes on which there is a field already */
function mistake(store, answer, remarked) {
  const told = answer.repairs.length ? answer.repairs : answer.feedback;
  const code = answer.repairs[0]?.code;
  const marks = answer.refused
    ? t("author-wrong-refused")
    : t("author-wrong-marks", {
        points: pointsTold(answer.points),
        most: pointsTold(answer.max_points),
        score: Math.round(100 * answer.score),
      });
  const listed = () => store.at(["definition", "tests", "misconceptions"]) ?? [];
  const own = code && !remarked.has(code) ? ownWords(store, code) : null;
  if (code) remarked.add(code);
  const codes = (/** @type {boolean} */ on) => {
    const others = listed().filter((/** @type {string} */ entry) => entry !== answer.misconception);
    store.set(["definition", "tests", "misconceptions"], on ? [...others, answer.misconception] : others);
  };
  const said = answer.refused
    ? t(`option-${answer.misconception}`)
    : told.map((/** @type {any} */ entry) => entry.message).join(" ") ||
      t("author-wrong-untold", { name: t(`option-${answer.misconception}`) });
  return el(
    "details",
    { class: "author-mistake", dataset: { misconception: answer.misconception } },
    el("summary", {}, el("span", { text: said }), " ", el("strong", { text: marks })),
    rowsTable(answer.table),
    tick(t("author-wrong-tested"), listed().includes(answer.misconception), codes),
    own,
  );
}

/** @param {DraftStore} store @param {string} code */
function ownWords(store, code) {
  const path = ["definition", "remarks", code, language];
  const set = (/** @type {any} */ event) => {
    if (event.target.value.trim()) return store.set(path, event.target.value);
    const { [language]: _gone, ...rest } = store.at(["definition", "remarks", code]) ?? {};
    const remarks = { ...store.at(["definition", "remarks"]), [code]: rest };
    if (!Object.keys(rest).length) delete remarks[code];
    store.set(["definition", "remarks"], Object.keys(remarks).length ? remarks : undefined);
    return undefined;
  };
  const area = el("textarea", { rows: "2", value: store.at(path) ?? "", dataset: { remark: code }, oninput: set });
  return el("label", { class: "field" }, t("author-own-words"), area);
}

/** The exercise as it stands, with the table editor and the verdict that a student would get. @param {import("../api.js").Api} api @param {DraftStore} store @param {() => any} view */
export function asStudent(api, store, view) {
  return shownOnDemand(t("author-try"), async (place) => {
    const [{ AnswerCard }, { VerdictCard }] = await Promise.all([
      import("../exercise/answer-card.js"),
      import("../exercise/verdict-card.js"),
      import("../editor/dh-table-editor.js"),
      import("../scene/robot-scene.js"),
    ]);
    const { exercise } = view();
    const form = el("div", {});
    const body = el("div", { id: "verdict" });
    const card = el(
      "section",
      { class: "card", id: "verdict-card", "aria-label": t("form-verdict-heading"), tabindex: "-1", hidden: true },
      body,
    );
    const problem = el("div", {});
    const verdict = new VerdictCard(card, body);
    const answer = new AnswerCard(form, exercise, {
      changed: () => verdict.outdated(),
      submit: (kind) => submit(kind),
    });
    const kept = el("p", {});
    fill(place, form, problem, card, kept);

    /** @param {any} table @param {boolean} correct */
    function keepButton(table, correct) {
      const keep = () => {
        keepSample(store, table, correct);
        fill(kept, t("author-sample-kept"));
      };
      return el("button", { type: "button", onclick: keep, text: t("author-sample-keep") });
    }

    /** Shows a refusal where it points into the answer. @param {unknown} error @param {any} table @returns {boolean} */
    function shownInPlace(error, table) {
      const ofAnswer = error instanceof Problem && error.faults.every(({ pointer }) => pointer.startsWith("/answer/"));
      if (!ofAnswer) return false;
      const faults = error.faults.map((fault) => ({ ...fault, pointer: fault.pointer.slice("/answer".length) }));
      return answer.showRefusal(faults, table);
    }

    /** @param {string} [kind] one part alone */
    async function submit(kind) {
      const request = answer.request(kind);
      if (!request) return;
      answer.busy = true;
      try {
        const graded = await api.post("author/grade", { draft: store.draft, answer: request });
        fill(problem);
        answer.showRefusal([], request.table);
        if (request.table) fill(kept, keepButton(request.table, graded.basis !== "refuted"));
        const convention = answer.convention;
        verdict.show(graded, {
          exercise,
          answer,
          convention,
          table: request.table,
          drawn: null,
          changed: false,
          further: null,
          kind,
        });
      } catch (error) {
        fill(problem, shownInPlace(error, request.table) ? [] : problemNotice(error));
      } finally {
        answer.busy = false;
      }
    }
  });
}

/** A button, and what it brings; a second press looks again. @param {string} label @param {(place: HTMLElement) => Promise<void>} bring */
function shownOnDemand(label, bring) {
  const place = el("div", { class: "stack" });
  const press = async () => {
    setAble(button, false);
    try {
      await bring(place);
      announce(label);
    } catch (error) {
      fill(place, problemNotice(error));
    } finally {
      setAble(button, true);
    }
  };
  const button = el("button", { type: "button", onclick: press, text: label });
  return el("div", { class: "stack" }, el("div", {}, button), place);
}

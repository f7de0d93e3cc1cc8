/** The trainer: frames attached to a robot's axes in the steps of the lecture, and the table read off from them. */

import "../scene/robot-scene.js";
import { Latest } from "../api.js";
import { announce, el, fill, segmented } from "../dom.js";
import { fromWire } from "../editor/model.js";
import { poseOf, ROWS_SECONDS, stillOf } from "../trainer/reading.js";
import { t } from "../i18n.js";
import { api, pageAddress, startPage } from "../page.js";
import { problemNotice } from "../problem.js";
import { emptyModel } from "../scene/model.js";
import { across, cross, dot, minus, norm, plus, times, unit } from "../scene/matrix.js";
import { carried, keep, recall } from "../storage.js";
import { notOpened, openSession } from "../session/session.js";
import { candidateText, findingNotice, showChooser } from "../trainer/chooser.js";
import { litModel, picture } from "../trainer/picture.js";
import { backTo, choose, isFull, onward, partOf, same, shuffled, start, STEPS, wire } from "../trainer/steps.js";
import { middlesOf, namedRow, rowToPoint, tableView } from "../trainer/table.js";
import { METRES } from "../units.js";

/** @typedef {import("../trainer/steps.js").State} State */
/** @typedef {{frames: Wire.JudgedFrame[], rows: any[], table: any, tool?: number[][]}} Judged */

const $ = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
const id = $("trainer").dataset.id ?? "";

class Trainer {
  #latest = new Latest();
  #running = 0;
  /** What is shown: a choice and the end of a step are for that. @type {State | null} */
  #shown = null;
  /** When the service has answered about the present state. */
  #answered = Promise.resolve();
  /** Why the step is not finished. */
  note = "";
  /** Why the step before is right. */
  why = "";
  /** @type {Judged | null} */
  judged = null;
  /** @type {Wire.Candidate[]} */
  candidates = [];

  /** @param {Wire.Exercise} exercise @param {string} draft where the browser keeps what was chosen */
  constructor(exercise, draft) {
    this.draft = draft;
    this.exercise = exercise;
    this.figure = exercise.figure;
    this.axes = exercise.figure.axes.map(({ type, point, direction }) => ({ joint: type, point, direction }));
    this.point =
      exercise.policy.tool === "axis" || exercise.policy.tool === "free" ? null : (exercise.figure.points?.[0] ?? null);
    const fresh = start(this.axes.length, exercise.conventions[0]);
    const kept = recall(draft, fresh);
    const isOfRobot = kept.frames?.length === fresh.frames.length && kept.frame in kept.frames;
    /** @type {State} */
    this.state = isOfRobot && exercise.conventions.includes(kept.convention) ? kept : fresh;
    this.scene = el("robot-scene", { label: t("trainer-scene"), grabs: true });
    fill($("scene"), this.scene, el("p", { class: "hint", text: t("trainer-click") }));
    this.scene.describe(`${this.figure.description} ${t("form-scene-keys")}`);
    this.scene.addEventListener("scene-pick", (event) =>
      this.#picked(Number(/** @type {CustomEvent} */ (event).detail.id)),
    );
    this.scene.addEventListener("scene-drag", (event) => {
      const { id: index } = /** @type {CustomEvent} */ (event).detail;
      this.#point(index === null ? null : (this.candidates[Number(index)] ?? null));
    });
    this.body = el("div", { class: "stack" });
    fill($("frame"), this.body);
    this.#convention();
  }

  #convention() {
    const options = this.exercise.conventions.map((value) => ({ value, label: t(`form-convention-${value}`) }));
    const onchange = (/** @type {any} */ convention) => this.become(start(this.axes.length, convention));
    fill(
      $("convention"),
      segmented({ name: "convention", label: t("form-convention"), value: this.state.convention, options, onchange }),
    );
  }

  /**
   * Takes a new state, asks the service about it and shows both.
   * @param {State} state @param {string} [note] why the step is not finished
   */
  become(state, note = "") {
    this.#answered = this.#ask(state, note);
    return this.#answered;
  }

  /** @param {State} state @param {string} note */
  async #ask(state, note) {
    cancelAnimationFrame(this.#running);
    this.note = note;
    if (note) announce(note);
    if (state.step !== this.state.step && STEPS.indexOf(state.step) < STEPS.indexOf(this.state.step)) this.why = "";
    this.state = state;
    keep(this.draft, state);
    $("frame").setAttribute("aria-busy", "true");
    try {
      const tool = this.point ? toolPose(this.figure, this.point.at) : null;
      const request = { axes: this.axes, convention: state.convention, frames: wire(state), ...(tool ? { tool } : {}) };
      const answer = await this.#latest.run((signal) => api.post("check-frames", request, { signal }));
      if (!answer) return;
      this.#show(answer.value);
      $("frame").removeAttribute("aria-busy");
    } catch (error) {
      $("frame").removeAttribute("aria-busy");
      const focused = this.body.contains(document.activeElement);
      fill(this.body, problemNotice(error, { retry: () => this.become(this.state) }));
      if (focused) this.body.querySelector("button")?.focus();
    }
  }

  /** @param {Judged} judged */
  #show(judged) {
    this.judged = judged;
    const { state } = this;
    const focused = this.body.contains(document.activeElement) || $("steps").contains(document.activeElement);
    const isOther = this.#shown?.step !== state.step;
    this.#shown = state;
    const part = partOf(state.step);
    this.candidates = part ? shuffled(judged.frames[state.frame].candidates[part], `${id}:${state.frame}`, part) : [];
    const normals = state.step === "normals" || state.step === "origin" ? normalsOf(judged) : [];
    this.scene.overlay = emptyModel();
    this.#point(null);
    this.scene.model = picture(
      this.figure,
      state,
      this.candidates,
      part,
      normals.map(({ ends }) => ends),
    );
    this.#steps();
    this.#because();
    this.#frames(part);
    if (part) this.#choices(part);
    else
      fill(
        this.body,
        state.step === "normals" ? normalsList(this.axes.length, normals) : this.#result(),
        this.#buttons(),
      );
    const read = state.step === "read" ? this.#rows() : state.frames.slice(1).map(() => null);
    fill($("table"), tableView(read, state.convention, { play: (row) => this.#film(row) }));
    if (focused && (isOther || !this.body.contains(document.activeElement))) this.#focusTask();
  }

  /** Whoever went on to another step goes on reading at what is to be done in it. */
  #focusTask() {
    const task = this.body.querySelector("p");
    task?.setAttribute("tabindex", "-1");
    task?.focus();
  }

  /** Whether what is shown is the state that choices would change. */
  get #isPresent() {
    return this.#shown?.frame === this.state.frame && this.#shown.step === this.state.step;
  }

  /** @param {"z" | "origin" | "x"} part */
  #choices(part) {
    const { state } = this;
    const findings = state.checked ? this.#faults(state.frame, part) : [];
    if (!this.list?.isConnected) {
      this.list = el("div", { class: "stack" });
      this.noted = el("p", { class: "notice" });
      const task = el("p", { class: "lead-small", text: t(`trainer-task-${part}`) });
      fill(this.body, task, this.list, this.noted, this.#buttons());
    } else if (this.body.firstElementChild) this.body.firstElementChild.textContent = t(`trainer-task-${part}`);
    if (this.noted) {
      this.noted.textContent = this.note;
      this.noted.hidden = !this.note;
    }
    showChooser(this.list, {
      state,
      part,
      candidates: this.candidates,
      findings,
      choose: (vector) => this.#choose(vector),
      point: (candidate) => this.#point(candidate),
    });
  }

  /** What is wrong with a frame's part: the rules of the convention, and where the exercise wants the last frame. @param {number} frame @param {string} part @returns {Wire.Finding[]} */
  #faults(frame, part) {
    const found = (this.judged?.frames[frame].findings ?? []).filter(
      (finding) => finding.part === part && finding.severity === "broken",
    );
    return [...found, ...this.#pointFault(frame, part)];
  }

  /** @param {number} frame @param {string} part @returns {Wire.Finding[]} */
  #pointFault(frame, part) {
    const origin = this.state.frames[frame].origin;
    if (!this.point || part !== "origin" || frame < this.axes.length || !origin) return [];
    const reachable = this.state.convention === "standard" || isOnAxis(this.figure, this.point.at);
    if (!reachable || same(origin, this.point.at)) return [];
    const message = t("trainer-point-missed", { frame, point: this.point.name });
    return [{ rule: "point_missed", part: "origin", severity: "broken", params: {}, message }];
  }

  /** Why what was chosen in the step before is right. */
  #because() {
    const place = $("why");
    place.hidden = !this.why;
    if (this.why) fill(place, el("p", { class: "notice notice-good", text: `${t("trainer-step-done")} ${this.why}` }));
  }

  /** The steps; those before the present one can be gone back to. */
  #steps() {
    const now = STEPS.indexOf(this.state.step);
    const item = (/** @type {import("../trainer/steps.js").Step} */ step, /** @type {number} */ i) =>
      el(
        "li",
        { "aria-current": i === now ? "step" : null, dataset: { step }, class: i < now ? "step-whole" : "" },
        i < now
          ? el("button", {
              type: "button",
              class: "small",
              onclick: () => this.become(backTo(this.state, step)),
              text: t(`trainer-step-${step}`),
            })
          : el("span", { text: t(`trainer-step-${step}`) }),
      );
    fill($("steps"), STEPS.map(item));
  }

  /** The frames of the step, to be gone to in any order; they stay the same elements. @param {string | null} part */
  #frames(part) {
    const place = $("frames");
    place.hidden = part === null;
    if (place.children.length !== this.state.frames.length) {
      const go = (/** @type {number} */ frame) => () => this.become({ ...this.state, frame });
      fill(
        place,
        this.state.frames.map((_, i) => el("button", { type: "button", onclick: go(i), text: `{${i}}` })),
      );
    }
    this.state.frames.forEach((frame, i) => {
      const broken = this.state.checked && part !== null && this.#faults(i, part).length > 0;
      const whole = part !== null && /** @type {any} */ (frame)[part] !== undefined;
      const state = broken ? "broken" : whole ? "whole" : "open";
      const button = place.children[i];
      button.className = `small step step-${state}`;
      button.setAttribute("aria-pressed", String(i === this.state.frame));
      button.setAttribute("aria-label", t("trainer-step", { frame: i, state: t(`trainer-state-${state}`) }));
    });
  }

  #buttons() {
    const label = partOf(this.state.step) ? "trainer-check" : "trainer-onward";
    const on =
      this.state.step === "read"
        ? null
        : el("button", { type: "button", class: "primary", onclick: () => this.#check(), text: t(label) });
    const again = el("button", {
      type: "button",
      class: "small",
      onclick: () => this.become(start(this.axes.length, this.state.convention)),
      text: t("trainer-restart"),
    });
    return el("div", { class: "row" }, on, again);
  }

  /** The end of a step: what is wrong is said now, and the next one comes when nothing is. */
  async #check() {
    const { state } = this;
    const part = partOf(state.step);
    if (this.#shown?.step !== state.step) return undefined; // it was pressed twice
    await this.#answered;
    if (this.#shown !== state) return undefined;
    if (!isFull(state)) {
      const frame = state.frames.findIndex((each) => part && each[part] === undefined);
      return this.become({ ...state, frame }, t("trainer-open-choice", { frame }));
    }
    const broken = state.frames.flatMap((_, i) => (part && this.#faults(i, part).length ? [i] : []));
    if (broken.length) {
      const frame = broken[0];
      return this.become({ ...state, checked: true, frame }, t("trainer-status", { broken: broken.length }));
    }
    this.why = part ? t(`trainer-why-${part}`, { convention: state.convention }) : "";
    announce(`${t("trainer-step-done")} ${this.why}`);
    return this.become(onward(state));
  }

  /** Rows in the exercise's names; in a modified table a fixed row leads to a point off the last axis. */
  #rows() {
    const { exercise, judged } = this;
    if (!judged?.table) return this.state.frames.slice(1).map(() => null);
    const metres = METRES[exercise.length_unit];
    const marks = new Map(
      (this.figure.dimensions ?? []).map(({ name, from, to }) => [name, times(plus(from, to), 0.5)]),
    );
    const dimensions = exercise.dimensions
      .filter(({ unit: each }) => each === exercise.length_unit)
      .map(({ name, value }) => ({ name, value, at: marks.get(name) }));
    const names = {
      dimensions,
      angle: exercise.angle_unit,
      size: this.figure.size / metres,
      zeroIsFree: exercise.policy.zero === "free",
    };
    const rows = [...judged.rows];
    const end = judged.tool?.slice(0, 3).map((line) => line[3]);
    if (this.point && end && norm(/** @type {any} */ (end)) > 1e-6 * this.figure.size) rows.push(rowToPoint(end));
    const poses = this.state.frames.map(poseOf);
    return rows.map((row, i) => {
      const inUnits = { ...row, a: scaled(row.a, metres), d: scaled(row.d, metres) };
      return namedRow(inUnits, names, poses[i + 1] ? middlesOf(this.state.convention, poses[i], poses[i + 1]) : {});
    });
  }

  #result() {
    const rows = this.#rows();
    if (rows.some((row) => row === null))
      return el("p", { class: "notice notice-problem", text: t("trainer-unfinished") });
    const take = () => {
      const { angle_unit, length_unit } = this.exercise;
      const table = fromWire({ convention: this.state.convention, angle_unit, length_unit, rows });
      keep(`read-off:${id}`, table);
      location.href = pageAddress(`exercises/${id}`) + carried();
    };
    const advice = (this.judged?.frames ?? []).flatMap(({ findings }) =>
      findings.filter(({ severity }) => severity !== "broken"),
    );
    return el(
      "div",
      { class: "stack" },
      el("p", { class: "notice notice-good", text: t("trainer-complete") }),
      el("p", { text: t("trainer-read") }),
      advice.map(findingNotice),
      el(
        "div",
        { class: "row" },
        el("button", { type: "button", class: "primary", onclick: take, text: t("trainer-take") }),
      ),
    );
  }

  /** How the four numbers of a row carry one frame into the next; in stills where motion is unwelcome. @param {number} row */
  #film(row) {
    cancelAnimationFrame(this.#running);
    const found = this.judged?.rows[row];
    const before = this.state.frames[row];
    if (!found || !before) return;
    const show = (/** @type {number} */ phase) =>
      (this.scene.overlay = stillOf(this.state.convention, found, before, phase, row, this.figure.size));
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return void show(4);
    const begin = performance.now();
    const tick = (/** @type {number} */ now) => {
      const phase = Math.min(4, ((now - begin) / 1000 / ROWS_SECONDS) * 4);
      show(phase);
      if (phase < 4) this.#running = requestAnimationFrame(tick);
    };
    this.#running = requestAnimationFrame(tick);
    return undefined;
  }

  /** Lights a candidate in the picture. @param {Wire.Candidate | null} candidate */
  #point(candidate) {
    const part = partOf(this.state.step);
    const lit = candidate && part ? litModel(this.figure, this.state, candidate, part) : null;
    this.scene.layer("candidate", lit);
  }

  /** @param {Wire.Vector} vector */
  #choose(vector) {
    if (!this.#isPresent) return;
    this.become({ ...choose(this.state, vector), checked: false });
  }

  /** @param {number} index of what was clicked */
  #picked(index) {
    const candidate = this.candidates[index];
    if (!candidate) return;
    announce(candidateText(candidate));
    this.#choose(candidate.vector);
  }
}

/** A length in another unit; the offset of a variable too. @param {string | number} value @param {number} metres */
function scaled(value, metres) {
  if (typeof value === "number") return value / metres;
  return value.replace(/(?<=[+-] )\S+$/, (text) => String(Number(text) / metres));
}

/** The pose of a frame at the marked point whose x leads there from the last axis. @param {Wire.Figure} figure @param {Wire.Vector} point */
function toolPose(figure, point) {
  const axis = figure.axes[figure.axes.length - 1];
  const z = unit(axis.direction);
  const foot = plus(axis.point, times(z, dot(minus(point, axis.point), z)));
  const away = minus(point, foot);
  const x = norm(away) > 1e-9 * figure.size ? unit(away) : across(z);
  const y = cross(z, x);
  return [...[0, 1, 2].map((k) => [x[k], y[k], z[k], point[k]]), [0, 0, 0, 1]];
}

/** Whether a point is on the last axis. @param {Wire.Figure} figure @param {Wire.Vector} point */
function isOnAxis(figure, point) {
  const axis = figure.axes[figure.axes.length - 1];
  return norm(cross(unit(axis.direction), minus(point, axis.point))) < 1e-6 * figure.size;
}

/**
 * The common normal of each pair of neighbouring axes, as the service's candidates tell it.
 * @param {Judged} judged
 * @returns {{axis: number, ends: Wire.Vector[]}[]} two ends of skew axes' normal, one point where axes meet
 */
function normalsOf(judged) {
  const all = judged.frames.flatMap(({ candidates }) => candidates.origin);
  const found = new Map();
  for (const { kind, vector, params } of all) {
    const axis = Math.min(params.axis, params.other);
    if (kind === "intersection") found.set(axis, [vector]);
    if (kind !== "foot") continue;
    const ends = found.get(axis) ?? [];
    if (!ends.some((/** @type {Wire.Vector} */ end) => same(end, vector))) found.set(axis, [...ends, vector]);
  }
  return [...found].map(([axis, ends]) => ({ axis, ends })).sort((a, b) => a.axis - b.axis);
}

/** What the common normals are, in words. @param {number} joints @param {{axis: number, ends: Wire.Vector[]}[]} normals */
function normalsList(joints, normals) {
  const items = Array.from({ length: Math.max(0, joints - 1) }, (_, i) => {
    const found = normals.find(({ axis }) => axis === i + 1);
    const kind = !found ? "parallel" : found.ends.length === 1 ? "meet" : "skew";
    return el("li", { text: t(`trainer-normal-${kind}`, { axis: i + 1, other: i + 2 }) });
  });
  return el(
    "div",
    { class: "stack" },
    el("p", { class: "lead-small", text: t("trainer-task-normals") }),
    el("ul", {}, items),
  );
}

/** On wide screens the picture stands beside the lists; on others above them, and so in the document. */
function arrange() {
  const wide = matchMedia("(min-width: 64rem)");
  const place = () =>
    wide.matches ? $("scene-side").append($("scene-card")) : $("frames-card").before($("scene-card"));
  wide.addEventListener("change", place);
  place();
}

startPage(async () => {
  arrange();
  try {
    const told = await openSession(api);
    const key = told?.exercise === id ? `:${told.person.key}` : ""; // values of one's own
    const trainer = new Trainer(await api.get(`exercises/${id}`), `trainer:2:${id}${key}`);
    await trainer.become(trainer.state);
  } catch (error) {
    fill($("frame"), notOpened(error));
  }
});

/** The trainer: attach frames to a robot's axes, one choice at a time, and see the table follow. */

import "../scene/robot-scene.js";
import { Latest } from "../api.js";
import { announce, el, fill, segmented } from "../dom.js";
import { t } from "../i18n.js";
import { api, pageAddress, startPage } from "../page.js";
import { problemNotice } from "../problem.js";
import { keep, recall } from "../storage.js";
import { permalink } from "../playground/permalink.js";
import { showChooser, candidateText } from "../trainer/chooser.js";
import { choose, clear, goTo, start, wire } from "../trainer/choices.js";
import { picture } from "../trainer/picture.js";
import { tableView } from "../trainer/table.js";

const $ = (id) => /** @type {HTMLElement} */ (document.getElementById(id));
const id = $("trainer").dataset.id;
const draft = `trainer:${id}`;

class Trainer {
  #latest = new Latest();

  /** @param {any} exercise */
  constructor(exercise) {
    this.figure = exercise.figure;
    this.axes = exercise.figure.axes.map(({ type, point, direction }) => ({ joint: type, point, direction }));
    const fresh = start(this.axes.length, "modified");
    const kept = recall(draft, fresh);
    this.state = kept.frames?.length === fresh.frames.length ? kept : fresh;
    this.scene = /** @type {any} */ (el("robot-scene", { label: t("trainer-scene") }));
    fill($("scene"), this.scene, el("p", { class: "hint", text: t("trainer-click") }));
    this.scene.describe(`${this.figure.description} ${t("form-scene-keys")}`);
    this.shown = -1;
    this.chooser = el("div", { class: "stack" });
    this.next = el("button", { type: "button", class: "small", onclick: () => this.#go(this.state.current + 1) }, t("trainer-next"));
    const clearing = el("button", { type: "button", class: "small", onclick: () => this.become(clear(this.state)) }, t("trainer-clear"));
    this.navigation = el("div", { class: "row" }, clearing, this.next);
    this.scene.addEventListener("scene-pick", (event) => this.#picked(/** @type {CustomEvent} */ (event).detail.id));
    this.#convention();
  }

  #convention() {
    fill(
      $("convention"),
      segmented({
        name: "convention",
        label: t("form-convention"),
        value: this.state.convention,
        options: ["standard", "modified"].map((value) => ({ value, label: t(`form-convention-${value}`) })),
        onchange: (convention) => this.become({ ...this.state, convention }),
      }),
    );
  }

  /** Takes a new state, asks the service about it and shows both. */
  async become(state) {
    this.state = state;
    keep(draft, state);
    try {
      const request = { axes: this.axes, convention: state.convention, frames: wire(state) };
      const answer = await this.#latest.run((signal) => api.post("check-frames", request, { signal }));
      if (answer) this.#show(answer.value);
    } catch (error) {
      fill($("frame"), problemNotice(error, { retry: () => this.become(this.state) }));
    }
  }

  #show(judged) {
    this.judged = judged;
    this.shown = this.state.current;
    const frame = judged.frames[this.shown];
    this.#steps(judged.frames);
    if (!this.chooser.isConnected) fill($("frame"), this.chooser, this.navigation);
    showChooser(this.chooser, {
      state: this.state,
      judged: frame,
      choose: (part, vector) => this.#choose(part, vector),
      part: (part) => this.#part(part),
    });
    this.#navigate();
    this.scene.model = picture(this.figure, this.state, frame.candidates);
    fill($("table"), tableView(judged, this.state.convention), this.#finish(judged));
    const broken = judged.frames.flatMap((each) => each.findings).filter((finding) => finding.severity === "broken").length;
    announce(judged.table ? t("trainer-complete") : t("trainer-status", { broken }));
  }

  #finish(judged) {
    if (!judged.table) return el("p", { class: "hint", text: t("trainer-unfinished") });
    const address = permalink(pageAddress("playground"), { table: judged.table, parameters: {}, joints: [] });
    return el("div", { class: "row" }, el("p", { class: "notice notice-good", text: t("trainer-complete") }), el("a", { class: "button", href: address }, t("trainer-open")));
  }

  /** The buttons stay the same elements, so that the focus stays on them. */
  #steps(frames) {
    const place = $("steps");
    if (place.children.length !== frames.length) {
      fill(place, frames.map((_, i) => el("button", { type: "button", onclick: () => this.#go(i) }, `{${i}}`)));
    }
    frames.forEach((frame, i) => {
      const broken = frame.findings.some((finding) => finding.severity === "broken");
      const state = broken ? "broken" : frame.complete ? "whole" : "open";
      const button = place.children[i];
      button.className = `small step step-${state}`;
      button.setAttribute("aria-pressed", String(i === this.state.current));
      button.setAttribute("aria-label", t("trainer-step", { frame: i, state: t(`trainer-state-${state}`) }));
    });
  }

  /** The buttons below the lists stay too; with the last frame the focus leaves the one that goes on. */
  #navigate() {
    const last = this.shown + 1 === this.state.frames.length;
    const focused = this.next === document.activeElement;
    this.next.hidden = last;
    if (last && focused) /** @type {HTMLElement} */ ($("steps").children[this.shown]).focus();
  }

  /** Takes a choice for the frame whose lists are shown; while those of another one are on their way, none. */
  #choose(part, vector) {
    if (this.shown === this.state.current) this.become(choose(this.state, part, vector));
  }

  #go(frame) {
    this.become(goTo(this.state, frame));
  }

  #part(part) {
    if (part === this.state.part || this.shown !== this.state.current) return;
    this.state = { ...this.state, part };
    this.scene.model = picture(this.figure, this.state, this.judged.frames[this.state.current].candidates);
    for (const group of document.querySelectorAll(".choices")) {
      group.classList.toggle("current", Boolean(group.querySelector(`[data-choice^="${part}:"]`)));
    }
  }

  #picked(pick) {
    const [part, index] = pick.split(":");
    const candidate = this.judged.frames[this.shown].candidates[part][Number(index)];
    if (this.shown !== this.state.current) return;
    announce(candidateText(candidate));
    this.#choose(/** @type {any} */ (part), candidate.vector);
  }
}

/** On wide screens the picture stands beside the lists; on others above them, and so in the document. */
function arrange() {
  const wide = matchMedia("(min-width: 64rem)");
  const place = () => (wide.matches ? $("scene-side").append($("scene-card")) : $("frames-card").before($("scene-card")));
  wide.addEventListener("change", place);
  place();
}

startPage(async () => {
  arrange();
  try {
    const trainer = new Trainer(await api.get(`exercises/${id}`));
    await trainer.become(trainer.state);
  } catch (error) {
    fill($("frame"), problemNotice(error, { retry: () => location.reload() }));
  }
});

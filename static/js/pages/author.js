/** The page on which an exercise is made: on the left what it is, on the right how it looks and whether it holds. */

import { Latest, Problem } from "../api.js";
import { DraftStore, KEPT, workIn } from "../author/draft-store.js";
import { DimensionHandles } from "../author/dimension-handles.js";
import { figureSection } from "../author/figure-form.js";
import { samplesSection } from "../author/samples.js";
import { helpSection, partsSection, policySection, valuesSection } from "../author/asked.js";
import { Start } from "../author/start.js";
import { folderField, takeAlong } from "../author/take-along.js";
import { textsSection } from "../author/texts.js";
import { asStudent, rightAnswers, SelfTest, wrongAnswers } from "../author/trials.js";
import { announce, debounced, el, fill, iconButton, setAble, setValid, variable } from "../dom.js";
import { named, t } from "../i18n.js";
import { inSentence } from "../numbers.js";
import { api, forgetFragment, startPage, watchOtherTabs } from "../page.js";
import { problemNotice } from "../problem.js";
import { openSession } from "../session/session.js";
import { stepAsked } from "../undo.js";

/** Milliseconds without a change until the draft is looked at. */
const REST = 350;

/** @param {string} id */
const $ = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

class AuthorPage {
  #latest = new Latest();

  constructor() {
    this.store = new DraftStore();
    this.start = new Start(api, this.store, () => announce(t("author-started")));
    this.selfTest = new SelfTest(api, this.store);
    /** @type {any} */
    this.view = null;
    /** @type {Record<string, {element: HTMLElement, fill: () => void, show: (view: any) => void}>} */
    this.sections = {
      texts: textsSection(this.store),
      parts: partsSection(this.store),
      policy: policySection(this.store),
      values: valuesSection(this.store),
      help: helpSection(this.store),
      figure: figureSection(this.store),
      samples: samplesSection(this.store),
      take: takeAlong(api, this.store),
    };
    this.handles = new DimensionHandles(this.store, $("author-dimension-handles"));
    this.look = debounced(() => this.#look(), REST);
  }

  build() {
    const folder = folderField(api, this.store, () => this.start.resume());
    fill($("author-start"), this.start.element, folder);
    for (const [name, { element }] of Object.entries(this.sections))
      fill($(name === "figure" ? "author-figure-fields" : `author-${name}`), element);
    this.undo = iconButton("undo", t("form-undo"), () => this.store.undo());
    this.redo = iconButton("redo", t("form-redo"), () => this.store.redo());
    fill($("author-tools"), this.undo, this.redo);
    fill($("author-selftest"), this.selfTest.element);
    fill($("author-right"), rightAnswers(api, this.store));
    fill($("author-wrong"), wrongAnswers(api, this.store));
    fill(
      $("author-try"),
      asStudent(api, this.store, () => this.view),
    );
    this.store.addEventListener("draft", (event) => this.#changed(/** @type {CustomEvent} */ (event).detail.whole));
    document.addEventListener("keydown", (event) => this.#keys(event));
  }

  /** The draft that was here last, and over it, as a step that can be taken back, the one of the address. */
  async restore() {
    const work = await workIn(location.hash);
    this.store.restore();
    if (work?.draft) this.store.load(work.draft, work.source);
    if (this.store.draft) this.start.resume();
    else this.start.show("robot");
    this.store.addEventListener("draft", () => forgetFragment("draft"));
    window.addEventListener("hashchange", () => void this.#follow());
    watchOtherTabs(KEPT, t("author-other-tab"), () => {
      this.store.takeKept();
      this.start.resume();
    });
  }

  /** Another draft's address that is opened where this page stands loads nothing: only its fragment is another. */
  async #follow() {
    const work = await workIn(location.hash);
    if (!work?.draft) return;
    this.store.load(work.draft, work.source);
    this.start.resume();
  }

  /** @param {boolean} whole */
  #changed(whole) {
    const { draft } = this.store;
    for (const card of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-needs-draft]")))
      card.hidden = !draft;
    if (this.undo) setAble(this.undo, this.store.canUndo);
    if (this.redo) setAble(this.redo, this.store.canRedo);
    if (!draft) return;
    if (whole) Object.values(this.sections).forEach((section) => section.fill());
    $("author-saved").textContent = t("author-saved");
    this.#latest.cancel();
    this.selfTest.outdated();
    this.look();
  }

  async #look() {
    try {
      const answer = await this.#latest.run((signal) =>
        api.post("author/preview", { draft: this.store.draft }, { signal }),
      );
      if (!answer) return;
      this.view = answer.value;
      fill($("author-problem"));
      this.#markFaults([]);
      for (const section of Object.values(this.sections)) section.show(this.view);
      showFigure(this.view);
      this.handles.show(this.view.dimensions);
      this.selfTest.soon();
    } catch (error) {
      if (error instanceof Error && error.name === "AbortError") return;
      fill($("author-problem"), error instanceof Problem ? refusal(error.faults) : problemNotice(error));
      this.selfTest.refused();
      this.#markFaults(error instanceof Problem ? error.faults : []);
    }
  }

  /** Marks the fields that a refusal speaks of. @param {import("../api.js").Fault[]} faults */
  #markFaults(faults) {
    const wrong = new Set(faults.flatMap(fieldsOf));
    for (const input of document.querySelectorAll("[data-path]")) {
      setValid(input, !wrong.has(/** @type {HTMLElement} */ (input)));
    }
  }

  /** Undo and redo of the whole draft; inside a text the browser's own go first. @param {KeyboardEvent} event */
  #keys(event) {
    const target = /** @type {HTMLElement} */ (event.target);
    if (target.closest("input, textarea, dh-table-editor")) return;
    const direction = stepAsked(event);
    if (!direction) return;
    event.preventDefault();
    this.store[direction]();
  }
}

/** The fields that a fault concerns: one, those of a group, that of the list it stands in, or of the dimension it names. @param {import("../api.js").Fault} fault @returns {HTMLElement[]} */
function fieldsOf({ pointer, params }) {
  const fields = /** @type {HTMLElement[]} */ ([...document.querySelectorAll("[data-path]")]);
  const steps = (pointer ?? "").replace(/^\/draft\//, "").split("/");
  const path = steps.join("/");
  const at = (/** @type {string} */ place) => fields.filter(({ dataset }) => dataset.path === place);
  const isGroup = steps.length > 2; // what is said of a whole card concerns none of its fields
  const inside = isGroup ? fields.filter(({ dataset }) => dataset.path?.startsWith(`${path}/`)) : [];
  const list = isGroup && /^\d+$/.test(steps.at(-1) ?? "") ? at(steps.slice(0, -1).join("/")) : [];
  const named = [`definition/figure/lengths/${params?.name}`, `definition/parameters/${params?.name}/value`].map(at);
  const places = [
    at(path),
    inside,
    list,
    ...named.map((all) => all.filter((field) => /** @type {any} */ (field).value)),
  ];
  return places.find((all) => all.length) ?? [];
}

/** Why there is no preview, each reason a link to its field. @param {import("../api.js").Fault[]} faults */
function refusal(faults) {
  const line = (/** @type {import("../api.js").Fault} */ fault) => {
    const [field] = fieldsOf(fault);
    if (!field) return el("li", { text: fault.detail });
    const group = field.closest("fieldset")?.querySelector("legend")?.textContent;
    const follow = (/** @type {Event} */ event) => {
      event.preventDefault();
      for (let fold = field.closest("details"); fold; fold = fold.parentElement?.closest("details") ?? null)
        fold.open = true;
      field.focus();
    };
    const text = group ? named(group, fault.detail) : fault.detail;
    return el("li", {}, el("a", { href: `#${field.id}`, onclick: follow, text }));
  };
  const isBetween = faults.every(({ code }) => code === "nothing_asked"); // one kind ticked off, the next not yet on
  const look = isBetween ? { class: "notice", role: "status" } : { class: "notice notice-problem", role: "alert" };
  return el("div", look, el("ul", {}, faults.map(line)));
}

/** @param {any} view */
function showFigure({ figure, exercise }) {
  const image = /** @type {HTMLImageElement} */ ($("author-figure"));
  const before = image.src;
  image.src = URL.createObjectURL(new Blob([figure], { type: "image/svg+xml" }));
  image.alt = exercise.figure.description;
  image.hidden = false;
  if (before.startsWith("blob:")) URL.revokeObjectURL(before);
  fill($("author-name"), exercise.title);
  fill(
    $("author-dimensions"),
    exercise.dimensions.map((/** @type {any} */ { name, value, unit }) =>
      el("li", {}, variable(name), ` = ${inSentence(value, 6)} ${unit}`),
    ),
  );
}

startPage(async () => {
  api.patience = 3; // tests, previews and rehearsals of one draft may stand in each other's way
  await openSession(api).catch(() => null); // a lecturer who came from a course may publish by it
  const page = new AuthorPage();
  page.build();
  await page.restore();
});

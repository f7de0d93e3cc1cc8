/** From what an exercise is started: a robot of the catalogue, a drawing, a table, an SCM chain, URDF. */

import { Latest, Problem } from "../api.js";
import { announce, el, fill, segmented, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { rowsTable } from "../editor/rows-table.js";
import { Cells, cellValue } from "../playground/cells.js";
import { problemNotice } from "../problem.js";
import { keep, recall } from "../storage.js";
import { AxesForm } from "./axes-form.js";
import { drawnAxes } from "./axes-scene.js";
import { field } from "./fields.js";
import { withRobot } from "./robot-change.js";

const WAYS = ["robot", "axes", "table", "scm", "urdf"];
const NEW_VALUE = 0.3;
const BEGUN = "author-begun";
const MOST_BEGUN = 20;
const SIX = ["x", "y", "z", "a", "b", "c"];

export class Start {
  #latest = new Latest();
  /** @type {any} */
  #scene = null;
  #way = "robot";
  /** @type {string[]} titles as text that drafts were started with */
  #begun = recall(BEGUN, []);
  /** @type {any} */
  editor = null;

  /** @param {import("../api.js").Api} api @param {import("./draft-store.js").DraftStore} store @param {() => void} started */
  constructor(api, store, started) {
    this.api = api;
    this.store = store;
    this.started = started;
    this.body = el("div", { class: "stack" });
    this.problem = el("div", { role: "status" });
    this.table = el("div", {});
    this.form = new AxesForm((drawing) => this.#draw(drawing));
    const ways = segmented({
      name: "author-start",
      label: t("author-start"),
      value: this.#way,
      options: WAYS.map((value) => ({ value, label: t(`author-start-${value}`) })),
      onchange: (way) => this.show(way),
    });
    this.element = el("div", { class: "stack" }, ways, this.body, this.problem);
  }

  /** @param {string} way */
  show(way) {
    this.#way = way;
    fill(this.problem);
    const radio = /** @type {HTMLInputElement | null} */ (this.element.querySelector(`input[value="${way}"]`));
    if (radio) radio.checked = true;
    /** @type {Record<string, () => any>} */
    const bodies = {
      robot: () => this.#catalogue(),
      axes: () => this.#drawing(),
      table: () => this.#tableEditor(),
      scm: () => this.#chain(),
      urdf: () => this.#urdf(),
    };
    fill(this.body, el("p", { class: "hint", text: t(`author-start-${way}-hint`) }), bodies[way]());
  }

  /** What was drawn before, to go on with it. */
  resume() {
    const axes = this.store.source?.axes;
    if (axes) this.form.take(axes);
    this.show(axes ? "axes" : "robot");
    if (axes) void this.#draw(axes);
  }

  #catalogue() {
    const choice = /** @type {HTMLSelectElement} */ (el("select", {}));
    this.api.get("robots").then(
      ({ robots }) =>
        choice.append(...robots.map((/** @type {any} */ { id, name }) => el("option", { value: id, text: name }))),
      (error) => this.#refuse(error),
    );
    return [field(t("author-robot"), choice), this.#button(() => ({ robot: choice.value }))];
  }

  #drawing() {
    void this.#openScene();
    const place = el("div", { class: "author-scene" });
    this.scenePlace = place;
    if (this.#scene) place.append(this.#scene);
    return [place, el("p", { class: "hint", text: t("author-scene-hint") }), this.form.element, this.table];
  }

  async #openScene() {
    if (this.#scene) return;
    await import("../scene/robot-scene.js");
    this.#scene = document.createElement("robot-scene");
    this.#scene.setAttribute("label", t("author-scene"));
    this.#scene.addEventListener("scene-pick", (/** @type {any} */ event) => this.#picked(event.detail.id));
    this.scenePlace?.append(this.#scene);
    await this.#draw(this.form.drawing);
  }

  /** @param {string} id */
  #picked(id) {
    const meaning = this.picks?.[id];
    if (!meaning) return;
    if ("select" in meaning) this.form.select(meaning.select);
    else this.form.change(meaning);
    announce(t("author-placed", { number: this.form.selected + 1 }));
  }

  /** The drawing as the service places it; its table goes into the draft. @param {import("./axes-form.js").Drawing} drawing */
  async #draw(drawing) {
    const answer = await this.#asked({ axes: drawing });
    if (!answer) return;
    if (this.#scene) {
      const { model, picks } = drawnAxes(answer.axes, this.form.selected);
      this.picks = picks;
      this.#scene.model = model;
      this.#scene.describe(t("author-scene-text", { count: answer.axes.length }));
      if (this.drawnCount !== answer.axes.length) this.#scene.reset();
      else this.#scene.settle();
      this.drawnCount = answer.axes.length;
    }
    const own = this.store.source?.axes;
    if (JSON.stringify(own) !== JSON.stringify(drawing)) this.#take(answer.draft, { axes: drawing }, "axes");
    fill(this.table, rowsTable(answer.draft.definition.reference));
  }

  #tableEditor() {
    const editor = /** @type {any} */ (document.createElement("dh-table-editor"));
    void import("../editor/dh-table-editor.js");
    this.editor = editor;
    return [editor, this.#button(() => ({ table: editor.table }))];
  }

  #chain() {
    const columns = SIX.map((name) => ({ name, label: name.toUpperCase(), otherwise: "0" }));
    const joints = new Cells(t("author-start-scm"), columns, {
      rows: [
        { z: "L0", c: "q1" },
        { x: "L1", c: "q2" },
      ],
    });
    const final = new Cells(t("author-scm-final"), columns, { rows: [{ x: "L2" }], fixed: true });
    /** @param {any} row */
    const entries = (row) =>
      Object.fromEntries(
        Object.entries(row)
          .filter(([, text]) => text !== "" && text !== "0")
          .map(([name, text]) => [name, cellValue(text)]),
      );
    return [
      joints.element,
      el("h3", { text: t("author-scm-final") }),
      final.element,
      this.#button(() => ({
        scm: { joints: joints.rows.map(entries), final: entries(final.rows[0]), angle_unit: "deg" },
      })),
    ];
  }

  #urdf() {
    const area = el("textarea", { rows: "8", spellcheck: "false", id: uniqueId("urdf") });
    const file = el("input", {
      type: "file",
      accept: ".urdf,.xml,text/xml,application/xml",
      onchange: async (event) => {
        const [chosen] = event.target.files;
        if (chosen) /** @type {any} */ (area).value = await chosen.text();
      },
    });
    return [
      field(t("author-urdf-file"), file),
      field("URDF", area),
      this.#button(() => ({ urdf: /** @type {any} */ (area).value })),
    ];
  }

  /** @param {() => any} source */
  #button(source) {
    const begin = async () => {
      const asked = source();
      const answer = await this.#asked(asked);
      if (!answer) return;
      this.#take(answer.draft, asked, "");
      this.started();
    };
    return el("div", {}, el("button", { type: "button", class: "primary", onclick: begin, text: t("author-begin") }));
  }

  /** What the service makes of a source; dimensions without a value get one, to be changed later. @param {any} source */
  async #asked(source) {
    try {
      const id = this.store.draft?.id ?? "my-robot";
      const answer = await this.#latest.run((signal) => this.#withValues(id, source, signal));
      if (answer) fill(this.problem);
      return answer?.value ?? null;
    } catch (error) {
      this.#refuse(error);
      return null;
    }
  }

  /** @param {string} id @param {any} source @param {AbortSignal} signal */
  async #withValues(id, source, signal) {
    try {
      return await this.api.post("author/start", { id, source }, { signal });
    } catch (error) {
      const [form] = Object.keys(source);
      const missing = error instanceof Problem ? error.faults.filter(({ code }) => code === "parameter_missing") : [];
      if (!missing.length || missing.length < /** @type {Problem} */ (error).faults.length) throw error;
      const parameters = Object.fromEntries(missing.map(({ params }) => [params.name, NEW_VALUE]));
      return this.api.post("author/start", { id, source: { [form]: { ...source[form], parameters } } }, { signal });
    }
  }

  /** @param {any} draft @param {any} source @param {string} tag */
  #take(draft, source, tag) {
    this.store.load(withRobot(this.store.draft, draft, this.#begun), source, tag);
    this.#begun = [...this.#begun, JSON.stringify(draft.definition.title)].slice(-MOST_BEGUN);
    keep(BEGUN, this.#begun);
  }

  /** Says what is wrong, in a typed table at its cells. @param {unknown} error */
  #refuse(error) {
    const ofTable = this.#way === "table" && error instanceof Problem && error.status < 500;
    const isShown = ofTable && this.editor?.showRefusal(error.faults);
    fill(this.problem, isShown ? null : problemNotice(error));
  }
}

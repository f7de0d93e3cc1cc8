/** From what an exercise is started: a robot of the catalogue, a drawing, a table, an SCM chain, URDF. */

import { Latest, Problem } from "../api.js";
import { announce, el, fill, segmented, uniqueId, VERBATIM } from "../dom.js";
import { t } from "../i18n.js";
import { COLUMNS } from "../editor/model.js";
import { rowsTable } from "../editor/rows-table.js";
import { Cells, cellValue } from "../playground/cells.js";
import { problemNotice } from "../problem.js";
import { keep, recall } from "../storage.js";
import { AxesForm } from "./axes-form.js";
import { drawnAxes } from "./axes-scene.js";
import { field } from "./fields.js";
import { kindsInChain, namedValues } from "./named-values.js";
import { withRobot } from "./robot-change.js";

const WAYS = ["robot", "axes", "table", "scm", "urdf"];
const NEW_CHAIN = {
  joints: [
    { z: "L0", c: "q1" },
    { x: "L1", c: "q2" },
  ],
  final: { x: "L2" },
};
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
  /** The key that the editor was last filled with, as text. */
  #keyShown = "";

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
    const { source } = this.store;
    const axes = source?.axes;
    if (axes) this.form.take(axes);
    this.show(WAYS.find((way) => source?.[way]) ?? (this.#key ? "table" : "robot"));
    if (axes) void this.#draw(axes);
  }

  /** The key of the draft, if it stands there as a table. */
  get #key() {
    const key = this.store.draft?.definition.reference;
    const rows = Array.isArray(key?.rows) ? key.rows : [];
    return key?.convention in COLUMNS && rows.length && rows.every((/** @type {any} */ row) => row) ? key : null;
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

  /** The table as it was typed, or the draft's key if that has become another one. */
  #tableEditor() {
    this.editor ??= document.createElement("dh-table-editor");
    void import("../editor/dh-table-editor.js").then(() => this.#showKey());
    return [this.editor, this.#button(() => ({ table: this.editor.table }))];
  }

  #showKey() {
    const key = this.#key;
    const text = JSON.stringify(key);
    if (!key || text === this.#keyShown) return;
    this.#keyShown = text;
    this.editor.table = key;
  }

  #chain() {
    const columns = SIX.map((name) => ({ name, label: name.toUpperCase(), otherwise: "0" }));
    const begun = this.store.source?.scm;
    const chain = Array.isArray(begun?.joints) ? begun : NEW_CHAIN;
    const joints = new Cells(t("author-start-scm"), columns, { rows: chain.joints });
    const final = new Cells(t("author-scm-final"), columns, { rows: [chain.final], fixed: true });
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
    const area = el("textarea", { rows: "8", ...VERBATIM, id: uniqueId("urdf") });
    if (typeof this.store.source?.urdf === "string") /** @type {any} */ (area).value = this.store.source.urdf;
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
      const names = await this.#kinds(
        source,
        missing.map(({ params }) => String(params.name)),
        signal,
      );
      if (!names.length) throw error;
      const parameters = namedValues(names, source[form], this.store.draft?.definition);
      return this.api.post("author/start", { id, source: { [form]: { ...source[form], parameters } } }, { signal });
    }
  }

  /** Which names are angles, which lengths. @param {any} source @param {string[]} names @param {AbortSignal} signal */
  async #kinds({ table, scm }, names, signal) {
    if (scm) return kindsInChain(scm, names);
    return table ? (await this.api.post("understand", { table }, { signal })).parameters : [];
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

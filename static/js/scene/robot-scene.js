/**
 * `<robot-scene label="…">`: a robot in space, to be turned, zoomed and moved.
 *
 * Properties: `model` (see model.js), `overlay` (a model without joints that is drawn over it, and does not change
 * what the view shows), `joints` (values in radians and lengths), `motion` (joint values it will take, all of which the
 * view has room for). Methods: `layer(name, model)`, `describe(text)`,
 * `picture()`, `enlarge()`.
 * Attributes: `label` (its name for screen readers), `renderer="svg"` (never use WebGL), `grabs` (items with a `pick` can
 * be dragged from one to another).
 * Events: `scene-pick` with `detail.id` when an item with a `pick` is clicked, or something is dropped on it;
 * `scene-drag` with `detail.id` of the item that is nearest while something is dragged, null when it is dropped.
 *
 * It draws as SVG at once, and with WebGL as soon as that is loaded, if the browser has it.
 */

import { announce, el, fill, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { whenIdle } from "../page.js";
import { saveFile } from "../save-file.js";
import { fitted, project, VIEWS } from "./camera.js";
import { listenTo } from "./gestures.js";
import { labelElement, placeLabels } from "./labels.js";
import { drawnPoints, emptyModel, poses, together } from "./model.js";
import { printable } from "./paper.js";
import { pickAt } from "./picking.js";
import { SvgRenderer } from "./svg-renderer.js";
import { toolbar } from "./toolbar.js";

export class RobotScene extends HTMLElement {
  #model = emptyModel();
  /** Models without joints that are drawn over the robot, by name. @type {Map<string, import("./model.js").Model>} */
  #layers = new Map();
  #whole = emptyModel();
  /** @type {number[]} */
  #joints = [];
  /** @type {number[][]} */
  motion = [];
  #camera = {
    ...VIEWS.corner,
    scale: 1,
    target: /** @type {[number, number, number]} */ ([0, 0, 0]),
    width: 320,
    height: 240,
  };
  viewport = /** @type {HTMLElement} */ (/** @type {unknown} */ (null));
  overlayLabels = el("div", { class: "scene-labels", "aria-hidden": "true" });
  description = el("p", { id: uniqueId("scene-text"), class: "visually-hidden" });
  #renderer = /** @type {any} */ (null);
  #labels = /** @type {{element: HTMLElement, item: any}[]} */ ([]);
  #frame = 0;
  #framed = false;
  #touched = false;
  #started = false;
  /** Ends what the window and the screen tell the scene. */
  #listening = new AbortController();
  #seen = new IntersectionObserver((entries) => {
    if (!entries.some((entry) => entry.isIntersecting)) return;
    this.#seen.unobserve(this);
    this.#upgrade();
  });

  connectedCallback() {
    if (!this.#started) this.#start();
    else this.#draw();
    this.#listen();
    if (this.dataset.renderer !== "webgl") this.#seen.observe(this);
  }

  disconnectedCallback() {
    queueMicrotask(() => this.isConnected || this.#leave()); // one that is only moved comes back at once
  }

  #start() {
    this.#started = true;
    this.#build();
    this.#renderer = new SvgRenderer();
    this.#renderer.setModel(this.#whole);
    this.viewport.prepend(this.#renderer.element);
    new ResizeObserver(() => this.#resize()).observe(this.viewport);
    this.#draw();
  }

  /** Listens beyond itself while it is on the page: a scene that has left would be held, and drawn, for ever. */
  #listen() {
    this.#listening.abort();
    this.#listening = new AbortController();
    const { signal } = this.#listening;
    const paper = (/** @type {SvgRenderer} */ renderer) => {
      renderer.setModel(this.#whole);
      renderer.draw(poses(this.#whole, this.#joints), this.#camera);
    };
    printable(this.viewport, paper, signal);
    const recolour = () => {
      this.#renderer.takeColours?.();
      this.#draw();
    };
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", recolour, { signal });
  }

  /** What is shown. Setting it keeps the view, once someone has turned it. */
  get model() {
    return this.#model;
  }

  set model(model) {
    this.#model = model;
    if (!this.#touched) this.#framed = false;
    this.#compose();
  }

  /** What is drawn over the model, in the scene's own coordinates. */
  get overlay() {
    return this.#layers.get("overlay") ?? emptyModel();
  }

  set overlay(overlay) {
    this.layer("overlay", overlay);
  }

  /**
   * Draws a model without joints over the robot, beside what is drawn over it under other names.
   * @param {string} name @param {import("./model.js").Model | null} model null takes it away
   */
  layer(name, model) {
    const before = this.#layers.get(name);
    if (model?.items.length) this.#layers.set(name, model);
    else if (!this.#layers.delete(name)) return;
    if (!this.#touched && isWide(before) !== isWide(model)) this.#framed = false;
    this.#compose();
  }

  /** Every point that is to be in the picture: the robot's, and those of clouds around it. */
  #points() {
    const clouds = [...this.#layers.values()].filter(isWide).flatMap((layer) => drawnPoints(layer, []));
    const robot = [this.#joints, ...this.motion].flatMap((joints) => drawnPoints(this.#model, joints));
    return [...robot, ...clouds];
  }

  #compose() {
    this.#whole = together([this.#model, ...this.#layers.values()]);
    this.#renderer?.setModel(this.#whole);
    this.#labelItems();
    this.#draw();
  }

  /** Joint values [rad or length], all models' side by side. */
  get joints() {
    return this.#joints;
  }

  set joints(values) {
    this.#joints = values;
    this.#draw();
  }

  /** Text that stands for the picture. @param {string} text */
  describe(text) {
    this.description.textContent = text;
  }

  /** Shows the whole scene again, from one of VIEWS. @param {string} [view] */
  reset(view = "corner") {
    Object.assign(this.#camera, VIEWS[view]);
    this.#framed = false;
    this.#touched = false;
    const choice = this.querySelector("select");
    if (choice) choice.value = view;
    this.#draw();
  }

  /** Shows the whole scene again if some of it has moved out of the picture, and nobody has chosen a view. */
  settle() {
    if (this.#touched) return;
    const { width, height } = this.#camera;
    const points = drawnPoints(this.#model, this.#joints).map((point) => project(this.#camera, point));
    if (points.every(({ x, y }) => x > 0 && x < width && y > 0 && y < height)) return;
    this.#framed = false;
    this.#draw();
  }

  #build() {
    this.viewport = el(
      "div",
      {
        class: "scene-view",
        tabindex: "0",
        role: "group",
        "aria-roledescription": t("form-scene-role"),
        "aria-label": this.getAttribute("label") || t("form-scene-label"),
        "aria-describedby": this.description.id,
      },
      this.overlayLabels,
    );
    const gestures = this.#gestures();
    fill(this, this.viewport, toolbar(gestures), this.description);
    listenTo(this.viewport, gestures);
    this.addEventListener("fullscreenchange", () => this.#enlarged(document.fullscreenElement === this));
    this.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && this.classList.contains("enlarged")) this.#enlarged(false);
    });
    this.#labelItems();
  }

  #gestures() {
    return {
      camera: () => this.#camera,
      change: (/** @type {import("./camera.js").Camera} */ camera) => this.#change(camera),
      reset: (/** @type {string} */ view = "corner") => this.reset(view),
      click: (/** @type {PointerEvent} */ event) => this.#click(event),
      grab: (/** @type {PointerEvent} */ event) => this.hasAttribute("grabs") && this.#drag(event, undefined),
      drag: (/** @type {PointerEvent} */ event) => void this.#drag(event, Infinity),
      drop: (/** @type {PointerEvent} */ event) => {
        this.#tell("scene-drag", null);
        if (event.type === "pointerup") this.#click(event, Infinity);
      },
      enlarge: () => this.enlarge(),
      record: () => this.#record(),
    };
  }

  /** Fills the screen with the scene, or the page where a frame does not allow that; a second time goes back. */
  async enlarge() {
    const large = this.classList.contains("enlarged");
    if (document.fullscreenElement === this) return document.exitFullscreen();
    if (!large && document.fullscreenEnabled) {
      const done = await this.requestFullscreen().then(
        () => true,
        () => false,
      );
      if (done) return;
    }
    this.#enlarged(!large);
  }

  /** @param {boolean} large */
  #enlarged(large) {
    this.classList.toggle("enlarged", large);
    this.querySelector(".scene-enlarge")?.setAttribute("aria-pressed", String(large));
  }

  /** The scene as it is seen, as a PNG. @returns {Promise<Blob>} */
  async picture() {
    const { pictureOf } = await import("./record.js");
    return pictureOf(this.viewport, this.#whole, poses(this.#whole, this.#joints), this.#camera);
  }

  async #record() {
    saveFile(await this.picture(), `${this.getAttribute("label") || "robot"}.png`);
    announce(t("form-scene-recorded"));
  }

  /** @param {PointerEvent} event @param {number} [reach] [px] */
  #click(event, reach) {
    const id = this.#pickedBy(event, reach);
    if (id) this.#tell("scene-pick", id);
  }

  /** Whether there is something to drag to. @param {PointerEvent} event @param {number} [reach] [px] */
  #drag(event, reach) {
    const id = this.#pickedBy(event, reach);
    if (id) this.#tell("scene-drag", id);
    return id !== null;
  }

  /** @param {string} name @param {string | null} id */
  #tell(name, id) {
    this.dispatchEvent(new CustomEvent(name, { detail: { id }, bubbles: true }));
  }

  /** @param {PointerEvent} event @param {number} [reach] [px] */
  #pickedBy(event, reach) {
    const box = this.viewport.getBoundingClientRect();
    return this.pickedAt(event.clientX - box.left, event.clientY - box.top, reach);
  }

  /** What a click at a point of the picture means. @param {number} x [px] @param {number} y [px] @param {number} [reach] [px] @returns {string | null} */
  pickedAt(x, y, reach) {
    return pickAt(this.#whole, poses(this.#whole, this.#joints), this.#camera, x, y, reach);
  }

  /** @param {import("./camera.js").Camera} camera */
  #change(camera) {
    this.#camera = camera;
    this.#touched = true;
    this.#framed = true;
    this.#draw();
  }

  #resize() {
    if (this.#measure()) this.#draw();
  }

  /** Takes the picture's size, and shows everything in it unless somebody chose a view; whether it has changed. */
  #measure() {
    const { clientWidth: width, clientHeight: height } = this.viewport;
    if (!width || !height || (width === this.#camera.width && height === this.#camera.height)) return false;
    const factor = Math.min(width, height) / Math.min(this.#camera.width, this.#camera.height);
    this.#camera = { ...this.#camera, width, height, scale: this.#camera.scale * factor };
    if (!this.#touched) this.#framed = false;
    return true;
  }

  #labelItems() {
    const items = this.#whole.items.filter((item) => item.kind === "label");
    this.#labels = items.map((item) => ({ item, element: labelElement(item) }));
    fill(
      this.overlayLabels,
      this.#labels.map(({ element }) => element),
    );
  }

  #draw() {
    if (!this.isConnected || this.#frame) return;
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0;
      this.#measure();
      if (!this.#framed) {
        this.#camera = fitted(this.#camera, this.#points());
        this.#framed = true;
      }
      const found = poses(this.#whole, this.#joints);
      this.#renderer.draw(found, this.#camera);
      placeLabels(this.#labels, found, this.#camera);
      this.dataset.drawn = String(Number(this.dataset.drawn || 0) + 1);
    });
  }

  async #upgrade() {
    if (this.getAttribute("renderer") === "svg" || !hasWebGL()) return this.#say("svg");
    await whenIdle();
    try {
      const { ThreeRenderer } = await import("./three-renderer.js");
      if (!this.isConnected || this.dataset.renderer === "webgl") return;
      const better = new ThreeRenderer();
      this.viewport.prepend(better.element);
      better.setModel(this.#whole);
      better.element.addEventListener("webglcontextlost", () => this.#renderer === better && this.#fallBack());
      this.#renderer.dispose();
      this.#renderer = better;
      this.#say("webgl");
      this.#draw();
    } catch {
      this.#fallBack();
    }
  }

  /** Gives back what WebGL holds: a browser has about sixteen of them, and takes the oldest on the page for the next. */
  #leave() {
    this.#listening.abort();
    this.#seen.unobserve(this);
    if (this.dataset.renderer !== "webgl") return;
    const left = this.#renderer;
    this.#fallBack();
    left.dispose();
  }

  #fallBack() {
    for (const element of this.viewport.querySelectorAll("canvas")) element.remove();
    this.#renderer = new SvgRenderer();
    this.#renderer.setModel(this.#whole);
    this.viewport.prepend(this.#renderer.element);
    this.#say("svg");
    this.#draw();
  }

  /** @param {string} renderer */
  #say(renderer) {
    this.dataset.renderer = renderer;
    this.dispatchEvent(new CustomEvent("scene-ready", { detail: { renderer } }));
  }
}

/** Whether a layer reaches beyond the robot. @param {import("./model.js").Model | null | undefined} model */
function isWide(model) {
  return Boolean(model?.items.some(({ kind }) => kind === "points"));
}

let webgl = /** @type {boolean | null} */ (null);

function hasWebGL() {
  if (webgl === null) {
    const context = document.createElement("canvas").getContext("webgl2");
    webgl = context !== null;
    context?.getExtension("WEBGL_lose_context")?.loseContext();
  }
  return webgl;
}

customElements.define("robot-scene", RobotScene);

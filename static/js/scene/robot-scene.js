/**
 * `<robot-scene label="…">`: a robot in space, to be turned, zoomed and moved.
 *
 * Properties: `model` (see model.js), `joints` (values in radians and lengths), `describe(text)`.
 * Attributes: `label` (its name for screen readers), `renderer="svg"` (never use WebGL).
 * Events: `scene-pick` with `detail.id` when an item with a `pick` is clicked.
 *
 * It draws as SVG at once, and with WebGL as soon as that is loaded, if the browser has it.
 */

import { announce, el, fill, iconButton, svg, uniqueId } from "../dom.js";
import { t } from "../i18n.js";
import { whenIdle } from "../page.js";
import { fitted, orbited, panned, project, VIEWS, zoomed } from "./camera.js";
import { labelElement, placeLabels } from "./labels.js";
import { drawnPoints, emptyModel, poses } from "./model.js";
import { pickAt } from "./picking.js";
import { SvgRenderer } from "./svg-renderer.js";

const TURN = Math.PI / 24;
const ZOOM = 1.2;
const DRAG = 0.008;
const CLICK = 5;

export class RobotScene extends HTMLElement {
  #model = emptyModel();
  /** @type {number[]} */
  #joints = [];
  #camera = { ...VIEWS.corner, scale: 1, target: /** @type {[number, number, number]} */ ([0, 0, 0]), width: 320, height: 240 };
  #renderer = /** @type {any} */ (null);
  #labels = /** @type {{element: HTMLElement, item: any}[]} */ ([]);
  #frame = 0;
  #framed = false;
  #touched = false;
  #text = "";
  #started = false;

  connectedCallback() {
    if (this.#started) return;
    this.#started = true;
    this.#build();
    this.#renderer = new SvgRenderer();
    this.#renderer.setModel(this.#model);
    this.viewport.prepend(this.#renderer.element);
    new ResizeObserver(() => this.#resize()).observe(this.viewport);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      this.#renderer.takeColours?.();
      this.#draw();
    });
    const seen = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      seen.disconnect();
      this.#upgrade();
    });
    seen.observe(this);
    this.#resize();
  }

  /** What is shown. Setting it keeps the view, once someone has turned it. */
  get model() {
    return this.#model;
  }

  set model(model) {
    this.#model = model;
    this.#renderer?.setModel(model);
    this.#labelItems();
    if (!this.#touched) this.#framed = false;
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
    this.#text = text;
    if (this.description) this.description.textContent = text;
  }

  /** Shows the whole scene again, from one of VIEWS. @param {string} [view] */
  reset(view = "corner") {
    Object.assign(this.#camera, VIEWS[view]);
    this.#framed = false;
    this.#touched = false;
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
    this.description = el("p", { id: uniqueId("scene-text"), class: "visually-hidden", text: this.#text });
    this.overlay = el("div", { class: "scene-labels", "aria-hidden": "true" });
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
      this.overlay,
    );
    this.tools = this.#toolbar();
    fill(this, this.viewport, this.tools, this.description);
    this.#listen();
    this.#labelItems();
  }

  #toolbar() {
    const turn = (right, up) => () => this.#change(orbited(this.#camera, right, up));
    const arrow = (degrees) =>
      svg(
        "svg",
        { viewBox: "0 0 24 24", "aria-hidden": "true" },
        svg("path", { d: "M5 14a7 7 0 0 1 14 0m-3.5-2.5L19 14.500l3-3.500", transform: `rotate(${degrees} 12 12)` }),
      );
    const button = (label, onclick, drawing) =>
      el("button", { type: "button", class: "icon quiet", "aria-label": label, title: label, onclick }, drawing);
    const view = el(
      "select",
      {
        "aria-label": t("form-scene-view"),
        onchange: (event) => {
          this.reset(event.target.value);
          announce(t("form-scene-view-now", { view: event.target.selectedOptions[0].textContent }));
        },
      },
      Object.keys(VIEWS).map((name) => el("option", { value: name, text: t(`form-scene-view-${name}`) })),
    );
    return el(
      "div",
      { class: "scene-tools no-print", role: "group", "aria-label": t("form-scene-tools") },
      button(t("form-scene-turn-left"), turn(-TURN * 2, 0), mirrored(arrow(0))),
      button(t("form-scene-turn-right"), turn(TURN * 2, 0), arrow(0)),
      button(t("form-scene-turn-up"), turn(0, TURN * 2), arrow(-90)),
      button(t("form-scene-turn-down"), turn(0, -TURN * 2), mirrored(arrow(-90))),
      iconButton("add", t("form-scene-zoom-in"), () => this.#change(zoomed(this.#camera, ZOOM))),
      button(
        t("form-scene-zoom-out"),
        () => this.#change(zoomed(this.#camera, 1 / ZOOM)),
        svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, svg("path", { d: "M5 12h14" })),
      ),
      iconButton("home", t("form-scene-reset"), () => {
        view.value = "corner";
        this.reset();
      }),
      view,
    );
  }

  #listen() {
    const view = this.viewport;
    view.addEventListener("keydown", (event) => this.#key(event));
    view.addEventListener(
      "wheel",
      (event) => {
        // The page keeps scrolling unless the view was entered or a modifier says that zooming is meant.
        if (document.activeElement !== view && !event.ctrlKey) return;
        event.preventDefault();
        this.#change(zoomed(this.#camera, Math.exp(-event.deltaY * 0.0015)));
      },
      { passive: false },
    );
    /** @type {Map<number, {x: number, y: number}>} */
    const fingers = new Map();
    let moved = 0;
    view.addEventListener("pointerdown", (event) => {
      fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      if (fingers.size === 1) moved = 0;
      view.setPointerCapture(event.pointerId);
    });
    view.addEventListener("pointermove", (event) => {
      const last = fingers.get(event.pointerId);
      if (!last) return;
      const dx = event.clientX - last.x;
      const dy = event.clientY - last.y;
      moved += Math.abs(dx) + Math.abs(dy);
      const before = spread(fingers);
      fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      if (fingers.size === 2) {
        const after = spread(fingers);
        const near = before > 0 ? zoomed(this.#camera, after / before) : this.#camera;
        this.#change(panned(near, dx / 2, dy / 2));
      } else if (event.shiftKey || event.buttons === 4) this.#change(panned(this.#camera, dx, dy));
      else this.#change(orbited(this.#camera, -dx * DRAG, dy * DRAG));
    });
    const lift = (event) => {
      if (!fingers.delete(event.pointerId)) return;
      if (event.type === "pointerup" && moved < CLICK) this.#click(event);
    };
    view.addEventListener("pointerup", lift);
    view.addEventListener("pointercancel", lift);
  }

  #click(event) {
    const box = this.viewport.getBoundingClientRect();
    const found = poses(this.#model, this.#joints);
    const id = pickAt(this.#model, found, this.#camera, event.clientX - box.left, event.clientY - box.top);
    if (id) this.dispatchEvent(new CustomEvent("scene-pick", { detail: { id }, bubbles: true }));
  }

  #key(event) {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const pan = event.shiftKey ? 24 : 0;
    /** @type {Record<string, () => void>} */
    const keys = {
      ArrowLeft: () => this.#change(pan ? panned(this.#camera, pan, 0) : orbited(this.#camera, -TURN, 0)),
      ArrowRight: () => this.#change(pan ? panned(this.#camera, -pan, 0) : orbited(this.#camera, TURN, 0)),
      ArrowUp: () => this.#change(pan ? panned(this.#camera, 0, pan) : orbited(this.#camera, 0, TURN)),
      ArrowDown: () => this.#change(pan ? panned(this.#camera, 0, -pan) : orbited(this.#camera, 0, -TURN)),
      "+": () => this.#change(zoomed(this.#camera, ZOOM)),
      "=": () => this.#change(zoomed(this.#camera, ZOOM)),
      "-": () => this.#change(zoomed(this.#camera, 1 / ZOOM)),
      0: () => this.reset(),
      Home: () => this.reset(),
    };
    const action = keys[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  }

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
    if (!this.overlay) return;
    const items = this.#model.items.filter((item) => item.kind === "label");
    this.#labels = items.map((item) => ({ item, element: labelElement(item) }));
    fill(this.overlay, this.#labels.map(({ element }) => element));
  }

  #draw() {
    if (!this.isConnected || this.#frame) return;
    this.#frame = requestAnimationFrame(() => {
      this.#frame = 0;
      this.#measure();
      if (!this.#framed) {
        this.#camera = fitted(this.#camera, drawnPoints(this.#model, this.#joints));
        this.#framed = true;
      }
      const found = poses(this.#model, this.#joints);
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
      const better = new ThreeRenderer();
      this.viewport.prepend(better.element);
      better.setModel(this.#model);
      better.element.addEventListener("webglcontextlost", () => this.#fallBack(), { once: true });
      this.#renderer.dispose();
      this.#renderer = better;
      this.#say("webgl");
      this.#draw();
    } catch {
      this.#fallBack();
    }
  }

  #fallBack() {
    for (const element of this.viewport.querySelectorAll("canvas")) element.remove();
    this.#renderer = new SvgRenderer();
    this.#renderer.setModel(this.#model);
    this.viewport.prepend(this.#renderer.element);
    this.#say("svg");
    this.#draw();
  }

  #say(renderer) {
    this.dataset.renderer = renderer;
    this.dispatchEvent(new CustomEvent("scene-ready", { detail: { renderer } }));
  }
}

function spread(fingers) {
  if (fingers.size < 2) return 0;
  const [a, b] = [...fingers.values()];
  return Math.hypot(a.x - b.x, a.y - b.y);
}

function mirrored(drawing) {
  drawing.setAttribute("class", "mirrored");
  return drawing;
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


/**
 * The dimensions of the figure, dragged to where they read well: with the mouse, by touch, or with the arrow keys.
 * A line stands only at places of which the service says that it can; the nearest is taken. Backspace leaves the place
 * to the service again.
 */

import { announce, el, fill } from "../dom.js";
import { t } from "../i18n.js";

/**
 * @typedef {[number, number]} Point on the paper, in the units of the figure's SVG
 * @typedef {{offset: number[], shift: Point}} Way
 * @typedef {{mark: any, ends: [Point, Point], line: [Point, Point], label: Point, ways: Way[]}} Line
 * @typedef {{box: number[], distances: number[], usual: number, lines: Line[]}} Dimensions
 */

const PATH = ["definition", "figure", "dimensions"];
const SVG = "http://www.w3.org/2000/svg";
const ROUND = 100;

export class DimensionHandles {
  /** @param {import("./draft-store.js").DraftStore} store @param {HTMLElement} place over the figure, of its size */
  constructor(store, place) {
    this.store = store;
    this.place = place;
    /** @type {Dimensions | null} */
    this.dimensions = null;
    this.dragged = false;
  }

  /** @param {Dimensions} dimensions as the service has drawn them */
  show(dimensions) {
    if (this.dragged) return;
    const focused = this.place.contains(document.activeElement)
      ? document.activeElement?.getAttribute("data-dimension")
      : null;
    this.dimensions = dimensions;
    this.preview = document.createElementNS(SVG, "svg");
    this.preview.setAttribute("viewBox", dimensions.box.join(" "));
    this.preview.setAttribute("aria-hidden", "true");
    fill(
      this.place,
      this.preview,
      dimensions.lines.map((line, i) => this.#handle(line, i)),
    );
    if (focused !== null)
      /** @type {HTMLElement | null} */ (this.place.querySelector(`[data-dimension="${focused}"]`))?.focus();
  }

  /** @param {Line} line @param {number} i */
  #handle(line, i) {
    const [left, top, width, height] = /** @type {Dimensions} */ (this.dimensions).box;
    const name = line.mark.name;
    const handle = el("button", {
      type: "button",
      class: "dimension-handle",
      dataset: { dimension: String(i) },
      "aria-label": t("author-dimension-handle", { name }),
      title: t("author-dimension-handle", { name }),
    });
    handle.style.left = `${(100 * (line.label[0] - left)) / width}%`;
    handle.style.top = `${(100 * (line.label[1] - top)) / height}%`;
    handle.addEventListener("keydown", (event) => this.#keys(event, i));
    handle.addEventListener("pointerdown", (event) => this.#drag(event, i));
    return handle;
  }

  /** @param {PointerEvent} event @param {number} i */
  #drag(event, i) {
    if (event.button !== 0 || !this.dimensions) return;
    event.preventDefault();
    const handle = /** @type {HTMLElement} */ (event.currentTarget);
    handle.setPointerCapture(event.pointerId);
    handle.focus({ preventScroll: true });
    this.dragged = true;
    /** @type {ReturnType<DimensionHandles["nearest"]> | null} */
    let found = null;
    const move = (/** @type {PointerEvent} */ { clientX, clientY }) => {
      found = this.nearest(i, this.#onPaper(clientX, clientY));
      this.#drawn(i, found);
    };
    const end = (/** @type {Event} */ { type }) => {
      handle.removeEventListener("pointermove", move);
      for (const name of ["pointerup", "pointercancel"]) handle.removeEventListener(name, end);
      this.dragged = false;
      this.preview?.replaceChildren();
      if (found && type === "pointerup") this.#take(i, found);
    };
    handle.addEventListener("pointermove", move);
    for (const name of ["pointerup", "pointercancel"]) handle.addEventListener(name, end);
  }

  /** @param {number} x @param {number} y @returns {Point} */
  #onPaper(x, y) {
    const { left, top, width, height } = this.place.getBoundingClientRect();
    const box = /** @type {Dimensions} */ (this.dimensions).box;
    return [box[0] + (box[2] * (x - left)) / width, box[1] + (box[3] * (y - top)) / height];
  }

  /** The way and the distance whose line runs nearest to a point of the paper. @param {number} i @param {Point} at */
  nearest(i, at) {
    const { lines, distances } = /** @type {Dimensions} */ (this.dimensions);
    const { ends, ways } = lines[i];
    let best = { way: 0, distance: distances[1], off: Infinity };
    ways.forEach(({ shift }, way) => {
      for (const distance of distances) {
        const off = toLine(at, moved(ends[0], shift, distance), moved(ends[1], shift, distance));
        if (off < best.off - 1e-6) best = { way, distance, off };
      }
    });
    return best;
  }

  /** @param {KeyboardEvent} event @param {number} i */
  #keys(event, i) {
    const { lines, distances, usual } = /** @type {Dimensions} */ (this.dimensions);
    const { ways, mark } = lines[i];
    if (["Backspace", "Delete"].includes(event.key)) {
      event.preventDefault();
      const { offset: _offset, distance: _distance, ...rest } = this.#marks()[i];
      this.#become(i, rest);
      return announce(t("author-dimension-free", { name: mark.name }));
    }
    const turn = { ArrowLeft: -1, ArrowRight: 1 }[event.key] ?? 0;
    const away = { ArrowUp: 1, ArrowDown: -1 }[event.key] ?? 0;
    if (!turn && !away) return undefined;
    event.preventDefault();
    const now = this.#now(i);
    const far = distances.indexOf(now.distance);
    const distance = distances[Math.max(0, Math.min(distances.length - 1, far + away))];
    return this.#take(i, { way: (now.way + turn + ways.length) % ways.length, distance: distance ?? usual });
  }

  /** Where a line stands, or was just put, among the places that there are. @param {number} i */
  #now(i) {
    const { lines, distances, usual } = /** @type {Dimensions} */ (this.dimensions);
    const { ends, line, ways } = lines[i];
    const mark = this.#marks()[i];
    const wished = ways.findIndex(({ offset }) => JSON.stringify(offset) === JSON.stringify(mark.offset));
    const apart = (/** @type {number} */ distance) => Math.abs(distance - (mark.distance ?? 1) * usual);
    if (wished >= 0) {
      const distance = distances.reduce((best, each) => (apart(each) < apart(best) ? each : best));
      return { way: wished, distance };
    }
    let best = { way: 0, distance: distances[1], off: Infinity };
    ways.forEach(({ shift }, way) => {
      for (const distance of distances) {
        const [x, y] = moved(ends[0], shift, distance);
        const off = Math.hypot(x - line[0][0], y - line[0][1]);
        if (off < best.off - 1e-6) best = { way, distance, off };
      }
    });
    return best;
  }

  /** @param {number} i @param {{way: number, distance: number}} found */
  #take(i, { way, distance }) {
    const { lines, usual } = /** @type {Dimensions} */ (this.dimensions);
    const { offset } = lines[i].ways[way];
    this.#become(i, { ...this.#marks()[i], offset, distance: Math.round((ROUND * distance) / usual) / ROUND });
    announce(t("author-dimension-moved", { name: lines[i].mark.name }));
  }

  /** The dimensions as the definition has them, or would have them. @returns {any[]} */
  #marks() {
    return this.store.at(PATH) ?? /** @type {Dimensions} */ (this.dimensions).lines.map(({ mark }) => mark);
  }

  /** @param {number} i @param {any} mark */
  #become(i, mark) {
    this.store.set(
      PATH,
      this.#marks().map((entry, k) => (k === i ? mark : entry)),
    );
  }

  /** The line where it would stand. @param {number} i @param {{way: number, distance: number}} found */
  #drawn(i, { way, distance }) {
    const { ends, ways } = /** @type {Dimensions} */ (this.dimensions).lines[i];
    const [a, b] = ends.map((point) => moved(point, ways[way].shift, distance));
    const line = document.createElementNS(SVG, "line");
    for (const [name, value] of Object.entries({ x1: a[0], y1: a[1], x2: b[0], y2: b[1] }))
      line.setAttribute(name, String(value));
    this.preview?.replaceChildren(line);
  }
}

/** @param {Point} point @param {Point} shift @param {number} distance @returns {Point} */
const moved = ([x, y], [dx, dy], distance) => [x + dx * distance, y + dy * distance];

/** Distance of a point from a line between two others. @param {Point} p @param {Point} a @param {Point} b */
function toLine([x, y], [ax, ay], [bx, by]) {
  const [ux, uy] = [bx - ax, by - ay];
  const share = Math.max(0, Math.min(1, ((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy || 1)));
  return Math.hypot(x - ax - share * ux, y - ay - share * uy);
}

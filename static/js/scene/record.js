/** A scene as a picture to keep: drawn as SVG with its names, whatever it is shown with, and turned into a PNG. */

import { svg } from "../dom.js";
import { SvgRenderer } from "./svg-renderer.js";

const SCALE = 2;
const PAINT = ["stroke", "fill", "stroke-width", "stroke-linecap", "stroke-dasharray", "stroke-opacity"];

/**
 * @param {HTMLElement} viewport in which the scene is shown: its colours and names are taken from there
 * @param {import("./model.js").Model} model @param {import("./matrix.js").Matrix[]} found poses of its nodes
 * @param {import("./camera.js").Camera} camera
 * @returns {Promise<Blob>} a PNG
 */
export async function pictureOf(viewport, model, found, camera) {
  const renderer = new SvgRenderer();
  renderer.setModel(model);
  renderer.element.setAttribute("class", "scene-svg scene-recorded");
  viewport.append(renderer.element);
  renderer.draw(found, camera);
  const text = serialized(renderer.element, viewport, camera);
  renderer.dispose();
  const image = new Image();
  const loaded = new Promise((resolve, reject) => {
    image.addEventListener("load", resolve);
    image.addEventListener("error", reject);
  });
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await loaded;
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { width: camera.width * SCALE, height: camera.height * SCALE });
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("no picture"))), "image/png"),
  );
}

/** @param {Element} drawing @param {HTMLElement} viewport @param {import("./camera.js").Camera} camera */
function serialized(drawing, viewport, { width, height }) {
  const copy = /** @type {SVGElement} */ (drawing.cloneNode(true));
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(width * SCALE));
  copy.setAttribute("height", String(height * SCALE));
  const shapes = drawing.querySelectorAll("*");
  copy.querySelectorAll("*").forEach((shape, i) => {
    const style = getComputedStyle(shapes[i]);
    for (const name of PAINT) shape.setAttribute(name, style.getPropertyValue(name));
  });
  const ground = getComputedStyle(viewport).getPropertyValue("--surface").trim();
  copy.prepend(svg("rect", { x: 0, y: 0, width, height, fill: ground || "#fff" }));
  copy.append(...namesIn(viewport));
  return new XMLSerializer().serializeToString(copy);
}

/** The names as they stand over the scene. @param {HTMLElement} viewport */
function namesIn(viewport) {
  const box = viewport.getBoundingClientRect();
  const labels = /** @type {NodeListOf<HTMLElement>} */ (viewport.querySelectorAll(".scene-label:not([hidden])"));
  return [...labels].map((label) => {
    const at = label.getBoundingClientRect();
    const style = getComputedStyle(label);
    const place = { x: at.x + at.width / 2 - box.x, y: at.y + at.height / 2 - box.y + 4 };
    const [text, sub] = [label.firstChild?.textContent ?? "", label.querySelector("sub")?.textContent];
    return svg(
      "text",
      {
        ...place,
        fill: style.color,
        "text-anchor": "middle",
        "font-size": 14,
        "font-style": style.fontStyle,
        "font-family": "serif",
      },
      text,
      sub ? svg("tspan", { dy: 4, "font-size": 10, "font-style": "normal" }, sub) : null,
    );
  });
}

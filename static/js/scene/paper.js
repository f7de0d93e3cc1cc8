/** Scenes on paper: what WebGL draws is blank there, and a page has another width than the window. */

import { SvgRenderer } from "./svg-renderer.js";

/**
 * Has a scene printed as SVG, in the size that it has in the window, with its labels where they are.
 * @param {HTMLElement} viewport
 * @param {(renderer: SvgRenderer) => void} draw draws what is shown
 * @param {AbortSignal} signal ends it
 */
export function printable(viewport, draw, signal) {
  const before = () => {
    const { clientWidth: width, clientHeight: height } = viewport;
    if (!width || !height) return;
    const paper = new SvgRenderer();
    paper.element.classList.add("scene-paper");
    viewport.prepend(paper.element);
    viewport.classList.add("printed");
    viewport.style.inlineSize = `${width}px`;
    viewport.style.blockSize = `${height}px`;
    draw(paper);
    const after = () => {
      paper.dispose();
      viewport.classList.remove("printed");
      viewport.style.inlineSize = "";
      viewport.style.blockSize = "";
    };
    addEventListener("afterprint", after, { once: true });
  };
  addEventListener("beforeprint", before, { signal });
}

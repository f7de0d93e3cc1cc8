/**
 * Figure and own robot in sight while a table is typed: beside it on wide screens, in a strip above it on others,
 * where they stand in the page otherwise; and cells and picture that light each other.
 */

const $ = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));

const wide = matchMedia("(min-width: 64rem)");

/** On wide screens figure and robot stand beside the answer; in the document, always where they are read. */
export function arrangePictures() {
  const place = () => {
    if (wide.matches) $("own-side").append($("figure-card"), $("own-card"));
    else {
      $("statement-card").after($("figure-card"));
      $("answer-card").after($("own-card"));
    }
  };
  wide.addEventListener("change", () => (pinned(false), place()));
  place();
  const answer = $("answer");
  answer.addEventListener("focusin", (event) => {
    if (wide.matches || !isField(event.target)) return;
    pinned(true);
    /** @type {Element} */ (event.target).scrollIntoView({ block: "nearest" });
  });
  answer.addEventListener("focusout", (event) => {
    if (!isField(event.relatedTarget) && !answer.contains(/** @type {Node | null} */ (event.relatedTarget)))
      pinned(false);
  });
}

/** @param {EventTarget | null} target */
function isField(target) {
  return target instanceof HTMLInputElement && target.type === "text" && target.closest("dh-table-editor") !== null;
}

/** Shows the pictures in a strip above what is typed. Their cards keep their height, so that nothing moves. @param {boolean} on */
function pinned(on) {
  const root = document.documentElement;
  if (root.classList.contains("typing") === on) return;
  for (const card of [$("figure-card"), $("own-card")]) card.style.minHeight = on ? `${card.offsetHeight}px` : "";
  root.classList.toggle("typing", on);
}

/**
 * The film follows the cell that has the focus, and a click on what a cell is drawn as leads to the cell.
 * @param {import("../editor/dh-table-editor.js").DhTableEditor} editor @param {import("./own-card.js").OwnCard} own
 */
export function connect(editor, own) {
  const detail = (/** @type {Event} */ event) => /** @type {CustomEvent} */ (event).detail;
  editor.addEventListener("cell-focus", (event) => own.film.show(detail(event).row, detail(event).cell));
  editor.addEventListener("row-play", (event) => own.film.play(detail(event).row));
  own.scene.addEventListener("scene-pick", (event) => {
    const [row, cell] = detail(event).id.split("/");
    if (cell) editor.focusCell(Number(row), cell);
  });
}

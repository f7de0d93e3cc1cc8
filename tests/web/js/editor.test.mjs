import assert from "node:assert/strict";
import { test } from "node:test";

/** As much of an element as the table editor asks for. */
class Element extends EventTarget {
  dataset = {};
  children = [];
  classList = { toggle() {} };
  isConnected = true;
  #text = "";
  get textContent() {
    return this.#text + this.children.map((child) => child.textContent ?? "").join("");
  }
  set textContent(text) {
    this.children = [];
    this.#text = text;
  }
  setAttribute() {}
  removeAttribute() {}
  focus() {}
  querySelector() {
    return null;
  }
  contains() {
    return false;
  }
  closest(name) {
    return name === this.name ? this : null;
  }
  appendChild(child) {
    this.children.push(child);
    child.parentElement = this;
    return child;
  }
  insertBefore(child, before) {
    this.children = this.children.filter((each) => each !== child);
    this.children.splice(before ? this.children.indexOf(before) : this.children.length, 0, child);
  }
  replaceChildren() {
    this.children = [];
  }
  remove() {}
}

const announcer = new Element();
globalThis.HTMLElement = Element;
globalThis.HTMLInputElement = Element;
globalThis.customElements = { define() {} };
globalThis.requestAnimationFrame = (run) => run();
globalThis.location = new URL("https://example.org/exercises/scara");
globalThis.document = {
  documentElement: { dataset: {}, lang: "en" },
  createElement: (name) => Object.assign(new Element(), { name }),
  createElementNS: (_, name) => Object.assign(new Element(), { name }),
  createTextNode: (text) => ({ textContent: text }),
  getElementById: (id) => (id === "announcer" ? announcer : null),
};
const { DhTableEditor } = await import("../../../static/js/editor/dh-table-editor.js");

/** An editor on the page, and every button in it by the text or the name that it has. */
function editorOf() {
  const editor = new DhTableEditor();
  editor.connectedCallback();
  const all = (element) => [element, ...(element.children ?? []).flatMap(all)];
  const press = (text) =>
    all(editor)
      .find((each) => each.name === "button" && each.textContent === text)
      .dispatchEvent(new Event("click"));
  return { editor, press };
}

/** Control and Z, pressed in an element inside the editor. @param {any} editor @param {string} name */
function undoIn(editor, name) {
  const event = new Event("keydown", { cancelable: true });
  Object.assign(event, { ctrlKey: true, key: "z" });
  Object.defineProperty(event, "target", { value: Object.assign(new Element(), { name }) });
  editor.dispatchEvent(event);
  return event;
}

test("undo in the dialog for a pasted table is that of its text, and leaves the table alone", () => {
  const { editor, press } = editorOf();
  press("+ form-row-add");
  const { rows } = editor.table;
  assert.equal(rows.length, 2);
  assert.ok(!undoIn(editor, "dialog").defaultPrevented);
  assert.deepEqual(editor.table.rows, rows);
  assert.ok(undoIn(editor, "input").defaultPrevented);
  assert.equal(editor.table.rows.length, 1);
});

test("a new table is read out once", () => {
  const { editor, press } = editorOf();
  announcer.textContent = "";
  press("form-new");
  assert.match(editor.notice.textContent, /form-new-done/);
  assert.equal(announcer.textContent, "");
});

/** A page of elements that know where they stand, and that lose the focus when they are taken out or moved. */

import "./silent-page.mjs";

export class Element extends EventTarget {
  children = [];
  parent = null;
  value = "";
  hidden = false;
  dataset = {};
  attributes = new Map();
  #text = "";
  constructor(tag) {
    super();
    this.tag = tag;
  }
  get all() {
    return [this, ...this.children.flatMap((child) => child.all)];
  }
  get isConnected() {
    return this === globalThis.document.body || Boolean(this.parent?.isConnected);
  }
  get textContent() {
    return this.children.map((child) => child.textContent).join("") || this.#text;
  }
  set textContent(text) {
    this.replaceChildren();
    this.#text = text;
  }
  get firstChild() {
    return this.children[0] ?? null;
  }
  get firstElementChild() {
    return this.firstChild;
  }
  get lastElementChild() {
    return this.children.at(-1) ?? null;
  }
  contains(other) {
    return this.all.includes(other);
  }
  getAttribute(name) {
    return this.attributes.get(name) ?? null;
  }
  setAttribute(name, value) {
    this.attributes.set(name, value);
  }
  remove() {
    if (this.contains(globalThis.document.activeElement)) globalThis.document.activeElement = globalThis.document.body;
    this.parent?.children.splice(this.parent.children.indexOf(this), 1);
    this.parent = null;
  }
  insertBefore(child, next) {
    child.remove();
    this.children.splice(next ? this.children.indexOf(next) : this.children.length, 0, child);
    child.parent = this;
    return child;
  }
  appendChild(child) {
    return this.insertBefore(child, null);
  }
  append(child) {
    this.insertBefore(child, null);
  }
  prepend(child) {
    this.insertBefore(child, this.firstChild);
  }
  replaceChild(fresh, child) {
    this.insertBefore(fresh, child);
    child.remove();
  }
  replaceChildren() {
    this.#text = "";
    for (const child of [...this.children]) child.remove();
  }
  querySelector() {
    return this.all.find(({ attributes }) => attributes.get("role") === "status");
  }
  scrollIntoView() {}
  focus() {
    if (this.isConnected && !this.hidden) globalThis.document.activeElement = this;
  }
  /** The first of these within, as a reader would point at it. */
  find(wanted) {
    return this.all.find(wanted);
  }
}

const body = new Element("body");
const places = new Map();
Object.assign(globalThis.document, {
  body,
  activeElement: body,
  createElement: (tag) => new Element(tag),
  createTextNode: (text) => Object.assign(new Element("#text"), { textContent: text }),
  getElementById: (id) => places.get(id) ?? null,
  querySelectorAll: () => [],
  addEventListener() {},
});
globalThis.window = globalThis;
globalThis.addEventListener = () => {};

/** An element of the page by its id. */
export function placed(id) {
  places.set(id, body.appendChild(new Element(id)));
  return places.get(id);
}

/** Lets the page go on until something is there, for a minute at most. */
export async function until(found) {
  const end = performance.now() + 60_000;
  while (!found() && performance.now() < end) await new Promise((done) => setTimeout(done));
  return found();
}

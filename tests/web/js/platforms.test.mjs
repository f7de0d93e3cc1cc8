import assert from "node:assert/strict";
import { test } from "node:test";
import "./silent-page.mjs";

/** As much of an element as the page asks for. */
class Element extends EventTarget {
  children = [];
  value = "";
  textContent = "";
  attributes = new Map();
  constructor(tag) {
    super();
    this.tag = tag;
  }
  get all() {
    return [this, ...this.children.flatMap((child) => child.all ?? [])];
  }
  setAttribute(name, value) {
    this.attributes.set(name, value);
  }
  appendChild(child) {
    this.children.push(child);
  }
  replaceChildren() {
    this.children = [];
  }
  querySelector() {
    return this.all.find(({ attributes }) => attributes.get("role") === "status");
  }
  scrollIntoView() {}
}
const places = new Map(
  ["platforms-problem", "list", "invite-card", "invite", "add-card", "add"].map((id) => [id, new Element(id)]),
);
Object.assign(globalThis.document, {
  createElement: (tag) => new Element(tag),
  createTextNode: () => new Element("#text"),
  getElementById: (id) => places.get(id) ?? null,
  querySelectorAll: () => [],
  addEventListener() {},
});
globalThis.window = globalThis;
globalThis.addEventListener = () => {};
globalThis.history = { replaceState() {} };
globalThis.location = new URL("https://example.org/platforms#code=once");
const settled = () => new Promise((done) => setTimeout(done, 20));

const PLATFORM = { id: 1, issuer: "https://lms", client_id: "c", name: "", deployments: [], not_fetched: [] };
const ANSWERS = {
  "POST open": { token: "t" },
  "GET platforms": { platforms: [{ ...PLATFORM, status: "active", names_shared: false }], invitations: [] },
  "POST invitations": { address: "https://example.org/invitation" },
  "PUT 1": {},
};
globalThis.fetch = async (address, { method = "GET" } = {}) => {
  const last = String(address).split("/").at(-1);
  return last.includes(".ftl") ? new Response("") : Response.json(ANSWERS[`${method} ${last}`]);
};

test("the address of an invitation, which is told once, and a note that is typed stay when a platform is changed", async () => {
  await import("../../../static/js/pages/platforms.js");
  await settled();
  const invite = places.get("invite");
  const find = (place, wanted) => place.all.find(wanted);
  find(invite, ({ tag }) => tag === "form").dispatchEvent(new Event("submit", { cancelable: true }));
  await settled();
  find(invite, ({ tag }) => tag === "input").value = "for the next one";
  find(places.get("list"), ({ textContent }) => textContent === "platforms-disable").dispatchEvent(new Event("click"));
  await settled();
  assert.ok(find(invite, ({ textContent }) => textContent === ANSWERS["POST invitations"].address));
  assert.equal(find(invite, ({ tag }) => tag === "input").value, "for the next one");
});

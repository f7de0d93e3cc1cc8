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
/** Lets the page go on until something is there. */
const until = async (found) => {
  for (let turn = 0; turn < 5000 && !found(); turn += 1) await new Promise((done) => setTimeout(done));
  return found();
};

const PLATFORM = { id: 1, issuer: "https://lms", client_id: "c", name: "", deployments: [], not_fetched: [] };
const ANSWERS = {
  "POST open": { token: "t" },
  "GET platforms": { platforms: [{ ...PLATFORM, status: "active", names_shared: false }], invitations: [] },
  "POST invitations": { address: "https://example.org/invitation" },
  "PUT 1": {},
};
let lists = 0;
const isAddress = ({ textContent }) => textContent === ANSWERS["POST invitations"].address;
globalThis.fetch = async (address, { method = "GET" } = {}) => {
  const last = String(address).split("/").at(-1);
  if (`${method} ${last}` === "GET platforms") lists += 1;
  return last.includes(".ftl") ? new Response("") : Response.json(ANSWERS[`${method} ${last}`]);
};

test("the address of an invitation, which is told once, and a note that is typed stay when a platform is changed", async () => {
  await import("../../../static/js/pages/platforms.js");
  const invite = places.get("invite");
  const find = (place, wanted) => place.all.find(wanted);
  const form = await until(() => find(invite, ({ tag }) => tag === "form"));
  await until(() => find(places.get("list"), ({ textContent }) => textContent === "platforms-disable"));
  form.dispatchEvent(new Event("submit", { cancelable: true }));
  await until(() => find(invite, isAddress));
  await until(() => lists === 2);
  find(invite, ({ tag }) => tag === "input").value = "for the next one";
  find(places.get("list"), ({ textContent }) => textContent === "platforms-disable").dispatchEvent(new Event("click"));
  await until(() => lists === 3);
  for (let i = 0; i < 50; i += 1) await new Promise((done) => setImmediate(done));
  assert.ok(find(invite, isAddress));
  assert.equal(find(invite, ({ tag }) => tag === "input").value, "for the next one");
});

import assert from "node:assert/strict";
import { test } from "node:test";
import { Problem } from "../../../static/js/api.js";
import { element } from "./silent-page.mjs";

globalThis.HTMLElement = class {};
globalThis.customElements = { define() {} };
globalThis.matchMedia = () => ({ matches: false });
const { LinkView } = await import("../../../static/js/lecturer/link-view.js");
const { studentName } = await import("../../../static/js/lecturer/class-view.js");

const settled = () => new Promise((done) => setTimeout(done));

test("a link whose answer comes after that of another one is not drawn, and has no form to save", async () => {
  const asked = [];
  const get = (path) => new Promise((answer, refuse) => asked.push({ path, answer, refuse }));
  let drawn = 0;
  const places = { card: {}, heading: {}, body: { replaceChildren: () => (drawn += 1), appendChild() {} } };
  const view = new LinkView({ get }, [], places, {});
  const slow = view.show({ id: 1, title: "first" });
  const quick = view.show({ id: 2, title: "second" });
  await settled();
  const of = (id) => asked.find(({ path }) => path === `course/links/${id}/settings`);
  of(2).refuse(new Problem(404, { code: "link_unknown" }));
  assert.equal(await quick, true);
  assert.deepEqual([view.link.id, places.heading.textContent, drawn], [2, "second", 1]);
  of(1).answer({ exercise: null, parts: [], version: 1 });
  await settled();
  asked.find(({ path }) => path === "course/links/1/statistics")?.answer({});
  assert.equal(await slow, false);
  assert.deepEqual([view.link.id, places.heading.textContent, drawn], [2, "second", 1]);
});

test("until a link's rules are here, what is saved is saved for the link that stands there", async () => {
  const get = () => new Promise(() => {});
  const places = { card: {}, heading: { textContent: "first" }, body: element() };
  const view = new LinkView({ get }, [], places, {});
  view.link = { id: 1 };
  void view.show({ id: 2, title: "second" });
  await settled();
  assert.deepEqual([view.link.id, places.heading.textContent], [1, "first"]);
});

test("two students of one name are told apart, and each by what a lecturer exports and erases by", () => {
  const keys = ["0123456789abcdef", "fedcba9876543210"];
  const names = keys.map((key) => studentName({ name: "Ann Lee", key }));
  assert.deepEqual(names, ["Ann Lee (01234567)", "Ann Lee (fedcba98)"]);
  assert.equal(studentName({ name: null, key: keys[0] }), "01234567");
});

import assert from "node:assert/strict";
import { test } from "node:test";
import { placed, until } from "./live-page.mjs";

const ids = ["platforms-problem", "list-heading", "list", "invite-card", "invite", "add-card", "add"];
const places = new Map(ids.map((id) => [id, placed(id)]));
globalThis.history = { replaceState() {} };
globalThis.location = new URL("https://example.org/platforms#code=once");

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

test("the focus and what is typed in another row stay when a platform is changed or removed", async () => {
  const list = places.get("list");
  const button = (text, row = list) => row.find((each) => each.tag === "button" && each.textContent === text);
  const rows = () => list.all.filter(({ tag, parent }) => tag === "tr" && parent.tag === "tbody");
  const answer = (...platforms) => (ANSWERS["GET platforms"] = { platforms, invitations: [] });
  const first = { ...PLATFORM, status: "active", names_shared: false };
  const second = { ...first, id: 2, issuer: "https://other" };
  const press = async (pressed) => {
    const before = lists;
    pressed.focus();
    pressed.dispatchEvent(new Event("click"));
    await until(() => lists > before);
    for (let i = 0; i < 50; i += 1) await new Promise((done) => setImmediate(done));
  };
  globalThis.confirm = () => true;
  ANSWERS["DELETE 1"] = ANSWERS["DELETE 2"] = {};
  answer(first, second);
  await press(button("platforms-disable"));
  const typed = rows()[1].find(({ tag }) => tag === "input");
  typed.value = "17";
  answer({ ...first, status: "disabled" }, second);
  const turning = button("platforms-disable");
  await press(turning);
  assert.equal(globalThis.document.activeElement, turning);
  assert.equal(turning.textContent, "platforms-activate");
  answer(second);
  await press(button("platforms-remove"));
  assert.ok(list.contains(globalThis.document.activeElement));
  assert.deepEqual([rows().length, rows()[0].contains(typed), typed.value], [1, true, "17"]);
  answer();
  await press(button("platforms-remove"));
  assert.equal(globalThis.document.activeElement, globalThis.document.getElementById("list-heading"));
});

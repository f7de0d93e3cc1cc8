import assert from "node:assert/strict";
import { test } from "node:test";
import { Element, placed } from "./live-page.mjs";

const { ClassView, UndeliveredView } = await import("../../../static/js/lecturer/class-view.js");
const heading = placed("class-heading");
const press = (button) => (button.focus(), button.dispatchEvent(new Event("click")));

test("the class is brought up to date under whoever reads it, and opens what there is now", () => {
  const opened = [];
  const openLink = (link) => opened.push(link.exercise);
  const openStudent = (link, student) => opened.push([link.exercise, student.links[1].attempts]);
  const view = new ClassView(placed("class"), heading, { openLink, openStudent, openState() {} });
  const link = { id: 1, title: "Arm", exercise: "scara", exercise_title: "SCARA", begun: 1 };
  const student = (attempts) => ({ key: "ada", links: { 1: { state: "begun", score: 0.5, attempts } } });
  view.show({ links: [link], students: [student(1)] });
  const buttons = () => globalThis.document.body.all.filter(({ tag }) => tag === "button");
  const [title, count, state] = buttons();
  press(state);
  view.show({ links: [{ ...link, exercise: "puma560" }], students: [{ key: "bob", links: {} }, student(2)] });
  assert.equal(globalThis.document.activeElement, state);
  assert.equal(state.textContent, "lecturer-state-begun 50 % (2)");
  for (const button of [title, state]) press(button);
  assert.deepEqual(opened, [["scara", 1], "puma560", ["puma560", 2]]);
  assert.deepEqual(buttons(), [title, count, state]);
});

test("the focus goes on to the list, and at last to the class, when a score is sent again", () => {
  const card = placed("undelivered-card");
  const view = new UndeliveredView(card, card.appendChild(new Element("div")), heading, () => {});
  const lost = { link: 1, key: "ada", title: "Arm", score: 1, problem: "503", dead: true };
  view.show([lost]);
  press(card.find(({ tag }) => tag === "button"));
  view.show([{ ...lost, dead: false }]);
  assert.equal(globalThis.document.activeElement, view.list.element);
  view.show([]);
  assert.equal(globalThis.document.activeElement, heading);
  assert.equal(card.hidden, true);
});

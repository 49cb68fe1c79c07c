// What counts: values of the seat, values at an answer, several devices of a seat, and a document that is not the teacher's.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { eventually, meniscus } from "../lab.mjs";
import { answer, join, school, shows, start, status, stored, teach } from "./class.mjs";

const { visitor, faults } = school();
const document = "tests/page/course.md";
let lesson;
before(async () => (lesson = await start({ what: [document] })));
after(() => lesson?.child.kill("SIGKILL"));

const address = () => `${lesson.base}/d/course.md`;
const assigned = (seat) => JSON.parse(meniscus("class", "assign", document, "--seats", String(seat), "--format", "json")).seats[seat - 1];
const field = (page, name) => page.getByRole("textbox", { name }).first();
const verdict = (page) => page.locator("#verdict-0");
/** The answer to the first question in the hand-in that the server has. */
const handed = async (page) => {
  const [handIn] = (await stored(page, lesson.base))["hand-ins"].map((text) => JSON.parse(text));
  const [item] = handIn.work.items.filter(({ item }) => item.item.answer?.attempts.length);
  return { handIn, attempts: item.item.item.answer.attempts };
};

test("answers are graded with the seat's values and with those at the time, and devices of a seat lose nothing", async () => {
  const teacher = await visitor();
  await teach(teacher, lesson);
  const student = await visitor({ locale: "en-GB" });
  await join(student, lesson.code, address());
  const own = assigned(1);
  const right = own.answers[0];
  await student.getByRole("tab", { name: "Questions" }).click();
  const setup = student.locator(".setup").first();
  assert.match(await setup.innerText(), /This question is about/);

  // A slider is moved: the answer for its value is wrong, that for the seat's value is right, and stays so.
  const other = own.values[0] === 0.5 ? 0.1 : 0.5;
  await student.getByRole("tab", { name: "Explore" }).click();
  await field(student, /^Damping/).fill(String(other));
  await field(student, /^Damping/).press("Enter");
  await answer(student, String(other));
  await eventually(async () => assert.notEqual(await verdict(student).getAttribute("data-grade"), ""));
  assert.notEqual(await verdict(student).getAttribute("data-grade"), "right");
  await answer(student, String(right));
  await eventually(async () => assert.equal(await verdict(student).getAttribute("data-grade"), "right"));
  await status(student, /^Everything is handed in/);
  await shows(teacher, /Found before the answer was shown: 100 %/);
  const first = await handed(student);
  assert.deepEqual(first.attempts.map(({ grade }) => grade === "correct"), [false, true]);
  assert.equal(first.handIn["meniscus hand-in"], 2);
  assert.ok(first.attempts.every(({ language, values }) => language === "en" && Array.isArray(values ?? [])));

  // A second device knows the attempts of the first, and adds its own; so does the first after it.
  await student.getByText("My seat").click();
  const key = await student.locator("#class-bar .key").innerText();
  await student.keyboard.press("Escape");
  const device = await visitor({ locale: "en-GB" });
  await join(device, key, address());
  await device.getByRole("tab", { name: "Questions" }).click();
  await eventually(async () => assert.equal(await device.locator("#answer-0").inputValue(), String(right)), 30);
  await answer(device, "12345");
  await eventually(async () => assert.equal((await handed(device)).attempts.length, 3), 60);
  await answer(student, "23456");
  const typed = async () => (await handed(student)).attempts.map(({ typed }) => typed);
  await eventually(async () => assert.deepEqual(await typed(), [String(other), String(right), "12345", "23456"]), 60);

  // A browser that has forgotten everything.
  const fresh = await visitor({ locale: "en-GB" });
  await join(fresh, key, address());
  await answer(fresh, "34567");
  await eventually(async () => assert.equal((await handed(fresh)).attempts.length, 5), 60);
  await shows(teacher, /Found before the answer was shown: 100 %/);
  assert.deepEqual(faults, []);
});

// Kinds of questions, as a student meets them: a choice of several with partial credit, a choice of one, and remarks on expected wrong numbers,
// in a lesson with a server, in an exported page, and in a course package.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { Lab, eventually, meniscus, temporary } from "../lab.mjs";
import { Platform, Visit, verified } from "../course.mjs";
import { join, school, shows, start, status, stored, teach } from "./class.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const DOCUMENT = "docs/lessons/tube-damping.md";
const { visitor, faults } = school();
let lesson;
before(async () => (lesson = await start({ what: [DOCUMENT] })));
after(() => lesson?.child.kill("SIGKILL"));

const answers = (seat) => JSON.parse(meniscus("class", "assign", DOCUMENT, "--seats", String(seat), "--format", "json")).seats[seat - 1].answers;
const question = (page, number) => page.locator(".question").nth(number);
const grade = (page, number) => page.locator(`#verdict-${number}`).getAttribute("data-grade");
const graded = (page, number, expected) => eventually(async () => assert.equal(await grade(page, number), expected));
const remarks = (page, number) => question(page, number).locator(".remarks").innerText();
const check = (page, number, name = "Check") => question(page, number).getByRole("button", { name, exact: true }).click();

async function faultless(page) {
  if (!(await page.evaluate(() => window.axe))) await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run(".question"));
  assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]), []);
}

test("a student chooses with the keyboard, gets a part of the credit, remarks, and finds the choice again", async () => {
  const teacher = await visitor();
  await teach(teacher, lesson);
  const student = await visitor({ locale: "en-GB", viewport: { width: 390, height: 844 } });
  await join(student, lesson.code, `${lesson.base}/d/tube-damping.md`);
  await student.getByRole("tab", { name: "Questions" }).click();
  const boxes = question(student, 0).getByRole("checkbox");
  assert.equal(await boxes.count(), 4);

  // Nothing chosen is no answer.
  await check(student, 0);
  await graded(student, 0, "unreadable");
  for (let back = 0; back < 4; back += 1) await student.keyboard.press("Shift+Tab");
  await student.keyboard.press("Space");
  await student.keyboard.press("Tab");
  await student.keyboard.press("Space");
  assert.deepEqual(await boxes.evaluateAll((boxes) => boxes.map((box) => box.checked)), [true, true, false, false]);
  await student.keyboard.press("Enter");
  await graded(student, 0, "wrong");
  assert.match(await remarks(student, 0), /a longer column swings more slowly[\s\S]*more sluggish/);
  await boxes.nth(1).uncheck();
  await check(student, 0);
  await graded(student, 0, "near");
  assert.match(await student.locator("#verdict-0").innerText(), /50 % of the credit/);
  const width = await student.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 390, `${width}`);
  await faultless(student);

  // One of several: the arrows move the choice.
  const radios = question(student, 1).getByRole("radio");
  await radios.nth(0).focus();
  // After a click Space is the key of the transport; Tab gives it back to the fields.
  for (const key of ["Shift+Tab", "Tab", "Space"]) await student.keyboard.press(key);
  await student.keyboard.press("ArrowDown");
  await student.keyboard.press("Enter");
  await graded(student, 1, "right");

  // The damping of the seat, and half of it: the remark knows the mistake.
  const [, damping] = answers(1);
  await student.locator("#answer-3").fill(`${damping / 2} g/s`);
  await check(student, 3);
  await graded(student, 3, "wrong");
  assert.match(await remarks(student, 3), /not/);
  await student.locator("#answer-3").fill(`${damping} g/s`);
  await check(student, 3);
  await graded(student, 3, "right");
  assert.equal(await remarks(student, 3), "");

  // All of it is handed in, and graded alike by the server and by the program.
  await status(student, /^Everything is handed in/);
  const [handIn] = (await stored(student, lesson.base))["hand-ins"];
  const { code, found } = verified(handIn);
  assert.equal(code, 0, JSON.stringify(found));
  await shows(teacher, /partly right/);

  // The choice is there after a reload.
  await student.reload();
  await student.getByRole("tab", { name: "Questions" }).click();
  await eventually(async () => assert.deepEqual(await boxes.evaluateAll((boxes) => boxes.map((box) => box.checked)), [true, false, false, false]));
  assert.equal(await radios.nth(1).isChecked(), true);
  await graded(student, 0, "near");
  assert.deepEqual(faults, []);
});

test("an exported page has the choices, in Spanish and in the dark, and its hand-in holds", async () => {
  const file = temporary("kinds.html");
  meniscus("export", DOCUMENT, "--output", file);
  const lab = await Lab.open({ file, language: "es-ES", theme: "dark", width: 390 });
  const { page } = lab;
  await page.getByRole("tab", { name: "Preguntas" }).click();
  await page.getByLabel("La densidad del líquido").check();
  await page.getByLabel("La longitud de la columna").check();
  await page.getByLabel("La aceleración de la gravedad").check();
  await check(page, 0, "Comprobar");
  await graded(page, 0, "near");
  assert.match(await remarks(page, 0), /cuesta más moverlo/);
  await page.getByLabel("La densidad del líquido").uncheck();
  await check(page, 0, "Comprobar");
  await graded(page, 0, "right");
  assert.match(await question(page, 0).locator(".explanation").innerText(), /no contiene/);
  await faultless(page);
  const handIn = await new Visit(lab, page).handIn("garza");
  const { code, found } = verified(handIn.text ?? handIn);
  assert.equal(code, 0, JSON.stringify(found));
  lab.wasQuiet();
  await lab.context.close();
});

for (const kind of ["scorm12", "scorm2004"]) {
  test(`${kind}: choices are interactions, and partial credit is in the score`, async () => {
    const platform = await Platform.begin(DOCUMENT, kind);
    const visit = await Visit.open(platform);
    await visit.start();
    await visit.tab("questions");
    await visit.page.getByLabel("The length of the column").check();
    await check(visit.page, 0);
    await graded(visit.page, 0, "near");
    await visit.page.getByLabel("The gravitational acceleration").check();
    await check(visit.page, 0);
    await graded(visit.page, 0, "right");
    await visit.page.getByLabel("At its level at rest").check();
    await check(visit.page, 1);
    await graded(visit.page, 1, "right");
    assert.deepEqual(await visit.noted("refused"), []);
    const noted = await visit.noted("calls.filter(([, name]) => /interactions.\\d+.(type|.*response|result)$/.test(name)).map(([, , value]) => value)");
    const both = kind === "scorm12" ? "a,d" : "a[,]d";
    assert.deepEqual(noted, ["choice", "a", "0.5", "choice", both, "correct", "choice", "b", "correct"]);
    await visit.lab.page.reload();
    await eventually(() => assert.equal(Number(platform.core.score.raw), 50));
    await visit.close();
  });
}

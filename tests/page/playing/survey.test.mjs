// The survey: answered by the keyboard alone, saved as a file, in both languages; its answers are nowhere else.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { STILL, beside, eventually, meniscus, temporary, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Exports the document with a survey and no questions. */
function surveyed() {
  const file = temporary("surveyed.player.html");
  meniscus("export", beside("surveyed.md"), "--output", file);
  return file;
}

/** Saves the answers by a key, and gives the content of the file. */
async function saved(page, name) {
  await page.tabTo("#save-survey");
  const [download] = await Promise.all([page.page.waitForEvent("download"), page.keys("Enter")]);
  assert.equal(download.suggestedFilename(), name);
  return readFileSync(await download.path(), "utf8");
}

visit("a survey is answered and saved with the keyboard", { file: surveyed, ...STILL }, async (page) => {
  const link = await page.page.evaluate(() => location.hash);
  await page.page.getByRole("tab", { name: "Questions" }).focus();
  await page.keys("Enter");
  const group = (name) => page.page.getByRole("group", { name });
  assert.equal(await group("You are a").getByRole("radio", { name: "No answer" }).isChecked(), true);
  await page.tabTo("#save-survey");
  await page.keys("Enter");
  assert.equal(await page.page.locator("#survey-said").innerText(), "Nothing is answered yet.");
  // From "No answer", the last of its group, the arrows lead round to the alternatives.
  await page.page.getByRole("tab", { name: "Questions" }).focus();
  await page.tabTo("#survey-0-none");
  await page.keys("ArrowDown", "ArrowDown");
  assert.equal(await group("You are a").getByRole("radio", { name: "teacher" }).isChecked(), true);
  await page.keys("Tab", "ArrowUp");
  assert.equal(await group("It was clear").getByRole("radio", { name: "5 agree" }).isChecked(), true);
  await page.keys("Tab", "Tab");
  await page.page.keyboard.type('More "time", k ñ');
  await eventually(async () => assert.equal(await page.field("What would you change?").inputValue(), 'More "time", k ñ'));
  const file = await saved(page, "Pendulum.survey");
  const { document, items, ...rest } = JSON.parse(file);
  assert.deepEqual([document, rest], ["Pendulum", { "meniscus survey": 1 }]);
  assert.deepEqual(items.map(({ kind, chosen, typed }) => [kind, chosen ?? typed]), [["role", 2], ["scale", 5], ["choice", undefined], ["text", 'More "time", k ñ']]);
  assert.match(await page.page.locator("#survey-said").innerText(), /^The answers are saved/);
  // Neither the address nor the browser keeps them.
  assert.equal(await page.page.evaluate(() => location.hash), link);
  assert.ok(!(await page.page.evaluate(() => JSON.stringify([{ ...localStorage }, { ...sessionStorage }]))).includes("time"));
  await page.page.evaluate(axe);
  const { violations } = await page.page.evaluate(() => axe.run(".survey"));
  assert.deepEqual(violations.map(({ id }) => id), []);
  // The program reads the file.
  const folder = temporary("answers");
  mkdirSync(folder);
  for (let index = 0; index < 5; index++) writeFileSync(`${folder}/${index}.survey`, file);
  const [{ n, items: counted }] = JSON.parse(meniscus("class", "survey", folder, "--format", "json"));
  assert.deepEqual([n, counted.map((item) => item.n)], [5, [5, 5, 5]]);
});

visit("the survey is asked in Spanish, and its file is the same", { file: surveyed, language: "es-ES" }, async (page) => {
  await page.page.getByRole("tab", { name: "Preguntas" }).click();
  await page.page.getByRole("group", { name: "Fue claro" }).getByRole("radio", { name: "1 en desacuerdo" }).check();
  await page.page.getByRole("group", { name: "¿Qué ayudó más?" }).getByRole("radio", { name: "gráficas" }).check();
  const { items } = JSON.parse(await saved(page, "Pendulum.survey"));
  assert.deepEqual(items.map(({ asked, chosen }) => [asked, chosen]), [["You are a", undefined], ["It was clear", 1], ["What helped most?", 2], ["What would you change?", undefined]]);
});

// The survey of a class in the dashboard: files that are dropped are counted; comments are marked and released by the keyboard.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { STILL, drop, eventually, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** A file with the answers of one person. */
function sheet(place, step, typed) {
  const items = [
    { name: "c", kind: "scale", asked: "It was clear", words: ["no", "yes"], of: 5, chosen: step },
    { name: "t", kind: "text", asked: "Why?", typed },
  ];
  return { name: `${place}.survey`, text: JSON.stringify({ "meniscus survey": 1, document: "U-tube", items }) };
}

const comments = ["Buenas gráficas", "La gráfica no funciona", "No funciona", "<img src=x onerror=alert(1)>", "Zeta", "Alfa"];
const sheets = comments.map((comment, place) => sheet(place, 1 + Math.min(place, 4), comment));

visit("answers that are dropped are counted from five on, and comments are released one by one", STILL, async (lab) => {
  await drop(lab, ...sheets.slice(0, 4));
  const part = lab.page.locator("#class-survey");
  await eventually(async () => assert.match(await part.innerText(), /n = 4\s+2 items have fewer than 5 answers/));
  assert.equal(await part.locator("svg").count(), 0);
  await drop(lab, ...sheets.slice(4), { name: "cut.survey", text: sheets[0].text.slice(0, 50) });
  await eventually(async () => assert.equal(await part.locator("svg").count(), 2));
  assert.match(await part.innerText(), /cut\.survey is damaged/);
  assert.match(await part.innerText(), /5 yes\s+2\s+33 % \(10 to 70 %, n = 6\)/);
  const words = await part.locator("table.words tbody tr").allInnerTexts();
  assert.deepEqual(words.map((row) => row.replace(/\s+/g, " ")), ["gráfica 2", "no funciona 2"]);
  // Alphabetical: the hostile one first, then Alfa. Nothing is released.
  const shown = part.locator(".survey-comment");
  assert.equal(await shown.innerText(), comments[3]);
  assert.equal(await part.getByText("Released comments").count(), 0);
  await part.getByRole("group", { name: "Comments" }).focus();
  await lab.keys("-", "+", "+", "0", "ArrowLeft", "ArrowLeft");
  assert.match(await part.innerText(), /Positive among the marked ones: 50 % \(15 to 85 %, n = 4\)/);
  assert.equal(await part.getByRole("button", { name: "Positive" }).getAttribute("aria-pressed"), "true");
  await part.getByRole("checkbox", { name: "Release this comment" }).check();
  await eventually(async () => assert.deepEqual(await part.locator(".comments li").allInnerTexts(), ["Buenas gráficas"]));
  assert.equal(await lab.page.locator("img[src=x]").count(), 0);
  await lab.page.evaluate(axe);
  const { violations } = await lab.page.evaluate(() => axe.run("#class-survey"));
  assert.deepEqual(violations.map(({ id }) => id), []);
  const [download] = await Promise.all([lab.page.waitForEvent("download"), lab.press("Save survey")]);
  const page = readFileSync(await download.path(), "utf8");
  assert.ok(page.includes("Buenas gráficas</li>") && !page.includes("Zeta") && !page.includes("onerror"));
});

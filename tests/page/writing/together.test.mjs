// Several records fitted together, and fits that are there again at the next visit.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { STILL, drop, eventually, visit } from "../lab.mjs";
import { DAMPING, film, fit, openTheory, records, unfold } from "../measured.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const TUBES = [["short.csv", 0.18], ["middle.csv", 0.24], ["long.csv", 0.3]];

/** Three tubes of different lengths, filmed and dropped at once. */
async function dropThree(lab) {
  await drop(lab, ...TUBES.map(([name, length], place) => ({ name, text: film(length, place + 1) })));
  await eventually(async () => assert.equal(await records(lab).count(), TUBES.length));
  await lab.page.locator("#tab-measure").click();
  await unfold(lab, "record");
  await unfold(lab, "theory");
}

const tick = (lab, group, name) => lab.page.getByRole("group", { name: group }).getByRole("checkbox", { name, exact: true });
const rows = (lab) => lab.page.locator(".fits tbody tr");

visit("three records are fitted together with a number in common, and are there again after a reload", async (lab) => {
  await openTheory(lab, "Linear damping");
  await dropThree(lab);
  // The last one is looked at and takes part; alone it has nothing to share.
  assert.ok(await tick(lab, "Fitted together", "long.csv").isDisabled());
  assert.equal(await lab.page.locator(".same").count(), 0);
  await tick(lab, "Fitted together", "short.csv").check();
  await tick(lab, "Fitted together", "middle.csv").check();
  const damping = lab.page.getByRole("checkbox", { name: "Damping rate: one value for all", exact: true });
  assert.equal(await damping.isChecked(), false, "what is varied is each record's own, as on the command line");
  await damping.check();
  const found = await fit(lab);
  const shared = found.get("Damping rate");
  assert.ok(Math.abs(shared.value - DAMPING) < 3 * shared.spread + 1e-3, JSON.stringify([...found]));
  for (const [name, length] of TUBES) {
    const { value, spread } = found.get(`${name}: Length of the column`);
    assert.ok(Math.abs(value - length) < 3 * spread + 1e-4, JSON.stringify([...found]));
  }

  // The sliders and what is drawn are those of the record that is looked at.
  assert.ok(Math.abs((await lab.number("Length of the column")) - 0.3) < 1e-3);
  const drawn = () => records(lab).locator("[id^=show-record]").evaluateAll((boxes) => boxes.map((box) => box.checked));
  assert.deepEqual(await drawn(), [false, false, true]);
  await lab.tab("Measure");
  await lab.page.locator("#fit-record").selectOption("short.csv");
  await eventually(async () => assert.ok(Math.abs((await lab.number("Length of the column")) - 0.18) < 1e-3));
  assert.deepEqual(await drawn(), [true, false, false]);
  await eventually(async () => assert.match(await lab.told(), /fitted values of short\.csv/));

  // The report has all three, and the font of its equations.
  await lab.tab("Measure");
  const report = await lab.save(lab.page.locator(".detail").getByRole("button", { name: "Report", exact: true }));
  assert.equal(report.name, "short-middle-long.html");
  for (const [name] of TUBES) assert.match(report.text, new RegExp(`<figcaption>${name}`));
  assert.match(report.text, /@font-face[^}]*font\/woff2;base64,[A-Za-z0-9+/]{1000}/);

  // After a reload the document is open as before, the fit in the list; from another document it can be opened again.
  const before = await rows(lab).locator("td").allInnerTexts();
  await lab.page.reload();
  await lab.tab("Measure");
  await eventually(async () => assert.equal(await rows(lab).count(), 1));
  await unfold(lab, "fit");
  assert.deepEqual((await rows(lab).locator("td").allInnerTexts()).slice(0, 5), before.slice(0, 5));
  assert.match(await rows(lab).innerText(), /short\.csv \+ middle\.csv \+ long\.csv/);
  assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "Linear damping");
  await openTheory(lab, "Oscillations of a liquid in a U-tube");
  await lab.tab("Measure");
  await lab.page.getByRole("button", { name: /^Open: Linear damping/ }).click();
  await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "Linear damping"));
  await eventually(async () => assert.match(await lab.told(), /fitted values of/));
});

visit("what is known of each record is held there", async (lab) => {
  await openTheory(lab, "Linear damping");
  await dropThree(lab);
  await tick(lab, "Fitted together", "short.csv").check();
  await lab.page.getByRole("checkbox", { name: /^Length of the column(?!:)/ }).uncheck();
  const same = lab.page.getByRole("checkbox", { name: "Length of the column: one value for all", exact: true });
  assert.ok(await same.isChecked(), "the slider's");
  await lab.tabTo("#same-0");
  await lab.keys("Space");
  await eventually(async () => assert.equal((await lab.focused()).name, "Length of the column: one value for all", "the focus stays"));
  await lab.enter("Length of the column, short.csv", "18 cm");
  await lab.enter("Length of the column, long.csv", "0.3");
  assert.equal(await lab.page.getByRole("textbox", { name: "Length of the column, short.csv" }).inputValue(), "0.18");
  const found = await fit(lab);
  assert.equal(found.has("short.csv: Length of the column"), false);
  const damping = found.get("short.csv: Damping rate");
  assert.ok(Math.abs(damping.value - DAMPING) < 3 * damping.spread + 1e-3, JSON.stringify([...found]));
  await lab.enter("Length of the column, short.csv", "18 kg");
  await eventually(async () => assert.match(await lab.page.locator("#fit-refusal").innerText(), /measures something else/));
});

for (const [language, theme, size] of [["en-GB", "light", {}], ["es-ES", "dark", { width: 390, height: 844, touch: true }]]) {
  visit(`axe finds nothing in a fit of several records: ${language}, ${theme}`, { ...STILL, language, theme, ...size }, async (lab) => {
    const spanish = language === "es-ES";
    await openTheory(lab, spanish ? "Amortiguamiento lineal" : "Linear damping");
    await dropThree(lab);
    const group = spanish ? "Se ajustan juntos" : "Fitted together";
    for (const [name] of TUBES.slice(0, 2)) await tick(lab, group, name).check();
    await lab.page.locator("#vary-0").uncheck();
    await lab.page.locator("#same-0").uncheck();
    await lab.page.locator("#known-0-0").waitFor();
    await fit(lab);
    await lab.page.evaluate(axe);
    const found = (await lab.page.evaluate(() => window.axe.run("html"))).violations;
    assert.deepEqual(found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 160))}`), []);
    assert.equal(await lab.page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false, "no sideways scrolling");
  });
}

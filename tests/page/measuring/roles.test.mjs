// A file that can be read in several ways: the page asks which, measures nothing before, and remembers the answer.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { STILL, drop, eventually, sight, visit } from "../lab.mjs";
import { openTheory, records } from "../measured.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** The column between two lengths may be a second clock. */
function twoReadings() {
  const rows = Array.from({ length: 60 }, (_, row) => [row / 30, 5 * Math.cos(row / 4), 40 * row, 3 * Math.cos(row / 5)]);
  return `t [s],y [cm],delay [ms],z [cm]\n${rows.map((row) => row.join(",")).join("\n")}\n`;
}

const taken = (lab) => records(lab).locator(".table select").evaluateAll((selects) => selects.map((select) => select.value));
const chosen = (select) => select.evaluate((node) => node.selectedOptions[0].innerText);

visit("the variable of a file with two readings is asked for, chosen with keys, and there after a reload", async (lab) => {
  await openTheory(lab, "Linear damping");
  await drop(lab, { name: "two.csv", text: twoReadings() });
  await records(lab).waitFor();
  const select = lab.page.getByRole("combobox", { name: "Measured against" });
  assert.match(await chosen(select), /which\?/);
  assert.equal(await select.getAttribute("aria-invalid"), "true");
  assert.ok((await taken(lab)).every((quantity) => quantity === ""), "nothing is measured before");
  assert.match(await sight(records(lab)), /can be read in 2 ways/);
  await lab.tabTo("[id^=variable-]");
  await lab.keys("ArrowDown", "Enter");
  await eventually(async () => assert.equal(await chosen(select), "all columns against t"));
  assert.deepEqual((await taken(lab)).slice(0, 2), ["t", "y"]);
  assert.equal(await select.getAttribute("aria-invalid"), null);
  assert.match((await lab.focused()).id, /^variable-/, "the focus stays");
  await lab.page.reload();
  await lab.tab("Measure");
  await eventually(async () => assert.equal(await chosen(select), "all columns against t"));
  // Each clock for its own columns.
  await select.selectOption({ label: "t, delay, each for its own columns" });
  await eventually(async () => assert.equal(await chosen(select), "t, delay, each for its own columns"));
});

visit("axe finds nothing where a file is asked about: phone, dark, Spanish", { ...STILL, language: "es-ES", theme: "dark", width: 390, height: 844, touch: true }, async (lab) => {
  await openTheory(lab, "Amortiguamiento lineal");
  await drop(lab, { name: "dos.csv", text: twoReadings() });
  await records(lab).waitFor();
  await lab.page.getByRole("combobox", { name: "Se mide frente a" }).waitFor();
  await lab.page.evaluate(axe);
  const found = (await lab.page.evaluate(() => window.axe.run("html"))).violations;
  assert.deepEqual(found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 160))}`), []);
  assert.equal(await lab.page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false, "no sideways scrolling");
});

/** Dates that may have the day or the month first. */
const DATED = "date;y (cm)\n02/03/2024 10:00:00;4\n03/03/2024 10:00:00;3\n05/03/2024 10:00:00;1\n08/03/2024 10:00:00;2\n";

visit("the order of open dates is asked for each file, dropped or pasted", async (lab) => {
  await openTheory(lab, "Linear damping");
  await drop(lab, { name: "dated.csv", text: DATED });
  const asked = lab.page.getByRole("group", { name: /^dated\.csv has dates such as/ });
  await asked.waitFor();
  assert.equal(await records(lab).count(), 0, "nothing is read before");
  assert.match(await sight(lab.page.locator("#record-refusal")), /day first or the month first.*Choose the order of day and month/s);
  await asked.getByRole("button", { name: "the day" }).click();
  await records(lab).waitFor();
  assert.equal(await asked.count(), 0);
  assert.equal(await lab.page.locator("#record-refusal").innerText(), "");
  // From the first to the third row three days have passed, or three months.
  const span = async (place) => (await records(lab).nth(place).locator("tbody tr").first().innerText()).replace(/\s+/g, " ");
  assert.match(await span(0), /259200/);
  await lab.page.locator("#other-ways summary").click();
  await lab.page.locator("#paste-record").fill(DATED);
  await lab.press("Read");
  await lab.page.getByRole("group", { name: /^pasted table has dates/ }).getByRole("button", { name: "the month" }).click();
  await eventually(async () => assert.equal(await records(lab).count(), 2));
  assert.doesNotMatch(await span(1), /259200/);
});

// The first fit that somebody makes: the opening document fits a sample, and one that cannot is not preselected.

import assert from "node:assert/strict";
import { eventually, visit } from "../lab.mjs";

for (const [language, tab, sample] of [["en-GB", "Measure", "Column of 18 cm"], ["es-ES", "Medir", "Columna de 18 cm"]]) {
  visit(`the first fit from a sample takes three actions: ${language}`, { language, fragment: "" }, async (lab) => {
    await lab.page.getByRole("tab", { name: tab, exact: true }).click();
    await lab.page.locator("#panel").getByRole("button", { name: sample, exact: true }).click();
    await lab.page.locator("#fit").click();
    // The left column of the sample stood at 9.5 cm.
    await eventually(async () => assert.match(await lab.page.locator("#fit-step").innerText(), /9[.,]4\d* ± 0[.,]0\d*\s+cm/), 60);
    assert.equal(await lab.page.locator("#unsuitable").count(), 0);
    assert.equal(await lab.page.locator(".theory-chip[aria-pressed=true]").count(), 1);
  });
}

visit("a document that cannot hold the record is no theory until it is chosen", async (lab) => {
  await lab.tab("Measure");
  await lab.page.locator("#panel").getByRole("button", { name: "Column of 18 cm", exact: true }).click();
  await eventually(async () => assert.match(await lab.page.locator("#unsuitable").innerText(), /periods from 2\.8.* s to .* s, and the record has one of 0\.6/), 30);
  assert.equal(await lab.page.locator(".theory-chip[aria-pressed=true]").count(), 0);
  await lab.page.locator("#fit").click();
  await eventually(async () => assert.match(await lab.page.locator("#fit-step").innerText(), /cannot hold this record/));
  // Chosen in spite of it, it is fitted, and the result says that it misses the data.
  await lab.page.locator(".theory-chip").first().click();
  assert.equal(await lab.page.locator(".theory-chip[aria-pressed=true]").count(), 1);
  await lab.page.locator("#fit").click();
  await eventually(async () => assert.match(await lab.page.locator("#fit-step").innerText(), /does not describe these data/), 60);
});

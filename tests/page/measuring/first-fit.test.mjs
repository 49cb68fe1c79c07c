// The first fit that somebody makes: the opening document fits a sample, and one that cannot is not preselected.

import assert from "node:assert/strict";
import { eventually, hold, visit } from "../lab.mjs";
import { openTheory, unfold } from "../measured.mjs";

/** Opens the tab *Measure* and takes a sample record. */
async function takeSample(lab) {
  await lab.tab("Measure");
  await lab.page.locator("#panel").getByRole("button", { name: /Column of 18 cm/ }).click();
}

for (const [language, tab, sample] of [["en-GB", "Measure", "Column of 18 cm"], ["es-ES", "Medir", "Columna de 18 cm"]]) {
  visit(`the first fit from a sample takes three actions: ${language}`, { language, fragment: "" }, async (lab) => {
    await lab.page.getByRole("tab", { name: tab, exact: true }).click();
    await lab.page.locator("#panel").getByRole("button", { name: new RegExp(sample) }).click();
    await lab.page.locator("#fit").click();
    // The left column of the sample stood at 9.5 cm.
    await eventually(async () => assert.match(await lab.page.locator("#fit-lines").innerText(), /9[.,]4\d* ± 0[.,]0\d*\s+cm/), 60);
    assert.equal(await lab.page.locator("#unsuitable").count(), 0);
    assert.equal(await lab.page.locator(".theory-chip[aria-pressed=true]").count(), 1);
  });
}

visit("a document that cannot hold the record is no theory until it is chosen", async (lab) => {
  await takeSample(lab);
  await eventually(async () => assert.match(await lab.page.locator("#unsuitable").innerText(), /periods from 2\.8.* s to .* s, and the record has one of 0\.6/), 30);
  assert.equal(await lab.page.locator(".theory-chip[aria-pressed=true]").count(), 0);
  await lab.page.locator("#fit").click();
  await eventually(async () => assert.match(await lab.page.locator("#fit-lines").innerText(), /cannot hold this record/));
  // Chosen in spite of it, it is fitted, and the result says that it misses the data.
  await unfold(lab, "theory");
  await lab.page.locator(".theory-chip").first().click();
  assert.equal(await lab.page.locator(".theory-chip[aria-pressed=true]").count(), 1);
  await lab.page.locator("#fit").click();
  await eventually(async () => assert.match(await lab.page.locator("#fit-lines").innerText(), /does not describe these data/), 60);
});

visit("Fit pressed as soon as the record is there waits until it is known whether the document can hold it", async (lab) => {
  await lab.tab("Measure");
  await lab.page.evaluate(() => {
    new MutationObserver((_, observer) => {
      const fit = document.getElementById("fit");
      if (!fit) return;
      observer.disconnect();
      fit.click();
    }).observe(document.body, { childList: true, subtree: true });
  });
  await lab.page.locator("#panel").getByRole("button", { name: /Column of 18 cm/ }).click();
  await eventually(async () => assert.match(await lab.page.locator("#fit-lines").innerText(), /cannot hold this record/), 30);
  assert.equal(await lab.page.locator(".fits tbody tr").count(), 0);
});

for (const [first, second, fits] of [["rank", "fit", 1], ["fit", "rank", 2]]) {
  visit(`of ${first} and ${second}, pressed one after the other, the second is done`, { fragment: "" }, async (lab) => {
    await takeSample(lab);
    await lab.page.locator("#fit").waitFor();
    await lab.page.evaluate((buttons) => buttons.forEach((id) => document.getElementById(id).click()), [first, second]);
    await eventually(async () => assert.ok((await lab.page.locator(".fits tbody tr").count()) >= fits), 120);
    if (second === "fit") {
      await eventually(async () => assert.equal(await lab.page.locator("#cancel-fit").count(), 0), 60);
      assert.equal(await lab.page.locator(".fits tbody tr").count(), 1);
    }
  });
}

visit("a ranking whose record is removed before it begins does not take place", { fragment: "" }, async (lab) => {
  await takeSample(lab);
  await lab.page.locator("#rank").waitFor();
  const held = await hold(lab);
  await lab.page.locator("#rank").click();
  await held.begun();
  await lab.page.locator(".record").getByRole("button", { name: /^Remove/ }).first().click();
  await eventually(async () => assert.equal(await lab.page.locator(".record").count(), 0));
  await held.release();
  assert.equal(await lab.page.locator("#strip, #fit-step, #cancel-fit, .fits").count(), 0);
});

visit("a ranking takes place even if another document is opened before it begins", { fragment: "" }, async (lab) => {
  await takeSample(lab);
  await lab.page.locator("#rank").waitFor();
  const held = await hold(lab);
  await lab.page.locator("#rank").click();
  await held.begun();
  await openTheory(lab, "Linear damping");
  await held.release();
  await lab.tab("Measure");
  await eventually(async () => assert.ok((await lab.page.locator(".fits tbody tr").count()) >= 2), 120);
});

// Points that are left out of fits by a press on them in a plot.

import assert from "node:assert/strict";
import { drop, eventually, visit } from "../lab.mjs";
import { film, fit, openTheory, records, unfold } from "../measured.mjs";

/** Number of rows left out that the page shows; 0 without a text. */
async function leftOut(lab) {
  const text = await lab.page.locator("#rows-left-out").innerText();
  return text === "" ? 0 : Number(text.match(/\d+$/)[0]);
}

visit("a click on a point, or Enter, leaves its row out of fits and takes it back", async (lab) => {
  await openTheory(lab, "Linear damping");
  await drop(lab, { name: "film.csv", text: film() });
  await records(lab).waitFor();
  const canvas = lab.page.locator("#canvas-0");
  const box = await canvas.boundingBox();
  const across = box.x + box.width / 2;
  const points = [...Array(Math.floor(box.height / 16)).keys()].map((step) => box.y + 8 + 16 * step);
  // Without the button, a click pins what is read there.
  await lab.page.mouse.click(across, box.y + box.height / 2);
  assert.equal(await leftOut(lab), 0);
  const leave = lab.page.locator("#leave-out");
  await unfold(lab, "record");
  await leave.click();
  assert.equal(await leave.getAttribute("aria-pressed"), "true");
  assert.ok(await lab.page.locator("#leave-out-note").isVisible());
  let hit;
  for (hit of points) {
    await lab.page.mouse.click(across, hit);
    if ((await leftOut(lab)) > 0) break;
  }
  assert.equal(await leftOut(lab), 1);
  assert.match(await lab.told(), /^film\.csv: row \d+ is left out of fits$/);
  const found = await fit(lab);
  assert.ok(found.size > 0);
  await eventually(async () => assert.match(await lab.page.locator("#fit-step").innerText(), /Values left out by hand: 1/));
  await lab.page.mouse.click(across, hit);
  await eventually(async () => assert.equal(await leftOut(lab), 0));
  assert.match(await lab.told(), /^film\.csv: row \d+ counts again$/);
  // By keyboard.
  await canvas.focus();
  await lab.keys("ArrowRight", "ArrowRight", "Enter");
  await eventually(async () => assert.equal(await leftOut(lab), 1));
  await lab.page.locator("#take-back").click();
  await eventually(async () => assert.equal(await leftOut(lab), 0));
  assert.equal(await lab.page.locator("#take-back").isVisible(), false);
  assert.equal(await lab.page.evaluate(() => document.activeElement.id), "leave-out");
  await leave.click();
  await lab.page.mouse.click(across, hit);
  assert.equal(await leftOut(lab), 0);
});

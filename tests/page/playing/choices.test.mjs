// A tick box for a switch, chips for a choice.

import assert from "node:assert/strict";
import { beside, eventually, visit } from "../lab.mjs";

/** Opens a document that has one of each. */
async function ball(lab) {
  await lab.page.setInputFiles("#open-file", beside("choices.md"));
  await lab.page.getByRole("heading", { level: 1, name: "A ball in a liquid" }).waitFor();
}

const liquids = (lab) => lab.page.getByRole("toolbar", { name: "Liquid" });
const chosen = (lab) => liquids(lab).locator("[aria-pressed=true]").innerText();

visit("a liquid is chosen, drag is ticked off, and defaults and undo bring both back", async (lab) => {
  await ball(lab);
  const drag = lab.page.getByLabel("With drag");
  assert.deepEqual(await liquids(lab).getByRole("button").allInnerTexts(), ["Water", "Glycerine"]);
  assert.equal(await drag.isChecked(), true);
  await liquids(lab).getByRole("button", { name: "Glycerine" }).click();
  await lab.drawn();
  // After a press Space plays; whoever comes with Tab uses what has the focus.
  await lab.page.keyboard.press("Tab");
  await drag.focus();
  await lab.page.keyboard.press("Space");
  assert.equal(await drag.isChecked(), false);
  await lab.press("Restore defaults");
  assert.equal(await chosen(lab), "Water");
  assert.equal(await drag.isChecked(), true);
  await lab.page.evaluate(() => document.activeElement.blur());
  await lab.keys("Control+z");
  assert.equal(await chosen(lab), "Glycerine");
  assert.equal(await drag.isChecked(), false);
});

visit("a link carries what is chosen, in words", async (lab) => {
  await ball(lab);
  await liquids(lab).getByRole("button", { name: "Glycerine" }).click();
  await lab.drawn();
  await lab.page.getByLabel("With drag").uncheck();
  assert.match(await lab.copyLink(), /[Ll]ink/);
  const address = decodeURIComponent(lab.page.url());
  assert.match(address, /drag:off/);
  assert.match(address, /liquid:Glycerine/);
});

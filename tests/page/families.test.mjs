// A family is one line with a picker for its member; its size is changed in the page.

import assert from "node:assert/strict";
import { beside, eventually, visit } from "./lab.mjs";

/** Opens a document with families of one and of two indices, and a vector. */
async function chain(lab) {
  await lab.page.setInputFiles("#open-file", beside("families.md"));
  await lab.page.getByRole("heading", { level: 1, name: "A chain and a body" }).waitFor();
}

const picker = (lab, name, part = "#readouts") => lab.page.locator(part).getByRole("spinbutton", { name, exact: true });

visit("a family is one line, and its member is picked by keys", async (lab) => {
  await chain(lab);
  await lab.play(lab.page.locator("#readouts"));
  assert.equal(await lab.page.locator("#readouts dl > div").count(), 5);
  assert.match(await lab.value("Displacement"), /^1\.000\s*cm$/);
  const index = picker(lab, "Displacement: index");
  await index.focus();
  await lab.keys("ArrowUp", "ArrowUp");
  assert.equal(await index.inputValue(), "3");
  assert.match(await lab.value("Displacement"), /^3\.000\s*cm$/);
  assert.equal(await picker(lab, "Velocity: index").inputValue(), "3", "the same body");
  await index.fill("99");
  await index.press("Enter");
  assert.equal(await index.inputValue(), "6", "the last member is shown");
  await picker(lab, "Heat: index 1").fill("2");
  await picker(lab, "Heat: index 2").fill("3");
  assert.match(await lab.value("Heat"), /^23\.00$/);
  assert.match(await lab.value("Position"), /^\(1\.000, 2\.000\)\s*m$/);
});

visit("the state of the chosen member is set", async (lab) => {
  await chain(lab);
  await lab.play(lab.page.locator("#settings"));
  await picker(lab, "Displacement: index", "#settings").fill("2");
  const field = lab.page.locator("#settings").getByRole("textbox", { name: /^Displacement/ });
  await eventually(async () => assert.equal(await field.inputValue(), "2.000"));
  await field.fill("7");
  await field.press("Enter");
  await eventually(async () => assert.match(await lab.value("Displacement"), /^7\.000\s*cm$/));
  assert.equal(await picker(lab, "Displacement: index").inputValue(), "2");
});

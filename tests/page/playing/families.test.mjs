// A family is one line with a picker for its member; its size is changed in the page.

import assert from "node:assert/strict";
import { beside, eventually, visit } from "../lab.mjs";

/** Opens a document with families of one and of two indices, and a vector. */
async function chain(lab) {
  await lab.page.setInputFiles("#open-file", beside("families.md"));
  await lab.page.getByRole("heading", { level: 1, name: "A chain and a body" }).waitFor();
}

const picker = (lab, name, part = ".readouts") => lab.page.locator(part).getByRole("spinbutton", { name, exact: true });

visit("a family is one line, and its member is picked by keys", async (lab) => {
  await chain(lab);
  await lab.play(lab.page.locator("#readouts"));
  await lab.openMore();
  assert.equal(await lab.page.locator(".readouts dl > div").count(), 5);
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
  await eventually(async () =>
    assert.match((await lab.page.locator(".message").allInnerTexts()).join("\n"), /“99” is not possible here/));
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

visit("the number of masses is changed in the page, and the link restores it", async (lab) => {
  await chain(lab);
  const size = lab.page.getByRole("spinbutton", { name: /^Number of masses/ });
  assert.equal(await size.inputValue(), "5");
  await lab.enter("Stiffness", "9");
  await size.focus();
  await lab.keys("ArrowUp");
  await eventually(async () => assert.equal(await size.inputValue(), "6"));
  assert.equal((await lab.focused()).id, "size-N");
  await size.fill("9");
  await size.press("Enter");
  await eventually(async () => assert.equal(await picker(lab, "Displacement: index").getAttribute("max"), "10"));
  assert.equal(await lab.number("Stiffness"), 9);
  // What cannot be is refused, and nothing changes.
  await size.fill("41");
  await size.press("Enter");
  await eventually(async () => assert.match(await lab.page.locator("#size-N-error").innerText(), /range 2\.\.40/));
  assert.equal(await picker(lab, "Displacement: index").getAttribute("max"), "10");
  assert.match(await lab.copyLink(), /[Ll]ink/);
  const address = lab.page.url();
  assert.match(address, /n=N:9/);
  await lab.page.goto("about:blank");
  await lab.go(address);
  await eventually(async () => assert.equal(await size.inputValue(), "9"));
  assert.equal(await lab.number("Stiffness"), 9);
  await lab.press("Restore defaults");
  await eventually(async () => assert.equal(await size.inputValue(), "5"));
  assert.notEqual(await lab.number("Stiffness"), 9);
  // The button is gone: nothing differs from the defaults. The focus stays in its panel.
  assert.equal((await lab.focused()).id, "panel-explore");
  await lab.openSource();
  assert.match(await lab.page.locator("#source pre").innerText(), /size N = 5/);
});

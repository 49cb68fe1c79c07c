// Buttons of a document: pressed by hand, by key and by finger, and in the link.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { STILL, beside, eventually, meniscus, temporary, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const PHONE = { width: 390, height: 844, touch: true };

/** The page of one simulation, with its translation. */
function exported() {
  const file = temporary("kicked.html");
  meniscus("export", "tests/page/kicked.md", "--output", file);
  return file;
}

/** Opens the document in the laboratory. */
async function kicked(lab) {
  await lab.page.setInputFiles("#open-file", beside("kicked.md"));
  await lab.page.getByRole("heading", { level: 1, name: "A kicked oscillator" }).waitFor();
}

visit("a kick acts at once, while the run stands and while it plays", async (lab) => {
  await kicked(lab);
  const actions = lab.page.getByRole("group", { name: "Actions" });
  assert.deepEqual(await actions.getByRole("button").allInnerTexts(), ["Kick", "Hold", "Let it go"]);
  assert.equal(await lab.value("Kicks"), "0");
  await lab.press("Kick");
  await eventually(async () => assert.equal(await lab.value("Kicks"), "1"));
  assert.equal(await lab.number("Velocity"), 0.5);
  assert.match(await lab.told(), /Kick, 0\.00 s/);
  await lab.button("Play").click();
  await lab.watchUntil(0.5);
  await lab.button("Kick").focus();
  await lab.keys("Enter");
  await lab.press("Pause");
  await eventually(async () => assert.equal(await lab.value("Kicks"), "2"));
  assert.equal((await lab.focused()).name, "Play", "the run went on while it was pressed");
});

visit("the link repeats the presses, and so does the run", async (lab) => {
  await kicked(lab);
  await lab.press("Kick");
  await lab.button("Play").click();
  await lab.watchUntil(0.6);
  await lab.press("Kick");
  await lab.watchUntil(1.2);
  await lab.press("Pause");
  const shown = [await lab.number("Displacement"), await lab.value("Kicks"), await lab.time()];
  await lab.copyLink();
  await eventually(async () => assert.match(lab.page.url(), /b=kick:0:\d\.\d+&/));
  const address = lab.page.url();
  await lab.page.reload();
  await lab.page.getByRole("heading", { level: 1, name: "A kicked oscillator" }).waitFor();
  assert.equal(lab.page.url(), address);
  await eventually(async () => assert.equal(await lab.value("Kicks"), "2"));
  assert.deepEqual([await lab.value("Kicks"), await lab.time()], shown.slice(1));
  assert.ok(Math.abs((await lab.number("Displacement")) - shown[0]) < 2e-4);
  // Back in time and on again.
  await lab.page.locator("#time-line").fill("0");
  await eventually(async () => assert.equal(await lab.value("Kicks"), "1"));
  await lab.button("Play").click();
  await lab.watchUntil(shown[2]);
  await lab.press("Pause");
  await eventually(async () => assert.equal(await lab.value("Kicks"), "2"));
  await lab.press("Back to start");
  await eventually(async () => assert.equal(await lab.value("Kicks"), "0"));
});

visit("where an event has ended the run, nothing is pressed", async (lab) => {
  await kicked(lab);
  await lab.press("Step forward");
  await lab.press("Let it go");
  await eventually(async () => assert.equal(await lab.button("Kick").getAttribute("aria-disabled"), "true"));
  await lab.button("Kick").focus();
  await lab.keys("Enter");
  await eventually(async () => assert.match(await lab.page.locator(".actions .refusal").innerText(), /has ended here/));
  assert.equal(await lab.value("Kicks"), "0");
  await lab.press("Back to start");
  await eventually(async () => assert.equal(await lab.button("Kick").getAttribute("aria-disabled"), null));
  await lab.press("Kick");
  await eventually(async () => assert.equal(await lab.value("Kicks"), "1"));
  assert.equal(await lab.page.locator(".actions .refusal").innerText(), "");
});

visit("with a finger, in Spanish, on the page of one simulation", { file: exported, language: "es", ...PHONE }, async (page) => {
  const kick = page.button("Patada");
  await kick.tap();
  const box = await kick.boundingBox();
  assert.ok(box.height >= 44 && box.width >= 44, JSON.stringify(box));
  await eventually(async () => assert.equal(await page.value("Patadas"), "1"));
});

for (const theme of ["light", "dark"]) {
  visit(`axe finds nothing wrong, ${theme}`, { file: exported, theme, ...STILL }, async (page) => {
    await page.press("Step forward");
    await page.press("Let it go");
    await page.page.evaluate(axe);
    const { violations } = await page.page.evaluate(() => window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag22aa"] }));
    assert.deepEqual(violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.target).join(" ")}`), []);
  });
}

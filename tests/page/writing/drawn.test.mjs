// A curve that the reader draws: with the mouse, with the keys and with a finger, and in the link.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { STILL, beside, eventually, meniscus, temporary, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const PHONE = { width: 390, height: 844, touch: true };

/** The page of one simulation, with its translation. */
function exported() {
  const file = temporary("drawn.html");
  meniscus("export", "tests/page/drawn.md", "--output", file);
  return file;
}

/** Opens the document in the laboratory. */
async function opened(lab) {
  await lab.page.setInputFiles("#open-file", beside("drawn.md"));
  await lab.page.getByRole("heading", { level: 1, name: "A push of your own" }).waitFor();
}

/** Draws a straight line with the mouse; places and heights are parts of the field. */
async function draw(lab, field, from, to) {
  await field.scrollIntoViewIfNeeded();
  const box = await field.boundingBox();
  const at = ([place, height]) => [box.x + place * box.width, box.y + (1 - height) * box.height];
  await lab.page.mouse.move(...at(from));
  await lab.page.mouse.down();
  await lab.page.mouse.move(...at(to), { steps: 12 });
  await lab.page.mouse.up();
}

visit("a push drawn with the mouse moves the cart, is in the link, and is cleared", async (lab) => {
  await opened(lab);
  const field = lab.slider("Push");
  await lab.press("Step forward");
  await draw(lab, field, [0, 0.75], [1, 0.75]);
  await eventually(async () => assert.equal(await lab.time(), 0, "the run starts again"));
  const accelerated = async () => parseFloat((await lab.value("Acceleration")).replace("−", "-"));
  await eventually(async () => assert.ok(Math.abs((await accelerated()) - 2.5) < 0.1, `${await accelerated()}`));
  await lab.copyLink();
  await eventually(async () => assert.match(lab.page.url(), /a=F:[\w-]{104}/));
  const line = await field.locator("path.curve").getAttribute("d");
  await lab.page.reload();
  await lab.page.getByRole("heading", { level: 1, name: "A push of your own" }).waitFor();
  await eventually(async () => assert.equal(await field.locator("path.curve").getAttribute("d"), line));
  await lab.page.getByRole("button", { name: "Clear: Push" }).click();
  await eventually(async () => assert.equal(await accelerated(), 0));
});

visit("point by point with the keys, each with its value", async (lab) => {
  await opened(lab);
  const field = lab.slider("Push");
  await eventually(async () => assert.equal(await field.getAttribute("aria-valuetext"), "t = 0 s: 0 N"));
  // The page may still be building its controls, and the field lose the focus.
  await eventually(async () => {
    await field.focus();
    await lab.keys("Home", "ArrowRight", "ArrowRight");
    assert.equal(await field.getAttribute("aria-valuetext"), "t = 0.4 s: 0 N");
  });
  await lab.keys("ArrowUp", "PageUp");
  await eventually(async () => assert.equal(await field.getAttribute("aria-valuetext"), "t = 0.4 s: 2.5 N"));
  await lab.keys("End", "ArrowDown");
  await eventually(async () => assert.equal(await field.getAttribute("aria-valuetext"), "t = 10 s: −0.5 N"));
  await lab.keys("Home");
  assert.equal(await field.getAttribute("aria-valuetext"), "t = 0 s: 0 N");
});

visit("with a finger, in Spanish, on the page of one simulation", { file: exported, language: "es", ...PHONE }, async (page) => {
  const field = page.slider("Empujón");
  await field.scrollIntoViewIfNeeded();
  await field.evaluate((node) => node.scrollIntoView({ block: "center", behavior: "instant" }));
  // The page may still be laying out what stands above.
  let box = await field.boundingBox();
  await eventually(async () => {
    const before = box;
    await page.page.waitForTimeout(100);
    box = await field.boundingBox();
    assert.deepEqual(box, before);
  });
  const session = await page.context.newCDPSession(page.page);
  const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  const scrolled = () => page.page.evaluate(() => window.scrollY);
  const before = await scrolled();
  await touch("touchStart", [{ x: box.x + 2, y: box.y + box.height / 2 }]);
  for (let step = 1; step <= 10; step += 1) {
    await touch("touchMove", [{ x: box.x + (step / 10) * (box.width - 2), y: box.y + box.height / 2 - 4 * step }]);
  }
  await touch("touchEnd", []);
  await eventually(async () => assert.match(await field.getAttribute("aria-valuetext"), /^t = 10 s: [1-9]/));
  assert.equal(await scrolled(), before, "the page stays where it is");
});

for (const theme of ["light", "dark"]) {
  visit(`axe finds nothing wrong, ${theme}`, { file: exported, theme, ...STILL }, async (page) => {
    await page.slider("Push").focus();
    await page.keys("PageUp");
    await page.page.evaluate(axe);
    const { violations } = await page.page.evaluate(() => window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag22aa"] }));
    assert.deepEqual(violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.target).join(" ")}`), []);
  });
}

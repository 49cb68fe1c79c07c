// One ruler for picture and plot: the curve is drawn at the height of the liquid, and a ring shows what can be dragged.

import assert from "node:assert/strict";
import { eventually, visit } from "../lab.mjs";

const line = (lab) => lab.page.locator(".level-line");
const ring = (lab) => lab.page.locator(".level-ring > .bubble");

/** How far the line is from the surface of the left column, in pixels, and how far its end lies within the plot, in one frame. */
const offset = (lab) =>
  lab.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
    const surface = document.querySelector(".drawing").shadowRoot.querySelector(".skin").getBoundingClientRect();
    const drawn = document.querySelector(".level-line").getBoundingClientRect();
    const plot = document.querySelector("#canvas-0").getBoundingClientRect();
    done({ off: Math.abs(drawn.top + 1 - surface.bottom), within: drawn.right - plot.left, shown: drawn.width > 0 });
  }))));

for (const [width, height] of [[1440, 900], [1280, 720], [1100, 760]]) {
  visit(`the line leads from the liquid to the curve in every frame: ${width}`, { width, height, fragment: "" }, async (lab) => {
    await line(lab).waitFor();
    const frames = [await offset(lab)];
    await lab.button("Play").click();
    for (let count = 0; count < 12; count += 1) frames.push(await offset(lab));
    assert.ok(frames.every(({ off, within, shown }) => shown && off <= 1.5 && within > 20), JSON.stringify(frames));
    assert.ok(Math.max(...frames.map(({ within }) => within)) > frames[0].within + 10, "the end follows the curve");
  });
}

visit("another quantity, a zoom and a swing that does not fit have a scale of their own", { fragment: "" }, async (lab) => {
  await line(lab).waitFor();
  await lab.page.locator("#canvas-0").focus();
  await lab.keys("+");
  await line(lab).waitFor({ state: "hidden" });
  await lab.keys("0");
  await line(lab).waitFor();
  await lab.page.locator("#show-plot-1").click();
  await lab.page.locator("#show-plot-0").click();
  await line(lab).waitFor({ state: "hidden" });
});

visit("the ring shows what can be dragged until it has been dragged", { fragment: "" }, async (lab) => {
  await ring(lab).waitFor();
  await eventually(async () => assert.match(await ring(lab).innerText(), /Drag it, then let go/));
  const at = await lab.page.locator(".level-line").boundingBox();
  const held = await ring(lab).evaluate((node) => node.parentElement.getBoundingClientRect().toJSON());
  assert.ok(Math.abs(held.y - at.y) < 2, JSON.stringify([held, at]));
  await lab.page.mouse.move(held.x, held.y);
  await lab.page.mouse.down();
  await lab.page.mouse.move(held.x, held.y - 40, { steps: 5 });
  await ring(lab).waitFor({ state: "hidden" });
  const { off } = await offset(lab);
  assert.ok(off <= 1.5, `${off}`);
  await lab.page.mouse.up();
  await lab.page.reload();
  await line(lab).waitFor();
  assert.equal(await ring(lab).isVisible(), false);
});

visit("on a phone the plot has its own scale, and the ring is there", { width: 390, height: 844, touch: true }, async (lab) => {
  await ring(lab).waitFor();
  assert.equal(await line(lab).isVisible(), false);
});

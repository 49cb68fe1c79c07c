// The film that the page has: See it measured from the first screen, and from its first click to a fit by hand.

import assert from "node:assert/strict";
import { eventually, visit } from "../lab.mjs";

const story = (lab, moment) => lab.page.locator(`:root[data-story="${moment}"]`).waitFor({ timeout: 90000 });

/** Notes while the curve is drawn, as the page has it, how far the pen is from the surface found in the film, in pixels. */
const watchPen = (lab) =>
  lab.page.evaluate(() => {
    globalThis.offsets = [];
    setInterval(() => {
      const [mark, pen] = [".film-mark.found", ".level-line:not([hidden])"].map((name) => document.querySelector(name)?.getBoundingClientRect());
      if (document.documentElement.dataset.story === "curve" && mark && pen) globalThis.offsets.push(Math.abs(mark.top + mark.height / 2 - pen.top - 1));
    }, 20);
  });

visit("See it measured: one press, and the curve comes out of the filmed liquid", { fragment: "" }, async (lab) => {
  await lab.page.locator("#see-measured").click();
  await story(lab, "film");
  const box = async (name) => lab.page.locator(name).boundingBox();
  const drawing = await box("#scene .drawing");
  await story(lab, "curve");
  // The film stands where the drawing was.
  const film = await box(".film-frame");
  assert.ok(Math.abs(film.x + film.width / 2 - drawing.x - drawing.width / 2) < 2, JSON.stringify([film, drawing]));
  await story(lab, "theory");
  await story(lab, "fit");
  await eventually(async () => assert.match(await lab.page.locator("#fit-lines").innerText(), /Hit[^]*= 0\.66/));
  await lab.page.locator("#your-turn").click();
  await lab.page.locator(":root:not([data-story])").waitFor();
  assert.equal(await lab.page.locator("#scene").isVisible(), true);
  await eventually(async () => assert.match(await lab.page.locator("#panel").innerText(), /0\.0105/));
});

visit("any press ends the story; the film stays, and is measured on", { fragment: "" }, async (lab) => {
  await lab.page.locator("#see-measured").click();
  await story(lab, "film");
  await lab.page.locator("#film-frame[data-frame]").waitFor();
  await lab.page.locator(".head h1").click();
  await lab.page.locator(":root.with-film:not([data-story])").waitFor();
  await lab.page.locator("#film-record").waitFor({ timeout: 90000 });
});

visit("with less motion the story stands still and comes to the same end", { fragment: "", motion: "reduce" }, async (lab) => {
  await watchPen(lab);
  await lab.page.locator("#see-measured").click();
  await story(lab, "fit");
  // The last frame has stood still for a while: the pen is at the height of the filmed surface.
  const offsets = await lab.page.evaluate(() => globalThis.offsets);
  assert.ok(offsets.length > 5 && offsets.slice(-5).every((offset) => offset <= 2), JSON.stringify(offsets.slice(-9)));
  await eventually(async () => assert.match(await lab.page.locator("#fit-lines").innerText(), /Hit/));
  await lab.keys("Escape");
  await lab.page.locator(":root.with-film:not([data-story])").waitFor();
});

visit("from the sample film to a fit in five actions", { fragment: "" }, async (lab) => {
  await lab.tab("Measure");
  await lab.page.locator("#open-sample").click();
  await lab.page.locator("#film-frame[data-frame]").waitFor();
  await lab.page.locator("#film-asked").waitFor();
  for (const [x, y] of [[205.5, 224], [312.75, 573], [312.75, 141]]) {
    const box = await lab.page.locator("#film-frame").boundingBox();
    await lab.page.mouse.click(box.x + (x / 472) * box.width, box.y + (y / 736) * box.height);
  }
  await lab.page.locator("#film-record").waitFor({ timeout: 90000 });
  await lab.page.locator("#fit").click();
  await eventually(async () => assert.match(await lab.page.locator("#fit-lines").innerText(), /Hit[^]*= 0\.66/));
});

// Plots as a person reads them: what shares the room, pinned readings, kept runs in the hue of their curve.

import assert from "node:assert/strict";
import { eventually, number, visit } from "../lab.mjs";

const boxes = (lab) => lab.page.locator(".figures .plot:visible").evaluateAll((plots) => plots.map((plot) => plot.getBoundingClientRect().height));

/** Plays at eight times the speed until `seconds`, and pauses. */
async function record(lab, seconds) {
  await lab.page.getByLabel("Speed").selectOption("8 ×");
  await lab.press("Play");
  await lab.watchUntil(seconds);
  await lab.press("Pause");
}

visit("one plot is open beside the scene; more of them share its room", async (lab) => {
  const alone = await boxes(lab);
  assert.equal(alone.length, 1);
  await lab.press("Phase portrait");
  await lab.press("Energy");
  const [first, second, third] = await boxes(lab);
  assert.ok(Math.abs(first - second) < 2 && Math.abs(second - third) < 2, "three of the same height");
  assert.ok(alone[0] > 1.8 * first, `${alone[0]} px`);
  // The canvas has as many pixels as it is large.
  const sizes = await lab.page.locator("#canvas-0").evaluate((canvas) => [canvas.width, canvas.clientWidth * devicePixelRatio, canvas.height, canvas.clientHeight * devicePixelRatio]);
  assert.ok(Math.abs(sizes[0] - sizes[1]) <= 1 && Math.abs(sizes[2] - sizes[3]) <= 1, String(sizes));
});

visit("the stage stays in sight while the panel is read", async (lab) => {
  await lab.tab("Questions");
  await lab.page.locator("section.question").last().scrollIntoViewIfNeeded();
  assert.ok((await lab.page.evaluate(() => scrollY)) > 500);
  const box = await lab.page.locator("#canvas-0").boundingBox();
  assert.ok(box.y > 0 && box.y < 400, `the plot is at ${box.y}`);
  const play = await lab.page.locator("#play").boundingBox();
  assert.ok(play.y > 0 && play.y + play.height < 900);
});

visit("on a phone the scene and one plot are in sight, above the slider that moves them", { width: 390, height: 844, touch: true }, async (lab) => {
  assert.equal((await boxes(lab)).length, 1);
  await lab.press("Energy");
  assert.deepEqual(await lab.page.locator(".figures .plot:visible h3").allTextContents(), ["Energy"]);
  await lab.openMore();
  const slider = lab.page.locator("#further").getByRole("slider").first();
  await slider.evaluate((slider) => slider.scrollIntoView({ block: "center", behavior: "instant" }));
  const [scene, above, below] = [await lab.page.locator("#scene .drawing").boundingBox(), await lab.page.locator(".figures canvas:visible").boundingBox(), await slider.boundingBox()];
  assert.ok(scene.y >= 0 && scene.height > 150 && scene.x + scene.width <= above.x, JSON.stringify(scene));
  assert.ok(above.y + above.height <= below.y && above.height > 90, `${JSON.stringify(above)}, ${below.y}`);
});

visit("two readings are pinned by pressing, and compared", async (lab) => {
  await record(lab, 8);
  const box = await lab.page.locator("#canvas-0").boundingBox();
  const plot = lab.page.locator("figure.plot").first();
  const press = (part) => lab.page.mouse.click(box.x + box.width * part, box.y + box.height / 2);
  await press(0.3);
  const pins = plot.locator(".pins li");
  await eventually(async () => assert.match(await pins.innerText(), /^A t = [\d.]+\ss, y = /));
  await lab.page.mouse.move(5, 5);
  assert.equal(await pins.count(), 1, "it stays");
  await press(0.5);
  await eventually(async () => assert.equal(await pins.count(), 3));
  const [a, b, difference] = await pins.allInnerTexts();
  const time = (text) => number(text.match(/t = (\S+)/)[1]);
  assert.ok(Math.abs(time(difference) - (time(b) - time(a))) < 0.006, `${a}; ${b}; ${difference}`);
  assert.match(await lab.told(), /^Pinned: .*Difference: Δt = /);
  await plot.getByRole("button", { name: "Unpin the readings" }).click();
  assert.equal(await pins.count(), 0);
});

visit("readings are pinned by keys", async (lab) => {
  await record(lab, 4);
  await lab.page.locator("#canvas-0").focus();
  await lab.keys("ArrowLeft", "Enter", "Shift+ArrowLeft", "Shift+ArrowLeft", "Enter");
  const pins = lab.page.locator("figure.plot").first().locator(".pins li");
  await eventually(async () => assert.match(await pins.nth(2).innerText(), /Δt = −/));
  await lab.keys("Escape");
  assert.equal(await pins.count(), 0);
});

visit("a reading stays when the finger lifts", { width: 390, height: 844, touch: true }, async (lab) => {
  await record(lab, 6);
  const box = await lab.page.locator("#canvas-0").boundingBox();
  await lab.page.touchscreen.tap(box.x + box.width * 0.4, box.y + box.height / 2);
  await eventually(async () => assert.match(await lab.page.locator(".pins li").first().innerText(), /^A t = /));
});

visit("a tip is as long as it needs to be, and in the window", async (lab) => {
  for (const damping of ["100", "200", "300", "400"]) {
    await lab.enter("Damping", damping);
    await lab.press("Back to start");
    await record(lab, 3);
    await lab.press("Keep run");
  }
  await lab.press("Energy");
  const box = await lab.page.locator("#canvas-2").boundingBox();
  await lab.page.mouse.move(box.x + box.width * 0.15, box.y + box.height / 2);
  await lab.page.mouse.move(box.x + box.width * 0.15 + 1, box.y + box.height / 2);
  const tip = lab.page.locator("figure.plot").nth(2).locator(".tip");
  await eventually(async () => assert.equal(await tip.isVisible(), true));
  const { x, y, width, height } = await tip.boundingBox();
  assert.ok(x >= 0 && y >= 0 && x + width <= 1440 && y + height <= 900, JSON.stringify({ x, y, width, height }));
  assert.equal((await tip.innerText()).split("\n").length, 16, "time, three curves, and those of four runs");
});

visit("kept runs have dashes of their own and the hue of their curve, paler, in the list and in what is saved", async (lab) => {
  await lab.press("Step forward");
  await lab.press("Keep run");
  await lab.press("Back to start");
  await lab.enter("Damping", "300");
  await lab.press("Step forward");
  await lab.press("Keep run");
  const samples = lab.page.locator(".runs .sample");
  const colours = await samples.evaluateAll((samples) => samples.map((sample) => getComputedStyle(sample).color));
  assert.equal(new Set(colours).size, 1, String(colours));
  const dashes = await samples.locator("path").evaluateAll((paths) => paths.map((path) => path.getAttribute("stroke-dasharray")));
  assert.equal(new Set(dashes).size, 2, String(dashes));
  const curve = await lab.page.locator(".legend li:not(.of-run) .sample").first().evaluate((sample) => getComputedStyle(sample).color);
  assert.ok(!colours.includes(curve));
  const { text } = await lab.saveOfPlot(lab.page.locator("figure.plot").first(), "Download SVG");
  assert.match(text, />b = 300\skg\/s</);
});

visit("the projector's view shows the stage alone; the button and Escape leave it", async (lab) => {
  const size = async () => {
    const { width, height } = await lab.page.locator("#scene").boundingBox();
    return width * height;
  };
  const before = await size();
  for (const leave of [() => lab.press("Projector's view"), () => lab.keys("Escape")]) {
    await lab.press("Projector's view");
    assert.equal(await lab.page.locator(".head").isVisible(), false);
    assert.equal(await lab.page.locator("#panel").isVisible(), false);
    assert.ok((await size()) > 1.4 * before, `${await size()} after ${before}`);
    const { overflows } = await lab.page.evaluate(() => ({ overflows: document.documentElement.scrollWidth > innerWidth || document.documentElement.scrollHeight > innerHeight }));
    assert.equal(overflows, false, "everything is on the screen");
    await leave();
    assert.equal(await lab.page.locator("#panel").isVisible(), true);
    assert.ok(Math.abs((await size()) - before) < 1);
  }
});

visit("at most 30 controls on the first screen, and Play among the first stops of Tab", async (lab) => {
  await lab.tabTo("#play", 12);
  const stops = await lab.page.locator("button, input, select, a[href], summary, canvas, [tabindex='0']").evaluateAll((all) =>
    all.filter((node) => {
      const box = node.getBoundingClientRect();
      return node.tabIndex >= 0 && node.checkVisibility() && box.bottom > 0 && box.top < innerHeight && box.right > 0;
    }).length);
  assert.ok(stops <= 30, `${stops} controls`);
});

visit("a stopwatch measures the time of the run", async (lab) => {
  await lab.page.getByLabel("Speed").selectOption("8 ×");
  await lab.press("Stopwatch");
  const watch = lab.page.getByRole("group", { name: "Stopwatch" });
  await lab.press("Play");
  await lab.watchUntil(1);
  await lab.press("Start the stopwatch");
  const running = await lab.time();
  await lab.watchUntil(running + 2);
  await lab.press("Pause");
  await lab.press("Stop the stopwatch");
  const held = number(await watch.locator("output").innerText());
  assert.ok(held >= 2 && held < (await lab.time()) - 1, `${held} s`);
  assert.match(await lab.told(), /^Stopwatch: [\d.]+ s/);
  await lab.press("Play");
  await lab.watchUntil((await lab.time()) + 1);
  await lab.press("Pause");
  assert.equal(number(await watch.locator("output").innerText()), held, "it stands");
  await lab.press("Reset the stopwatch");
  assert.equal(number(await watch.locator("output").innerText()), 0);
});

visit("a ruler measures lengths in the scene, by pointer and by keys", async (lab) => {
  await lab.press("Ruler");
  const ends = lab.page.getByRole("slider", { name: /^End of the ruler/ });
  assert.equal(await ends.count(), 2);
  const reads = async () => number(await ends.first().getAttribute("aria-valuetext"));
  const before = await reads();
  await ends.nth(1).focus();
  await lab.keys("Shift+ArrowUp");
  assert.ok((await reads()) > before, `${before} m, then ${await reads()} m`);
  // As far as the drawing says: 53 units are a metre.
  const { x, y, width, height } = await ends.nth(1).boundingBox();
  const unit = await ends.nth(1).evaluate((end) => end.ownerSVGElement.getScreenCTM().d);
  const from = await reads();
  await lab.page.mouse.move(x + width / 2, y + height / 2);
  await lab.page.mouse.down();
  await lab.page.mouse.move(x + width / 2, y + height / 2 + 53 * unit, { steps: 5 });
  await lab.page.mouse.up();
  assert.ok(Math.abs((await reads()) - (from - 1)) < 0.03, `${from} m, then ${await reads()} m`);
  assert.match(await lab.told(), /^Ruler: /);
  await lab.press("Ruler");
  assert.equal(await ends.count(), 0);
});

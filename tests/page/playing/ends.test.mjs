// Runs that are watched faster than they happen and have an end, and plots that need runs of their own.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { Lab, beside, eventually, temporary, visit } from "../lab.mjs";
import { withoutWorkers } from "../workers.mjs";

/** Opens the driven oscillator whose time is counted in days. */
async function driven(lab) {
  await lab.page.setInputFiles("#open-file", beside("resonance.md"));
  await lab.page.getByRole("heading", { level: 1, name: "A moon with a tide" }).waitFor();
}

visit("a run pauses at the end that its document gives it, says so, and goes on", async (lab) => {
  await driven(lab);
  const offered = await lab.page.getByLabel("Speed").locator("option").allInnerTexts();
  assert.deepEqual(offered, ["0.125 d/s", "0.25 d/s", "0.5 d/s", "1 d/s", "2 d/s", "4 d/s", "8 d/s"]);
  assert.equal(await lab.button("Go on").count(), 0);
  await lab.press("Play");
  await lab.button("Go on").waitFor();
  assert.equal(await lab.time(), 2);
  assert.match(await lab.told(), /^The run ends at 2\.000\sd; press Play to continue$/);
  assert.equal(await lab.button("Play").count(), 1, "it stands still");
  // By the keyboard: the focus stays in the transport when the button is gone.
  await lab.button("Go on").focus();
  await lab.page.keyboard.press("Enter");
  await eventually(async () => assert.ok((await lab.time()) > 2));
  assert.equal(await lab.page.evaluate(() => document.activeElement.id), "play");
  assert.equal(await lab.button("Go on").count(), 0);
  await lab.press("Pause");
});

visit("a plot over the values of a parameter says how far it is, and is read by keys", async (lab) => {
  await driven(lab);
  // What is said of the progress, however short.
  await lab.page.evaluate(() => {
    window.progress = [];
    new MutationObserver(() => {
      for (const shown of document.querySelectorAll("figure.plot .progress")) window.progress.push(shown.textContent);
    }).observe(document.body, { childList: true, subtree: true, characterData: true });
  });
  const progresses = () => eventually(async () => {
    const said = await lab.page.evaluate(() => window.progress);
    assert.ok(said.length > 0 && said.every((text) => /^\d+ of 1101 runs$/.test(text.trim())), JSON.stringify(said.slice(0, 5)));
  });
  // Its runs are computed once it is shown.
  await lab.showPlots();
  const plot = lab.page.locator("figure.plot", { hasText: "Resonance" });
  const progress = plot.locator(".progress");
  await progresses();
  await eventually(async () => assert.equal(await progress.count(), 0), 60);
  // Another parameter: the runs are made again.
  const slider = lab.slider(/^Damping/);
  await lab.play(slider);
  await slider.focus();
  await lab.page.evaluate(() => { window.progress = []; });
  await lab.page.keyboard.press("ArrowRight");
  await progresses();
  await eventually(async () => assert.equal(await progress.count(), 0), 60);
  await plot.locator("canvas").focus();
  await lab.page.keyboard.press("ArrowRight");
  assert.match(await lab.told(), /ω = 3[.\d]*\s/);
});

/** Opens a pendulum with two plots over the angle from which it starts. `change` changes its text. */
async function swings(lab, change = (text) => text) {
  const path = temporary("swings.md");
  writeFileSync(path, change(readFileSync(beside("swings.md"), "utf8")));
  await lab.page.setInputFiles("#open-file", path);
  await lab.page.getByRole("heading", { level: 1, name: "Swings" }).waitFor();
}

const plot = (lab, title) => lab.page.locator("figure.plot", { has: lab.page.getByRole("heading", { name: title, exact: true }) });
const isComplete = (lab, title) => eventually(async () => assert.equal(await plot(lab, title).locator(".progress").count(), 0), 120);

/** Moves the slider three times while runs are made, and takes the data of both plots once they are complete. */
async function moved(lab) {
  await swings(lab);
  const slider = lab.slider(/^Friction/);
  await lab.play(slider);
  await slider.focus();
  for (let presses = 0; presses < 3; presses += 1) await lab.keys("ArrowRight");
  await lab.showPlots();
  const saved = [];
  for (const title of ["Lines", "Points"]) {
    await isComplete(lab, title);
    saved.push((await lab.saveOfPlot(plot(lab, title), "Download CSV of this plot")).text);
  }
  return saved;
}

visit("a slider is moved while a plot over a parameter is computed: workers draw what the page itself draws", async (lab) => {
  const [lines, points] = await moved(lab);
  assert.ok(lab.page.workers().length > 0, "workers compute");
  assert.equal(lines.trim().split("\n").length, 1 + 681);
  assert.ok(points.trim().split("\n").length > 10_000);
  // The browser reports in its console what it refuses; this page is not asked whether it was quiet.
  const other = await Lab.open({ file: withoutWorkers() });
  try {
    assert.deepEqual(await moved(other), [lines, points]);
    assert.equal(other.page.workers().length, 0);
  } finally {
    await other.context.close();
  }
});

visit("a plot whose runs take no time needs no worker", async (lab) => {
  await swings(lab, (text) => text.replace("step 0.25", "step 85").replace("until: 60", "until: 2"));
  await isComplete(lab, "Lines");
  assert.equal(lab.page.workers().length, 0);
});

visit("a hidden plot is not computed; another document gives up the runs of the one before", async (lab) => {
  await swings(lab);
  await lab.press("Lines");
  await lab.press("Lines");
  await isComplete(lab, "Lines");
  const slider = lab.slider(/^Friction/);
  await lab.play(slider);
  await slider.focus();
  await lab.keys("ArrowRight");
  await swings(lab);
  await isComplete(lab, "Lines");
});

// Runs that are watched faster than they happen and have an end, and plots that need runs of their own.

import assert from "node:assert/strict";
import { beside, eventually, visit } from "../lab.mjs";

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

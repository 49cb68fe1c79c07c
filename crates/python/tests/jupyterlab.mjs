// A person with the widget of widget.ipynb in JupyterLab: `node jupyterlab.mjs BROWSER ADDRESS`. Prints how long a slider takes to Python
// and back.

import assert from "node:assert/strict";
import { createRequire } from "node:module";

const { chromium } = createRequire(new URL("../../../tests/page/package.json", import.meta.url))("playwright-core");

const [executablePath, address] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu"] });
const page = await browser.newPage({ viewport: { width: 1280, height: 1100 } });
page.setDefaultTimeout(60_000);
try {
  await page.goto(`${address}/lab/tree/widget.ipynb`);
  const cell = page.locator(".jp-CodeCell").first();
  await cell.locator(".cm-content").click();
  const run = async (count) => {
    for (let ran = 0; ran < count; ran += 1) await page.keyboard.press("Shift+Enter");
  };
  await run(2);
  const shown = page.frameLocator('iframe[title="Damped oscillation"]');
  const slider = (name) => shown.getByRole("slider", { name });
  await slider("Damping rate").waitFor();
  const valueOf = (name) => slider(name).getAttribute("aria-valuetext");
  const eventually = async (check) => {
    for (let tried = 0; ; tried += 1) {
      try {
        return await check();
      } catch (failure) {
        if (tried > 300) throw failure;
        await page.waitForTimeout(100);
      }
    }
  };
  // Python moves a slider.
  await run(1);
  await eventually(async () => assert.match(await valueOf("Natural angular frequency"), /^20/));
  // A slider reaches Python, which moves another.
  await slider("Damping rate").focus();
  await page.keyboard.press("ArrowRight");
  await eventually(async () => assert.doesNotMatch(await valueOf("Displacement at the start"), /^2[^.,\d]/));
  const times = [];
  for (let turn = 0; turn < 20; turn += 1) {
    const begun = await slider("Displacement at the start").evaluateHandle((element) => {
      const before = element.getAttribute("aria-valuetext");
      const answered = new Promise((resolve) => {
        new MutationObserver(() => element.getAttribute("aria-valuetext") !== before && resolve(performance.now())).observe(element, { attributes: true });
      });
      return { answered };
    });
    const pressed = await slider("Damping rate").evaluate((element, by) => {
      element.value = String(Number(element.value) + by);
      element.dispatchEvent(new Event("input", { bubbles: true }));
      return performance.now();
    }, turn % 2 === 0 ? 5 : -5);
    times.push((await begun.evaluate(({ answered }) => answered)) - pressed);
    await page.waitForTimeout(100);
  }
  times.sort((one, other) => one - other);
  console.log(`slider to Python and back: median ${times[10].toFixed(0)} ms, longest ${times[19].toFixed(0)} ms`);
} finally {
  await browser.close();
}

// A person with the widget in a notebook: `node widget.mjs BROWSER MODE ADDRESS`. MODE is "cells" where the person runs three cells, and
// "button" where cells run by themselves and a button runs the last one. Prints how long a slider takes to Python and back.

import assert from "node:assert/strict";
import { createRequire } from "node:module";

const { chromium } = createRequire(new URL("../../../tests/page/package.json", import.meta.url))("playwright-core");

const [executablePath, mode, address] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-gpu"] });
const page = await browser.newPage({ viewport: { width: 1280, height: 1100 } });
page.setDefaultTimeout(60_000);
try {
  await page.goto(address);
  let ran = 0;
  // The next cell. Pressed before there is a kernel, the keys run nothing: a person sees no number beside the cell, and presses again.
  const run = async () => {
    const cell = page.locator(".jp-CodeCell").nth(ran);
    for (let tried = 0; ; tried += 1) {
      await cell.locator(".cm-content").click();
      await page.keyboard.press("Shift+Enter");
      try {
        await cell.locator(".jp-InputPrompt", { hasText: /\[(\*|\d+)\]/ }).waitFor({ timeout: 5000 });
        break;
      } catch (failure) {
        if (tried > 10) throw failure;
      }
    }
    ran += 1;
  };
  if (mode === "cells") {
    await run();
    await run();
  }
  const shown = page.frameLocator('iframe[title="Damped oscillation"]');
  const slider = (name) => shown.getByRole("slider", { name });
  await slider("Damping rate").waitFor({ timeout: 240_000 });
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
  if (mode === "cells") await run();
  else await page.getByRole("button", { name: "Move" }).click();
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

// The strip under the plots: what a fit needs and its result are in sight without scrolling, in every window.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { drop, eventually, visit } from "../lab.mjs";
import { film, openTheory, records } from "../measured.mjs";

const WINDOWS = [["desk", { width: 1440, height: 900 }], ["tablet", { width: 1024, height: 768 }], ["phone", { width: 390, height: 844, touch: true }]];

/** Measured columns, which are not part of the project; without them a drawn one, in metres without a unit. */
const measured = [1, 2, 3, 4].map((number) => new URL(`../../../../shared/data/utube/U${number}.txt`, import.meta.url)).filter((file) => existsSync(file));
const drawn = () => film().split("\r\n").slice(1).map((row) => row.replaceAll(",", ".").split(";").map(Number)).map(([time, level]) => `${time} ${level / 100}`).join("\n");
const texts = measured.length ? measured.map((file) => [file.pathname.split("/").pop(), readFileSync(file, "utf8")]) : [["drawn.txt", drawn()]];

/** Asserts that an element is whole inside the window and covered by nothing. */
async function inSight(lab, selector) {
  const found = await lab.page.evaluate((selector) => {
    const element = document.querySelector(selector);
    const { left, top, right, bottom } = element.getBoundingClientRect();
    const corners = [[left + 4, top + 4], [right - 4, bottom - 4]].map(([x, y]) => document.elementFromPoint(x, y));
    return {
      whole: left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight && bottom > top,
      seen: corners.every((corner) => corner && (element.contains(corner) || corner.contains(element))),
      box: [left, top, right, bottom],
      scrolled: scrollY,
    };
  }, selector);
  assert.ok(found.whole && found.seen, `${selector}: ${JSON.stringify(found)}`);
  assert.equal(found.scrolled, 0, "nobody has scrolled");
}

for (const [device, size] of WINDOWS) {
  for (const [name, text] of device === "desk" ? texts : texts.slice(0, 1)) {
    visit(`the first fit of a dropped record takes two actions and no scrolling: ${name}, ${device}`, { ...size, fragment: "" }, async (lab) => {
      await drop(lab, { name, text });
      await records(lab).waitFor();
      assert.equal(await lab.page.getByRole("button", { name: "Fit", exact: true }).count(), 1, "one button of this name");
      await inSight(lab, "#fit");
      await lab.page.locator("#fit").click();
      const nearness = lab.page.locator("#fit-lines .nearness");
      await nearness.waitFor({ timeout: 60_000 });
      // The curve meets the data with what is preselected.
      assert.equal(await nearness.getAttribute("data-nearness"), "met");
      const [, percent] = /Hit: off by ([\d.]+) % of the swing/.exec(await nearness.innerText());
      assert.ok(Number(percent) < 5, percent);
      assert.match(await lab.page.locator("#fit-lines .lead").innerText(), / = 0\.\d+ ± 0\.\d+ s\s*Period$/);
      assert.ok((await lab.page.locator("#fit-lines .found > span").count()) >= 4);
      await inSight(lab, "#fit");
      for (const line of [".nearness", ".lead", ".found > span"]) await inSight(lab, `#fit-lines ${line}`);
    });
  }

  visit(`all else about a fit is folded, and the strip is of this tab alone: ${device}`, size, async (lab) => {
    await openTheory(lab, "Linear damping");
    await drop(lab, { name: "film.csv", text: film() });
    await records(lab).waitFor();
    assert.deepEqual(await lab.page.locator(".fitting-steps > details").evaluateAll((steps) => steps.map((step) => step.open)), [false, false, false]);
    await lab.tab("Theory");
    assert.equal(await lab.page.locator("#strip").count(), 0);
    await lab.tab("Measure");
    assert.equal(await lab.page.locator("#fit-record").evaluate((choice) => choice.selectedOptions[0].textContent), "film.csv");
    const theory = lab.page.locator("#fit-theory");
    assert.equal(await theory.evaluate((choice) => choice.selectedOptions[0].textContent), "Linear damping");
    // Another theory is chosen where the eye is.
    await theory.selectOption({ label: "Quadratic damping" });
    await lab.page.getByRole("heading", { level: 1, name: "Quadratic damping" }).waitFor();
    await eventually(async () => assert.equal((await lab.focused()).id, "fit-theory"));
    await lab.page.locator("#fit").click();
    await lab.page.locator("#fit-lines .nearness").waitFor({ timeout: 60_000 });
  });
}

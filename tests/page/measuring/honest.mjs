// A measure, not a part of the tests: COUNT hand-ins and COUNT reports with different data, made in Chromium, all verified by the
// program. `COUNT=20 CHROME=.. MENISCUS=.. PAGE=.. node --test measuring/honest.mjs`

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { drop, eventually, program, temporary, visit } from "../lab.mjs";
import { film, fit, openTheory, records } from "../measured.mjs";

const COUNT = Number(process.env.COUNT ?? 20);

visit("hand-ins and reports made in the browser hold", async (lab) => {
  const files = [];
  for (let seed = 1; seed <= COUNT; seed += 1) {
    await lab.page.evaluate(() => localStorage.clear());
    await lab.page.goto("about:blank");
    await lab.go(lab.address);
    await openTheory(lab, seed % 2 ? "Linear damping" : "Quadratic damping");
    await drop(lab, { name: `tube-${seed}.csv`, text: film(0.15 + 0.005 * seed, seed) });
    await eventually(async () => assert.equal(await records(lab).count(), 1));
    await fit(lab);
    const report = await lab.save(lab.page.locator("#export-Report-false"));
    await lab.press("Share");
    await lab.page.locator("#hand-in-name").fill(`group ${seed}`);
    const handed = await lab.save(lab.page.locator("#save-hand-in"));
    for (const [name, text] of [[`${seed}.html`, report.text], [`${seed}.hand-in`, handed.text]]) {
      files.push(temporary(name));
      writeFileSync(files.at(-1), text);
    }
  }
  const found = [];
  for (const file of files) {
    try {
      found.push(JSON.parse(execFileSync(program, ["verify", file, "--format", "json"], { encoding: "utf8" })).hand_ins[0]);
    } catch (failure) {
      found.push(JSON.parse(failure.stdout).hand_ins[0]);
    }
  }
  const alarms = found.filter((one) => !one.holds);
  console.log(`${found.length} made in Chromium, ${alarms.length} false alarms, ${found.reduce((sum, one) => sum + one.equal, 0)} equal values`);
  assert.deepEqual(alarms, []);
});

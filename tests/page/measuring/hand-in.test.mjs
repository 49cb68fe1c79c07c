// Handing in: the program computes the results of the page again, bit for bit.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { readFileSync, writeFileSync } from "node:fs";
import { STILL, drop, eventually, program, temporary, visit } from "../lab.mjs";
import { film, fit, openTheory, records } from "../measured.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Exit code and result of `meniscus verify`. */
function verified(text) {
  const file = temporary("a.hand-in");
  writeFileSync(file, text);
  try {
    return { code: 0, found: JSON.parse(execFileSync(program, ["verify", file, "--format", "json"], { encoding: "utf8" })) };
  } catch (failure) {
    return { code: failure.status, found: JSON.parse(failure.stdout) };
  }
}

visit("what the page hands in follows from its data to the bit, and a changed result is named", async (lab) => {
  await openTheory(lab, "Linear damping");
  await drop(lab, { name: "one.csv", text: film(0.18, 1) }, { name: "two.csv", text: film(0.24, 2) });
  await eventually(async () => assert.equal(await records(lab).count(), 2));
  await fit(lab);
  await lab.press("Share");
  // Without a name nothing is saved.
  await lab.page.locator("#save-hand-in").click();
  assert.equal(await lab.page.locator("#hand-in-said").innerText(), "Type a name first.");
  assert.equal((await lab.focused()).id, "hand-in-name");
  await lab.page.keyboard.type("blue heron 17");
  const { name, text } = await lab.save(lab.page.locator("#save-hand-in"));
  assert.equal(name, "linear.hand-in");
  const honest = verified(text);
  assert.deepEqual(honest.found.hand_ins[0].differences, []);
  assert.equal(honest.code, 0);
  const count = honest.found.hand_ins[0].equal;
  assert.ok(count > 30, String(count));
  assert.equal(await lab.page.locator("#hand-in-said").innerText(), `Saved linear.hand-in with ${count} values.`);

  const handed = JSON.parse(text);
  handed.facts.find((fact) => fact.quantity === "value:gamma").number *= 1.0000000001;
  const changed = verified(JSON.stringify(handed));
  assert.equal(changed.code, 1);
  assert.deepEqual(changed.found.hand_ins[0].differences.map((one) => one.quantity), ["value:gamma"]);
});

for (const [language, theme, size] of [["en-GB", "light", {}], ["es-ES", "dark", { width: 390, height: 844 }]]) {
  visit(`axe finds nothing in the dialog with the hand-in: ${language}, ${theme}`, { ...STILL, language, theme, ...size }, async (lab) => {
    await lab.page.locator("#share").click();
    await lab.page.locator("#save-hand-in").scrollIntoViewIfNeeded();
    await lab.page.evaluate(axe);
    assert.deepEqual((await lab.page.evaluate(() => window.axe.run("html"))).violations.map((one) => [one.id, one.nodes.map((node) => node.html)]), []);
  });
}

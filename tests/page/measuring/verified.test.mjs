// Reports of the page carry their data. A report or hand-in that is dropped on the page is computed again there, as by the program.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { readFileSync, writeFileSync } from "node:fs";
import { STILL, drop, eventually, program, temporary, visit } from "../lab.mjs";
import { film, fit, openTheory, records } from "../measured.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Result of `meniscus verify` for a file. */
function verified(name, text) {
  const file = temporary(name);
  writeFileSync(file, text);
  try {
    return JSON.parse(execFileSync(program, ["verify", file, "--format", "json"], { encoding: "utf8" })).hand_ins[0];
  } catch (failure) {
    return JSON.parse(failure.stdout).hand_ins[0];
  }
}

/** The verdict of the page for a dropped file. */
async function verdict(lab, name, text) {
  await drop(lab, { name, text });
  await lab.page.locator("#verified[open]").waitFor();
  return eventually(async () => {
    const said = await lab.page.locator("#verdict").innerText();
    assert.doesNotMatch(said, /\.\.\./);
    return said;
  }, 60);
}

const differences = (lab) => lab.page.locator("#differences li").allInnerTexts();

let report;

visit("a report of the page holds in the program and in the page, and a change is named in both", async (lab) => {
  await openTheory(lab, "Linear damping");
  await drop(lab, { name: "one.csv", text: film(0.18, 1) });
  await eventually(async () => assert.equal(await records(lab).count(), 1));
  await fit(lab);
  const saved = await lab.save(lab.page.locator("#export-Report-false"));
  report = saved.text;
  assert.equal(saved.name, "one.html");
  const section = report.indexOf('<section id="hand-in">');
  console.log(`report: ${report.length} bytes, of which ${report.indexOf("</section>", section) - section} are the data`);
  const honest = verified("one.html", report);
  assert.deepEqual(honest.differences, []);
  assert.equal(honest.holds, true);

  const words = await verdict(lab, "one.html", report);
  assert.equal(words, `Every value follows from the data. ${honest.equal} values computed again, all equal`);
  assert.deepEqual(await differences(lab), []);
  await lab.keys("Escape");

  const results = report.indexOf("<h2>Results");
  const at = results + report.slice(results).search(/\d{2}/) + 1;
  const changed = report.slice(0, at) + (report[at] === "7" ? "3" : "7") + report.slice(at + 1);
  assert.equal(verified("changed.html", changed).differences.length, 1);
  assert.match(await verdict(lab, "changed.html", changed), /^Not every value follows from the data\./);
  assert.match((await differences(lab)).join(), /^report "Results", text: stated/);
  await lab.keys("Escape");
});

visit("a dropped hand-in is verified, and its work can be opened", async (lab) => {
  await openTheory(lab, "Linear damping");
  await drop(lab, { name: "two.csv", text: film(0.24, 2) });
  await eventually(async () => assert.equal(await records(lab).count(), 1));
  await fit(lab);
  await lab.press("Share");
  await lab.page.locator("#hand-in-name").fill("<img src=x onerror=document.title=1>");
  const { text } = await lab.save(lab.page.locator("#save-hand-in"));
  await lab.keys("Escape");

  const handed = JSON.parse(text);
  handed.facts.find((fact) => fact.quantity === "value:gamma").number *= 1.001;
  handed.bits += 1;
  assert.match(await verdict(lab, "changed.hand-in", JSON.stringify(handed)), /^Not every value follows/);
  const found = await differences(lab);
  assert.match(found[0], /whose results have bits \d+ \(here \d+\): numbers are compared to a relative deviation of 1e-6/);
  assert.match(found[1], /^fit "Linear damping: two\.csv", gamma: stated/);
  assert.match(await lab.page.locator("#verified").innerText(), /<img src=x onerror=document\.title=1>/);
  await lab.keys("Escape");

  // In a fresh page the work opens like a project.
  await lab.page.evaluate(() => localStorage.clear());
  await lab.page.goto("about:blank");
  await lab.go(lab.address);
  assert.match(await verdict(lab, "two.hand-in", text), /^Every value follows/);
  await lab.page.locator("#open-verified").click();
  await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "Linear damping"));
  await lab.page.locator("#tab-measure").click();
  await lab.page.locator(".estimates").waitFor({ state: "attached", timeout: 60_000 });

  await drop(lab, { name: "cut.hand-in", text: text.slice(0, 500) });
  await eventually(async () => assert.match(await lab.page.locator("#messages").innerText(), /cut\.hand-in is damaged; ask for it again/));
});

for (const [language, theme, size] of [["en-GB", "light", {}], ["es-ES", "dark", { width: 390, height: 844 }]]) {
  visit(`axe finds nothing in the verification: ${language}, ${theme}`, { ...STILL, language, theme, ...size }, async (lab) => {
    await verdict(lab, "one.html", report.replace("<h2>Results", "<h2>Result"));
    await lab.page.evaluate(axe);
    assert.deepEqual((await lab.page.evaluate(() => window.axe.run("html"))).violations.map((one) => [one.id, one.nodes.map((node) => node.html)]), []);
  });
}

// The dashboard of a class: hand-ins that are dropped are computed again and shown together.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { STILL, beside, drop, eventually, meniscus, temporary, visit } from "../lab.mjs";
import { film, fit, openTheory, records } from "../measured.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const linear = readFileSync(beside("../../simulations/theories/linear.md"), "utf8");

const item = (name, content) => ({ name, item: { meniscus: 3, since: 1000, item: content } });

/** The hand-in that the program makes of these items. */
function handIn(items, name) {
  const project = { "meniscus project": 1, documents: [{ name: "linear.md", text: linear }], state: "", items };
  const [from, to] = [temporary("work.meniscus"), temporary("work.hand-in")];
  writeFileSync(from, JSON.stringify(project));
  meniscus("hand-in", from, "--name", name, "--output", to);
  return readFileSync(to, "utf8");
}

/** The hand-in of a group that has measured a column of 18 cm and fitted linear damping to it. */
function group(name, seed, length = 0.18) {
  const record = item("r", { record: { name: `${name}.csv`, text: film(length, seed) } });
  const content = JSON.parse(handIn([record], name)).facts.find((fact) => fact.quantity === "content").text;
  const columns = [
    { column: 0, quantity: "t", unit: "s", stated: true, fitted: false },
    { column: 1, quantity: "y", unit: "cm", stated: false, fitted: true },
  ];
  const task = {
    file: "theories/linear.md",
    window: [null, null],
    parameters: [0.2, 0.04, 0, 0, 0, 0.4],
    varied: [{ target: { parameter: 0 } }, { target: { parameter: 1 } }, { target: { parameter: 5 } }],
    loss: "least-squares",
    records: [{ record: content, name: `${name}.csv`, columns }],
  };
  const fit = item("f", { fit: { documents: [linear], task, found: { values: [], starts: 1 } } });
  return handIn([record, fit], name);
}

const said = (lab) => lab.page.locator("#class-said").innerText();
const row = (lab, name) => lab.page.locator("#class-hand-ins tr").filter({ hasText: name });

const groups = ["otter", "heron", "fox"].map((name, place) => ({ name: `${name}.hand-in`, text: group(name, place + 1) }));

visit("hand-ins that are dropped are computed again and shown together, on the wall without names", async (lab) => {
  await drop(lab, ...groups);
  await eventually(async () => assert.equal(await said(lab), "3 groups"), 60);
  for (const name of ["otter", "heron", "fox"]) assert.match(await row(lab, name).innerText(), /\d+ values computed again, all equal/);
  const { text } = await lab.save(lab.page.locator("#class-report"));
  assert.match(text, /Linear damping/);
  const pooled = await lab.page.locator("#class-results summary").allInnerTexts();
  assert.ok(pooled.some((title) => /^Linear damping: gamma = \(0\.39\d+ ± 0\.\d+\) 1\/s, n = 3$/.test(title)), pooled.join("\n"));

  // Three curves on the wall in four actions.
  for (const name of ["otter", "heron", "fox"]) await lab.page.locator("#class-curves .chip").filter({ hasText: name }).click();
  assert.equal(await lab.page.locator("#wall .wall-content").count(), 0, "nothing before it is shown");
  await lab.page.locator("#class-wall").click();
  const wall = lab.page.locator("#wall");
  assert.equal(await wall.locator(".wall-letter").innerText(), "A, B, C");
  assert.equal(await wall.locator("svg").count() > 0, true);
  await lab.keys("ArrowRight");
  assert.equal(await wall.locator(".wall-letter").innerText(), "A · 1/3");
  await lab.keys("ArrowRight", "ArrowRight", "ArrowRight");
  assert.equal(await wall.locator(".wall-letter").innerText(), "C · 3/3");
  assert.doesNotMatch(await wall.innerText(), /otter|heron|fox/);
  await lab.keys("Escape");

  // A name stays on this device, and is in no report.
  await lab.page.locator("#class-name-0").fill("Ana");
  assert.doesNotMatch((await lab.save(lab.page.locator("#class-report"))).text, /Ana/);
  await lab.keys("Escape");
  await lab.page.reload();
  await drop(lab, groups[0]);
  await lab.page.locator("#verified-to-class").click();
  await eventually(async () => assert.equal(await lab.page.locator("#class-name-0").inputValue(), "Ana"));
});

visit("changed, repeated, damaged and hostile hand-ins are told apart, and are shown as text", async (lab) => {
  const honest = JSON.parse(groups[0].text);
  const changed = structuredClone(honest);
  changed.sender.name = "<img src=x onerror=document.title=1>";
  changed.facts.find((fact) => fact.quantity === "value:gamma").number *= 1.0000000001;
  const later = { ...honest, made: honest.made + 5 };
  await drop(
    lab,
    groups[0],
    { name: "changed.hand-in", text: JSON.stringify(changed) },
    { name: "later.hand-in", text: JSON.stringify(later) },
    { name: "cut.hand-in", text: groups[1].text.slice(0, 500) },
  );
  await eventually(async () => assert.equal(await said(lab), "2 groups, 2 further files that do not count"), 60);
  assert.match(await row(lab, "otter.hand-in").innerText(), /was made before later\.hand-in, which counts/);
  assert.match(await row(lab, "changed.hand-in").innerText(), /gamma: stated 0\.\d+, computed 0\.\d+/);
  assert.match(await row(lab, "cut.hand-in").innerText(), /is damaged; ask for it again/);
  assert.equal(await lab.page.locator("#class img").count(), 0);
  assert.equal(await lab.page.locator("#class-hand-ins .refusal").innerText().then((text) => /equal data/.test(text)), true);
  // Its work opens in the laboratory.
  await lab.page.locator("#class-open-2").click();
  await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "Linear damping"));
});

visit("a folder with hand-ins and reports: pages without data are left out, the progress is stated, results stand against a parameter", async (lab) => {
  await openTheory(lab, "Linear damping");
  await drop(lab, { name: "one.csv", text: film(0.18, 7) });
  await eventually(async () => assert.equal(await records(lab).count(), 1));
  await fit(lab);
  const report = (await lab.save(lab.page.locator("#export-Report-false"))).text;
  const folder = temporary("class");
  mkdirSync(folder);
  const files = { "one.html": report, "notes.html": "<html><body>notes</body></html>", "data.csv": "1,2" };
  for (const { name, text } of groups) files[name] = text;
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);

  await lab.tab("Class");
  await lab.page.locator("#open-class").click();
  await lab.page.evaluate(() => {
    window.seen = new Set();
    const parts = ["class-curves", "class-stuck", "class-results"];
    const look = () => parts.forEach((part) => window.seen.add(`${part}: ${document.getElementById(part)?.textContent}`));
    new MutationObserver(look).observe(document.getElementById("class"), { childList: true, subtree: true, characterData: true });
  });
  await lab.page.locator("#class-folder-files").setInputFiles(folder);
  await eventually(async () => assert.equal(await said(lab), "4 groups"), 60);
  const seen = [...(await lab.page.evaluate(() => [...window.seen]))];
  for (const part of ["class-curves", "class-stuck", "class-results"]) {
    const early = seen.filter((text) => text.startsWith(part) && text.includes("Being computed: 0 of 4 hand-ins are done."));
    assert.notEqual(early.length, 0, `${part} states the progress`);
    assert.deepEqual(early.filter((text) => /None\.|No group is stuck/.test(text)), []);
  }
  assert.match(await row(lab, "one.html").innerText(), /\d+ values computed again, all equal/);
  assert.equal(await row(lab, "notes.html").count(), 0);
  // The report is of a column that was let go otherwise.
  await eventually(async () => assert.match(await lab.page.locator("#class-stuck").innerText(), /one\.html: y_0 .* is far from the others/));

  const against = lab.page.locator("#class-against");
  const set = async (id, text) => {
    await lab.page.locator(id).fill(text);
    await lab.page.locator(id).press("Tab");
  };
  await set("#class-x", "L^^2");
  await eventually(async () => assert.match(await against.innerText(), /L\^\^2 is no power of a quantity/));
  await set("#class-y", "omega_0^2");
  await set("#class-x", "drift");
  await eventually(async () => assert.match(await against.innerText(), /omega_0\^2 \[1\/s²\] against drift/));
  assert.equal(await against.locator("svg").count(), 1);
  assert.match(await against.innerText(), /No line: /);
  assert.match((await lab.save(lab.page.locator("#class-report"))).text, /Results against a parameter/);
});

for (const [language, theme, size] of [["en-GB", "light", {}], ["es-ES", "dark", { width: 390, height: 844 }]]) {
  visit(`axe finds nothing in the dashboard and on the wall: ${language}, ${theme}`, { ...STILL, language, theme, ...size }, async (lab) => {
    const check = async () => {
      const violations = (await lab.page.evaluate(() => window.axe.run("html"))).violations;
      assert.deepEqual(violations.map((one) => [one.id, one.nodes.map((node) => node.html)]), []);
    };
    await drop(lab, ...groups);
    await eventually(async () => assert.match(await said(lab), /^3 gr\S+$/), 60);
    await lab.page.evaluate(axe);
    await check();
    await lab.page.locator("#class-curves .chip").first().click();
    await lab.page.locator("#class-wall").click();
    await check();
  });
}

// The page of one simulation, as `meniscus export` makes it: everything that a visitor does, offline, from a file.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { STILL, beside, eventually, meniscus, sight, temporary, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Exports a document and gives the page's file. */
function exported(document = "utube.md") {
  const file = temporary(document.replace(".md", ".player.html"));
  meniscus("export", join("simulations", document), "--output", file);
  return file;
}

visit("a visitor plays, changes, drags and goes back", { file: exported }, async (page) => {
  assert.deepEqual(await page.page.getByRole("tab").allInnerTexts(), ["Explore", "Questions", "Theory"]);
  await page.press("Play");
  await page.watchUntil(1);
  await page.press("Pause");
  await page.enter("Damping", "0.2 t/s");
  assert.equal(await page.number("Damping"), 200);
  await page.preset("Mercury");
  assert.equal(await page.number("Density of the liquid"), 13_546);
  await page.press("Back to start");
  assert.equal(await page.time(), 0);
  assert.equal(await page.number("Displacement"), 0.5);
  const handle = page.slider("Left column: Displacement");
  await handle.focus();
  await page.keys("ArrowDown", "ArrowDown");
  await eventually(async () => assert.ok((await page.number("Displacement")) < 0.5));
});

/** Exports the document with buttons of its author. */
function kicked() {
  const file = temporary("kicked.player.html");
  meniscus("export", beside("kicked.md"), "--output", file);
  return file;
}

visit("locked values are fixed, and the buttons of the author act", { file: kicked }, async (page) => {
  await page.go(`${page.address}?lock`);
  assert.equal(await page.field("Angular frequency").isDisabled(), true);
  assert.equal(await page.button("Restore defaults").or(page.page.locator("#restore-defaults")).isDisabled(), true);
  assert.equal(await page.button("Kick").isDisabled(), false);
  await page.press("Play");
  await page.watchUntil(0.2);
  await page.press("Kick");
  await eventually(async () => assert.equal(await page.page.locator(".readouts dl > div", { hasText: /Kicks/ }).locator("dd").innerText(), "1"));
});

visit("what is typed may be arithmetic in the names of the model", { file: exported }, async (page) => {
  await page.enter("Damping", "b_c/2");
  const half = await page.number("Damping");
  await page.enter("Damping", "b_c");
  await eventually(async () => assert.ok(Math.abs((await page.number("Damping")) / half - 2) < 1e-4));
  await page.enter("Damping", "2*(30 + 20) kg/s");
  assert.equal(await page.number("Damping"), 100);
});

visit("questions are answered, and the answers are there again", { file: exported }, async (page) => {
  await page.tab("Questions");
  const question = page.page.locator(".question").first();
  await question.getByRole("textbox").fill("1000");
  await question.getByRole("textbox").press("Enter");
  await question.getByRole("button", { name: "Show the answer" }).click();
  const answer = await sight(question.locator(".revealed strong"));
  await question.getByRole("textbox").fill(answer.split(/\s/)[0]);
  await question.getByRole("textbox").press("Enter");
  await eventually(async () => assert.match(await sight(question), /Correct/));
  await page.page.reload();
  await page.tab("Questions");
  await eventually(async () => assert.match(await sight(page.page.locator(".question").first()), /Correct/));
});

visit("a link opens the same state, and the run is saved", { file: exported }, async (page) => {
  await page.context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.enter("Damping", "321");
  await page.press("Step forward");
  await page.page.locator("#share").click();
  const link = await eventually(async () => {
    const copied = await page.page.evaluate(() => navigator.clipboard.readText());
    assert.match(copied, /b:321/);
    return copied;
  });
  await page.openTable();
  const { text } = await page.save(page.page.locator("#save-csv"));
  assert.match(text, /^t \[s\],/);
  await page.page.goto("about:blank");
  await page.go(link);
  assert.equal(await page.number("Damping"), 321);
  await eventually(async () => assert.ok((await page.time()) > 0));
});

visit("the document is saved as it was written", { file: exported }, async (page) => {
  await page.openMenu();
  const { name, text } = await page.save(page.page.locator("#document"));
  assert.match(name, /^utube(\.es)?\.md$/);
  assert.match(text, /^---\ntitle: /);
});

visit("it speaks Spanish with its document", { file: exported, language: "es-ES" }, async (page) => {
  assert.match(await page.page.getByRole("heading", { level: 1 }).innerText(), /tubo en U/);
  await page.tab("Teoría");
  assert.ok((await page.page.locator("#panel-theory math").count()) > 5, "its equations are set");
});

visit("a simulation that was damaged on its way says so", async (page) => {
  const whole = readFileSync(exported(), "utf8");
  const place = whole.indexOf('id="bundle"') + 2000;
  const file = temporary("damaged.player.html");
  writeFileSync(file, whole.slice(0, place) + "A".repeat(60) + whole.slice(place + 60));
  await page.page.goto(`file://${file}`);
  await page.page.getByRole("alert").filter({ hasText: "This file is damaged" }).waitFor();
});

for (const document of readdirSync(beside("../../simulations")).filter((name) => /^[^.]+\.md$/.test(name))) {
  visit(`${document} plays as a page of its own`, { file: () => exported(document) }, async (page) => {
    await page.press("Play");
    // In slow motion a second of watching is a few milliseconds or nanoseconds.
    await page.watchUntil(1e-6);
    assert.equal(await page.page.locator("#scene svg, #scene .drawing").first().isVisible(), true);
  });
}

for (const [theme, size] of [["light", {}], ["dark", { width: 390, height: 844, touch: true }]]) {
  visit(`axe finds nothing in an exported page: ${theme}`, { ...STILL, file: exported, theme, ...size }, async (page) => {
    const found = [];
    for (const tab of await page.page.getByRole("tab").all()) {
      await tab.click();
      await page.page.evaluate(axe);
      const { violations } = await page.page.evaluate(() => window.axe.run());
      found.push(...violations.map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 200)}`));
    }
    assert.deepEqual(found, []);
    assert.equal(await page.page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false);
  });
}

// The tab Write, as its writer uses it: a document is changed, broken, mended, begun, saved and found again.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { Lab, STILL, beside, eventually, number, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const editor = (lab) => lab.page.locator(".cm-content");
const status = (lab) => lab.page.locator("#writing-status");
const text = (lab) => editor(lab).evaluate((content) => content.cmTile?.view?.state.doc.toString() ?? content.innerText);

async function write(lab, name = "Write") {
  await lab.tab(name);
  await editor(lab).waitFor();
}

/** Selects words in the text by searching for them, and types others in their place. */
async function replace(lab, before, after) {
  await editor(lab).click();
  await lab.keys("Control+f");
  await lab.page.locator(".cm-search [name=search]").fill(before);
  await lab.keys("Control+Home", "Enter", "Escape");
  await eventually(async () => assert.equal(await lab.page.evaluate(() => getSelection().toString().trim()), before.trim()));
  await lab.page.keyboard.insertText(after);
}

/** Begins a document from a template. */
async function begin(lab, title, button = "New", template = title) {
  await lab.press(button);
  await lab.press(template);
  await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), title));
}

const runs = (lab) => eventually(async () => assert.match(await status(lab).innerText(), /^No errors/));

visit("a default is changed in the text while the run goes on, and the time stays", async (lab) => {
  await write(lab);
  assert.match(await text(lab), /^---\ntitle: /);
  await runs(lab);
  await lab.button("Play").click();
  await lab.watchUntil(1);
  await lab.button("Pause").click();
  const time = await lab.time();
  assert.ok(time >= 1);
  await replace(lab, "parameter b   = 50 ", "parameter b   = 5000 ");
  await lab.tab("Explore");
  await eventually(async () => assert.equal(await lab.number("Damping"), 5000));
  assert.equal(await lab.time(), time);
  // What follows in the text is the same document, and its own copy: Back leads to that of the library.
  await lab.tab("Write");
  assert.match(await text(lab), /parameter b {3}= 5000 /);
  await lab.page.goBack();
  await eventually(async () => assert.doesNotMatch(await text(lab), /parameter b {3}= 5000 /));
});

visit("with an error the last good version runs on; its place, reason and remedy are shown, and mended it runs", async (lab) => {
  await write(lab);
  await begin(lab, "A mass on a spring");
  await runs(lab);
  await replace(lab, "k*y = 0", "kk*y = 0");
  await eventually(async () => assert.match(await status(lab).innerText(), /^1 error\. The last version without errors is running\.$/));
  const finding = lab.page.locator(".writing .finding");
  assert.match(await finding.innerText(), /kk/);
  assert.match(await finding.innerText(), /Help: /);
  assert.equal(await lab.page.locator(".cm-lintRange-error").innerText(), "kk");
  assert.equal(await lab.page.locator(".cm-lint-marker-error").count(), 1);
  // The old one plays.
  await lab.button("Play").click();
  await lab.watchUntil(0.5);
  await lab.button("Pause").click();
  const time = await lab.time();
  // The place leads into the text.
  await finding.getByRole("button", { name: /line 1[0-9]/ }).click();
  await eventually(async () => assert.ok(await editor(lab).evaluate((content) => content.contains(document.activeElement))));
  await lab.keys("Delete");
  await runs(lab);
  assert.equal(await finding.count(), 0);
  assert.equal(await lab.time(), time);
  // And what was typed can be undone.
  await lab.keys("Control+z");
  await eventually(async () => assert.match(await status(lab).innerText(), /^1 error/));
});

visit("a document in which nothing runs opens in the editor, says what is wrong, and runs as soon as it can", async (lab) => {
  await lab.page.setInputFiles("#open-file", beside("broken.md"));
  await lab.page.getByRole("heading", { name: "There is nothing to run yet" }).waitFor();
  await editor(lab).waitFor();
  const findings = lab.page.locator(".writing .findings");
  await findings.getByRole("heading", { name: "Dimensions do not match" }).waitFor();
  await findings.locator("code", { hasText: /^sqr$/ }).first().waitFor();
  assert.doesNotMatch(await findings.innerText(), /`|dimension-mismatch|unknown-function/, "no raw backticks and codes");
  assert.deepEqual(await lab.page.locator("#panel > .tabs [role=tab]:visible").allInnerTexts(), ["Write", "Class"]);
  // One error corrected, one left: nothing runs yet, and what was typed stays in another language.
  await replace(lab, "sqr(", "sqrt(");
  await eventually(async () => assert.match(await status(lab).innerText(), /^1 error\. There is nothing to run yet\.$/));
  await lab.pressInMenu("ES – Español");
  await lab.page.getByRole("heading", { name: "Todavía no hay nada que ejecutar" }).waitFor();
  await eventually(async () => assert.match(await text(lab), /sqrt\(/));
  await lab.pressInMenu("EN – English");
  await editor(lab).waitFor();
  await replace(lab, "+ k = 0", "+ k*x = 0");
  await runs(lab);
  await lab.button("Step forward").click();
  await eventually(async () => assert.ok((await lab.time()) > 0));
  assert.ok((await lab.page.locator("[role=tab]:visible").count()) > 3);
});

visit("a remedy is carried out by a click, and taken back with a key", async (lab) => {
  await write(lab);
  await begin(lab, "A mass on a spring");
  await runs(lab);
  await replace(lab, "= y_0 ", "= y_00 ");
  await lab.page.locator(".writing .finding").getByRole("button", { name: "Replace y_00 by y_0", exact: true }).click();
  await runs(lab);
  assert.match(await text(lab), /= y_0 /);
  assert.equal(await lab.page.locator(".writing .finding").count(), 0);
  await lab.keys("Control+z");
  await eventually(async () => assert.match(await status(lab).innerText(), /^1 error/));
});

visit("a document is begun, written, saved, and there again after a reload, also with an error in it", async (lab) => {
  await write(lab);
  for (const title of ["Two coupled bodies", "Discharge in an RLC circuit", "A projectile", "A damped oscillation as a formula", "A population from year to year", "A mass on a spring"]) {
    await begin(lab, title);
    await runs(lab);
  }
  // The text of another document is there to be typed into at once.
  await eventually(async () => assert.ok(await editor(lab).evaluate((content) => content === document.activeElement)));
  await replace(lab, "title: A mass on a spring", "title: My spring");
  await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "My spring"));
  const saved = await lab.save(lab.button("Save"));
  assert.equal(saved.name, "my-spring.md");
  assert.match(saved.text, /^---\ntitle: My spring\n/);
  await lab.page.reload();
  await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "My spring"));
  await write(lab);
  await replace(lab, "k*y = 0", "kk*y = 0");
  await eventually(async () => assert.match(await status(lab).innerText(), /^1 error/));
  await lab.page.reload();
  await editor(lab).waitFor();
  await eventually(async () => assert.match(await status(lab).innerText(), /^1 error/));
  assert.match(await text(lab), /kk\*y = 0/);
  assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "My spring");
  // Nothing is left in the storage of the titles in between.
  const stored = await lab.page.evaluate(() => Object.keys(localStorage).filter((key) => key.includes("oscillator.md")));
  assert.ok(stored.every((key) => /:(My spring|A mass on a spring)(:|$)/.test(key)), stored.join(" "));
  // A page that is opened afresh offers it.
  await lab.page.evaluate(() => history.replaceState(null, ""));
  await lab.page.reload();
  await eventually(async () => assert.match(await lab.page.getByRole("heading", { level: 1 }).innerText(), /U-tube/));
  await write(lab);
  await begin(lab, "My spring");
  await eventually(async () => assert.match(await status(lab).innerText(), /^1 error/));
  assert.match(await text(lab), /kk\*y = 0/);
  await lab.page.goBack();
  await eventually(async () => assert.match(await text(lab), /U-tube/));
  await lab.page.goForward();
  await eventually(async () => assert.match(await text(lab), /kk\*y = 0/));
});

visit("a link holds what was written", async (lab) => {
  await write(lab);
  await begin(lab, "A mass on a spring");
  await replace(lab, "title: A mass on a spring", "title: My spring");
  await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "My spring"));
  await lab.copyLink();
  await eventually(() => assert.match(lab.page.url(), /#1&s=/));
  const other = await Lab.open();
  try {
    await other.page.goto("about:blank");
    await other.go(lab.page.url());
    await write(other);
    assert.equal(await text(other), await text(lab));
    other.wasQuiet();
  } finally {
    await other.context.close();
  }
});

visit("a translation is written beside its document, and each file has its own undoing", { language: "es-ES" }, async (lab) => {
  await write(lab, "Escribir");
  await lab.page.getByLabel("Archivo", { exact: true }).selectOption("utube.es.md");
  await eventually(async () => assert.match(await text(lab), /translates: utube\.md/));
  await replace(lab, "title: Oscilaciones", "title: Mis oscilaciones");
  const title = (expected) => eventually(async () => assert.match(await lab.page.getByRole("heading", { level: 1 }).innerText(), expected));
  await title(/^Mis oscilaciones/);
  await lab.page.getByLabel("Archivo", { exact: true }).selectOption("utube.md");
  await replace(lab, "title: Oscillations", "title: My oscillations");
  await lab.pressInMenu("EN – English");
  await title(/^My oscillations/);
  await editor(lab).click();
  await lab.keys("Control+z");
  await title(/^Oscillations/);
  await lab.page.getByLabel("File", { exact: true }).selectOption("utube.es.md");
  assert.match(await text(lab), /title: Mis oscilaciones/);
  await editor(lab).click();
  await lab.keys("Control+z");
  await eventually(async () => assert.match(await text(lab), /title: Oscilaciones/));
});

visit("tabs, questions and plots follow the text", async (lab) => {
  await write(lab);
  await begin(lab, "My simulation", "New", "Empty document");
  assert.equal(await lab.page.locator("#tab-questions:visible").count(), 0);
  await editor(lab).click();
  await lab.keys("Control+End");
  await lab.page.keyboard.insertText("\n```question\nHow fast?\nanswer: v within 1 %\n```\n\n```plots\n\"Speed\": x' against t\n```\n");
  await eventually(async () => assert.equal(await lab.page.locator("#tab-questions:visible").count(), 1));
  await lab.button("Speed").waitFor();
  assert.ok(await editor(lab).evaluate((content) => content === document.activeElement), "the writer goes on writing");
});

visit("Tab leads out of the text, until Control with M lets it indent", async (lab) => {
  await write(lab);
  await begin(lab, "My simulation", "New", "Empty document");
  await eventually(async () => assert.ok(await editor(lab).evaluate((content) => content === document.activeElement)));
  await lab.keys("Tab");
  assert.ok(!(await editor(lab).evaluate((content) => content.contains(document.activeElement))));
  await editor(lab).click();
  await lab.keys("Control+Home", "Control+m", "Tab");
  assert.match(await text(lab), /^\s+---/);
  assert.ok(await editor(lab).evaluate((content) => content === document.activeElement));
  await lab.keys("Control+m", "Tab");
  assert.ok(!(await editor(lab).evaluate((content) => content.contains(document.activeElement))));
});

visit("names, functions and units are proposed with their meaning, and Enter takes none that was not chosen", async (lab) => {
  await write(lab);
  await begin(lab, "A mass on a spring");
  await replace(lab, "E = m*y'^2/2", "E = sq");
  const proposal = (name) => lab.page.locator(".cm-tooltip-autocomplete li").filter({ has: lab.page.getByText(name, { exact: true }) });
  await lab.page.keyboard.type("r");
  await proposal("sqrt").getByText("square root").waitFor();
  // CodeMirror takes no keys for 75 ms after the list has appeared, lest somebody who goes on typing chooses from it.
  await lab.page.waitForTimeout(150);
  await lab.keys("ArrowDown", "Enter");
  await eventually(async () => assert.match(await text(lab), /E = sqrt \+ k/));
  await lab.page.keyboard.type("(y_0/1 [c");
  await proposal("cm").getByText("length").waitFor();
  await lab.keys("Escape");
  await replace(lab, "E = sqrt(y_0/1 [c]) + k", "E = b");
  await lab.page.keyboard.type("*y_");
  await proposal("y_0").getByText("Displacement at the start, parameter in cm").waitFor();
  await lab.keys("Enter");
  await eventually(async () => assert.match(await text(lab), /E = b\*y_\n/));
  // A prime is no quotation mark that wants another one.
  await lab.page.keyboard.type("x[i]' ");
  await eventually(async () => assert.match(await text(lab), /\n\s*x\[i\]' \*y/));
  // In prose nothing is proposed.
  await replace(lab, "Drag it", "Dra");
  await lab.page.keyboard.type("g s");
  await lab.page.waitForTimeout(400);
  assert.equal(await lab.page.locator(".cm-tooltip-autocomplete").count(), 0);
});

visit("in Spanish, templates and messages are Spanish", { language: "es-ES" }, async (lab) => {
  await write(lab, "Escribir");
  await begin(lab, "Una masa en un resorte", "Nuevo");
  await replace(lab, "k*y = 0", "kk*y = 0");
  await eventually(async () => assert.match(await status(lab).innerText(), /^1 error\. Sigue funcionando/));
  assert.match(await lab.page.locator(".writing .finding").innerText(), /Ayuda: /);
  assert.equal(await editor(lab).getAttribute("aria-label"), "Texto del documento");
});

for (const [device, size] of [["desk", {}], ["phone", { width: 390, height: 844, touch: true }]]) {
  for (const theme of ["light", "dark"]) {
    visit(`axe finds nothing while a document with an error is written: ${device}, ${theme}`, { ...STILL, theme, ...size }, async (lab) => {
      await write(lab);
      await begin(lab, "A mass on a spring");
      await replace(lab, "k*y = 0", "kk*y = 0");
      await eventually(async () => assert.match(await status(lab).innerText(), /^1 error/));
      await lab.press("New");
      await lab.page.evaluate(axe);
      const { violations } = await lab.page.evaluate(() => window.axe.run("html"));
      assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`), []);
      const size = number(await editor(lab).evaluate((content) => getComputedStyle(content).fontSize));
      if (device === "phone") assert.ok(size >= 16, "a phone does not zoom in");
    });
  }
}

visit("the text is given its layout, which can be undone", async (lab) => {
  await write(lab);
  await begin(lab, "A mass on a spring");
  await replace(lab, "m*y'' + b*y' + k*y = 0", "m * y''+b*y'  +k*y=0");
  // What follows typing at once is one step with it.
  await lab.page.waitForTimeout(600);
  await lab.press("Format");
  await eventually(async () => assert.match(await editor(lab).innerText(), /m\*y'' \+ b\*y' \+ k\*y = 0/));
  await lab.press("Format");
  await lab.page.getByText("The text has its layout already.").first().waitFor();
  await editor(lab).focus();
  await lab.keys("Control+Z");
  await eventually(async () => assert.match(await editor(lab).innerText(), /m \* y''\+b\*y' {2}\+k\*y=0/));
});

visit("one list is unfolded at a time, and Escape folds it up", async (lab) => {
  await lab.tab("Write");
  await lab.page.locator(".cm-content").waitFor();
  const open = () => lab.page.locator(".writing-tools [aria-expanded=true]").evaluateAll((buttons) => buttons.map((button) => button.id));
  await lab.press("New");
  assert.deepEqual(await open(), ["new-document"]);
  await lab.press("Versions");
  assert.deepEqual(await open(), ["versions"]);
  assert.equal(await lab.page.locator("#templates").isVisible(), false);
  await lab.page.locator("#versions").focus();
  await lab.keys("Escape");
  await eventually(async () => assert.deepEqual(await open(), []));
  assert.equal(await lab.page.evaluate(() => document.activeElement.id), "versions");
});

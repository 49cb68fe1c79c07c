// What belongs to a person stays: the focus, the key Space, the tab, the simulation that runs, the documents that were written.

import assert from "node:assert/strict";
import { drop, eventually, visit } from "../lab.mjs";

const editor = (lab) => lab.page.locator(".cm-content");
const text = (lab) => editor(lab).evaluate((content) => content.cmTile?.view?.state.doc.toString() ?? content.innerText);
const playing = (lab) => eventually(() => lab.page.locator("#play[aria-label=Pause]").waitFor({ timeout: 1000 }));
const paused = (lab) => eventually(() => lab.page.locator("#play[aria-label=Play]").waitFor({ timeout: 1000 }));
const title = (lab) => lab.page.getByRole("heading", { level: 1 }).innerText();
const said = (lab, expected) => eventually(async () => assert.match(await lab.page.locator("body").innerText(), expected));

async function write(lab, name = "Write") {
  await lab.tab(name);
  await editor(lab).waitFor();
}

/** A template of the tab Write, in one of its panels. */
async function template(lab, name, panel) {
  await write(lab);
  await lab.press("New");
  await lab.press(name);
  await eventually(async () => assert.match(await text(lab), /```model/));
  if (panel) await lab.page.locator(`#writing-tab-${panel}`).click();
}

visit("Space is the transport's after a click on whatever button, and the button's after Tab", async (lab) => {
  await lab.button("Play").click();
  await playing(lab);
  // A run without a step is not kept.
  await lab.watchUntil(0.5);
  await lab.page.keyboard.press("Space");
  await paused(lab);
  // A run that is kept is kept once.
  await lab.button("Keep run").first().click();
  const kept = () => lab.page.getByRole("button", { name: /^Remove.*run/i }).count();
  const once = await kept();
  await lab.page.keyboard.press("Space");
  await playing(lab);
  assert.equal(await kept(), once);
  await lab.page.keyboard.press("Space");
  await paused(lab);
  // Elsewhere on the page, too: a tab, a step, the sound.
  await lab.everything();
  for (const button of [lab.page.locator("#tab-measure"), lab.page.locator("#step-forward"), lab.page.locator("#tab-write"), lab.page.locator("#tab-explore")]) {
    await button.click();
    await lab.page.keyboard.press("Space");
    await playing(lab);
    await lab.page.keyboard.press("Space");
    await paused(lab);
  }
  // With Tab, the button that has the focus takes it.
  const before = await lab.time();
  await lab.page.locator("#back-to-start").click();
  await lab.page.keyboard.press("Tab");
  await lab.page.keyboard.press("Tab");
  await lab.page.keyboard.press("Tab");
  assert.equal((await lab.focused()).id, "step-forward");
  await lab.page.keyboard.press("Space");
  await paused(lab);
  await eventually(async () => assert.ok((await lab.time()) > 0 && (await lab.time()) <= before + 1));
  // What is typed stays typed.
  await write(lab);
  await editor(lab).click();
  await lab.page.keyboard.press("Space");
  await paused(lab);
});

visit("an empty file or prose does not take the place of the simulation", async (lab) => {
  const before = await title(lab);
  const wrong = [
    ["empty.md", ""],
    ["letter.md", "# A letter\n\nDear friend, $x^2$ and ```code``` stand here.\n"],
    ["notes.markdown", "---\ntitle: Notes\n---\n\nNothing.\n\n```scene\n<svg/>\n```\n"],
    ["spring.es.md", "---\nlanguage: es\ntranslates: spring.md\n---\n\nUna masa.\n"],
  ];
  for (const [name, words] of wrong) {
    await drop(lab, { name, text: words });
    await said(lab, new RegExp(`${name.replace(".", "\\.")} holds no simulation`));
    assert.equal(await title(lab), before);
  }
  // One with errors in it is opened: it is a simulation.
  await drop(lab, { name: "faulty.md", text: "---\ntitle: Faulty\n---\n\n```model\nx' = -k*x\n```\n" });
  await said(lab, /nothing to run/i);
});

visit("a quantity with an initial value brings no equation", async (lab) => {
  await template(lab, "A mass on a spring", "model");
  const before = await text(lab);
  await lab.press("Add quantity with an initial value");
  await eventually(async () => assert.notEqual(await text(lab), before));
  assert.match(await text(lab), /\nu\(0\) = 0\n/);
  assert.doesNotMatch(await text(lab), /u'/);
  await said(lab, /No equation contains a derivative of u/);
});

visit("on the Spanish page Escribir shows the Spanish file", { language: "es-ES" }, async (lab) => {
  await write(lab, "Escribir");
  await eventually(async () => assert.match(await text(lab), /^---\n(.*\n)*?language: es\n/));
});

visit("the tab stays after the page is loaded again", async (lab) => {
  for (const tab of ["Measure", "Write", "Theory", "Explore"]) {
    await lab.tab(tab);
    await lab.page.reload();
    await eventually(async () => assert.equal(await lab.page.locator("#panel > .tabs [aria-selected=true]").innerText(), tab));
  }
});

visit("the document after the last one that is kept is refused, and none of the others is lost", async (lab) => {
  const own = () => lab.page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("meniscus:written:")).sort());
  await lab.page.evaluate(() => {
    for (let number = 1; number <= 50; number += 1) {
      const source = [{ name: `own-${number}.md`, text: `---\ntitle: Own ${number}\n---\n\n\`\`\`model\nx' = -${number}*x/1 [s]\nx(0) = 1\n\`\`\`\n` }];
      localStorage.setItem(`meniscus:written:${1700000000000 + number}`, `own ${JSON.stringify(source)}`);
    }
  });
  const before = await own();
  await template(lab, "A mass on a spring", "model");
  await lab.page.getByLabel("m: Value", { exact: true }).fill("0.25");
  await said(lab, /keeps 50 documents of yours, and has no room for this one/);
  assert.deepEqual(await own(), before);
  await lab.page.evaluate(() => localStorage.removeItem("meniscus:written:1700000000007"));
  await lab.page.getByLabel("m: Value", { exact: true }).fill("0.5");
  await eventually(async () => assert.equal((await own()).length, 50));
});

visit("answers of a document whose title begins like that of another stay", async (lab) => {
  const document = (title) => `---\ntitle: ${title}\n---\n\n\`\`\`model\nx' = -x/1 [s]\nx(0) = 1\n\`\`\`\n\n\`\`\`question\nHow much is two?\n\nanswer: 2 within 1 %\n\`\`\`\n`;
  const answers = () => lab.page.evaluate(() => Object.entries(localStorage).filter(([key]) => key.startsWith("meniscus:answer:")).map(([key]) => key).sort());
  for (const name of ["Pendulum: large angles", "Pendulum"]) {
    await drop(lab, { name: "pendulum.md", text: document(name) });
    await eventually(async () => assert.equal(await title(lab), name));
    await lab.tab("Questions");
    const field = lab.page.locator("#panel-questions").getByRole("textbox").first();
    assert.equal(await field.inputValue(), "", name);
    await field.fill("2");
    await lab.page.getByRole("button", { name: "Check", exact: true }).click();
  }
  await eventually(async () => assert.equal((await answers()).length, 2, (await answers()).join()));
  const before = await answers();
  // Its title is edited, letter by letter.
  await write(lab);
  await lab.page.locator("#writing-tab-model").click();
  const name = lab.page.getByLabel("Title", { exact: true });
  for (const letters of ["Pendulum a", "Pendulum ab", "Pendulum abc"]) {
    await name.fill(letters);
    await eventually(async () => assert.equal(await title(lab), letters));
  }
  await eventually(async () => assert.equal((await answers()).length, 3));
  const after = await answers();
  assert.ok(before.every((key) => after.includes(key)), `${before.join()} ${after.join()}`);
  assert.ok(after.some((key) => key.includes("written:")), "its own are kept by its name in the storage");
});

visit("the focus goes on where a button is gone", async (lab) => {
  await template(lab, "A mass on a spring", "model");
  const lines = await text(lab);
  const start = /^(\w+)'\(0\).*\n/m.exec(lines);
  await lab.page.locator("#writing-tab-text").click();
  await editor(lab).click();
  await lab.page.keyboard.press("Control+a");
  await lab.page.keyboard.insertText(lines.replace(start[0], ""));
  await lab.page.locator("#writing-tab-model").click();
  const remedy = lab.page.locator(".faults .fix").first();
  await remedy.waitFor();
  await remedy.focus();
  await lab.page.keyboard.press("Enter");
  await eventually(async () => assert.match((await lab.focused()).id, /^cell-\d+-/));
  const place = await lab.page.evaluate(() => document.activeElement.value);
  assert.match(place, new RegExp(`${start[1]}'`));
  await lab.page.locator("#writing-tab-translation").click();
  await lab.page.getByRole("button", { name: "Begin a translation", exact: true }).focus();
  await lab.page.keyboard.press("Enter");
  await eventually(async () => assert.equal((await lab.focused()).id, "translation-0"));
});

visit("the ends of a spring have names of their own", async (lab) => {
  await template(lab, "A mass on a spring", "view");
  await lab.page.locator("#drawing-add").click();
  await lab.page.locator("#drawing-palette [data-part=spring]").click();
  await lab.page.locator(".inspector-follow select").first().waitFor();
  const names = await lab.page.locator(".inspector-follow select").evaluateAll((all) => all.map((one) => one.labels[0].textContent));
  assert.ok(names.length >= 4 && new Set(names).size === names.length, names.join());
});

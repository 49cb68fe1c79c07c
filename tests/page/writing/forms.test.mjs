// The tab Write by forms: cells change their places in the text, faults stand beside them, one history takes everything back.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { STILL, eventually, number, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const status = (lab) => lab.page.locator("#writing-status");
const editor = (lab) => lab.page.locator(".cm-content");
const text = (lab) => editor(lab).evaluate((content) => content.cmTile?.view?.state.doc.toString() ?? content.innerText);
const runs = (lab) => eventually(async () => assert.match(await status(lab).innerText(), /^No errors/));
const field = (lab, name) => lab.page.getByLabel(name, { exact: true });
const now = (lab, expected) => eventually(async () => assert.match(await text(lab), expected));

async function panel(lab, name) {
  await lab.page.locator(".writing-tabs").getByRole("tab", { name, exact: true }).click();
}

/** The oscillator of the templates, by forms. */
async function forms(lab, { write = "Write", begin = "New", template = "A mass on a spring", model = "Model" } = {}) {
  await lab.tab(write);
  await editor(lab).waitFor();
  await lab.press(begin);
  await lab.press(template);
  await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), template));
  await panel(lab, model);
  await lab.page.locator(".forms").waitFor();
}

visit("a cell changes its place in the text, the simulation follows, and comments and columns stay", async (lab) => {
  await forms(lab);
  const before = await text(lab);
  await field(lab, "m: Value").fill("0.25");
  await now(lab, /parameter m {3}= 0\.25 /);
  await runs(lab);
  const lines = (text) => text.split("\n");
  const after = lines(await text(lab));
  const changed = lines(before).filter((line, place) => line !== after[place]);
  assert.equal(changed.length, 1);
  await field(lab, "m: Label").fill("Mass of the bob");
  await field(lab, "m: Range").fill("0.1..3");
  await field(lab, "m: Step").fill("0.05");
  await now(lab, /in 0\.1\.\.3 step 0\.05 +"Mass of the bob"/);
  await runs(lab);
  await lab.tab("Explore");
  await eventually(async () => assert.equal(await lab.number("Mass of the bob"), 0.25));
  await lab.tab("Write");
  // Text and forms have one history.
  await panel(lab, "Model");
  for (let left = 40; left > 0 && (await text(lab)) !== before; left -= 1) await lab.press("Undo");
  assert.equal(await text(lab), before);
  await eventually(async () => assert.equal(await field(lab, "m: Value").inputValue(), /parameter m\s+= ([\d.]+)/.exec(before)[1]));
  await lab.press("Redo");
  await eventually(async () => assert.notEqual(await text(lab), before));
});

visit("a fault stands beside its cell with a remedy, and the last good version runs on", async (lab) => {
  await forms(lab);
  await field(lab, "k: Unit").fill("N");
  await eventually(async () => assert.match(await status(lab).innerText(), /^\d errors?\. The last version/));
  const line = lab.page.locator(".statement", { has: lab.page.locator(".brief.error") });
  await line.first().waitFor();
  await field(lab, "k: Unit").fill("N/m");
  await runs(lab);
  assert.equal(await lab.page.locator(".brief.error").count(), 0);
  await field(lab, "k: Unit").fill("Nm/kgg");
  await eventually(async () => assert.equal(await field(lab, "k: Unit").getAttribute("aria-invalid"), "true"));
  const described = await field(lab, "k: Unit").getAttribute("aria-describedby");
  assert.match(await lab.page.locator(`#${described}`).innerText(), /Nm/);
  await field(lab, "k: Unit").fill("N/m");
  await runs(lab);
  // A remedy is carried out where it stands.
  const start = field(lab, "y(0): At the start");
  await start.fill("y_00");
  await lab.page.locator(".forms .brief").getByRole("button", { name: "Replace y_00 by y_0", exact: true }).click();
  await runs(lab);
  assert.equal(await start.inputValue(), "y_0");
  // What would not stay in its cell is not written.
  const kept = await text(lab);
  await field(lab, "k: Label").fill('a" in 3');
  await lab.page.locator(".forms .refusal", { hasText: 'cannot contain `"`' }).waitFor();
  assert.equal(await text(lab), kept);
});

visit("an equation is typeset as it is typed, a name is changed everywhere, statements come and go", async (lab) => {
  await forms(lab);
  const equation = lab.page.locator(".statement input").first();
  const typeset = lab.page.locator(".statement .typeset").first();
  const before = await typeset.innerHTML();
  await equation.press("End");
  await lab.page.keyboard.type(" + sqrt(2");
  await lab.page.keyboard.type(")*0*y");
  await eventually(async () => assert.match(await typeset.innerHTML(), /<msqrt>/));
  for (let left = 40; left > 0 && (await typeset.innerHTML()) !== before; left -= 1) await lab.press("Undo");
  await field(lab, "k: Name").fill("stiff");
  await field(lab, "k: Name").press("Enter");
  await now(lab, /parameter stiff/);
  await eventually(async () => assert.match(await equation.inputValue(), /stiff\*y/));
  // Its cells are called after it.
  await field(lab, "stiff: Value").waitFor();
  await lab.button("Remove stiff").waitFor();
  await runs(lab);
  await lab.press("Add parameter");
  await eventually(async () => assert.match(await lab.page.evaluate(() => document.activeElement.id), /^cell-\d+-name$/));
  await now(lab, /parameter a = 1 in 0\.\.2\n/);
  await lab.press("Add event");
  await now(lab, /when t > 1 \[s\] \{\n {4}stop\n\}/);
  await runs(lab);
  await lab.press("Remove a");
  await eventually(async () => assert.doesNotMatch(await text(lab), /parameter a /));
});

visit("the forms are worked with keys alone, and what the cursor is on is explained", async (lab) => {
  await forms(lab);
  await lab.page.getByRole("tab", { name: "Model", exact: true }).focus();
  await lab.keys("ArrowLeft");
  await eventually(async () => assert.ok(await editor(lab).isVisible()));
  await lab.keys("ArrowRight");
  await lab.page.locator(".forms").waitFor();
  await field(lab, "k: Value").focus();
  await lab.keys("Control+a");
  await lab.page.keyboard.type("30");
  await now(lab, /parameter k\s+= 30 /);
  await lab.keys("Control+z");
  await eventually(async () => assert.doesNotMatch(await text(lab), /parameter k\s+= 30 /));
  await field(lab, "k: Unit").focus();
  await lab.keys("Home");
  await eventually(async () => assert.match(await lab.page.locator("#insight").innerText(), /^N: force/));
  const equation = lab.page.locator(".statement input").first();
  await equation.focus();
  await lab.keys("Home", "ArrowRight");
  await eventually(async () => assert.match(await lab.page.locator("#insight").innerText(), /^m: .*mass/i));
  await panel(lab, "Text");
  await editor(lab).click();
  await lab.keys("Control+Home");
  await lab.page.keyboard.press("ArrowDown");
  await eventually(async () => assert.match(await lab.page.locator("#insight").innerText(), /title/));
});

visit("a translation is begun, written beside the texts of the document, and its missing texts are counted", async (lab) => {
  await forms(lab);
  await panel(lab, "Translation");
  await lab.press("Begin a translation");
  const count = lab.page.locator(".sides-count");
  await eventually(async () => assert.match(await count.innerText(), /^1\d texts have no translation\.$/));
  const before = Number.parseInt(await count.innerText(), 10);
  const side = (original) => lab.page.locator(".side", { has: lab.page.getByText(original, { exact: true }) }).locator("textarea");
  await side("Stiffness of the spring").fill("Rigidez del resorte");
  await side("A mass hangs on a spring. Drag it and let go.").fill("Una masa cuelga de un resorte.");
  await eventually(async () => assert.equal(Number.parseInt(await count.innerText(), 10), before - 2));
  await side("Mass").fill('a" = "b');
  await lab.page.locator(".side .refusal", { hasText: 'cannot contain `"`' }).waitFor();
  await side("Mass").fill("Masa");
  await lab.page.locator("#only-missing").check();
  await eventually(async () => assert.equal(await lab.page.locator(".side").count(), before - 3));
  await eventually(async () => assert.match(await status(lab).innerText(), /No errors/));
  await lab.pressInMenu("ES – Español");
  await lab.page.locator("#tab-explore").click();
  await eventually(async () => assert.ok(await lab.page.getByText("Rigidez del resorte").first().isVisible()));
  await lab.tab("Escribir");
  await panel(lab, "Texto");
  await lab.page.getByLabel("Archivo", { exact: true }).selectOption("a-mass-on-a-spring.es.md");
  await now(lab, /"Stiffness of the spring" = "Rigidez del resorte"/);
  await now(lab, /\nUna masa cuelga de un resorte\.\n/);
});

visit("the questions stand with their answers, and one is added that the model answers", async (lab) => {
  await forms(lab);
  await panel(lab, "Questions");
  const asked = lab.page.locator(".asked-one");
  await eventually(async () => assert.match(await asked.first().innerText(), /Measure the period[^]*0\.99\d+ s/));
  const part = (name) => field(lab, `Question 1: ${name}`);
  assert.equal(await part("Hidden until answered").inputValue(), "T");
  assert.match(await part("Hint").inputValue(), /^Count several/);
  await lab.press("Add question");
  const form = lab.page.locator("#new-question-form");
  const add = form.getByRole("button", { name: "Add", exact: true });
  // An empty one is refused in the language of the page.
  await add.click();
  await form.locator(".refusal", { hasText: "Write what is asked." }).waitFor();
  await form.getByLabel("What is asked").fill("How long is one swing?");
  await form.getByLabel("Answer", { exact: true }).selectOption("T");
  await form.getByLabel("Tolerance in percent").fill("5");
  await add.click();
  await eventually(async () => assert.equal(await asked.count(), 2));
  await now(lab, /```question\nHow long is one swing\?\n\nhide: T\nanswer: T within 5 %\n```\n/);
  await runs(lab);
  await asked.nth(1).getByRole("button", { name: "Go to the text" }).click();
  await eventually(async () => assert.ok(await editor(lab).evaluate((content) => content.contains(document.activeElement))));
  await lab.tab("Questions");
  await eventually(async () => assert.equal(await lab.page.locator(".question").count(), 2));
  // Each part is written in its field; the field keeps the focus.
  await lab.tab("Write");
  await panel(lab, "Questions");
  const before = await text(lab);
  await part("Answer").fill("T within 7 %");
  await part("Answer").press("End");
  await lab.page.keyboard.press("Backspace");
  await lab.page.keyboard.type("%");
  await now(lab, /answer: T within 7 %\n/);
  await part("What is asked").fill("Measure T.");
  await part("Explanation").fill("It is 2 pi times the root of m/k.");
  await now(lab, /Measure T\.\n[^`]*explanation: It is 2 pi/);
  await runs(lab);
  await part("Answer").fill("T");
  await asked.first().locator(".brief.error").waitFor();
  await part("Answer").fill("T within 7 %");
  await runs(lab);
  await lab.press("Remove Question 2");
  await eventually(async () => assert.equal(await asked.count(), 1));
  await lab.press("Undo");
  await eventually(async () => assert.equal(await asked.count(), 2));
  for (let left = 60; left > 0 && (await text(lab)) !== before; left -= 1) await lab.press("Undo");
  await now(lab, /Measure the period[^]*T within 3 %/);
});

for (const [device, size] of [["desk", {}], ["phone", { width: 390, height: 844, touch: true }]]) {
  for (const theme of ["light", "dark"]) {
    visit(`axe finds nothing in the forms, in Spanish: ${device}, ${theme}`, { ...STILL, theme, ...size, language: "es-ES" }, async (lab) => {
      await forms(lab, { write: "Escribir", begin: "Nuevo", template: "Una masa en un resorte", model: "Modelo" });
      await field(lab, "k: Unidad").fill("kgg");
      await lab.page.locator(".brief.error").first().waitFor();
      await lab.page.evaluate(axe);
      const sound = async () => {
        const { violations } = await lab.page.evaluate(() => window.axe.run("html"));
        assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`), []);
      };
      await sound();
      for (const other of ["Preguntas", "Traducción", "Modelo"]) {
        await panel(lab, other);
        if (other === "Preguntas") await lab.page.locator("#new-question").click();
        if (other === "Traducción") {
          await lab.press("Empezar una traducción");
          await lab.page.locator(".sides-count").waitFor();
        }
        await sound();
      }
      if (device === "phone") {
        assert.equal(await lab.page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0);
        const cell = await field(lab, "m: Valor").boundingBox();
        assert.ok(cell.height >= 40, `${cell.height} px for a finger`);
        assert.ok(number(await field(lab, "m: Valor").evaluate((one) => getComputedStyle(one).fontSize)) >= 16);
      }
    });
  }
}

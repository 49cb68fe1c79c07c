// The panel View of Write: plots, controls and values by forms; each change is one of the text.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { STILL, eventually, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const editor = (lab) => lab.page.locator(".cm-content");
const text = (lab) => editor(lab).evaluate((content) => content.cmTile?.view?.state.doc.toString() ?? content.innerText);
const now = (lab, expected) => eventually(async () => assert.match(await text(lab), expected));
const field = (lab, name) => lab.page.getByLabel(name, { exact: true });
const runs = (lab) => eventually(async () => assert.match(await lab.page.locator("#writing-status").innerText(), /^No errors/));

/** The oscillator of the templates, at what its readers see. */
async function view(lab, { write = "Write", begin = "New", template = "A mass on a spring", panel = "View" } = {}) {
  await lab.tab(write);
  await editor(lab).waitFor();
  await lab.press(begin);
  await lab.press(template);
  await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), template));
  await lab.page.locator(".writing-tabs").getByRole("tab", { name: panel, exact: true }).click();
  await lab.page.locator(".plots-form").waitFor();
}

visit("a plot is added, changed, moved and removed, and the text with it", async (lab) => {
  await view(lab);
  const before = await text(lab);
  await lab.press("Add plot");
  await lab.page.locator("#new-plot-curves").selectOption("y'");
  await lab.page.locator("#new-plot-across").selectOption("y");
  await field(lab, "Title").fill("Phases");
  await lab.page.locator("#new-plot-form").getByRole("button", { name: "Add", exact: true }).click();
  await now(lab, /"Phases": y' against y\n/);
  await runs(lab);
  const count = await lab.page.locator(".plot-form").count();
  const last = `Plot ${count}`;
  await field(lab, `${last}: Title`).fill("Phase portrait");
  await field(lab, `${last}: Add a quantity`).selectOption("y");
  await now(lab, /"Phase portrait": y', y against y\n/);
  await field(lab, `${last}: Curves`).fill("y'");
  await field(lab, `${last}: Equal scales`).check();
  await now(lab, /"Phase portrait": y' against y, equal axes\n/);
  await field(lab, `${last}: Type`).selectOption("points");
  await now(lab, /"Phase portrait": points y' against y every 1 \[s\], equal axes\n/);
  await field(lab, `${last}: Type`).selectOption("histogram");
  await now(lab, /"Phase portrait": histogram y'\n/);
  await runs(lab);
  await lab.press("Move up: Phase portrait");
  await eventually(async () => assert.equal(await field(lab, `Plot ${count - 1}: Title`).inputValue(), "Phase portrait"));
  await eventually(async () => assert.equal(await lab.page.evaluate(() => document.activeElement.id), `plot-form-${count - 2}-up`));
  await lab.press("Remove Phase portrait");
  await eventually(async () => assert.equal(await lab.page.locator(".plot-form").count(), count - 1));
  await eventually(async () => assert.equal(await text(lab), before));
});

visit("a fault of a plot stands beside it, and what would be read otherwise is refused", async (lab) => {
  await view(lab);
  const card = lab.page.locator(".plot-form").first();
  const curves = field(lab, "Plot 1: Curves");
  const kept = await curves.inputValue();
  await curves.fill("yy");
  await card.locator(".brief.error").waitFor();
  await curves.fill(kept);
  await eventually(async () => assert.equal(await card.locator(".brief").count(), 0));
  const before = await text(lab);
  await field(lab, "Plot 1: Title").fill('a" b');
  await card.locator(".refusal", { hasText: 'cannot contain `"`' }).waitFor();
  assert.equal(await text(lab), before);
  await field(lab, "Plot 1: Title").fill("Height");
  await now(lab, /"Height":/);
  assert.equal(await card.locator(".refusal").innerText(), "");
});

visit("controls are put under headings, which are moved, named and removed", async (lab) => {
  await view(lab);
  const before = await text(lab);
  const words = () => lab.page.locator("[aria-labelledby=view-controls] .shown-row .word").allInnerTexts();
  const controls = await words();
  await lab.press("Add group");
  await eventually(async () => assert.deepEqual(await words(), ["Group", ...controls]));
  // The name can be typed at once.
  await eventually(async () => assert.match(await lab.page.evaluate(() => document.activeElement.id), /^shown-\d+-label$/));
  await lab.page.keyboard.press("Control+a");
  await lab.page.keyboard.type("Spring");
  await now(lab, /group "Spring"\nparameter/);
  await lab.button("Move down: Group").press("Enter");
  await eventually(async () => assert.deepEqual(await words(), [controls[0], "Group", ...controls.slice(1)]));
  await runs(lab);
  await lab.tab("Explore");
  // Three parameters are in sight, the others under More.
  await lab.openMore();
  const group = lab.page.getByRole("group", { name: "Spring" });
  await eventually(async () => assert.equal(await group.locator(".parameter").count(), controls.length - 1));
  await lab.tab("Write");
  // In the forms of the model it is a row among the parameters.
  await lab.page.getByRole("tab", { name: "Model", exact: true }).click();
  await field(lab, "Group").fill("Spring and damper");
  await now(lab, /group "Spring and damper"\nparameter/);
  await lab.page.getByRole("tab", { name: "View", exact: true }).click();
  await lab.press("Move up: Group");
  await eventually(async () => assert.deepEqual(await words(), ["Group", ...controls]));
  await lab.press("Remove the group; its controls stay");
  await eventually(async () => assert.equal(await text(lab), before));
});

visit("what is wrong is in sight from the end of a long form, and one press leads to it", async (lab) => {
  await view(lab);
  await field(lab, "Plot 1: Curves").fill("yy");
  const lead = lab.page.locator("#show-errors");
  await lead.waitFor();
  assert.equal(await lead.innerText(), "Show the error");
  await lab.page.locator("#view-values").scrollIntoViewIfNeeded();
  const inside = () => lead.evaluate((button) => {
    const { top, bottom } = button.getBoundingClientRect();
    return top >= 0 && bottom <= innerHeight && document.elementFromPoint(button.getBoundingClientRect().left + 4, (top + bottom) / 2) === button;
  });
  await eventually(async () => assert.ok(await inside()));
  await lead.click();
  await eventually(async () => assert.equal(await lab.page.evaluate(() => document.activeElement.id), "writing-findings"));
});

visit("controls change their order and labels, values are hidden, with keys alone", async (lab) => {
  await view(lab);
  const names = () => lab.page.locator("[aria-labelledby=view-controls] .shown-row .word").allInnerTexts();
  const [first, second, ...rest] = await names();
  await lab.button(`Move down: ${first}`).focus();
  await lab.keys("Enter");
  await eventually(async () => assert.deepEqual(await names(), [second, first, ...rest]));
  await eventually(async () => assert.match(await lab.page.evaluate(() => document.activeElement.id), /^shown-\d+-down$/));
  await field(lab, `${first}: Label`).fill("What hangs there");
  await now(lab, /"What hangs there"/);
  await runs(lab);
  const last = await lab.page.locator("[aria-labelledby=view-values] input[type=checkbox]").last().getAttribute("aria-label");
  await lab.tabTo(`[aria-label="${last}"]`);
  await lab.keys("Space");
  await now(lab, /\nhidden /);
  await runs(lab);
  await lab.tab("Explore");
  await eventually(async () => {
    const labels = await lab.page.locator(".parameter label").allInnerTexts();
    assert.ok(labels[1].includes("What hangs there"), `${labels}`);
  });
});

visit("the description of the document is a form, and keys that it does not know stay", async (lab) => {
  await view(lab);
  await lab.page.getByRole("tab", { name: "Model", exact: true }).click();
  await field(lab, "Title").fill("A bob on a spring");
  await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "A bob on a spring"));
  await field(lab, "Summary").fill("A mass swings: up and down.");
  await now(lab, /\nsummary: A mass swings: up and down\.\n---\n/);
  await lab.page.getByText("Method and duration").click();
  await lab.page.locator("#front-method").selectOption("dormand-prince");
  await field(lab, "Ends at").fill("5 [s]");
  await now(lab, /\nmethod: dormand-prince\nuntil: 5 \[s\]\n---\n/);
  await runs(lab);
  await field(lab, "Ends at").fill("");
  await field(lab, "Ends at").press("Tab");
  await eventually(async () => assert.doesNotMatch(await text(lab), /until:/));
  await lab.page.locator("#front-language").selectOption("es");
  await now(lab, /^---\ntitle: A bob on a spring\nlanguage: es\n/);
});

visit("a question appears when the one before is answered, and the author sees all of them", async (lab) => {
  await view(lab);
  await lab.page.locator(".writing-tabs").getByRole("tab", { name: "Questions", exact: true }).click();
  await lab.press("Add question");
  await lab.page.locator("#new-prompt").fill("How long is one swing?");
  await lab.page.locator("#new-follows").check();
  await lab.page.locator("#new-question-form").getByRole("button", { name: "Add", exact: true }).click();
  await now(lab, /```question\nHow long is one swing\?\n\nafter: previous\nhide: T\n/);
  await eventually(async () => assert.equal(await field(lab, "Question 2: Appears after question").inputValue(), "previous"));
  await runs(lab);
  await lab.tab("Questions");
  const second = lab.page.locator(".question").nth(1);
  await eventually(async () => assert.match(await second.innerText(), /^question 2\s+Answer this first: Question 1$/i));
  await lab.page.locator("#answer-0").fill("7 s");
  await lab.page.locator(".question").first().getByRole("button", { name: "Check", exact: true }).click();
  await eventually(async () => assert.match(await lab.page.locator("#verdict-0").innerText(), /./));
  assert.equal(await lab.page.locator("#answer-1").count(), 0);
  await lab.page.locator("#answer-0").fill("0.9935 s");
  await lab.page.locator(".question").first().getByRole("button", { name: "Check", exact: true }).click();
  await lab.page.locator("#answer-1").waitFor();
  await eventually(async () => assert.match(await second.innerText(), /How long is one swing\?/));
});

visit("how far the present run is off what is conserved is shown beside the claim", async (lab) => {
  await lab.page.goto("about:blank");
  await lab.go(`${lab.address}#1&d=kepler.md`);
  await lab.everything();
  await lab.tab("Theory");
  await lab.page.locator("#checks > summary").click();
  const show = lab.page.getByRole("button", { name: "Show in the present run" }).first();
  await show.click();
  await lab.page.locator(".deviation .note").waitFor();
  await lab.button("Play").click();
  await lab.page.locator(".deviation-plot svg").waitFor();
  await eventually(async () => assert.match(await lab.page.locator(".deviation-plot svg").innerHTML(), /relative deviation|deviation/));
  await lab.press("Hide the plot");
  await eventually(async () => assert.equal(await lab.page.locator(".deviation-plot").count(), 0));
});

for (const [language, theme, width] of [["en-GB", "light", 1440], ["es-ES", "dark", 390], ["es-ES", "light", 1024]]) {
  visit(`the panel fits and is accessible: ${language}, ${theme}, ${width} px`, { ...STILL, language, theme, width, height: 900, touch: width < 500 }, async (lab) => {
    const spanish = { write: "Escribir", begin: "Nuevo", template: "Una masa en un resorte", panel: "Vista" };
    await view(lab, language === "es-ES" ? spanish : {});
    await lab.page.locator("#new-plot").click();
    const cut = await lab.page.locator(".tabs, .writing-tabs, .writing-tabs button, .plot-form, .shown-row").evaluateAll((parts) =>
      parts.filter((part) => part.scrollWidth > part.clientWidth + 1).map((part) => `${part.className} ${part.innerText}`));
    assert.deepEqual(cut, []);
    await lab.page.evaluate(axe);
    const { violations } = await lab.page.evaluate(() => window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21aa", "best-practice"] }));
    assert.deepEqual(violations.map((found) => [found.id, found.nodes.map((node) => node.html)]), []);
    if (width < 500) {
      const small = await lab.page.locator(".plots-form :is(button, select, input:not([type=checkbox])), .shown-row :is(button, input:not([type=checkbox]))").evaluateAll((parts) =>
        parts.map((part) => [part.id, part.getBoundingClientRect().height]).filter(([, height]) => height > 1 && height < 39.5));
      assert.deepEqual(small, []);
    }
    if (process.env.SHOTS) {
      await lab.page.locator("#view-plots").scrollIntoViewIfNeeded();
      await lab.page.screenshot({ path: `${process.env.SHOTS}/view-${width}-${theme}.png`, fullPage: true });
    }
  });
}

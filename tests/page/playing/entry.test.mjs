// The first screen: a simulation by the word that a teacher types, the published simulation, a film of one's own.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { STILL, eventually, labPage, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const PHONE = { width: 390, height: 844, touch: true };
/** The page as it opens, without a link. */
const FIRST = { fragment: "" };

const heading = (lab) => lab.page.getByRole("heading", { level: 1 }).innerText();
const line = (lab) => lab.page.locator(".welcome");

for (const [language, typed, title] of [
  ["en-GB", "Hooke", "A mass on a spring, driven"],
  ["es-ES", "hooke", "Una masa en un muelle, forzada"],
  ["es-ES", "simple harmonic spring", "Una masa en un muelle, forzada"],
  ["en-GB", "resorte armonico", "A mass on a spring, driven"],
  ["es-ES", "RLC", "Un circuito y su gemelo mecánico"],
  ["en-GB", "SHM", "A ball on a column of air"],
]) {
  visit(`a simulation is found and opened in three actions: ${typed}, ${language}`, { ...FIRST, language }, async (lab) => {
    await lab.page.locator("#browse").click();
    await lab.page.keyboard.type(typed);
    await lab.page.getByRole("dialog").getByRole("link", { name: title, exact: true }).click();
    await eventually(async () => assert.equal(await heading(lab), title));
    assert.equal(await line(lab).count(), 0, "the line belongs to the opening document");
  });
}

for (const [language, published] of [["en-GB", "Published simulation"], ["es-ES", "Simulación publicada"]]) {
  visit(`a button opens the published simulation: ${language}`, { ...FIRST, language }, async (lab) => {
    const title = await heading(lab);
    await lab.press(published);
    await eventually(async () => assert.notEqual(await heading(lab), title));
    assert.match(lab.page.url(), /#1&d=utube\.md$/);
    assert.equal(await line(lab).count(), 0);
    await eventually(async () => assert.equal((await lab.focused()).id, "browse"));
    await lab.page.goBack();
    await eventually(async () => assert.equal(await heading(lab), title));
    assert.equal(await line(lab).count(), 1);
  });
}

for (const idle of [true, false]) {
  visit(`Film your own leads to the chooser of a film, ${idle ? "in the laboratory" : "before the laboratory is there"}`, { ...FIRST, idle }, async (lab) => {
    const chooser = lab.page.waitForEvent("filechooser");
    await lab.page.locator("#film-own").click();
    assert.equal(await (await chooser).element().getAttribute("id"), "film-file");
    assert.equal(await lab.page.locator("#tab-measure").getAttribute("aria-selected"), "true");
    await eventually(async () => assert.equal((await lab.focused()).id, "open-film"));
  });
}

visit("the line is one stop of Tab, with arrow keys between its buttons", FIRST, async (lab) => {
  await lab.tabTo("#film-own");
  await lab.keys("ArrowRight");
  assert.equal((await lab.focused()).id, "published");
  await lab.keys("Tab");
  assert.equal((await lab.focused()).id, "browse");
  await lab.keys("Shift+Tab", "Enter");
  await eventually(async () => assert.match(lab.page.url(), /#1&d=utube\.md$/));
});

for (const size of [{}, { width: 1024, height: 768 }, PHONE]) {
  visit(`nothing moves when the laboratory takes over: ${size.width ?? 1440}`, { ...FIRST, ...size, idle: false }, async (lab) => {
    const places = () =>
      lab.page.evaluate(() =>
        [".welcome", "#browse", ".scene", "#play", ".tabs"].map((part) => {
          const { left, top, width, height } = document.querySelector(part).getBoundingClientRect();
          return [part, left, top, width, height].map((value) => (typeof value === "number" ? Math.round(value) : value)).join(" ");
        }),
      );
    await line(lab).waitFor();
    const before = await places();
    await lab.rest();
    await lab.rest();
    await lab.taken();
    assert.deepEqual(await places(), before);
    const wide = await lab.page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, "no sideways scrolling");
  });
}

visit("a document from a link has no line", { fragment: "#1&d=rlc.md" }, async (lab) => {
  await eventually(async () => assert.match(await heading(lab), /circuit/));
  assert.equal(await line(lab).count(), 0);
});

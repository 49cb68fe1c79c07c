// The first screen: a simulation by the word that a teacher types, the published simulation, a film of one's own, the guided start.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { STILL, eventually, visit } from "../lab.mjs";

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

for (const [language, published] of [["en-GB", "The U-tube as published"], ["es-ES", "El tubo en U publicado"]]) {
  visit(`a button opens the published simulation: ${language}`, { ...FIRST, language }, async (lab) => {
    const title = await heading(lab);
    await lab.pressInMenu(published);
    await eventually(async () => assert.notEqual(await heading(lab), title));
    assert.match(lab.page.url(), /#1&d=utube\.md$/);
    assert.equal(await line(lab).count(), 0);
    await eventually(async () => assert.equal((await lab.focused()).id, "menu"));
    await lab.page.goBack();
    await eventually(async () => assert.equal(await heading(lab), title));
    assert.equal(await line(lab).count(), 1);
  });
}

for (const idle of [true, false]) {
  visit(`Film your own leads to the chooser of a film, ${idle ? "in the laboratory" : "before the laboratory is there"}`, { ...FIRST, idle }, async (lab) => {
    const chooser = lab.page.waitForEvent("filechooser");
    await lab.page.locator("#film-own").click();
    assert.equal(await (await chooser).element().getAttribute("id"), "record-file");
    assert.equal(await lab.page.locator("#tab-measure").getAttribute("aria-selected"), "true");
    await eventually(async () => assert.equal((await lab.focused()).id, "choose-record"));
  });
}

visit("the line is one stop of Tab, with arrow keys between its buttons", FIRST, async (lab) => {
  await lab.tabTo("#guide");
  await lab.keys("ArrowRight");
  assert.equal((await lab.focused()).id, "film-own");
  await lab.keys("ArrowRight", "ArrowLeft");
  await lab.keys("Tab");
  assert.equal((await lab.focused()).id, "browse");
  await lab.keys("Shift+Tab", "Enter");
  await eventually(async () => assert.equal(await lab.page.locator("#tab-measure").getAttribute("aria-selected"), "true"));
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
    // It comes when the page is idle for the second time, after it has been compiled.
    await eventually(async () => {
      await lab.rest();
      assert.equal(await lab.page.locator("[role=tab][aria-busy=true]").count(), 0);
    });
    assert.deepEqual(await places(), before);
    const wide = await lab.page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, "no sideways scrolling");
  });
}

visit("a document from a link has no line", { fragment: "#1&d=rlc.md" }, async (lab) => {
  await eventually(async () => assert.match(await heading(lab), /circuit/));
  assert.equal(await line(lab).count(), 0);
});

const WORDS = {
  "en-GB": { guide: "60-second start", steps: [/Lift the liquid/, /Let go/, /Change the damping/, /Read the period/, /Done/], play: "Play", pause: "Pause", damping: "Damping", skip: "Skip", close: "Close" },
  "es-ES": { guide: "Inicio en 60 segundos", steps: [/Levanta el líquido/, /Suéltalo/, /Cambia el amortiguamiento/, /Lee el periodo/, /Hecho/], play: "Reproducir", pause: "Pausar", damping: "Amortiguamiento", skip: "Omitir", close: "Cerrar" },
};
const guide = (lab, words) => lab.page.getByRole("region", { name: words.guide, exact: true });
const asked = (lab, words, step) => eventually(async () => assert.match(await lab.page.locator("#guide-step").innerText(), words.steps[step]));

/** Drags a column of the drawing upwards. */
async function lift(lab) {
  const { x, y, width, height } = await lab.page.locator(".scene .drawing [part~=handle]").first().boundingBox();
  await lab.page.mouse.move(x + width / 2, y + height * 0.6);
  await lab.page.mouse.down();
  await lab.page.mouse.move(x + width / 2, y + height * 0.55, { steps: 4 });
  await lab.page.mouse.move(x + width / 2, y + height * 0.5, { steps: 4 });
  await lab.page.mouse.up();
}

for (const [language, words] of Object.entries(WORDS)) {
  visit(`the guided start is done by mouse and does not return: ${language}`, { ...FIRST, language }, async (lab) => {
    assert.equal(await guide(lab, words).count(), 0, "it does not begin by itself");
    await lab.press(words.guide);
    await asked(lab, words, 0);
    await lab.press(words.play);
    await lab.press(words.pause);
    await asked(lab, words, 0);
    await lift(lab);
    await asked(lab, words, 1);
    await lab.press(words.play);
    await asked(lab, words, 2);
    await lab.enter(words.damping, "0.05");
    await asked(lab, words, 3);
    await lab.watchUntil(1.2);
    await lab.press(words.pause);
    await asked(lab, words, 4);
    await lab.press(words.close);
    assert.equal(await guide(lab, words).count(), 0);
    assert.equal((await lab.focused()).id, "guide");
    await lab.page.reload();
    await line(lab).waitFor();
    assert.equal(await guide(lab, words).count(), 0);
    assert.equal(await lab.page.locator("#guide.action").count(), 0, "it is no longer offered prominently");
  });

  visit(`the guided start is done by keyboard: ${language}`, { ...FIRST, language }, async (lab) => {
    await lab.tabTo("#guide");
    await lab.keys("Enter");
    await eventually(async () => assert.equal((await lab.focused()).id, "guide-end"));
    assert.equal(await lab.page.locator("#guide-end").getAttribute("aria-describedby"), "guide-step");
    assert.equal(await lab.page.locator("#guide-step").getAttribute("aria-live"), "polite");
    await lab.tabTo("[part~=handle]");
    await lab.keys("ArrowUp");
    await asked(lab, words, 1);
    await lab.keys("k");
    await asked(lab, words, 2);
    await lab.tabTo("#range-2");
    const before = await lab.focused();
    await lab.keys("ArrowRight");
    await asked(lab, words, 3);
    assert.deepEqual(await lab.focused(), before, "the focus stays where it is");
    await lab.watchUntil(1.2);
    await lab.keys("k");
    await asked(lab, words, 4);
    await lab.tabTo("#guide-end");
    await lab.keys("Enter");
    await eventually(async () => assert.equal((await lab.focused()).id, "guide"));
  });
}

visit("the guided start is skipped, begun again, and ends with its document", FIRST, async (lab) => {
  const words = WORDS["en-GB"];
  await lab.press(words.guide);
  await lab.press(words.skip);
  assert.equal(await guide(lab, words).count(), 0);
  await lab.press(words.guide);
  await asked(lab, words, 0);
  await lab.page.locator("#browse").click();
  await lab.page.getByRole("dialog").getByRole("link", { name: "The Lorenz equations", exact: true }).click();
  await eventually(async () => assert.match(await heading(lab), /Lorenz/));
  assert.equal(await guide(lab, words).count(), 0);
  await lab.page.goBack();
  await line(lab).waitFor();
  assert.equal(await guide(lab, words).count(), 0);
});

visit("the guided start begins in the player, which brings the laboratory", { ...FIRST, idle: false }, async (lab) => {
  await lab.page.locator("#guide").click();
  await asked(lab, WORDS["en-GB"], 0);
});

for (const [language, words] of Object.entries(WORDS)) {
  for (const theme of ["light", "dark"]) {
    for (const [device, size] of [["desk", {}], ["phone", PHONE]]) {
      visit(`axe finds nothing in the line and in the guided start: ${language}, ${theme}, ${device}`, { ...FIRST, ...STILL, language, theme, ...size }, async (lab) => {
        const clean = async () => {
          const { violations } = await lab.page.evaluate(() => window.axe.run(document));
          assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 160))}`), []);
          assert.ok((await lab.page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0, "no sideways scrolling");
        };
        await lab.page.evaluate(axe);
        await clean();
        await lab.press(words.guide);
        await asked(lab, words, 0);
        await clean();
      });
    }
  }
}

for (const [language, words] of Object.entries(WORDS)) {
  for (const [width, height] of [[1440, 900], [1260, 800], [1024, 768]]) {
    visit(`line and guided start have room in the head: ${language}, ${width}`, { ...FIRST, language, width, height }, async (lab) => {
      const high = () => lab.page.locator("header.head").evaluate((head) => head.offsetHeight);
      assert.equal(await high(), 56);
      await lab.press(words.guide);
      await asked(lab, words, 0);
      assert.equal(await high(), 56);
    });
  }
}

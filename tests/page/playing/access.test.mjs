// For everyone: axe on every view, in all languages and both themes; the phone; the whole laboratory by keyboard.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync, writeFileSync } from "node:fs";
import { STILL, beside, drop, eventually, meniscus, temporary, visit } from "../lab.mjs";
import { film, fit, openTheory, records } from "../measured.mjs";
import { pathToFileURL } from "node:url";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What axe finds wrong with the page as it is, or with a part of it. */
async function faults(lab, view, part = "html") {
  await lab.page.evaluate(axe);
  const { violations } = await lab.page.evaluate((part) => window.axe.run(part), part);
  return violations.map(({ id, help, nodes }) => `${view}: ${id}: ${help}\n    ${nodes.map((node) => node.html.slice(0, 200)).join("\n    ")}`);
}

/** Each language with each theme and each size, and the third one where its texts have least room. */
const VIEWS = [
  ["en-GB", "light", "desk"],
  ["en-GB", "dark", "phone"],
  ["es-ES", "dark", "desk"],
  ["es-ES", "light", "phone"],
  ["pt-BR", "dark", "phone"],
];

for (const [language, theme, device] of VIEWS) {
  const size = device === "phone" ? { width: 390, height: 844, touch: true } : {};
  visit(`axe finds nothing: ${language}, ${theme}, ${device}`, { ...STILL, language, theme, ...size }, async (lab) => {
    const found = await faults(lab, "as it opens");
    await lab.page.locator("#step-forward").click();
    await lab.page.locator("#keep").click();
    await lab.page.locator("#step-forward").click();
    // As a student sees them, then as an author.
    for (const tab of ["explore", "questions", "measure", "theory", "everything", "explore", "theory", "class", "write"].map((id) => lab.page.locator(id === "everything" ? "#everything" : `#tab-${id}`))) {
      await tab.click();
      // What is folded inside is built when its outside is unfolded.
      for (let depth = 0; depth < 2; depth += 1) {
        await lab.page.evaluate(() => document.querySelectorAll("details").forEach((details) => (details.open = true)));
        await lab.drawn();
      }
      found.push(...(await faults(lab, await tab.innerText(), "#panel")));
    }
    await lab.page.locator("#tab-explore").click();
    await lab.page.locator("#parameter-0").fill("nonsense");
    await lab.page.locator("#parameter-0").press("Enter");
    found.push(...(await faults(lab, "a refusal")));
    await lab.openMenu();
    await lab.page.locator("#help").click();
    found.push(...(await faults(lab, "the list of keys", "dialog")));
    assert.deepEqual(found, []);
  });
}

/** A document with two errors, one of them a missing factor: nothing of it runs. */
const broken = beside("broken.md");

for (const language of ["en-GB", "es-ES"]) {
  for (const [theme, size] of [["light", {}], ["dark", { width: 390, height: 844, touch: true }]]) {
    visit(`axe finds nothing in a document with errors: ${language}, ${theme}`, { ...STILL, language, theme, ...size }, async (lab) => {
      await lab.page.setInputFiles("#open-file", broken);
      await lab.page.locator(".idle").waitFor();
      await lab.page.locator(".writing .finding").first().waitFor();
      assert.deepEqual(await faults(lab, "errors"), []);
      assert.equal(await lab.page.evaluate(() => document.querySelector(document.querySelector(".skip").getAttribute("href")) !== null), true, "the skip link leads somewhere");
      assert.equal(await lab.page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false, "no sideways scrolling");
    });
  }
  visit(`axe finds nothing in reports: ${language}`, { ...STILL, language }, async (lab) => {
    const spanish = language === "es-ES";
    await openTheory(lab, spanish ? "Amortiguamiento lineal" : "Linear damping");
    await drop(lab, { name: "film.csv", text: film() });
    await records(lab).waitFor();
    await fit(lab);
    const [download] = await Promise.all([
      lab.page.waitForEvent("download"),
      lab.page.locator(".detail").getByRole("button", { name: spanish ? "Informe" : "Report", exact: true }).click(),
    ]);
    const [ofPage, data, ofProgram] = ["report.html", "film.csv", "program.html"].map((name) => temporary(`${language}-${name}`));
    await download.saveAs(ofPage);
    writeFileSync(data, film());
    meniscus("fit", "simulations/theories/linear.md", data, "--observe", "y", "--language", language.slice(0, 2), "--output", ofProgram);
    const found = [];
    for (const file of [ofPage, ofProgram]) {
      await lab.page.goto(pathToFileURL(file).href);
      await lab.page.evaluate(() => document.querySelectorAll("details").forEach((details) => (details.open = true)));
      found.push(...(await faults(lab, file)));
    }
    assert.deepEqual(found, []);
  });
}

visit("from a document with errors there is a way back", async (lab) => {
  await drop(lab, { name: "film.csv", text: film() });
  await records(lab).waitFor();
  await lab.page.setInputFiles("#open-file", broken);
  await lab.press("Back to the previous document");
  await lab.page.getByRole("heading", { level: 1, name: /U-tube/ }).waitFor();
  await lab.tab("Measure");
  assert.equal(await records(lab).count(), 1, "the records are still there");
  await lab.page.setInputFiles("#open-file", broken);
  await lab.press("Other documents");
  await lab.page.getByRole("dialog").getByRole("heading", { name: "Simulations" }).waitFor();
});

for (const [width, height] of [[844, 390], [667, 375], [568, 320]]) {
  visit(`a phone on its side has Play in sight: ${width} by ${height}`, { width, height, touch: true }, async (lab) => {
    for (const button of await lab.page.locator("#transport button:visible").all()) {
      const box = await button.boundingBox();
      assert.ok(box.y >= 0 && box.y + box.height <= height && box.x >= 0 && box.x + box.width <= width, `${await button.getAttribute("aria-label")} at ${box.x}, ${box.y}`);
      assert.ok(box.width >= 40 && box.height >= 40);
    }
    await lab.press("Play");
    await lab.watchUntil(0.3);
    const { height: bar } = await lab.page.locator("#transport").boundingBox();
    assert.ok(bar <= 60, `the row is ${bar} px high`);
    assert.equal(await lab.page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false, "no sideways scrolling");
  });
}

visit("handles have names and ranges of their own", async (lab) => {
  const handles = lab.page.locator("#scene [role=slider]");
  const described = await handles.evaluateAll((handles) => handles.map((handle) => [handle.getAttribute("aria-label"), handle.getAttribute("aria-valuemin"), handle.getAttribute("aria-valuemax")]));
  assert.deepEqual(described, [["Left column: Displacement", "-2.5", "2.5"], ["Right column: Displacement", "-2.5", "2.5"]]);
  await lab.enter("Height of the left column", "5");
  await eventually(async () => assert.equal(await handles.first().getAttribute("aria-valuemax"), "3.5"));
});

visit("a drag with the mouse leaves no ring, the keyboard has one", async (lab) => {
  const handle = lab.page.locator("#scene [role=slider]").first();
  const ring = () => handle.evaluate((node) => node.matches("[part~=ring]:focus-visible") && getComputedStyle(node).strokeWidth === "3px");
  const { x, y, width } = await handle.boundingBox();
  await lab.page.mouse.move(x + width / 2, y + 150);
  await lab.page.mouse.down();
  await lab.page.mouse.move(x + width / 2, y + 120, { steps: 4 });
  await lab.page.mouse.up();
  assert.equal(await ring(), false);
  await lab.keys("ArrowUp");
  assert.equal(await ring(), true);
});

visit("hints fit the device", { width: 390, height: 844, touch: true }, async (lab) => {
  const first = await lab.page.locator(".level-ring").innerText();
  assert.match(first, /Drag it/);
  assert.doesNotMatch(first, /keys/);
  // Once something has been dragged, a line below the scene says it.
  await lab.page.evaluate(() => localStorage.setItem("meniscus:dragged", "1"));
  await lab.page.reload();
  const text = await lab.page.locator("#scene").innerText();
  assert.match(text, /finger/);
  assert.doesNotMatch(text, /keys/);
});

visit("a symbol stands on the line of the last word", async (lab) => {
  await lab.openMore();
  const parted = await lab.page.locator(".parameter label .unbroken").evaluateAll((names) =>
    names.filter((name) => {
      const [word, symbol] = [document.createRange(), name.querySelector(".symbol")];
      word.selectNodeContents(name.firstChild);
      const [a, b] = [word.getBoundingClientRect(), symbol.getBoundingClientRect()];
      return a.bottom < b.top || b.bottom < a.top;
    }).map((name) => name.textContent));
  assert.ok((await lab.page.locator(".parameter label .symbol").count()) > 5);
  assert.deepEqual(parted, []);
});

visit("a phone shows everything without sideways scrolling", { width: 390, height: 844, touch: true }, async (lab) => {
  const isWide = () => lab.page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth);
  for (const all of [false, true]) {
    await lab.everything(all);
    for (const tab of await lab.page.locator("#panel > .tabs [role=tab]:visible").all()) {
      await tab.click();
      assert.equal(await isWide(), false, await tab.innerText());
    }
  }
  await lab.press("Play");
  await lab.watchUntil(0.5);
  assert.equal(await isWide(), false, "while it plays");
  for (const button of await lab.page.locator("#transport button:visible").all()) {
    const { width, height } = await button.boundingBox();
    assert.ok(width >= 40 && height >= 40, `${await button.getAttribute("aria-label")} is ${width} by ${height}`);
  }
});

visit("the whole laboratory is worked by keyboard alone", async (lab) => {
  // Every control can be reached, and the focus is never lost on the way.
  const reached = new Set();
  for (let presses = 0; presses < 200; presses += 1) {
    await lab.keys("Tab");
    const { tag } = await lab.focused();
    if (tag === "BODY" && reached.size > 0) break;
    reached.add(
      await lab.page.evaluate(() => {
        const all = [...document.querySelectorAll("*")];
        return all.indexOf(document.activeElement);
      }),
    );
  }
  const missed = await lab.page.evaluate((reached) => {
    const all = [...document.querySelectorAll("*")];
    const usable = (element) =>
      element.matches("button, input, select, summary, a[href], [tabindex='0']") &&
      !element.matches("[tabindex='-1'], [hidden], :disabled") &&
      element.checkVisibility();
    return all.filter((element, index) => usable(element) && !reached.includes(index)).map((element) => element.outerHTML.slice(0, 120));
  }, [...reached]);
  assert.deepEqual(missed, [], "not reached with Tab");

  // Play, pause, step, reset, speed, scrub.
  await lab.page.evaluate(() => document.activeElement.blur());
  await lab.tabTo("#play");
  await lab.keys("Enter");
  await lab.watchUntil(0.5);
  await lab.keys("Space");
  const paused = await lab.time();
  await lab.keys(".");
  assert.ok((await lab.time()) > paused);
  await lab.tabTo("#time-line");
  await lab.keys("ArrowLeft", "ArrowLeft");
  assert.ok((await lab.time()) <= paused);
  await lab.tabTo("#speed");
  await lab.keys("ArrowDown");
  assert.equal(await lab.page.locator("#speed").inputValue(), "2");
  await lab.page.evaluate(() => document.activeElement.blur());
  await lab.keys("k");
  await eventually(async () => assert.equal(await lab.page.locator("#play").getAttribute("aria-label"), "Pause"));
  await lab.keys("k", "r");
  assert.equal(await lab.time(), 0);

  // The liquid, a plot, a parameter, the state.
  await lab.tabTo("[role=slider][part~=handle]");
  await lab.keys("ArrowUp");
  assert.ok((await lab.number("Displacement")) > 0.5);
  await lab.tabTo("canvas");
  await lab.keys("ArrowRight", "+", "0");
  const damping = lab.slider(/^Damping/);
  await lab.tabTo(`#${await damping.getAttribute("id")}`);
  const before = await lab.number("Damping");
  await lab.keys("ArrowRight", "ArrowRight");
  assert.ok((await lab.number("Damping")) > before);

  // The panel: tabs with arrows; single keys do nothing there.
  await lab.tabTo("[role=tab]");
  await lab.keys("ArrowRight");
  assert.equal(await lab.page.getByRole("tab").nth(1).getAttribute("aria-selected"), "true");
  const time = await lab.time();
  await lab.keys("k");
  assert.equal(await lab.page.locator("#play").getAttribute("aria-label"), "Play");
  assert.equal(await lab.time(), time);

  // The list of keys opens and closes, and the focus comes back.
  await lab.tabTo("#menu");
  await lab.keys("Enter");
  await lab.tabTo("#help");
  await lab.keys("Enter");
  await lab.page.getByRole("dialog").waitFor();
  await lab.keys("Escape");
  assert.equal((await lab.focused()).id, "menu");
});

visit("single keys can be switched off, and never act while typing", async (lab) => {
  await lab.field("Damping").focus();
  await lab.keys("k", "r");
  assert.equal(await lab.page.locator("#play").getAttribute("aria-label"), "Play");
  await lab.keys("Escape");
  await lab.pressInMenu("Keyboard shortcuts");
  await lab.page.getByRole("checkbox", { name: "Single-key shortcuts" }).uncheck();
  await lab.keys("Escape");
  await lab.page.evaluate(() => document.activeElement.blur());
  await lab.keys("k");
  assert.equal(await lab.page.locator("#play").getAttribute("aria-label"), "Play");
});

visit("changes are announced", async (lab) => {
  await lab.page.evaluate(() => document.activeElement.blur());
  await lab.keys("k");
  await eventually(async () => assert.notEqual(await lab.told(), ""));
  await lab.keys("k");
  await lab.preset("Mercury");
  await eventually(async () => assert.match(await lab.told(), /Mercury/));
});

visit("the language is switched live, and nothing is lost", async (lab) => {
  await lab.enter("Damping", "62.5");
  await lab.press("Step forward");
  const time = await lab.time();
  await lab.pressInMenu("ES – Español");
  assert.equal(await lab.time(), time);
  assert.equal(await lab.field("Amortiguamiento").inputValue(), "62,5");
  assert.equal((await lab.focused()).id, "menu", "the focus stays at the menu");
  await lab.press("Reproducir");
  await lab.press("Pausar");
  await lab.pressInMenu("PT – Português");
  assert.equal((await lab.focused()).id, "menu");
  await lab.press("Reproduzir");
  await lab.press("Pausar");
  assert.equal(await lab.field("Damping").inputValue(), "62,5", "the document is in its own language");
  await lab.openMenu();
  assert.match(await lab.page.locator("#head-menu").innerText(), /Esta simulação não está traduzida/);
  await lab.page.keyboard.press("Escape");
  await lab.page.locator("#tab-theory").click();
  assert.equal(await lab.page.locator(".prose").first().getAttribute("lang"), "en");
  await lab.pressInMenu("EN – English");
  assert.doesNotMatch(await lab.page.locator("#head-menu").textContent(), /translated/);
  await lab.page.locator("#tab-explore").click();
  assert.equal(await lab.field("Damping").inputValue(), "62.5");
});

visit("light and dark follow the system and can be chosen", { theme: "dark" }, async (lab) => {
  const ground = () => lab.page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const dark = await ground();
  await lab.openMenu();
  await lab.page.getByRole("button", { name: /^Colours/ }).click();
  const light = await ground();
  assert.notEqual(light, dark);
  await lab.page.reload();
  await lab.page.getByRole("heading", { level: 1 }).waitFor();
  assert.equal(await ground(), light, "remembered");
});

// The laboratory opens with the player and its simulation, and takes it over.

import assert from "node:assert/strict";
import { eventually, meniscus, temporary, visit } from "../lab.mjs";

/** The laboratory with a document whose numbers the tests know. */
function file() {
  const page = temporary("opening.html");
  meniscus("export", "simulations/utube.md", "--lab", "--output", page);
  return page;
}

const waiting = (lab) => lab.page.locator("[role=tab][aria-busy=true]").count();

/** Everything that stands on the page, and the pictures of its plots that are in sight: the others are not drawn. */
const seen = (lab) =>
  lab.page.evaluate(() => ({
    stage: document.querySelector(".stage").innerText,
    panel: document.querySelector("#panel-explore").innerText,
    head: document.querySelector("header").innerText,
    plots: [...document.querySelectorAll("canvas[id^=canvas-]")]
      .filter((canvas) => canvas.checkVisibility() && canvas.getBoundingClientRect().bottom < innerHeight)
      .map((canvas) => canvas.toDataURL()),
    scroll: scrollY,
    theme: document.documentElement.dataset.theme,
    language: document.documentElement.lang,
  }));

visit("the page opens with its simulation, and the tabs of the laboratory wait", { file, idle: false }, async (lab) => {
  assert.equal(await waiting(lab), 5);
  await lab.press("Play");
  await lab.watchUntil(0.3);
  assert.equal(await waiting(lab), 5);
});

visit("a tab that is asked for brings the laboratory, which shows what was there", { file, idle: false, theme: "dark" }, async (lab) => {
  await lab.openMenu();
  await lab.page.locator("#language-es").click();
  await lab.enter("Amortiguamiento", "321");
  await lab.press("Reproducir");
  await lab.watchUntil(1);
  await lab.press("Pausar");
  await lab.press("Guardar ensayo");
  await lab.press("Volver al inicio");
  await lab.press("Reproducir");
  await lab.watchUntil(0.5);
  await lab.slider("Amortiguamiento").focus();
  await lab.keys("ArrowRight", "ArrowRight");
  await lab.watchUntil(1);
  await lab.press("Pausar");
  await lab.drawn();
  const before = await seen(lab);
  await lab.page.locator("#tab-theory").click();
  await lab.taken();
  assert.equal(await lab.page.locator("#tab-theory").getAttribute("aria-selected"), "true");
  assert.equal((await lab.focused()).id, "tab-theory");
  await lab.page.locator("#panel-theory h2, #panel-theory h3").first().waitFor();
  assert.equal(await lab.told(), "", "a screen reader hears nothing again");
  await lab.page.locator("#tab-explore").click();
  await lab.page.evaluate(() => scrollTo(0, 0));
  await eventually(async () => {
    const after = await seen(lab);
    for (const part of Object.keys(before)) assert.ok(JSON.stringify(after[part]) === JSON.stringify(before[part]), part);
  });
});

visit("a run that plays goes on", { file, idle: false }, async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(0.3);
  const before = await lab.time();
  await lab.tab("Measure");
  await lab.taken();
  assert.ok((await lab.time()) >= before);
  await lab.watchUntil(before + 0.5);
  await lab.press("Pause");
});

visit("the laboratory waits until nothing in the panel has the focus, and no message is read", { file, idle: false }, async (lab) => {
  const compiled = () => lab.page.evaluate(() => typeof laboratory);
  await lab.slider("Damping").focus();
  await lab.rest();
  await eventually(async () => assert.equal(await compiled(), "function"));
  await lab.drawn();
  assert.equal(await waiting(lab), 5);
  await lab.page.locator("#play").focus();
  await eventually(async () => {
    await lab.rest();
    assert.equal(await waiting(lab), 0);
  });
  assert.equal((await lab.focused()).id, "play");
  assert.equal(await lab.told(), "");
});

/** The page is idle as often as the laboratory takes for all parts of its work, and more often. */
async function restLong(lab) {
  for (let times = 0; times < 30; times += 1) await lab.rest();
}

visit("the laboratory does not come while something is pressed, nor while a run plays that somebody has just touched", { file, idle: false }, async (lab) => {
  await lab.press("Play");
  await restLong(lab);
  assert.equal(await waiting(lab), 5, "a run plays");
  await lab.press("Pause");
  await lab.page.locator("#clock").hover();
  await lab.page.mouse.down();
  await restLong(lab);
  assert.equal(await waiting(lab), 5, "a pointer is down");
  await lab.page.mouse.up();
  await eventually(async () => {
    await lab.rest();
    assert.equal(await waiting(lab), 0);
  });
  assert.ok((await lab.time()) > 0);
});

visit("a button of the laboratory does what it says once the laboratory is there", { file, idle: false }, async (lab) => {
  await lab.page.locator("#browse").click();
  await lab.page.locator("dialog[open]").getByRole("searchbox").waitFor();
  assert.equal(await waiting(lab), 0);
});

visit("a link to a state of the page's own document opens in the player", { file, idle: false, fragment: "#1&p=b:300&t=2" }, async (lab) => {
  assert.equal(await waiting(lab), 5);
  assert.equal(await lab.number("Damping"), 300);
  assert.equal(await lab.time(), 2);
  await lab.tab("Measure");
  await lab.taken();
  assert.equal(await lab.number("Damping"), 300);
  assert.equal(await lab.time(), 2);
});

visit("with a link to another document the laboratory comes at once", { file, idle: false, fragment: "#1&d=pendulum.md" }, async (lab) => {
  await lab.page.getByRole("heading", { level: 1, name: /pendulum/i }).waitFor();
  assert.equal(await waiting(lab), 0);
});

visit("after a reload the simulation is as it was left, with the tab that was open", { file, idle: false }, async (lab) => {
  await lab.enter("Damping", "250");
  await lab.tab("Theory");
  await lab.taken();
  await lab.page.reload();
  await lab.taken();
  assert.equal(await lab.page.locator("#tab-theory").getAttribute("aria-selected"), "true");
  assert.equal(await lab.number("Damping"), 250);
});

function exported() {
  const page = temporary("first-frame.html");
  meniscus("export", "simulations/utube.md", "--output", page);
  return page;
}

// Chromium can cut a page off from what is stored if it reads it earlier.
for (const [page, options] of [
  ["the laboratory", { fragment: "" }],
  ["the laboratory with another document", { fragment: "#1&d=pendulum.md" }],
  ["an exported page", { file: exported }],
]) {
  visit(`nothing stored is read before the first frame: ${page}`, options, async (lab) => {
    await lab.page.addInitScript(() => {
      window.reads = { early: [], count: 0 };
      let hasBegun = false;
      const frame = window.requestAnimationFrame;
      window.requestAnimationFrame = (does) =>
        frame((time) => {
          if (hasBegun) return does(time);
          // The first frame comes late, as on a busy computer.
          setTimeout(() => { hasBegun = true; does(time); }, 400);
        });
      const read = Storage.prototype.getItem;
      Storage.prototype.getItem = function (key) {
        window.reads.count += 1;
        if (!hasBegun) window.reads.early.push(key);
        return read.call(this, key);
      };
    });
    await lab.page.reload();
    const reads = await lab.page.evaluate(() => window.reads);
    assert.ok(reads.count > 1);
    assert.deepEqual(reads.early, []);
  });
}

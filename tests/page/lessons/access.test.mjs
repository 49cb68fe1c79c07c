// A lesson for everyone: axe on the pages of student and teacher in all languages, both themes, on desk and phone; joining by the keyboard
// alone; the line of what is not handed in stays in sight.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, before, test } from "node:test";
import { eventually } from "../lab.mjs";
import { answer, join, school, start, status, teach } from "./class.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const { visitor, faults } = school();
let server;
before(async () => (server = await start({ what: ["tests/page/surveyed.md", "simulations/utube.md"] })));
after(() => server?.child.kill("SIGKILL"));

const DESK = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844 };

/** What axe finds wrong with a page, or with a part of it, at the desk and on a phone, light and dark. */
async function wrong(page, view, part = "html") {
  if (!(await page.evaluate(() => window.axe))) await page.evaluate(axe);
  const found = [];
  for (const size of [DESK, PHONE]) {
    await page.setViewportSize(size);
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme, reducedMotion: "reduce" });
      await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
      const { violations } = await page.evaluate((part) => window.axe.run(part), part);
      found.push(...violations.map(({ id, nodes }) => `${view}, ${size.width}, ${colorScheme}: ${id}\n    ${nodes.map(({ html }) => html.slice(0, 200)).join("\n    ")}`));
      if (await page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth)) found.push(`${view}, ${size.width}: scrolls sideways`);
    }
  }
  await page.setViewportSize(DESK);
  return found;
}

const LANGUAGES = ["en-GB", "es-ES", "pt-BR"];

/** Token of the teacher, from the one-time link. */
let teaching;
const teacher = async (locale) => {
  const page = await visitor({ locale, storageState: teaching });
  if (teaching) await page.goto(`${server.base}/teacher`);
  else await teach(page, server);
  await page.locator("#class[open] #class-live").waitFor();
  teaching ??= await page.context().storageState();
  return page;
};

for (const language of LANGUAGES) {
  test(`axe finds nothing in the pages of a student: ${language}`, async () => {
    const student = await visitor({ locale: language });
    const found = [];
    await student.goto(`${server.base}/#join=${server.code}`);
    found.push(...(await wrong(student, "list of the documents")));
    await student.goto(`${server.base}/stored`);
    found.push(...(await wrong(student, "What is stored")));
    await student.goto(`${server.base}/d/surveyed.md`);
    const code = student.locator("#class-code");
    await code.fill("222222");
    await code.press("Enter");
    await eventually(async () => assert.notEqual(await student.locator("#class-status").innerText(), ""));
    found.push(...(await wrong(student, "joining, after a wrong code", "#class-bar")));
    await code.fill(server.code);
    await code.press("Enter");
    await student.locator("#class-mine summary").click();
    found.push(...(await wrong(student, "the seat", "#class-bar")));
    await student.keyboard.press("Escape");
    await student.locator("#tab-questions").click();
    found.push(...(await wrong(student, "the survey")));
    assert.deepEqual(found, []);
  });
}

test("a student joins, answers, opens and closes the seat by the keyboard alone", async () => {
  const student = await visitor();
  await student.goto(`${server.base}/d/utube.md`);
  await student.locator("#tab-questions").waitFor();
  const { keyboard } = student;
  const tabTo = async (selector) => {
    for (let presses = 0; presses < 60; presses += 1) {
      if (await student.evaluate((selector) => document.activeElement.matches(selector), selector)) return;
      await keyboard.press("Tab");
    }
    assert.fail(`Tab does not reach ${selector}`);
  };
  await tabTo("#class-code");
  await keyboard.type(server.code);
  await keyboard.press("Enter");
  await status(student, /^Nothing is handed in/);
  await tabTo("#class-mine summary");
  await keyboard.press("Enter");
  await student.getByText("Key for another device").waitFor();
  await keyboard.press("Tab");
  assert.equal(await student.evaluate(() => document.activeElement.textContent), "Get the file for this class");
  await keyboard.press("Escape");
  assert.equal(await student.evaluate(() => document.activeElement.matches("#class-mine:not([open]) summary")), true);
  await tabTo("#tab-explore");
  await keyboard.press("ArrowRight");
  await keyboard.press("Enter");
  await tabTo("[role=tabpanel]:not([hidden]) input");
  await keyboard.type("0.61");
  await keyboard.press("Enter");
  await status(student, /^Everything is handed in/);
});

test("the line of what is not handed in stays in sight on a phone, and covers nothing", async () => {
  const student = await visitor({ viewport: { width: 390, height: 844 }, hasTouch: true });
  await join(student, server.code, `${server.base}/d/utube.md`);
  await student.context().setOffline(true);
  await answer(student, "0.62");
  await status(student, /not handed in yet/);
  for (const [width, height] of [[390, 844], [844, 390]]) {
    await student.setViewportSize({ width, height });
    for (const top of [0, 400, 100_000]) {
      await student.evaluate((top) => scrollTo({ top, behavior: "instant" }), top);
      const { seen, below } = await student.evaluate(() => {
        const box = document.getElementById("class-status").getBoundingClientRect();
        const at = document.elementFromPoint(box.left + 5, box.top + box.height / 2);
        const bar = document.getElementById("class-bar").getBoundingClientRect();
        // What else sticks to the top of the window lies below the line.
        const sticks = [...document.querySelectorAll(".head, .stage, .tabs")].filter((one) => getComputedStyle(one).position === "sticky");
        return { seen: at?.id === "class-status", below: sticks.every((one) => one.getBoundingClientRect().top >= bar.bottom - 1 || one.getBoundingClientRect().bottom <= bar.bottom) };
      });
      assert.equal(seen, true, `${width} × ${height}, scrolled to ${top}`);
      if (height > width) continue;
      assert.equal(below, true, `${width} × ${height}, scrolled to ${top}`);
    }
  }
});

for (const language of LANGUAGES) {
  test(`axe finds nothing in the dashboard of a lesson: ${language}`, async () => {
    const page = await teacher(language);
    await page.locator("#class-answers details").first().waitFor();
    // As it is before the first hand-in, too.
    await page.evaluate(() => {
      document.querySelectorAll("#class details").forEach((details) => (details.open = true));
      document.getElementById("class-first").hidden = false;
    });
    const found = await wrong(page, "the dashboard", "#class");
    await page.locator("#class-bar button").first().click();
    found.push(...(await wrong(page, "the code, large", "#class-large")));
    assert.deepEqual(found, []);
    assert.deepEqual(faults, []);
  });
}

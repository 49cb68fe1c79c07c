// Two readers of the laboratory: a student sees four tabs; with the switch *Everything* teachers and authors see the rest.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { STILL, beside, drop, eventually, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const shown = (lab) => lab.page.locator("#panel > .tabs [role=tab]:visible").allInnerTexts();
const STUDENT = ["Explore", "Questions", "Measure", "Theory"];
const EVERYTHING = [...STUDENT, "Write", "Class"];
const isOn = (lab) => lab.page.locator("#everything").getAttribute("aria-pressed");
const message = (lab) => lab.page.locator("#messages").innerText();

visit("a student has four tabs, and the switch adds what teachers and authors need", { fragment: "" }, async (lab) => {
  assert.deepEqual(await shown(lab), STUDENT);
  await lab.openMore();
  const numerics = lab.page.locator(".numerics");
  assert.equal(await numerics.count(), 0);
  await lab.tab("Theory");
  const [source, checks] = [lab.page.locator("#source"), lab.page.locator("#checks")];
  await lab.page.locator("#equations").waitFor();
  assert.deepEqual([await source.count(), await checks.count()], [0, 0]);
  await lab.press("For teachers");
  assert.deepEqual(await shown(lab), EVERYTHING);
  await source.waitFor();
  await checks.waitFor();
  await lab.tab("Explore");
  await numerics.waitFor();
  // In the tab that disappears, the first one takes its place.
  await lab.tab("Class");
  await lab.page.locator("#open-class").waitFor();
  await lab.press("For teachers");
  assert.deepEqual(await shown(lab), STUDENT);
  assert.equal(await lab.page.locator("#tab-explore").getAttribute("aria-selected"), "true");
});

visit("the fit is offered as soon as there is a record; its options and statistics are for those who see everything", { fragment: "" }, async (lab) => {
  await lab.tab("Measure");
  assert.equal(await lab.page.locator("#fit").count(), 0, "nothing to fit yet");
  await lab.page.locator("#panel").getByRole("button", { name: /Column of 18 cm/ }).click();
  await lab.page.locator("#fit").waitFor();
  await lab.page.locator("#fit").click();
  await lab.page.locator("#fit-results").waitFor({ state: "attached", timeout: 60_000 });
  const [statistics, loss] = [lab.page.locator(".statistics"), lab.page.locator("#fit-loss")];
  assert.deepEqual([await statistics.count(), await loss.count()], [0, 0]);
  await lab.press("For teachers");
  assert.deepEqual([await statistics.count(), await loss.count()], [1, 1]);
  assert.equal(await lab.page.locator("#tab-measure").getAttribute("aria-selected"), "true");
});

visit("the switch is remembered, and works before the laboratory is there", { fragment: "", idle: false }, async (lab) => {
  await lab.page.locator("#everything").click();
  await lab.taken();
  await eventually(async () => assert.deepEqual(await shown(lab), EVERYTHING));
  // The browser may read what is stored in another process, a moment later.
  await eventually(async () => {
    await lab.page.reload();
    await lab.page.locator("#everything").waitFor();
    // The player that the page begins with shows the same tabs as the laboratory.
    assert.equal(await lab.page.locator("[role=tab][aria-busy=true]").count() > 0, true, "the laboratory is not there yet");
    assert.deepEqual(await shown(lab), EVERYTHING);
    assert.equal(await isOn(lab), "true");
  });
});

visit("a link opens the page for either reader", async (lab) => {
  const copied = async () => {
    await lab.copyLink();
    return lab.page.evaluate(() => location.href);
  };
  assert.doesNotMatch(await copied(), /everything/, "nobody has chosen");
  await lab.everything();
  const all = await copied();
  assert.match(all, /\?everything#1&d=utube\.md/);
  await lab.everything(false);
  // The address follows the switch.
  await lab.page.reload();
  assert.equal(await isOn(lab), "false");
  const few = await copied();
  assert.match(few, /\?everything=no#1&d=utube\.md/);
  await lab.page.goto("about:blank");
  await lab.go(all);
  assert.deepEqual(await shown(lab), EVERYTHING);
  await lab.everything();
  await lab.page.goto("about:blank");
  await lab.go(few);
  assert.deepEqual(await shown(lab), STUDENT);
});

visit("a teacher's link chooses tabs, hidden values and fixed controls", { fragment: "#1&d=utube.md&p=b:200" }, async (lab) => {
  await lab.everything();
  await lab.press("Share");
  const section = lab.page.locator("section[aria-label='Link for a class']");
  const link = () => section.locator("#lesson-code").innerText();
  await eventually(async () => assert.match(await link(), /#1&d=utube\.md&p=b:200/));
  await section.getByLabel("Tabs").selectOption("of a student");
  for (const name of ["Values", "Measurements and fits"]) await section.getByRole("checkbox", { name, exact: true }).uncheck();
  await section.getByRole("checkbox", { name: /^Fix the values/ }).check();
  await eventually(async () => assert.match(await link(), /\?hide=values,measure&lock&everything=no#1&d=utube\.md&p=b:200/));
  await section.getByRole("button", { name: "Copy this link" }).click();
  await eventually(async () => assert.match(await section.innerText(), /Copied\.|Select the text and copy it/));
  const address = await link();
  await lab.page.goto("about:blank");
  await lab.go(address);
  assert.deepEqual(await shown(lab), ["Explore", "Questions", "Theory"]);
  assert.equal(await lab.page.locator(".readouts").count(), 0);
  assert.equal(await lab.page.locator("#panel-explore fieldset.locked").first().evaluate((set) => set.disabled), true);
  await lab.openMore();
  assert.equal(await lab.page.locator("#parameter-0").isDisabled(), true);
  assert.equal(await lab.page.locator("[role=slider][part~=handle]").count(), 0, "the liquid is not dragged");
  await lab.button("Play").click();
  await lab.watchUntil(0.3);
  // Other states keep the choice, and the switch adds to it.
  await lab.everything();
  assert.deepEqual(await shown(lab), ["Explore", "Questions", "Theory", "Write", "Class"]);
  assert.match(await lab.page.evaluate(() => location.search), /^\?hide=values,measure&lock&everything$/);
});

for (const address of ["?hide=scene,measure,activities,text&lock&everything=no", "?hide=measure,activities,text&everything"]) {
  visit(`the page opens as the laboratory shows it: ${address}`, { fragment: address, idle: false }, async (lab) => {
    const seen = async () => ({ tabs: await shown(lab), scene: await lab.page.locator("#scene").isVisible(), locked: await lab.page.locator("fieldset.locked").count() > 0 });
    await lab.page.locator("#play").waitFor();
    const before = await seen();
    assert.deepEqual(before, address.includes("lock") ? { tabs: ["Explore"], scene: false, locked: true } : { tabs: ["Explore", "Write", "Class"], scene: true, locked: false });
    await eventually(async () => {
      await lab.rest();
      assert.equal(await lab.page.locator("[role=tab][aria-busy=true]").count(), 0);
    }, 30);
    assert.deepEqual(await seen(), before);
  });
}

visit("a document with errors turns everything on, and says so", async (lab) => {
  await lab.page.setInputFiles("#open-file", beside("broken.md"));
  await lab.page.getByRole("heading", { name: "There is nothing to run yet" }).waitFor();
  assert.equal(await isOn(lab), "true");
  assert.match(await message(lab), /The tabs for teachers are shown now: .* tab Write/);
  await lab.page.locator(".cm-content").waitFor();
  // It opens in the editor also for those who turn the switch off.
  await lab.everything(false);
  assert.equal(await lab.page.locator("#tab-write").getAttribute("aria-selected"), "true");
  // Not the choice of the student: the next document is shown as before.
  await lab.page.evaluate(() => localStorage.removeItem("meniscus:everything"));
  await lab.page.goto("about:blank");
  await lab.go(`${lab.address}#1&d=utube.md`);
  assert.deepEqual(await shown(lab), STUDENT);
});

visit("a record shows the tab that the address hides, and says so", { fragment: "?hide=measure#1&d=utube.md" }, async (lab) => {
  assert.deepEqual(await shown(lab), ["Explore", "Questions", "Theory"]);
  await drop(lab, { name: "film.csv", text: "t [s],y [cm]\n0,1\n0.1,2\n0.2,3\n0.3,2\n" });
  await lab.page.locator(".record").waitFor();
  assert.deepEqual(await shown(lab), STUDENT);
  await eventually(async () => assert.match(await message(lab), /The tab Measure is shown now/));
  assert.equal(await lab.page.locator("#tab-measure").getAttribute("aria-selected"), "true");
});

visit("several hand-ins turn everything on, and say so", async (lab) => {
  const files = ["otter", "heron"].map((name) => ({ name: `${name}.hand-in`, mimeType: "application/json", buffer: Buffer.from("{}") }));
  await lab.page.setInputFiles("#open-file", files);
  await lab.page.locator("#class-hand-ins").waitFor();
  await lab.keys("Escape");
  assert.equal(await isOn(lab), "true");
  assert.deepEqual(await shown(lab), EVERYTHING);
  assert.match(await message(lab), /The tabs for teachers are shown now: .* tab Class/);
  await lab.tab("Class");
  await lab.page.locator("#open-class").click();
  await lab.page.locator("#class-hand-ins").waitFor();
});

visit("a student's first screen has few controls, and the play button comes soon", { fragment: "" }, async (lab) => {
  const seen = new Set();
  let play = 0;
  for (let count = 1; count <= 60; count += 1) {
    await lab.page.keyboard.press("Tab");
    const at = await lab.page.evaluate(() => {
      let element = document.activeElement;
      while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
      if (!element || element === document.body) return undefined;
      const box = element.getBoundingClientRect();
      return { id: element.id, name: element.outerHTML.slice(0, 160), isSkip: element.matches(".skip"), isSeen: box.top < innerHeight && box.bottom > 0 };
    });
    if (!at || seen.has(at.name)) break;
    if (at.isSeen && !at.isSkip) seen.add(at.name);
    if (at.id === "play") play = count;
  }
  assert.ok(play > 0 && play <= 12, `Play is stop ${play}`);
  assert.ok(seen.size > 10 && seen.size <= 30, `${seen.size} controls`);
});

for (const [language, size, theme] of [["en-GB", {}, "light"], ["pt-BR", {}, "light"], ["es-ES", { width: 390, height: 844, touch: true }, "dark"]]) {
  visit(`axe finds nothing as the page opens for either reader: ${language}`, { ...STILL, language, theme, ...size, fragment: "" }, async (lab) => {
    await lab.page.evaluate(axe);
    for (const all of [false, true]) {
      await lab.everything(all);
      const { violations } = await lab.page.evaluate(() => window.axe.run(document));
      assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes[0].html.slice(0, 160)}`), []);
      assert.equal(await lab.page.evaluate(() => document.documentElement.scrollWidth > innerWidth), false, "no sideways scrolling");
    }
  });
}

/** Most controls on the first screen, without those of the drawing (`rules.test.mjs`). */
const MOST = 24;

/** Names of the controls that an eye finds in the window. */
const controls = (lab) =>
  lab.page.evaluate(() =>
    [...document.querySelectorAll("button, input, select, textarea, summary, a[href]")]
      .filter((control) => {
        const { left, top, right, bottom } = control.getBoundingClientRect();
        const inside = right > 0 && bottom > 0 && left < innerWidth && top < innerHeight;
        return inside && control.checkVisibility({ opacityProperty: true, visibilityProperty: true });
      })
      .map((control) => control.id || control.innerText || control.getAttribute("aria-label")),
  );

visit("a student's first screen is seen in one glance", { fragment: "" }, async (lab) => {
  // The pointer is nowhere near.
  await lab.page.mouse.move(2, 2);
  await lab.drawn();
  const seen = await controls(lab);
  assert.ok(seen.length <= MOST, `${seen.length}: ${seen.join(", ")}`);
  const panel = lab.page.locator("#panel-explore");
  assert.equal(await panel.getByRole("slider").count(), 3);
  assert.equal(await panel.locator(".preset-group").count(), 1);
  assert.equal(await panel.locator("select").count(), 0);
  assert.deepEqual(await panel.locator(".preset-group .chip[aria-pressed=true]").allInnerTexts(), ["Water"], "water is water");
  assert.equal(await panel.locator("#readouts dl > div").count(), 3);
});

visit("what is needed later appears when it is needed", { fragment: "" }, async (lab) => {
  const shown = (selector) => lab.page.locator(selector).evaluate((part) => part.checkVisibility({ opacityProperty: true, visibilityProperty: true }));
  const LATER = ["#back-to-start", "#step-back", "#time-line", "#speed"];
  await lab.page.mouse.move(2, 2);
  await lab.drawn();
  for (const part of LATER) assert.equal(await shown(part), false, part);
  assert.equal(await lab.page.locator("#keep").isVisible(), false, "an empty run is not kept");
  // By keyboard they are there before anything runs.
  await lab.page.locator("#play").focus();
  await eventually(async () => assert.equal(await shown("#step-forward"), true));
  const place = () => lab.page.locator("#play").boundingBox();
  const before = await place();
  await lab.keys("k");
  await lab.watchUntil(0.3);
  await lab.keys("k");
  await lab.page.locator("#tab-explore").focus();
  for (const part of [...LATER, "#keep"]) await eventually(async () => assert.equal(await shown(part), true, part));
  assert.deepEqual(await place(), before, "nothing moves");
  // The number beside a slider is a field for whoever comes near.
  const field = lab.field("Damping");
  assert.equal(await shown("#parameter-2"), false);
  await field.focus();
  assert.equal(await shown("#parameter-2"), true);
});

visit("More has the rest, and hidden values are listed to those who ask for them", { fragment: "" }, async (lab) => {
  const row = lab.page.locator(".readouts dl > div").filter({ has: lab.page.getByText("Period", { exact: true }) });
  await lab.openMore();
  assert.equal(await row.isVisible(), false);
  await lab.page.getByLabel("Show the values that questions ask for").check();
  await eventually(async () => assert.match(await row.innerText(), /Period[^]*0\.\d+\s*s/));
  assert.ok((await lab.page.locator("#further .preset-group").count()) >= 3);
  await lab.preset("Moon");
  assert.ok((await lab.number("Gravitational acceleration")) < 2);
});

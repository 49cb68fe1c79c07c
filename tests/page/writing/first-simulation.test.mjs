// docs/first-simulation.md, as its reader follows it: from New to a mass on a spring with drawing, plot, slider, question and Spanish
// translation that runs, is saved and opened again. By mouse, by keys and on a phone. Prints the number of actions: clicks, taps, and
// keys that are no typed text.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { eventually, temporary, visit } from "../lab.mjs";

const tutorial = readFileSync(join(dirname(fileURLToPath(import.meta.url)), "..", "..", "..", "docs", "first-simulation.md"), "utf8");
const [first, controls, drawing] = [...tutorial.matchAll(/^````markdown\n(.*?)^````$/gms)].map((found) => found[1]);
const further = /^## 4\..*?(^```question\n.*?^```$)\n\n(^```check\n.*?^```$)/ms.exec(tutorial);
const spanish = /^````text\n(.*?)^````$/ms.exec(tutorial)[1];
/** Not more actions with these hands. */
const MOST = { mouse: 60, keyboard: 72, finger: 60 };

const editor = (lab) => lab.page.locator(".cm-content");
const text = (lab) => editor(lab).evaluate((content) => content.cmTile?.view?.state.doc.toString() ?? content.innerText);
const runs = (lab) => eventually(async () => assert.match(await lab.page.locator("#writing-status").innerText(), /^No errors/));

/** A person with a mouse, a finger, or a keyboard alone. Counts what is done. */
class Person {
  constructor(lab, hands) {
    Object.assign(this, { lab, hands, mouse: hands !== "keyboard", actions: 0 });
  }

  async keys(...keys) {
    for (const key of keys) {
      this.actions += 1;
      await this.lab.page.keyboard.press(key);
    }
  }

  /** Presses a button: clicks it, or goes to it with Tab and presses Enter. A toolbar is one stop of Tab; arrows go on in it. */
  async press(locator) {
    await locator.waitFor();
    if (this.mouse) {
      this.actions += 1;
      return this.hands === "finger" ? locator.tap() : locator.click();
    }
    const has = () => locator.evaluate((node) => node === document.activeElement);
    const isThere = () => locator.evaluate((node) => (node.closest("[role=toolbar]") ?? node).contains(document.activeElement));
    // Whichever way round is the shorter one.
    const way = await locator.evaluate((aim) => {
      const node = aim.closest("[role=toolbar]")?.querySelector("[tabindex='0']") ?? aim;
      const all = [...document.querySelectorAll("a[href], button, input, select, textarea, summary, [tabindex]")].filter((one) => one.tabIndex >= 0 && !one.disabled && one.checkVisibility());
      const from = all.indexOf(document.activeElement);
      return all.indexOf(node) < from ? "Shift+Tab" : "Tab";
    });
    for (let left = 60; !(await isThere()); left -= 1) {
      assert.ok(left > 0, "the keys lead to it");
      await this.keys(way);
    }
    for (let left = 6; !(await has()); left -= 1) {
      assert.ok(left > 0, "the arrow keys lead to it");
      await this.keys("ArrowRight");
    }
    await this.keys("Enter");
  }

  /** Goes to a tab of the panel, from a place in it. */
  async tab(name) {
    const tab = this.lab.page.locator("#panel > .tabs").getByRole("tab", { name, exact: true, includeHidden: true });
    if (!(await tab.isVisible())) {
      await this.press(this.lab.page.locator("#everything"));
      // Back to the link that skips to the panel.
      if (!this.mouse) await this.keys("Shift+Tab", "Shift+Tab", "Shift+Tab", "Enter");
    }
    if (this.mouse) return this.press(tab);
    const selected = this.lab.page.locator("#panel > .tabs [aria-selected=true]");
    if (await this.lab.page.evaluate(() => document.activeElement === document.body)) {
      // The second link of the page skips to the panel.
      await this.keys("Tab", "Tab", "Enter");
    }
    await this.press(selected);
    for (let left = 6; (await selected.innerText()) !== name; left -= 1) {
      assert.ok(left > 0, "the arrow keys lead to it");
      await this.keys(left === 6 && name === "Write" ? "End" : name === "Write" ? "ArrowLeft" : left === 6 && name === "Explore" ? "Home" : "ArrowRight");
    }
  }

  /** Goes to a tab inside Write: the first or last one, where the key leads. */
  async panel(name, key) {
    if (this.mouse) return this.press(this.lab.page.locator(".writing-tabs").getByRole("tab", { name, exact: true }));
    // Behind a form a button leads back to the tabs.
    const isInForm = await this.lab.page.evaluate(() => document.activeElement.closest(".writing-panel:not(#writing-text)") !== null);
    await this.press(isInForm ? this.lab.page.locator(".writing-panel:not([hidden]) .way-back") : this.lab.page.locator(".writing-tabs [aria-selected=true]"));
    await this.keys(key);
  }

  /** Saves the file that is shown. */
  async save() {
    const [download] = await Promise.all([this.lab.page.waitForEvent("download"), this.press(this.lab.button("Save"))]);
    return { name: download.suggestedFilename(), text: readFileSync(await download.path(), "utf8") };
  }

  /** Replaces the whole text. */
  async rewrite(words) {
    if (this.mouse) {
      this.actions += 1;
      await (this.hands === "finger" ? editor(this.lab).tap() : editor(this.lab).click());
    }
    await eventually(async () => assert.ok(await editor(this.lab).evaluate((content) => content.contains(document.activeElement))));
    await this.keys("Control+a");
    await this.lab.page.keyboard.insertText(words);
    await runs(this.lab);
  }
}

for (const hands of ["mouse", "keyboard", "finger"]) {
  const screen = hands === "finger" ? { width: 390, height: 844, touch: true } : {};
  visit(`the tutorial, by ${hands}`, screen, async (lab) => {
    const person = new Person(lab, hands);
    const { mouse } = person;
    await person.tab("Write");
    await editor(lab).waitFor();
    await person.press(lab.page.getByRole("button", { name: "New", exact: true }));
    await person.press(lab.page.getByRole("button", { name: "Empty document", exact: true }));
    await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "My simulation"));
    // 1. The equation. 2. Parameters with sliders. 3. A drawing.
    for (const version of [first, controls, drawing]) {
      await person.rewrite(version);
    }
    await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "A mass on a spring"));
    // 4. A question and a promise at the end.
    await person.keys("Control+End");
    await lab.page.keyboard.insertText(`\n${further[1]}\n\n${further[2]}\n`);
    await runs(lab);
    await lab.page.locator("#tab-questions").waitFor();
    const saved = await text(lab);
    // It runs.
    if (mouse) await person.press(lab.button("Play"));
    else {
      await person.tab("Explore");
      await person.keys("k");
    }
    await lab.watchUntil(0.5);
    if (mouse) await person.press(lab.button("Pause"));
    else {
      await person.keys("k", "End", "ArrowLeft");
      await person.keys("Tab");
    }
    // A phone shows one plot at a time.
    await lab.page.getByRole("button", { name: "Energy", exact: true }).first().waitFor();
    // 5. The translation is begun beside the document, and written text by text.
    await person.panel("Translation", "End");
    await person.press(lab.page.getByRole("button", { name: "Begin a translation", exact: true }));
    await lab.page.locator(".sides-count").waitFor();
    const side = (original) => lab.page.locator(".side", { has: lab.page.getByText(original, { exact: true }) }).locator("textarea");
    const pairs = [...spanish.matchAll(/^"(.*)" = "(.*)"$/gm)].map((found) => [found[1], found[2]]);
    const prose = /---\n\n(.*?)\n\n```/s.exec(spanish)[1];
    const question = /```question\n(.*?)\n\nhint: (.*?)\n```/s.exec(spanish);
    const title = /title: (.*)/.exec(spanish)[1];
    // From field to field with Tab, or by a click: each is one action.
    const fields = [["A mass swings on a spring. Drag it and let go.", prose], ["Measure the period of the oscillation.", question[1]], ["Count several oscillations and divide.", question[2]], ...pairs];
    const all = await lab.page.locator(".side textarea").count();
    for (let place = 0; place < all; place += 1) {
      const field = lab.page.locator(".side textarea").nth(place);
      const original = await lab.page.locator(".side .original").nth(place).innerText();
      const words = fields.find(([known]) => known === original.trim())?.[1] ?? (place === 0 ? title : undefined);
      assert.ok(words, `the tutorial has no translation of ${original}`);
      person.actions += 1;
      await field.focus();
      if (place === 0) await lab.page.keyboard.press("Control+a");
      await lab.page.keyboard.insertText(words);
    }
    await eventually(async () => assert.equal(await lab.page.locator(".sides-count").innerText(), "Nothing is missing."));
    await runs(lab);
    // Saved, and opened again in another visit.
    const files = await lab.page.evaluate(() => history.state);
    assert.match(files, /Una masa en un resorte/);
    await person.panel("Text", "Home");
    await eventually(async () => assert.equal(await text(lab), saved));
    const base = await person.save();
    person.actions += 2;
    await lab.page.getByLabel("File", { exact: true }).selectOption({ index: 1 });
    await eventually(async () => assert.match(await text(lab), /translates: /));
    const other = await person.save();
    for (const file of [base, other]) writeFileSync(temporary(file.name), file.text);
    await lab.page.evaluate(() => history.replaceState(null, ""));
    await lab.page.reload();
    await lab.page.getByRole("heading", { level: 1 }).waitFor();
    person.actions += 1;
    await lab.page.setInputFiles("#open-file", [temporary(base.name), temporary(other.name)]);
    await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "A mass on a spring"));
    await lab.pressInMenu("ES – Español");
    await eventually(async () => assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), "Una masa en un resorte"));
    // The tab is the one before the reload.
    await lab.tab("Explorar");
    assert.ok(await lab.page.getByText("Amortiguamiento").first().isVisible());
    console.log(`${hands}: ${person.actions} actions`);
    assert.ok(person.actions < MOST[hands], `${person.actions} actions`);
  });
}

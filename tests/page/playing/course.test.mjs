// Course packages with `scorm-again` as the platform.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { after, test } from "node:test";
import { Lab, eventually, meniscus, number, program, temporary, visit } from "../lab.mjs";
import { Platform } from "../course.mjs";

const platforms = [];
after(() => platforms.forEach(({ server }) => server.close()));

async function begin(document, kind) {
  const platform = await Platform.begin(document, kind);
  platforms.push(platform);
  return platform;
}

/** Exit code and result of `meniscus verify`. */
function verified(text) {
  const file = temporary("a.hand-in");
  writeFileSync(file, text);
  try {
    return { code: 0, found: JSON.parse(execFileSync(program, ["verify", file, "--format", "json"], { encoding: "utf8" })) };
  } catch (failure) {
    return { code: failure.status, found: JSON.parse(failure.stdout) };
  }
}

/** Work of a student on the page of a package, in a profile of its own. */
class Visit {
  static async open(platform, options = {}) {
    const lab = await Lab.open({ address: () => platform.address, ...options });
    const visit = new Visit(lab, platform);
    visit.page = lab.page.frameLocator("iframe");
    return visit;
  }

  constructor(lab, platform) {
    [this.lab, this.platform] = [lab, platform];
  }

  async start() {
    await this.page.locator("#course-start").click();
    await eventually(async () => assert.equal(await this.page.locator("#course").count(), 0));
  }

  async tab(id) {
    await this.page.locator(`#tab-${id}`).click();
  }

  async enter(name, text) {
    await this.tab("play");
    const field = this.page.getByRole("textbox", { name, exact: true });
    await field.fill(text);
    await field.press("Enter");
  }

  async value(name) {
    await this.tab("play");
    return number(await this.page.getByRole("textbox", { name, exact: true }).inputValue());
  }

  async answer(question, text) {
    await this.tab("activities");
    const field = this.page.locator(`#answer-${question}`);
    await field.fill(text);
    await field.press("Enter");
    await eventually(async () => assert.notEqual(await this.page.locator(`#verdict-${question}`).innerText(), ""));
  }

  /** Text and grade of the answer to each question. */
  async answers(count) {
    await this.tab("activities");
    const one = async (question) => [
      await this.page.locator(`#answer-${question}`).inputValue(),
      await this.page.locator(`#verdict-${question}`).getAttribute("data-grade"),
    ];
    return Promise.all(Array.from({ length: count }, (_, question) => one(question)));
  }

  /** Hands in: what the file contains. */
  async handIn(name) {
    await this.page.locator("#hand-in").click();
    await this.page.locator("#hand-in-name").fill(name);
    const saved = await this.lab.save(this.page.locator("#save-hand-in"));
    await this.page.locator("#hand-in-dialog .dialog-head button").click();
    return saved;
  }

  refused() {
    return this.lab.page.evaluate(() => refused);
  }

  async close() {
    assert.deepEqual(this.lab.faults, [], "errors in the page");
    await this.lab.context.close();
  }
}

for (const kind of ["scorm12", "scorm2004"]) {
  const score = ({ stored: { cmi } }) => Number((cmi.core ?? cmi).score.raw);
  for (const [way, leave] of [
    ["navigates", (lab) => lab.page.goto("about:blank")],
    ["reloads", (lab) => lab.page.reload()],
  ]) {
    test(`${kind}: who ${way} finds values, answers and score again on another device`, async () => {
      const platform = await begin("tests/page/course.md", kind);
      const first = await Visit.open(platform);
      await first.start();
      const damping = await first.value("Damping");
      assert.ok(damping >= 0.1 && damping <= 0.5, String(damping));
      await first.enter("Stiffness", "7");
      await first.answer(0, String(damping));
      await first.answer(1, "1000 s");
      assert.deepEqual(await first.refused(), []);
      await leave(first.lab);
      await eventually(() => assert.equal(score(platform), 50));
      await first.close();

      const second = await Visit.open(platform, { language: "es-ES" });
      await second.start();
      assert.deepEqual([await second.value("Amortiguamiento"), await second.value("Rigidez")], [damping, 7]);
      assert.deepEqual(await second.answers(2), [[String(damping), "right"], ["1000 s", "wrong"]]);
      assert.deepEqual(await second.refused(), []);
      assert.equal(score(platform), 50);
      await second.close();
    });
  }
}

/** Exports the document of these tests as a page. */
function exported() {
  const file = temporary("course.player.html");
  meniscus("export", "tests/page/course.md", "--output", file);
  return file;
}

visit("what an exported page hands in follows from its data to the bit, and a changed grade is named", { file: exported }, async (lab) => {
  const page = new Visit(lab);
  page.page = lab.page;
  await page.enter("Seat", "7");
  await page.enter("Stiffness", "7");
  await lab.press("Play");
  await lab.watchUntil(0.5);
  await lab.press("Pause");
  await page.answer(0, "Muñoz \u2028 🎉 \"'<&>");
  await page.answer(0, "0.1");
  await page.answer(1, "20 ± 1 s");
  const { name, text } = await page.handIn("blue heron 17");
  assert.equal(name, "course.hand-in");
  const { code, found } = verified(text);
  assert.deepEqual(found.hand_ins[0].differences, []);
  assert.equal(code, 0);
  assert.ok(found.hand_ins[0].equal >= 15, JSON.stringify(found.hand_ins[0]));
  const handed = JSON.parse(text);
  assert.deepEqual(handed.sender, { name: "blue heron 17", seat: 7, assignment: "course-test" });
  handed.facts.find((fact) => fact.quantity === "x").number += 1e-12;
  handed.facts.find((fact) => fact.quantity === "grade of attempt 1").text = "correct";
  const changed = verified(JSON.stringify(handed));
  assert.equal(changed.code, 1);
  assert.deepEqual(changed.found.hand_ins[0].differences.map((one) => one.quantity), ["x", "grade of attempt 1"]);
});

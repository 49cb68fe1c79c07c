// Course packages with `scorm-again` as the platform: state, answers and score stay, however the page is left.

import assert from "node:assert/strict";
import { test } from "node:test";
import { Lab, eventually, meniscus, temporary, visit } from "../lab.mjs";
import { Platform, Visit, verified } from "../course.mjs";

const COURSE = "tests/page/course.md";

for (const kind of ["scorm12", "scorm2004"]) {
  for (const [way, leave] of [
    ["navigates", (lab) => lab.page.goto("about:blank")],
    ["reloads", (lab) => lab.page.reload()],
  ]) {
    test(`${kind}: who ${way} finds values, answers and score again on another device`, async () => {
      const platform = await Platform.begin(COURSE, kind);
      const first = await Visit.open(platform);
      await first.start();
      const damping = await first.value("Damping");
      assert.ok(damping >= 0.1 && damping <= 0.5, String(damping));
      assert.equal(await first.page.locator("#seat").isEditable(), false);
      await first.enter("Stiffness", "7");
      await first.answer(0, String(damping));
      await first.answer(1, "1000 s");
      assert.deepEqual(await first.noted("refused"), []);
      await leave(first.lab);
      await eventually(() => assert.equal(Number(platform.core.score.raw), 50));
      await first.close();

      const second = await Visit.open(platform, { language: "es-ES" });
      await second.start();
      assert.deepEqual([await second.value("Amortiguamiento"), await second.value("Rigidez")], [damping, 7]);
      assert.deepEqual(await second.answers(2), [[String(damping), "right"], ["1000 s", "wrong"]]);
      assert.deepEqual(await second.noted("refused"), []);
      assert.equal(Number(platform.core.score.raw), 50);
      await second.close();
    });
  }

  test(`${kind}: a window that its student closes has handed over everything`, async () => {
    const platform = await Platform.begin(COURSE, kind);
    const lab = await Lab.open({ address: () => `${platform.address}?window` });
    const [window] = await Promise.all([lab.page.waitForEvent("popup"), lab.press("Open")]);
    const first = new Visit(lab, window);
    await first.start();
    await first.enter("Stiffness", "3");
    await first.answer(0, "five");
    await Promise.all([window.waitForEvent("close"), window.evaluate(() => close())]);
    const last = () => first.noted("calls.at(-1)[0]");
    await eventually(async () => assert.equal(await last(), kind === "scorm12" ? "Finish" : "Terminate"));
    assert.deepEqual(await first.noted("refused"), []);
    await first.close();
    const second = await Visit.open(platform);
    await second.start();
    assert.equal(await second.value("Stiffness"), 3);
    assert.deepEqual(await second.answers(1), [["five", "unreadable"]]);
    await second.close();
  });

  test(`${kind}: a tab that is killed loses no graded answer`, async () => {
    const platform = await Platform.begin(COURSE, kind);
    const first = await Visit.open(platform);
    await first.start();
    const damping = await first.value("Damping");
    await first.answer(0, String(damping));
    const session = await first.lab.context.newCDPSession(first.lab.page);
    const crashed = first.lab.page.waitForEvent("crash");
    // There is no answer from a page that is gone.
    session.send("Page.crash").catch(() => {});
    await crashed;
    await first.lab.page.close();
    await first.lab.context.close();
    assert.equal(Number(platform.core.score.raw), 50);
    const second = await Visit.open(platform);
    await second.start();
    assert.deepEqual(await second.answers(1), [[String(damping), "right"]]);
    await second.close();
  });

  test(`${kind}: values are kept every 30 s and when the page is hidden, and a teacher who looks at the work changes nothing`, async () => {
    const platform = await Platform.begin(COURSE, kind);
    const first = await Visit.open(platform);
    await first.lab.context.clock.install();
    await first.lab.page.reload();
    await first.start();
    const kept = () => first.noted("calls.filter(([, name]) => name === 'cmi.suspend_data').length");
    await first.enter("Stiffness", "7");
    assert.equal(await kept(), 0);
    await first.lab.context.clock.fastForward(31_000);
    await eventually(async () => assert.equal(await kept(), 1));
    await first.lab.context.clock.fastForward(31_000);
    await first.enter("Stiffness", "8");
    assert.equal(await kept(), 1, "nothing is sent if nothing has changed");
    await first.page.locator("body").evaluate(() => {
      Object.defineProperty(document, "hidden", { value: true });
      document.dispatchEvent(new Event("visibilitychange"));
    });
    await eventually(async () => assert.equal(await kept(), 2));
    await first.close();

    platform.mode = "review";
    const teacher = await Visit.open(platform);
    await teacher.start();
    await teacher.page.locator("#messages").getByText("nothing that you do here is kept").waitFor();
    assert.equal(await teacher.value("Stiffness"), 8);
    await teacher.answer(0, "17");
    await teacher.page.locator("body").evaluate(() => dispatchEvent(new PageTransitionEvent("pagehide")));
    assert.deepEqual(await teacher.noted("calls.map(([name]) => name)"), ["Initialize", kind === "scorm12" ? "Finish" : "Terminate"]);
    await teacher.close();
  });
}

test("before the button nothing is sent, and who only looks is not seen by the course", async () => {
  const platform = await Platform.begin(COURSE, "scorm12");
  const reader = await Visit.open(platform);
  await reader.page.locator("#course").getByText("your answers with all attempts and their grades").waitFor();
  await reader.page.locator("#course").getByRole("button", { name: "Only look, send nothing" }).last().click();
  await reader.answer(0, "17");
  assert.deepEqual(await reader.noted("calls"), []);
  await reader.close();
});

/** Exports the document of these tests as a page. */
function exported() {
  const file = temporary("course.player.html");
  meniscus("export", COURSE, "--output", file);
  return file;
}

visit("what an exported page hands in follows from its data to the bit, and a changed value is named", { file: exported }, async (lab) => {
  const page = new Visit(lab, lab.page);
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
  handed.facts.find((fact) => fact.quantity === "value:x").number += 1e-12;
  handed.facts.find((fact) => fact.quantity === "grade:1").text = "correct";
  const changed = verified(JSON.stringify(handed));
  assert.equal(changed.code, 1);
  assert.deepEqual(changed.found.hand_ins[0].differences.map((one) => one.quantity), ["value:x", "grade:1"]);
});

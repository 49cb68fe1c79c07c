// Playing: the transport, time, parameters while it runs, presets, the state by hand.

import assert from "node:assert/strict";
import { eventually, sight, visit } from "../lab.mjs";

visit("it plays, pauses, steps and goes back to the start", async (lab) => {
  assert.equal(await lab.time(), 0);
  await lab.press("Play");
  await lab.watchUntil(1);
  await lab.press("Pause");
  const paused = await lab.time();
  await new Promise((done) => setTimeout(done, 300));
  assert.equal(await lab.time(), paused, "it stands still");

  await lab.press("Step forward");
  const ahead = await lab.time();
  assert.ok(ahead > paused && ahead <= paused + 0.1, `${paused}, a step, ${ahead}`);
  await lab.press("Step back");
  await lab.press("Step back");
  assert.ok((await lab.time()) < ahead);
  await lab.press("Back to start");
  assert.equal(await lab.time(), 0);
  assert.equal(await lab.number("Displacement"), 0.5);
});

visit("one second takes about one second", async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(0.5);
  const [start, shown] = [Date.now(), await lab.time()];
  await new Promise((done) => setTimeout(done, 2000));
  const [passed, shownLater] = [(Date.now() - start) / 1000, await lab.time()];
  // Generous: machines that test are busy. A clock that counts frames is off by far more.
  assert.ok(Math.abs(shownLater - shown - passed) < 0.5, `${passed} s passed, ${shownLater - shown} s were shown`);
});

visit("speeds go from an eighth to eight times", async (lab) => {
  const speed = lab.page.getByLabel("Speed");
  const offered = await speed.locator("option").allInnerTexts();
  assert.deepEqual(offered, ["1/8 ×", "1/4 ×", "1/2 ×", "1 ×", "2 ×", "4 ×", "8 ×"]);
  await speed.selectOption("8 ×");
  await lab.press("Play");
  await lab.watchUntil(10);
});

visit("the recorded run is scrubbed and continued from there", async (lab) => {
  await lab.page.getByLabel("Speed").selectOption("8 ×");
  await lab.press("Play");
  await lab.watchUntil(8);
  await lab.press("Pause");
  const end = await lab.time();
  const line = lab.slider("Time line");
  await line.focus();
  await lab.keys("Home");
  await eventually(async () => assert.equal(await lab.time(), 0));
  assert.equal(await lab.number("Displacement"), 0.5);
  // The line ends later than what is recorded.
  const box = await line.boundingBox();
  const recorded = await lab.page.locator("#transport .recorded").boundingBox();
  await lab.page.mouse.click(recorded.x + recorded.width / 2, box.y + box.height / 2);
  await eventually(async () => assert.ok(Math.abs((await lab.time()) - end / 2) < end / 10, `half of ${end}`));
  const from = await lab.time();
  await lab.press("Play");
  await eventually(async () => assert.ok((await lab.time()) > from));
});

visit("the time line shows how far the run has come", async (lab) => {
  const line = lab.slider("Time line");
  const part = () => line.evaluate((line) => Number(line.value) / Number(line.max));
  await lab.press("Play");
  await lab.watchUntil(1);
  const first = await part();
  await lab.watchUntil(3);
  const [later, time] = [await part(), await lab.time()];
  assert.ok(first < later && later < 0.6, `${first}, then ${later} at ${time} s`);
  await lab.press("Pause");
  // Beyond what is recorded there is nothing to go to.
  const box = await line.boundingBox();
  const end = await lab.time();
  await lab.page.mouse.click(box.x + box.width * 0.95, box.y + box.height / 2);
  assert.equal(await lab.time(), end);
  assert.ok(Math.abs((await part()) - end / 10) < 0.01, "the thumb goes back to the end of the run");
});

visit("the values are those of the curves in the same frame", async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(0.3);
  // The clock is drawn with the curves. The value that stands beside it must be that of its time.
  const seen = await lab.page.evaluate(async () => {
    const row = [...document.querySelectorAll("#readouts dl > div")].find((row) => row.textContent.startsWith("Displacement"));
    const seen = [];
    for (let frames = 0; frames < 30; frames += 1) {
      await new Promise((drawn) => requestAnimationFrame(() => setTimeout(drawn)));
      seen.push([document.querySelector("#clock").textContent, row.querySelector("dd").textContent]);
    }
    return seen;
  });
  const clocks = new Set(seen.map(([clock]) => clock));
  const values = new Set(seen.map(([, value]) => value));
  // The clock shows hundredths of a second; no value is held while it goes on.
  assert.ok(values.size >= 0.8 * clocks.size, `${values.size} values at ${clocks.size} times`);
});

visit("damping acts at once and without a jump", async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(1);
  await lab.press("Pause");
  const [time, displacement] = [await lab.time(), await lab.number("Displacement")];
  await lab.enter("Damping", "900");
  assert.equal(await lab.time(), time);
  assert.equal(await lab.number("Displacement"), displacement);
  assert.match(await lab.value("Regime"), /underdamped/);
  await lab.enter("Damping", "5000");
  assert.match(await lab.value("Regime"), /overdamped/);
  const period = lab.page.locator(".readouts dl > div").filter({ has: lab.page.getByText("Period", { exact: true }) });
  assert.equal(await period.isVisible(), false, "a question asks for it");
  await lab.page.getByLabel("Show the values that questions ask for").check();
  assert.match(await lab.value("Period"), /^–/, "there is none");
});

visit("a level restarts the run", async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(1);
  await lab.press("Pause");
  await lab.enter("Height of the left column", "5");
  assert.equal(await lab.time(), 0);
  assert.equal(await lab.number("Displacement"), 1.5);
  await lab.press("Restore defaults");
  assert.equal(await lab.number("Height of the left column"), 3);
});

visit("what cannot be is refused in words, and corrected", async (lab) => {
  await lab.enter("Damping", "-500");
  assert.equal(await lab.field("Damping").getAttribute("aria-invalid"), "true");
  const refusal = lab.page.locator("#" + (await lab.field("Damping").getAttribute("aria-describedby")));
  assert.match(await refusal.innerText(), /0/);
  await lab.enter("Damping", "abc");
  assert.equal(await lab.field("Damping").getAttribute("aria-invalid"), "true");
  await lab.enter("Damping", "60");
  assert.equal(await lab.field("Damping").getAttribute("aria-invalid"), null);
});

visit("presets set what they name", async (lab) => {
  await lab.preset("Mercury");
  assert.ok((await lab.number("Density of the liquid")) > 13000);
  const liquid = lab.page.getByRole("group", { name: "Liquid", exact: true });
  assert.deepEqual(await liquid.locator("[aria-pressed=true]").allInnerTexts(), ["Mercury"]);
  await lab.preset("Moon");
  assert.ok((await lab.number("Gravitational acceleration")) < 2);
});

visit("the state is edited while it stands still, and is the start until the defaults are restored", async (lab) => {
  await lab.enter("Displacement", "-0.8");
  await lab.enter("Velocity", "1");
  assert.equal(await lab.number("Displacement"), -0.8);
  await lab.press("Play");
  // While the run plays, values and fields follow it ten times in a second.
  await eventually(async () => assert.equal(await lab.field("Displacement").isEditable(), false));
  await lab.watchUntil(0.3);
  await lab.press("Back to start");
  assert.deepEqual([await lab.number("Displacement"), await lab.number("Velocity")], [-0.8, 1]);
  await lab.page.getByText("The run starts from a state that was set by hand").waitFor();
  await lab.press("Restore defaults");
  assert.deepEqual([await lab.number("Displacement"), await lab.number("Velocity")], [0.5, 0]);
});

visit("the liquid is dragged and let go", async (lab) => {
  const handle = lab.page.locator("#scene [role=slider]").first();
  const box = await handle.boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await lab.page.mouse.move(x, y);
  await lab.page.mouse.down();
  await lab.page.mouse.move(x, y - 20, { steps: 5 });
  await lab.page.mouse.up();
  const lifted = await lab.number("Displacement");
  assert.ok(lifted > 0.6, `the left column was lifted to ${lifted} m`);
  // At the start the heights follow, one as much as the other, and the run can be taken back there.
  const heights = async () => [await lab.number("Height of the left column"), await lab.number("Height of the right column")];
  const [left, right] = await heights();
  assert.ok(Math.abs(left - right - 2 * lifted) < 2e-3 && Math.abs(left + right - 5) < 1e-4, `${left} m and ${right} m`);
  await lab.press("Play");
  await lab.watchUntil(0.5);
  await lab.press("Back to start");
  assert.equal(await lab.number("Displacement"), lifted);
  assert.deepEqual(await heights(), [left, right]);
  await lab.press("Restore defaults");
  assert.deepEqual([await lab.number("Displacement"), ...(await heights())], [0.5, 3, 2]);
});

visit("a run is kept and the next one drawn over it", async (lab) => {
  await lab.press("Step forward");
  await lab.press("Keep run");
  const kept = lab.page.getByRole("list", { name: "Kept runs" }).getByRole("listitem");
  assert.equal(await kept.count(), 1);
  await kept.getByRole("checkbox").uncheck();
  await kept.getByRole("button").click();
  assert.equal(await lab.page.getByRole("list", { name: "Kept runs" }).count(), 0);
});

visit("a question is answered", async (lab) => {
  const tabs = await lab.page.getByRole("tab").allInnerTexts();
  let questions;
  for (const name of tabs) {
    await lab.tab(name);
    questions = lab.page.locator("section.question:visible");
    if ((await questions.count()) > 0) break;
  }
  assert.ok((await questions.count()) >= 7, "at least seven");
  const question = questions.first();
  const verdict = question.locator(".verdict");
  await question.getByRole("textbox").fill("123456789");
  await question.getByRole("button", { name: "Check" }).click();
  assert.equal(await verdict.getAttribute("data-grade"), "wrong");
  await question.getByRole("button", { name: "Show the answer" }).click();
  const answer = await sight(question.locator(".revealed strong"));
  await question.getByRole("textbox").fill(answer.split(/\s/)[0]);
  await question.getByRole("button", { name: "Check" }).click();
  assert.equal(await verdict.getAttribute("data-grade"), "right");
});

// Points on a film: corners of a rectangle, both arms, points by hand, several bodies, the radius of one, fixed marks; moved and
// removed one by one, by pointer, keys and finger.

import assert from "node:assert/strict";
import { eventually, number, visit } from "../lab.mjs";
import { RULER, SURFACE, clickFilmed, filmSimulation, goTo, onScreen, tracked, unfoldStep } from "../films.mjs";
import { openTheory } from "../measured.mjs";

/** The level of the filmed U-tube above rest in metres, at a frame. */
function level(frame) {
  const [gamma, time] = [50 / 700, 0.002 + frame / 30];
  const omega = Math.sqrt(2.8 - gamma ** 2);
  return 0.5 * Math.exp(-gamma * time) * (Math.cos(omega * time) + (gamma / omega) * Math.sin(omega * time));
}

/** The numbers of a frame, by their names. */
async function values(lab, frame) {
  await goTo(lab.page, frame);
  const text = await lab.page.locator("#film-values").innerText();
  return Object.fromEntries([...text.matchAll(/(\S+) = (\S+) ± \S+ (px|m)/g)].map(([, name, value]) => [name, number(value)]));
}

const scale = (lab) => lab.page.locator("#film-scale").innerText();

visit("a rectangle: corners in any order, moved and removed one by one", async (lab) => {
  await filmSimulation(lab, { seconds: "3" });
  await clickFilmed(lab, SURFACE);
  await tracked(lab);
  await unfoldStep(lab, "lengths");
  await lab.page.locator("#film-corners").click();
  // A pixel of the picture is 1/38.96 m: the sides are those of a rectangle in the plane of the tube.
  const corners = [[170, 49], [170, 280.8], [555.5, 280.8], [555.5, 49]];
  for (const corner of corners) await clickFilmed(lab, corner);
  await lab.page.locator("#film-width").fill("9.896 m");
  await lab.page.locator("#film-height").fill("5.95 m");
  await lab.page.locator("#film-height").press("Enter");
  await eventually(async () => assert.match(await scale(lab), /%/));
  const fall = async () => (await values(lab, 0)).y - (await values(lab, 56)).y;
  const expected = level(0) - level(56);
  const found = await fall();
  assert.ok(Math.abs(found / expected - 1) < 0.015, `${found} m, not ${expected} m`);
  // The first is the one at the bottom left. Moved down, it makes the rectangle larger in the picture, and lengths smaller.
  const [, left, low] = (await lab.page.locator("#film-corner-0").getAttribute("aria-label")).match(/x ([\d.]+), y ([\d.]+)/).map(Number);
  assert.ok(Math.abs(left - 170) < 2 && Math.abs(low - 281) < 2, `${left}, ${low}`);
  await lab.page.locator("#film-corner-0").focus();
  await lab.keys("Shift+ArrowDown", "Shift+ArrowDown", "Enter");
  await eventually(async () => assert.ok((await fall()) < 0.99 * found));
  await eventually(async () => assert.equal((await lab.focused()).id, "film-corner-0"));
  await lab.keys("Delete");
  await eventually(async () => assert.equal(await scale(lab), ""));
  assert.equal(await lab.page.locator("[id^=film-corner-]").count(), 3);
  await lab.page.locator("#film-corners").click();
  await clickFilmed(lab, corners[1]);
  await eventually(async () => assert.match(await scale(lab), /%/));
  assert.ok(Math.abs((await fall()) / expected - 1) < 0.015);
});

visit("both arms: what one loses, the other gains", async (lab) => {
  await filmSimulation(lab, { seconds: "3" });
  await lab.page.locator("#film-kind-arms").click();
  await clickFilmed(lab, SURFACE);
  await clickFilmed(lab, [354, 205]);
  await tracked(lab);
  const sums = [];
  for (const frame of [0, 20, 40, 56, 80]) {
    const { y_1, y_2 } = await values(lab, frame);
    sums.push(y_1 + y_2);
  }
  assert.ok(Math.max(...sums) - Math.min(...sums) < 0.8, sums.join(", "));
});

visit("points by hand, one in each frame, and one of them is removed", async (lab) => {
  await filmSimulation(lab, { seconds: "2" });
  await lab.page.locator("#film-kind-hand").click();
  for (let frame = 0; frame < 5; frame += 1) {
    await eventually(async () => assert.equal(await lab.page.locator("#film-frame").getAttribute("data-frame"), String(frame)));
    await clickFilmed(lab, [253, 158 + frame]);
  }
  await lab.page.locator("#film-leave").click();
  const read = await values(lab, 2);
  assert.ok(Math.abs(read.x - 253) < 1 && Math.abs(read.y - 200) < 1, JSON.stringify(read));
  // A point that is only pointed at stays where it is and can be removed.
  await clickFilmed(lab, [253, 160]);
  await eventually(async () => assert.equal(await lab.page.locator("#film-remove").count(), 1));
  assert.deepEqual(await values(lab, 2), read);
  await lab.page.locator("#film-remove").click();
  await eventually(async () => assert.equal(await lab.page.locator("#film-values").innerText(), ""));
  assert.notDeepEqual(await values(lab, 3), {});
});

visit("two bodies", async (lab) => {
  await openTheory(lab, "Coupled oscillators");
  // A body shows what it is by its motion: both move from the start.
  await lab.press("In phase");
  await filmSimulation(lab, { seconds: "3" });
  await lab.page.locator("#film-kind-body").click();
  await clickFilmed(lab, [230, 207]);
  await tracked(lab);
  await lab.page.getByRole("button", { name: "Another body", exact: true }).click();
  await clickFilmed(lab, [398, 207]);
  await eventually(async () => assert.match(await lab.page.locator("#film-values").innerText(), /x_2 =/), 60);
  await lab.page.locator("#compare-truth").click();
  const text = await lab.page.locator("#film-truth").innerText();
  const rms = [...text.matchAll(/true values (\d): RMS ([\d.]+) px/g)].map(([, , value]) => Number(value));
  assert.ok(rms.length === 2 && Math.max(...rms) < 0.3, text);
});

visit("the radius of a body is found from the click, typed, refused, and found again", async (lab) => {
  await openTheory(lab, "Coupled oscillators");
  await filmSimulation(lab, { seconds: "2" });
  await lab.page.locator("#film-kind-body").click();
  assert.equal(await lab.page.locator("#film-radius").count(), 0);
  await clickFilmed(lab, [236, 207]);
  await tracked(lab);
  const field = lab.page.getByRole("textbox", { name: "Radius", exact: true });
  const find = lab.page.getByRole("button", { name: "Find from the click", exact: true });
  const said = () => lab.page.locator("#film-radius-said").innerText();
  /** The field shows this radius, and so does the circle in the picture. */
  const shows = (radius) => eventually(async () => {
    assert.equal(number(await field.inputValue()), radius);
    const circle = await lab.page.locator(".film-lines .body-outline").evaluate((path) => path.getBBox().width / 2);
    assert.ok(Math.abs(circle - radius) < 0.1, `${circle} px, not ${radius} px`);
  });
  await eventually(async () => assert.match(await said(), /found from the click/));
  const found = number(await field.inputValue());
  assert.ok(found >= 3 && found <= 40, `${found} px`);
  await shows(found);
  assert.equal(await find.isVisible(), false);

  const typed = found + 5;
  await field.fill(String(typed));
  await field.press("Enter");
  await shows(typed);
  await eventually(async () => assert.doesNotMatch(await said(), /found/));
  // The ruler is asked for next: 200 pixels are 2 m.
  for (const mark of [[100, 300], [300, 300]]) await clickFilmed(lab, mark);
  await lab.page.locator("#film-length").fill("2 m");
  await lab.page.locator("#film-length").press("Enter");
  await eventually(async () => {
    const [, metres] = (await said()).match(/= ([\d.]+) m/);
    assert.ok(Math.abs(number(metres) / (0.01 * typed) - 1) < 0.02, metres);
  });

  const outside = /from 3 to 100 px/;
  for (const [refused, why] of [["1", outside], ["1000", outside], ["large", /“large” is not a number. Write one such as 2.5 px/]]) {
    await field.fill(refused);
    await field.press("Enter");
    await eventually(async () => assert.match(await lab.page.locator("#film-radius-refused").innerText(), why));
    const circle = await lab.page.locator(".film-lines .body-outline").evaluate((path) => path.getBBox().width / 2);
    assert.ok(Math.abs(circle - typed) < 0.1, `${refused}: ${circle} px`);
  }
  await field.fill("");
  await field.press("Enter");
  await shows(found);
  assert.equal(await lab.page.locator("#film-radius-refused").innerText(), "");
  assert.equal((await lab.focused()).id, "film-radius");

  await field.fill(String(typed));
  await field.press("Enter");
  await shows(typed);
  await find.click();
  await shows(found);
  assert.equal((await lab.focused()).id, "film-radius");
});

visit("fixed marks are placed, and removed one by one", async (lab) => {
  await filmSimulation(lab, { seconds: "2" });
  await unfoldStep(lab, "follow");
  await lab.page.locator("#film-still").click();
  for (const mark of RULER) await clickFilmed(lab, mark);
  await lab.page.locator("#film-leave").click();
  assert.equal(await lab.page.locator("[id^=film-still-]").count(), 2);
  await lab.page.locator("#film-click").click();
  await clickFilmed(lab, SURFACE);
  await tracked(lab);
  await lab.page.locator("#compare-truth").click();
  assert.ok(number((await lab.page.locator("#film-truth").innerText()).match(/RMS ([\d.]+) px/)[1]) < 0.2);
  await lab.page.locator("#film-leave").click();
  await clickFilmed(lab, RULER[1]);
  await lab.page.locator("#film-remove").click();
  await eventually(async () => assert.equal(await lab.page.locator("[id^=film-still-]").count(), 1));
  await lab.page.locator("#film-still-0").focus();
  await lab.keys("Delete");
  await eventually(async () => assert.equal(await lab.page.locator("[id^=film-still-]").count(), 0));
});

visit("the loupe shows what the finger hides", { width: 390, height: 844, touch: true }, async (lab) => {
  await filmSimulation(lab, { seconds: "1" });
  const session = await lab.context.newCDPSession(lab.page);
  const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  const loupe = lab.page.locator("#film-loupe");
  assert.equal(await loupe.isVisible(), false);
  const [x, y] = await onScreen(lab, SURFACE);
  await touch("touchStart", [[x, y + 20]]);
  await touch("touchMove", [[x, y + 8]]);
  await eventually(async () => assert.equal(await loupe.isVisible(), true));
  const box = await loupe.boundingBox();
  assert.ok(box.y + box.height < y + 8 || box.y > y + 8, "beside the finger");
  await touch("touchMove", [[x, y]]);
  await touch("touchEnd", []);
  await tracked(lab);
  assert.equal(await loupe.isVisible(), false);
  const clicked = await lab.page.locator("#film-surface-0").getAttribute("aria-label");
  const [, across, down] = clicked.match(/x ([\d.]+), y ([\d.]+)/).map(Number);
  assert.ok(Math.abs(across - SURFACE[0]) < 2 && Math.abs(down - SURFACE[1]) < 2, clicked);
});

visit("numbers of a film are read with their units, or refused at their fields", async (lab) => {
  await filmSimulation(lab, { seconds: "2" });
  await lab.page.locator("#film-acts details").evaluateAll((folds) => folds.forEach((fold) => (fold.open = true)));
  const from = lab.page.locator("#film-from");
  const enter = async (field, text) => {
    await field.fill(text);
    await field.press("Enter");
  };
  await enter(from, "500 ms");
  await eventually(async () => assert.equal(await from.inputValue(), "0.500"));
  for (const [typed, why] of [["abc", /“abc” is not a number/], ["3 kg", /kg measures something else/], ["9 s", /two frames/]]) {
    await enter(from, typed);
    await eventually(async () => assert.match(await lab.page.locator("#film-from-error").innerText(), why));
    assert.equal(await from.getAttribute("aria-invalid"), "true");
  }
  await enter(from, "1/4");
  await eventually(async () => assert.equal(await from.inputValue(), "0.250"));
  assert.equal(await lab.page.locator("#film-from-error").innerText(), "");

  const intervals = lab.page.locator("#film-intervals");
  await enter(intervals, "ten");
  await eventually(async () => assert.match(await lab.page.locator("#film-intervals-error").innerText(), /whole number from 1 to 1000/));
  await enter(intervals, "10.0");
  await eventually(async () => assert.equal(await lab.page.locator("#film-intervals-error").innerText(), ""));
});

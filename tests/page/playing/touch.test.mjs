// Dragging in the scene with a finger and with a pen, as the browser hands them on: real touches, not events made by hand.

import assert from "node:assert/strict";
import { eventually, visit } from "../lab.mjs";
import { openTheory } from "../measured.mjs";

const PHONE = { width: 390, height: 844, touch: true };

/** A finger on the page. */
class Finger {
  constructor(lab) {
    this.lab = lab;
  }

  async begin(x, y) {
    this.session ??= await this.lab.context.newCDPSession(this.lab.page);
    [this.x, this.y] = [x, y];
    await this.send("touchStart", [{ x, y }]);
  }

  /** Moves on by so many pixels, in steps as a hand makes them. */
  async move(right, down, steps = 8) {
    for (let step = 1; step <= steps; step += 1) {
      await this.send("touchMove", [{ x: this.x + (right * step) / steps, y: this.y + (down * step) / steps }]);
    }
    [this.x, this.y] = [this.x + right, this.y + down];
  }

  async end() {
    await this.send("touchEnd", []);
  }

  async send(type, touchPoints) {
    await this.session.send("Input.dispatchTouchEvent", { type, touchPoints });
  }
}

/** Notes from now on which pointer events reach the page. */
async function watch(lab) {
  await lab.page.evaluate(() => {
    window.seen = [];
    for (const kind of ["pointerdown", "pointermove", "pointerup", "pointercancel"]) {
      addEventListener(kind, (event) => window.seen.push(`${event.pointerType} ${kind}`), true);
    }
  });
}

const seen = (lab, what) => lab.page.evaluate((what) => window.seen.filter((kind) => kind === what).length, what);
const scrolled = (lab) => lab.page.evaluate(() => Math.round(window.scrollY));
const handles = (lab) => lab.page.locator("#scene [role=slider]");

/** The middle of a handle, and CSS pixels for a unit of the drawing. */
async function grip(lab, handle) {
  // A scene that has just been opened stands in its place once it has been drawn.
  await lab.time();
  await handle.evaluate((node) => node.scrollIntoView({ block: "center", behavior: "instant" }));
  return handle.evaluate((node) => {
    const box = node.getBoundingClientRect();
    return { x: box.x + box.width / 2, y: box.y + box.height / 2, width: box.width, height: box.height, unit: node.ownerSVGElement.getScreenCTM().d };
  });
}

visit("a finger drags the liquid, and the page stays where it is", PHONE, async (lab) => {
  await watch(lab);
  const at = await grip(lab, handles(lab).first());
  const page = await scrolled(lab);
  const finger = new Finger(lab);
  await finger.begin(at.x, at.y);
  await finger.move(0, -30);
  await finger.move(0, 6);
  assert.equal(await seen(lab, "touch pointercancel"), 0);
  assert.ok((await seen(lab, "touch pointermove")) >= 10);
  await finger.end();
  assert.equal(await scrolled(lab), page);
  // 53 units of the drawing are a metre.
  const expected = 0.5 + 24 / at.unit / 53;
  assert.ok(Math.abs((await lab.number("Displacement")) - expected) < 2e-3, `${await lab.number("Displacement")} m for ${expected} m`);
});

visit("a finger beside the handles scrolls the page", PHONE, async (lab) => {
  await watch(lab);
  const at = await grip(lab, handles(lab).first());
  const page = await scrolled(lab);
  const finger = new Finger(lab);
  // On the drawing, but on none of its parts: left of the left column, where the ruler stands.
  await finger.begin(at.x - at.width / 2 - 30, at.y);
  await finger.move(0, -200, 16);
  await finger.end();
  await eventually(async () => assert.ok((await scrolled(lab)) > page + 100, `scrolled by ${(await scrolled(lab)) - page} px`));
  assert.equal(await lab.number("Displacement"), 0.5);
});

visit("a pen drags the liquid", { width: 1024, height: 768 }, async (lab) => {
  await watch(lab);
  const at = await grip(lab, handles(lab).first());
  const session = await lab.context.newCDPSession(lab.page);
  const pen = (type, y, buttons) =>
    session.send("Input.dispatchMouseEvent", { type, x: at.x, y, button: type === "mouseMoved" && !buttons ? "none" : "left", buttons, clickCount: 1, pointerType: "pen" });
  await pen("mouseMoved", at.y, 0);
  await pen("mousePressed", at.y, 1);
  for (let down = 4; down <= 40; down += 4) await pen("mouseMoved", at.y + down, 1);
  await pen("mouseReleased", at.y + 40, 0);
  assert.ok((await seen(lab, "pen pointermove")) >= 10);
  assert.equal(await seen(lab, "pen pointercancel"), 0);
  const expected = 0.5 - 40 / at.unit / 53;
  assert.ok(Math.abs((await lab.number("Displacement")) - expected) < 2e-3, `${await lab.number("Displacement")} m for ${expected} m`);
});

for (const [title, name] of [
  ["The pendulum, small swings and large", "Angle"],
  ["The double pendulum", "Upper angle"],
  ["A bouncing ball", "Height of the ball"],
  ["Van der Pol's oscillator", "Voltage"],
  ["Linear damping", "Displacement"],
]) {
  visit(`a finger that misses a handle by a little drags it all the same: ${title}`, PHONE, async (lab) => {
    await openTheory(lab, title);
    // Its fields of the state are built when they are unfolded.
    await lab.page.locator("#more").evaluate((more) => (more.open = true));
    await watch(lab);
    const state = () => lab.page.locator("#state-0").inputValue();
    const at = await grip(lab, handles(lab).first());
    const page = await scrolled(lab);
    const before = await state();
    const finger = new Finger(lab);
    // In the square of 44 px around the middle of what is smaller, else inside.
    await finger.begin(at.x + (at.width < 44 ? 20 : 0), at.y);
    await finger.move(-15, 15);
    await finger.move(-15, 15);
    assert.equal(await seen(lab, "touch pointercancel"), 0);
    await finger.end();
    assert.equal(await scrolled(lab), page);
    assert.notEqual(await state(), before, `${name}: ${before}`);
  });
}

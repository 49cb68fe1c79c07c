// Lengths in a plane that the camera sees at an angle: the four corners of a rectangle in it give them.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { beside, eventually, number, visit } from "../lab.mjs";
import { dropFilm, goTo, unfoldStep } from "../films.mjs";
import { openTheory } from "../measured.mjs";

const truth = JSON.parse(readFileSync(beside("films/plane.json"), "utf8"));
const frames = truth.frames.map(([t, u, v, x, y]) => ({ t, place: [u, v], seen: [x, y] }));
const distance = ([a, b], [c, d]) => Math.hypot(a - c, b - d);
/** Pairs of frames between which the ball goes far, in all directions and at all distances from the camera. */
const PAIRS = [[0, 44], [0, 12], [12, 35], [20, 44], [10, 30]];

async function click(lab, [x, y]) {
  const box = await lab.page.locator("#film-picture").boundingBox();
  await lab.page.mouse.click(box.x + (x / truth.size[0]) * box.width, box.y + (y / truth.size[1]) * box.height);
}

const scale = (lab) => lab.page.locator("#film-scale").innerText();

/** Where the record has the ball in a frame, in metres. */
async function place(lab, frame) {
  await goTo(lab.page, frame);
  let found;
  await eventually(async () => {
    const text = await lab.page.locator("#film-values").innerText();
    found = ["x", "y"].map((name) => number(text.match(new RegExp(`${name} = (\\S+) ±[^m]* m`))[1]));
  });
  return found;
}

visit("a rectangle that is seen at an angle gives lengths within the stated error", async (lab) => {
  await openTheory(lab, "A projectile with drag");
  await dropFilm(lab.page, beside("films/plane.mp4"));
  await lab.page.locator("#film-kind-body").click();
  await click(lab, frames[0].seen);
  await lab.page.locator("#film-record").waitFor({ timeout: 60_000 });
  await unfoldStep(lab, "lengths");
  await lab.page.locator("#film-corners").click();
  // In any order: the page names them.
  for (const corner of [2, 0, 3, 1]) await click(lab, truth.corners[corner]);
  const [width, height] = truth.sides;
  await lab.page.locator("#film-width").fill(`${100 * width} cm`);
  await lab.page.locator("#film-height").fill(`${100 * height} cm`);
  await lab.page.locator("#film-height").press("Enter");
  await eventually(async () => assert.match(await scale(lab), /%/));
  const stated = number((await scale(lab)).match(/([\d.]+) ?%/)[1]) / 100;
  assert.ok(stated > 1e-3 && stated < 0.02, `${stated}`);
  // One scale for the whole picture, that of the lower side, would not do.
  const wrong = PAIRS.map(([one, other]) => {
    const scale = width / distance(truth.corners[0], truth.corners[1]);
    return (scale * distance(frames[one].seen, frames[other].seen)) / distance(frames[one].place, frames[other].place) - 1;
  });
  assert.ok(Math.max(...wrong.map(Math.abs)) > 0.08, `${wrong}`);
  for (const [one, other] of PAIRS) {
    const found = distance(await place(lab, one), await place(lab, other));
    const drawn = distance(frames[one].place, frames[other].place);
    assert.ok(Math.abs(found / drawn - 1) < 2 * stated, `${one} to ${other}: ${found} m, not ${drawn} m; stated ${stated}`);
  }
  // Axes and not only lengths: to the right along the lower side, upwards along the left one.
  const [start, end] = [await place(lab, 0), await place(lab, 44)];
  [0, 1].forEach((axis) => assert.ok(Math.abs(end[axis] - start[axis] - (frames[44].place[axis] - frames[0].place[axis])) < 0.004, `${start} ${end}`));
});

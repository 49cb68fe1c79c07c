// Films in the page, as tests handle them: dropped, gone through, and read from the canvas.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import { beside, eventually } from "./lab.mjs";

/** A swing in a U-tube, drawn by a formula, and where its surfaces are. */
export const swing = beside("films/utube.mp4");
/** The same in VP9, which every browser decodes by itself; H.264 needs libraries that not every machine has. */
export const freeSwing = beside("films/utube.webm");
export const truth = JSON.parse(readFileSync(beside("films/utube.json"), "utf8"));
/** Some of its frames, in no order. */
export const SOME = [119, 0, 60, 59, 58, 57, 40, 90, 91, 5, 118, 3, 2, 1, 100, 33];

/** Lets a film fall on the page, or on the frame `place` in it. */
export async function dropFilm(page, path, place = page, bytes = readFileSync(path)) {
  const before = await place.evaluate(() => document.querySelector("#film-name")?.textContent);
  await place.evaluate(({ name, text }) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([Uint8Array.from(atob(text), (character) => character.charCodeAt(0))], name));
    document.querySelector("#apparatus").dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, { name: basename(path), text: Buffer.from(bytes).toString("base64") });
  if (arguments.length > 3) return before;
  await eventually(async () => {
    const now = await place.evaluate(() => [document.querySelector("#film-name")?.textContent, document.querySelector("#film-frame")?.dataset.frame]);
    assert.equal(now[0], basename(path));
    assert.ok(now[1]);
  });
  return before;
}

/** Goes to a frame and waits until it is painted. */
export async function goTo(place, frame) {
  await place.evaluate(async (frame) => {
    const line = document.querySelector("#film-line");
    line.value = frame;
    line.dispatchEvent(new Event("input", { bubbles: true }));
    const end = performance.now() + 10_000;
    while (document.querySelector("#film-frame").dataset.frame !== String(frame)) {
      if (performance.now() > end) throw new Error(`frame ${frame} is not painted`);
      await new Promise((done) => setTimeout(done, 5));
    }
  }, frame);
}

/** Grey values of these frames, or of all, with the time that the page says. */
export async function pictures(place, frames) {
  const count = await place.evaluate(() => Number(document.querySelector("#film-line").max) + 1);
  const seen = [];
  for (const frame of frames ?? [...Array(count).keys()]) {
    await goTo(place, frame);
    seen.push(await place.evaluate(() => {
      const canvas = document.querySelector("#film-picture");
      const copy = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
      const context = copy.getContext("2d");
      context.drawImage(canvas, 0, 0);
      const { data } = context.getImageData(0, 0, copy.width, copy.height);
      const grey = [];
      for (let place = 0; place < data.length; place += 4) grey.push(data[place] + data[place + 1] + data[place + 2]);
      return { grey, width: copy.width, time: parseFloat(document.querySelector("#film-clock").textContent) };
    }));
  }
  return seen;
}

/** The row of the surface in a tube at `x`: where it is darkest below what is brightest, nearest to `row`. */
export function surface({ grey, width }, x, row) {
  const at = (y) => [-4, -2, 0, 2, 4].reduce((sum, aside) => sum + grey[y * width + Math.round(x) + aside], 0);
  const height = grey.length / width;
  let [best, steepest] = [0, -Infinity];
  for (let y = 3; y < height - 4; y += 1) {
    const fall = at(y - 2) + at(y - 1) - at(y + 1) - at(y + 2);
    if (fall > steepest) [best, steepest] = [y + 0.5, fall];
  }
  return best - row;
}

/** The mean difference of two pictures of the same size. */
export const difference = (one, other) => one.grey.reduce((sum, value, place) => sum + Math.abs(value - other.grey[place]), 0) / one.grey.length;

/** In each of these frames of the swing, the surface is where it was drawn. */
export async function isRight(page, place = page, frames = SOME, film = swing) {
  await dropFilm(page, film, place);
  const seen = await pictures(place, frames);
  seen.forEach((picture, number) => {
    const [time, row] = truth.frames[frames[number]];
    const error = surface(picture, truth.arms[0], row);
    assert.ok(Math.abs(error) < 2.5, `frame ${frames[number] + 1}: the surface is ${error} px off`);
    assert.ok(Math.abs(picture.time - time) < 6e-4, `frame ${frames[number] + 1}: ${picture.time} s, not ${time} s`);
  });
}

/** The picture of a filmed simulation, and in that of the U-tube the surface in the left arm at the start and the ends of the ruler, which are 5 m apart. */
const SIZE = [640, 360];
export const SURFACE = [251, 165];
export const RULER = [[566, 310], [566, 115]];

/** Films the open simulation; `change` gives fields of the form other values. */
export async function filmSimulation(lab, change = {}) {
  await lab.page.locator("#tab-measure").click();
  await lab.page.locator("#film-simulation").click();
  for (const [field, value] of Object.entries(change)) await lab.page.locator(`#filming-${field}`).fill(value);
  await lab.page.locator("#start-filming").click();
  await lab.page.locator("#film-frame").waitFor({ timeout: 120_000 });
  await eventually(async () => assert.ok(await lab.page.locator("#film-frame").getAttribute("data-frame")));
}

/** Where a pixel of a film of this size is on the screen; without a size, of a filmed simulation. */
export async function onScreen(lab, [x, y], size = SIZE) {
  const box = await lab.page.locator("#film-picture").boundingBox();
  return [box.x + (x / size[0]) * box.width, box.y + (y / size[1]) * box.height];
}

export const clickFilmed = async (lab, at, size = SIZE) => lab.page.mouse.click(...(await onScreen(lab, at, size)));
/** Unfolds a step from film to record with all that is folded in it: `film`, `follow`, `lengths`, `record`. */
export const unfoldStep = (lab, step) =>
  lab.page.locator(`#film-act-${step} details`).evaluateAll((folds) => folds.forEach((fold) => (fold.open = true)));
export const tracked = (lab) => lab.page.locator("#film-record").waitFor({ timeout: 60_000 });

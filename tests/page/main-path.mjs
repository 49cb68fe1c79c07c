// The main path through the page in WebKit, whose drawing, film decoder and workers iPads and Macs have: open it from a file, look at the
// liquid and at clips, play, read a record, fit, film, hand in. `cargo xtask test` runs this; WEBKIT names WebKitWebDriver.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { CELLS, clips } from "./clips.mjs";
import { freeSwing, truth } from "./films.mjs";
import { eventually, labPage, meniscus, number, temporary } from "./lab.mjs";
import { DAMPING, LENGTH, film } from "./measured.mjs";
import { WebKit } from "./webkit.mjs";

let webkit;
before(async () => {
  webkit = await WebKit.open(1280, 900);
});
after(() => webkit?.close());

/** A test: somebody opens the page at this fragment. Fails if the page throws an error. */
const visit = (title, fragment, does) =>
  test(title, async () => {
    await webkit.go("about:blank");
    await webkit.go(pathToFileURL(labPage).href + fragment);
    await webkit.run(() => {
      window.faults = [];
      addEventListener("error", ({ message }) => faults.push(message));
      addEventListener("unhandledrejection", ({ reason }) => faults.push(String(reason)));
      console.error = (...words) => faults.push(words.join(" "));
    });
    await whole();
    await does();
    assert.deepEqual(await webkit.run(() => faults), [], "errors in the page");
  });

/** Until the laboratory is there as a whole: it opens with a simulation alone, and its other tabs wait. */
const whole = () =>
  webkit.until("the laboratory", () => document.querySelector("h1") && !document.querySelector("[role=tab][aria-busy=true]"));

/** Colours of the scene at points of its drawing. */
async function colours(points) {
  const places = await webkit.run((points) => {
    const drawing = [...document.querySelectorAll("#apparatus *")].find(({ shadowRoot }) => shadowRoot).shadowRoot.querySelector("svg");
    return points.map(([x, y]) => {
      const place = new DOMPoint(x, y).matrixTransform(drawing.getScreenCTM());
      return [place.x, place.y];
    });
  }, points);
  return webkit.pixels(places);
}

/** Place in the picture of a film, px, of a point of the drawing of the document that the page opens. */
function filmed([x, y]) {
  const [left, top, width, height] = [-12, 64, 314, 490];
  const scale = Math.min(544 / width, 344 / height);
  // The drawing is in the middle of 544 by 344 px, 8 px from the upper left corner.
  return [280, 180].map((middle, axis) => Math.round(middle + scale * ([x - left, y - top][axis] - [width, height][axis] / 2)));
}

/** True for a colour that is nearer to blue than to red. */
const isLiquid = ([red, , blue]) => blue > red + 40;

for (const [name, fragment, levels] of [
  ["the document that the page opens", "", [[125, 300, true], [247, 420, true], [247, 300, false], [186, 531, true]]],
  ["the trolley", "#1&d=utube-push.md", [[111, 450, true], [289, 450, true], [111, 300, false]]],
  ["a theory", "#1&d=theories/linear.md", [[125, 380, true], [247, 380, true], [125, 100, false], [186, 461, true]]],
]) {
  visit(`liquid fills the tube from wall to wall: ${name}`, fragment, async () => {
    // On both sides of the middle of the bore, of which a clip at the box without strokes would leave one.
    const points = levels.flatMap(([x, y]) => (x === 186 ? [[x, y - 9], [x, y + 9]] : [[x - 9, y], [x + 9, y]]));
    const expected = levels.flatMap(([, , filled]) => [filled, filled]);
    await eventually(async () => assert.deepEqual((await colours(points)).map(isLiquid), expected));
  });
}

visit("a film of the simulation shows the liquid from wall to wall", "", async () => {
  for (const part of ["#tab-measure", "#film-simulation"]) await webkit.press(part);
  await webkit.type("#filming-seconds", "0.4");
  await webkit.press("#start-filming");
  await webkit.until("a frame of the film", () => document.querySelector("#film-frame")?.dataset.frame);
  // Grey values on both sides of the middle of the left arm, filled and empty.
  const greys = await webkit.run((points) => {
    const copy = Object.assign(document.createElement("canvas"), { width: 640, height: 360 });
    const context = copy.getContext("2d");
    context.drawImage(document.querySelector("#film-picture"), 0, 0, copy.width, copy.height);
    return points.map(([x, y]) => context.getImageData(x, y, 1, 1).data[1]);
  }, [[125 - 5, 350], [125 + 5, 350], [247 - 5, 300], [247 + 5, 300]].map(filmed));
  const [left, right, ...empty] = greys;
  assert.ok(Math.abs(left - right) < 20 && empty.every((grey) => grey > left + 30), String(greys));
});

visit("clips of several shapes are those of other browsers", "", async () => {
  writeFileSync(temporary("clips.md"), clips());
  await webkit.drop(temporary("clips.md"));
  await webkit.until("the document", () => document.title.startsWith("Clips"));
  const points = CELLS.flatMap(({ points }, cell) => points.map(([x, y]) => [x + 100 * cell, y]));
  const expected = CELLS.map(({ points }) => points.map(([, , seen]) => seen));
  await eventually(async () => {
    const seen = (await colours(points)).map(isLiquid);
    assert.deepEqual(CELLS.map(({ points }) => seen.splice(0, points.length)), expected);
  });
});

visit("it plays, reads a record, fits it, follows a film, and hands in what follows from its data", "#1&d=theories/linear.md", async () => {
  await webkit.press("[aria-label=Play]");
  await webkit.until("time goes on", () => parseFloat(document.querySelector("#clock").textContent) > 0.2);
  await webkit.press("[aria-label=Pause]");
  await webkit.press("#tab-measure");
  writeFileSync(temporary("film.csv"), film());
  await webkit.drop(temporary("film.csv"));
  await webkit.until("a record", () => document.querySelector("article.record"));
  await webkit.press("#fit");
  await webkit.press("#fit-step > summary");
  const rows = () => webkit.run(() => [...document.querySelectorAll(".estimates tr")].map((row) => [...row.cells].map((cell) => cell.innerText)));
  for (const [name, truth] of [["Length of the column", LENGTH], ["Damping rate", DAMPING]]) {
    await eventually(async () => {
      const row = (await rows()).find(([label, value]) => label.startsWith(name) && value?.includes("±")) ?? assert.fail(`no estimate of ${name}`);
      const [value, error] = row[1].split("±").map(number);
      assert.ok(Math.abs(value - truth) < 3 * error + 1e-3, `${name}: ${row[1]}, not ${truth}`);
    }, 60);
  }

  // The file of the hand-in is taken before the browser saves it.
  await webkit.run(() => {
    window.makeAddress = URL.createObjectURL;
    URL.createObjectURL = (blob) => (blob.text().then((text) => (window.handed = text)), "data:,");
    HTMLAnchorElement.prototype.click = () => {};
  });
  await webkit.press("#share");
  await webkit.type("#hand-in-name", "blue heron 17");
  await webkit.press("#save-hand-in");
  writeFileSync(temporary("a.hand-in"), await webkit.until("a hand-in", () => window.handed));
  const { hand_ins: [verified] } = JSON.parse(meniscus("verify", temporary("a.hand-in"), "--format", "json"));
  assert.deepEqual(verified.differences, []);
  assert.ok(verified.equal > 10, String(verified.equal));
  await webkit.run(() => {
    URL.createObjectURL = window.makeAddress;
    delete HTMLAnchorElement.prototype.click;
    document.querySelector("dialog[open]").close();
  });

  await webkit.drop(freeSwing);
  await webkit.until("a frame of the film", () => document.querySelector("#film-frame")?.dataset.frame);
  await webkit.until("a question for the surface", () => /surface/.test(document.querySelector("#film-asked")?.innerText));
  const at = [truth.arms[0], truth.frames[0][1]].map((place, axis) => place / truth.size[axis]);
  const place = await webkit.run((at) => {
    const picture = document.querySelector("#film-picture");
    picture.scrollIntoView({ block: "center" });
    const { x, y, width, height } = picture.getBoundingClientRect();
    return [x + at[0] * width, y + at[1] * height];
  }, at);
  await webkit.click(place);
  await webkit.until("a track", () => document.querySelector("#film-record"));
});

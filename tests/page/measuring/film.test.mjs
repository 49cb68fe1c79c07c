// From film to curve: a film is dropped, what moves is clicked, two marks of the ruler are clicked, and a fit finds what was drawn.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { STILL, eventually, number, sight, visit } from "../lab.mjs";
import { clickFilmed, dropFilm, goTo, swing, truth } from "../films.mjs";
import { fit, fitted, openTheory, records } from "../measured.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const [LEFT, RIGHT] = truth.arms;
/** The surface in the left arm in the first frame. */
const SURFACE = [LEFT, truth.frames[0][1]];
/** The marks of the drawn ruler stand at every hundredth of a metre; these are 20 cm apart. */
const MARKS = [[165, truth.rest - 75], [165, truth.rest + 75]];

const click = (lab, at) => clickFilmed(lab, at, truth.size);
const tracked = (lab) => lab.page.locator("#film-record").waitFor({ timeout: 30_000 });

/** Clicks two marks of the ruler and types what lies between them. */
async function calibrate(lab) {
  for (const mark of MARKS) await click(lab, mark);
  await lab.page.locator("#film-length").fill("20 cm");
  await lab.page.locator("#film-length").press("Enter");
  await eventually(async () => assert.notEqual(await lab.page.locator("#film-scale").innerText(), ""));
}

/** What a fit finds agrees with what was drawn: the period to 0.2 ms, all within four standard errors. */
async function agrees(lab) {
  const found = await fit(lab);
  const near = (label, drawn, most) => {
    const { value, spread } = found.get(label);
    assert.ok(Math.abs(value - drawn) < Math.max(4 * spread, most), `${label}: ${value} ± ${spread}, not ${drawn}`);
    return Math.abs(value - drawn);
  };
  assert.ok(near("Period", truth.period, 5e-5) < 2e-4);
  near("Damping rate", 1 / truth.decay, 5e-4);
  // A click on each mark is half a pixel wrong, and so is the length by one part in two hundred.
  assert.ok(Math.abs(found.get("Amplitude").value / truth.amplitude - 1) < 0.015, `amplitude ${found.get("Amplitude").value} m`);
}

const THEORY = "Damped cosine";

visit("a film becomes a record by a click, a ruler, and a fit finds what was drawn", async (lab) => {
  await openTheory(lab, THEORY);
  await dropFilm(lab.page, swing);
  await eventually(async () => assert.match(await lab.page.locator("#film-asked").innerText(), /surface/));
  await click(lab, SURFACE);
  await tracked(lab);
  assert.equal(await records(lab).count(), 1);
  await calibrate(lab);
  await agrees(lab);
});

visit("a length without a unit is refused beside its field, and the table of the record follows ruler and origin", async (lab) => {
  await openTheory(lab, THEORY);
  await dropFilm(lab.page, swing);
  await click(lab, SURFACE);
  await tracked(lab);
  for (const mark of MARKS) await click(lab, mark);
  const length = lab.page.locator("#film-length");
  await length.fill("20");
  await length.press("Enter");
  await eventually(async () => assert.match(await lab.page.locator("#film-lengths-refused").innerText(), /^20 has no unit\./));
  await length.fill("20 cm");
  await length.press("Enter");
  await eventually(async () => assert.equal(await lab.page.locator("#film-lengths-refused").innerText(), ""));
  const first = async () => number((await sight(records(lab).locator(".first-values").nth(1))).split(" · ")[0]);
  await eventually(async () => assert.ok(Math.abs((await first()) - ((truth.size[1] - truth.frames[0][1]) * 0.2) / 150) < 1e-3));
  assert.match(await lab.page.locator("#film-values").innerText(), /set the origin/);
  await lab.page.locator("#film-set-origin").click();
  await click(lab, [LEFT, truth.rest]);
  await eventually(async () => assert.ok(Math.abs((await first()) - ((truth.rest - truth.frames[0][1]) * 0.2) / 150) < 1e-3, `${await first()}`));
  assert.doesNotMatch(await lab.page.locator("#film-values").innerText(), /set the origin/);
});

visit("by keyboard alone", async (lab) => {
  await openTheory(lab, THEORY);
  await dropFilm(lab.page, swing);
  await lab.page.locator("#film-frame").focus();
  const place = async ([x, y], from) => {
    await lab.keys("Enter");
    const [right, down] = [Math.round(x - from[0]), Math.round(y - from[1])];
    const walk = async (steps, key) => {
      for (let left = Math.abs(steps); left > 0; left -= left >= 10 ? 10 : 1) await lab.keys(left >= 10 ? `Shift+${key}` : key);
    };
    await walk(right, right > 0 ? "ArrowRight" : "ArrowLeft");
    await walk(down, down > 0 ? "ArrowDown" : "ArrowUp");
    await lab.keys("Enter");
    return [from[0] + right, from[1] + down];
  };
  await lab.keys("ArrowRight", "Shift+ArrowRight", "ArrowLeft", "Home");
  await eventually(async () => assert.equal(await lab.page.locator("#film-frame").getAttribute("data-frame"), "0"));
  let at = await place(SURFACE, truth.size.map((side) => side / 2));
  await tracked(lab);
  await eventually(async () => assert.match(await lab.page.locator("#film-asked").innerText(), /ruler/));
  for (const mark of MARKS) {
    await lab.page.locator("#film-frame").focus();
    at = await place(mark, at);
  }
  await eventually(async () => assert.equal((await lab.focused()).id, "film-length"));
  await lab.page.keyboard.type("20 cm");
  await lab.keys("Enter");
  await lab.tabTo("#fit");
  await lab.keys("Enter");
  await fitted(lab);
  await agrees(lab);
});

visit("the frames are gone through by slider, keys and the picture under the film", async (lab) => {
  await dropFilm(lab.page, swing);
  await click(lab, SURFACE);
  await tracked(lab);
  await lab.page.locator("#film-line").focus();
  await lab.keys("End");
  await eventually(async () => assert.equal(await lab.page.locator("#film-number").innerText(), "120 / 120"));
  const strip = await lab.page.locator("#space-time-0").boundingBox();
  await lab.page.mouse.click(strip.x + (60.5 / 120) * strip.width, strip.y + strip.height / 2);
  await eventually(async () => assert.equal(await lab.page.locator("#film-number").innerText(), "61 / 120"));
  await lab.press("Previous frame");
  await eventually(async () => assert.equal(await lab.page.locator("#film-number").innerText(), "60 / 120"));
  await lab.page.locator("#show-scene").click();
  await lab.page.locator("#scene").waitFor();
  await lab.page.locator("#show-film").click();
  await lab.page.locator("#film-frame").waitFor();
  assert.equal(await lab.page.locator("#film-number").innerText(), "60 / 120");
});

visit("the model is drawn over the film, and plots and film show the same time", async (lab) => {
  await openTheory(lab, THEORY);
  await dropFilm(lab.page, swing);
  await click(lab, SURFACE);
  await tracked(lab);
  await calibrate(lab);
  await agrees(lab);
  await goTo(lab.page, 37);
  // The run is brought to the end of the film, and to the time of the frame.
  await eventually(async () => assert.ok(Math.abs((await lab.time()) - 37 / 30) < 0.02, `${await lab.time()}`));
  await eventually(async () => assert.equal(await lab.page.locator(".film-mark.model").count(), 1));
  const away = (await lab.page.locator("#film-values").innerText()).match(/model ([\d.]+) px/);
  assert.ok(Number(away[1]) < 0.5, away[0]);
  // A place in a plot shows its frame.
  const plot = await lab.page.locator("#plots figure:not([hidden]) canvas").first().boundingBox();
  await lab.page.mouse.move(plot.x + plot.width / 2, plot.y + plot.height / 2);
  await eventually(async () => assert.notEqual(await lab.page.locator("#film-number").innerText(), "38 / 120"));
  const frame = number(await lab.page.locator("#film-number").innerText()) - 1;
  await eventually(async () => assert.ok(Math.abs((await lab.time()) - frame / 30) < 0.02));
});

visit("a wrong stretch is dragged, and the correction can be taken back", async (lab) => {
  await dropFilm(lab.page, swing);
  await click(lab, SURFACE);
  await tracked(lab);
  // Upwards from the bottom of the picture.
  const read = async () => truth.size[1] - number((await lab.page.locator("#film-values").innerText()).split("=")[1]);
  await goTo(lab.page, 60);
  const before = await read();
  assert.ok(Math.abs(before - truth.frames[60][1]) < 0.6, `${before}, not ${truth.frames[60][1]}`);
  await lab.page.locator("#space-time-0").focus();
  await lab.keys("Shift+ArrowDown", "Enter");
  // The anchor holds the path to within some pixels of a place where no surface is: the error of that frame grows.
  await eventually(async () => assert.ok(Math.abs((await read()) - before) > 1));
  await lab.keys("Delete");
  await eventually(async () => assert.equal(await read(), before));
});

visit("the work is there at the next visit, and the same file takes it up", async (lab) => {
  await openTheory(lab, THEORY);
  await dropFilm(lab.page, swing);
  await click(lab, SURFACE);
  await tracked(lab);
  await calibrate(lab);
  const scale = await lab.page.locator("#film-scale").innerText();
  // What has changed is stored a moment later.
  await eventually(async () => assert.ok(await lab.page.evaluate(() => Object.keys(localStorage).some((key) => key.startsWith("meniscus:film:") && localStorage[key].includes("20 cm")))));
  await lab.page.reload();
  await lab.page.getByRole("heading", { level: 1 }).waitFor();
  await lab.page.locator("#tab-measure").click();
  await eventually(async () => assert.equal(await records(lab).count(), 1));
  assert.equal(await lab.page.locator("#film-frame").count(), 0);
  await dropFilm(lab.page, swing);
  await tracked(lab);
  assert.equal(await records(lab).count(), 1);
  assert.equal(await lab.page.locator("#film-scale").innerText(), scale);
  assert.equal(await lab.page.locator("#film-length").inputValue(), "20 cm");
  await lab.page.locator("#space-time-0").waitFor();
  await agrees(lab);
});

for (const theme of ["light", "dark"]) {
  for (const language of ["en-GB", "es-ES"]) {
    visit(`axe finds nothing: ${theme}, ${language}`, { ...STILL, theme, language }, async (lab) => {
      await dropFilm(lab.page, swing);
      await click(lab, SURFACE);
      await tracked(lab);
      for (const mark of MARKS) await click(lab, mark);
      await lab.page.locator("#film-acts details").evaluateAll((folds) => folds.forEach((fold) => (fold.open = true)));
      await lab.page.evaluate(axe);
      const { violations } = await lab.page.evaluate(() => window.axe.run({ resultTypes: ["violations"] }));
      assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target).join(", ")}`), []);
    });
  }
}

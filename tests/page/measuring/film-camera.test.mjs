// Without a film of one's own: the simulation of the page is filmed, tracked, calibrated and compared with the truth.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { STILL, eventually, number, visit } from "../lab.mjs";
import { RULER, SURFACE, goTo, clickFilmed as click, filmSimulation as film, tracked } from "../films.mjs";
import { fit, openTheory, records } from "../measured.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
/** Asks for the truth; the root mean square of the differences in pixels. */
async function compare(lab) {
  await lab.page.locator("#compare-truth").click();
  const text = await lab.page.locator("#film-truth").innerText();
  return { text, rms: number(text.match(/RMS ([\d.,]+) px/)[1]) };
}

/** A number that tells whether two pictures have the same pixels. */
const picture = (lab) => lab.page.locator("#film-picture").evaluate((canvas) => canvas.toDataURL());

visit("the U-tube is filmed, tracked and compared with the truth", async (lab) => {
  await film(lab);
  assert.match(await lab.page.locator("#film-name").innerText(), /Filmed simulation: .*U-tube/);
  assert.equal(await lab.page.locator("#film-number").innerText(), "1 / 300");
  await click(lab, SURFACE);
  await tracked(lab);
  assert.equal(await records(lab).count(), 1);
  for (const mark of RULER) await click(lab, mark);
  await lab.page.locator("#film-length").fill("5 m");
  await lab.page.locator("#film-length").press("Enter");
  await eventually(async () => assert.notEqual(await lab.page.locator("#film-scale").innerText(), ""));
  // A column without its zero is not finished.
  const lengths = (state) => eventually(async () => assert.match(await lab.page.locator("#film-act-lengths").getAttribute("class"), state));
  assert.match(await lab.page.locator("#film-lacks-origin").innerText(), /choose Origin and click the height that is zero/);
  await lengths(/act now$/);
  await lab.page.locator("#film-set-origin").click();
  await click(lab, [SURFACE[0], 184]);
  await lengths(/act done$/);
  assert.equal(await lab.page.locator("#film-lacks-origin").count(), 0);
  // Nothing of the truth is shown before somebody asks.
  assert.equal(await lab.page.locator("#film-truth").count(), 0);
  const { rms, text } = await compare(lab);
  assert.ok(rms < 0.15, text);
  assert.ok(Math.abs(number(text.match(/Error of the scale: (\S+)/)[1].replace("−", "-"))) < 1.5, text);
  // What oscillates is taken for a damped cosine. The model has L = 2 m + 3 m + 2 m, and γ = b/(2 ρ S L).
  await openTheory(lab, "Damped cosine");
  const { value, spread } = (await fit(lab)).get("Period");
  const [gamma, length] = [50 / (2 * 1000 * 0.05 * 7), 7];
  const period = (2 * Math.PI) / Math.sqrt((2 * 9.8) / length - gamma ** 2);
  assert.ok(Math.abs(value - period) < 4 * spread && spread < 2e-3, `${value} ± ${spread}, not ${period}`);
});

visit("the bob of the pendulum, by keyboard", async (lab) => {
  await openTheory(lab, "The pendulum, small swings and large");
  await lab.page.locator("#tab-measure").focus();
  await lab.keys("Enter");
  await lab.page.locator("#film-simulation").focus();
  await lab.keys("Enter");
  await eventually(async () => assert.equal((await lab.focused()).id, "filming-seconds"));
  await lab.keys("Control+A");
  await lab.page.keyboard.type("4");
  await lab.tabTo("#start-filming");
  await lab.keys("Enter");
  await lab.page.locator("#film-frame").waitFor({ timeout: 120_000 });
  await lab.page.locator("#film-kind-body").focus();
  await lab.keys("Enter");
  await lab.page.locator("#film-frame").focus();
  // From the middle of the picture.
  const walk = async (steps, [back, on]) => {
    const [far, near] = [Math.floor(Math.abs(steps) / 10), Math.abs(steps) % 10];
    for (let left = far; left > 0; left -= 1) await lab.keys(`Shift+${steps < 0 ? back : on}`);
    for (let left = near; left > 0; left -= 1) await lab.keys(steps < 0 ? back : on);
  };
  await lab.keys("Enter");
  await walk(329 - 320, ["ArrowLeft", "ArrowRight"]);
  await walk(317 - 180, ["ArrowUp", "ArrowDown"]);
  await lab.keys("Enter");
  await tracked(lab);
  await lab.page.locator("#compare-truth").focus();
  await lab.keys("Enter");
  await eventually(async () => assert.equal((await lab.focused()).id, "film-truth"));
  const text = await lab.page.locator("#film-truth").innerText();
  assert.ok(number(text.match(/RMS ([\d.,]+) px/)[1]) < 0.5, text);
});

visit("the same film is there at the next visit, with what was found", async (lab) => {
  const short = { seconds: "3", noise: "4" };
  await film(lab, short);
  await click(lab, SURFACE);
  await tracked(lab);
  await goTo(lab.page, 40);
  const before = [await picture(lab), await lab.page.locator("#film-values").innerText()];
  await eventually(async () => assert.ok(await lab.page.evaluate(() => Object.keys(localStorage).some((key) => key.startsWith("meniscus:film:") && localStorage[key].includes("recipe")))));
  await lab.page.reload();
  await lab.page.getByRole("heading", { level: 1 }).waitFor();
  await lab.page.locator("#tab-measure").click();
  await lab.page.locator("#film-again-0").click();
  await lab.page.locator("#film-frame").waitFor({ timeout: 60_000 });
  await tracked(lab);
  assert.equal(await records(lab).count(), 1);
  assert.equal(await lab.page.locator("#film-again-0").count(), 0);
  await goTo(lab.page, 40);
  assert.deepEqual([await picture(lab), await lab.page.locator("#film-values").innerText()], before);
  await lab.page.locator("#space-time-0").waitFor();
});

visit("filming can be cancelled, and what cannot be filmed is said", async (lab) => {
  await lab.page.locator("#tab-measure").click();
  await lab.page.locator("#film-simulation").click();
  // What is no number is refused at its field.
  await lab.page.locator("#filming-seconds").fill("ten");
  await lab.page.locator("#start-filming").click();
  await eventually(async () =>
    assert.match(await lab.page.locator("#filming-seconds-error").innerText(), /“ten” is not a number. Write one such as 2.5 s/));
  assert.equal(await lab.page.locator("#filming-seconds").getAttribute("aria-invalid"), "true");
  await lab.page.locator("#filming-seconds").fill("1000");
  await lab.page.locator("#start-filming").click();
  await eventually(async () => assert.match((await lab.page.locator(".message").allInnerTexts()).join("\n"), /between 10 and 900 frames/));
  await lab.page.locator("#filming-seconds").fill("30");
  await lab.page.locator("#start-filming").click();
  await lab.page.locator("#cancel-filming").click();
  await lab.page.locator("#cancel-filming").waitFor({ state: "detached" });
  assert.equal(await lab.page.locator("#film-frame").count(), 0);
  await openTheory(lab, "The logistic map");
  await lab.page.locator("#tab-measure").click();
  await lab.page.locator("#film-simulation").click();
  await eventually(async () => assert.match((await lab.page.locator(".message").allInnerTexts()).join("\n"), /does not run in time/));
});

for (const [theme, language] of [["light", "en-GB"], ["dark", "es-ES"]]) {
  visit(`axe finds nothing: ${theme}, ${language}`, { ...STILL, theme, language }, async (lab) => {
    await film(lab, { seconds: "2" });
    await click(lab, SURFACE);
    await tracked(lab);
    await lab.page.locator("#compare-truth").click();
    await lab.page.locator("#film-simulation").click();
    await lab.page.locator("#filming").waitFor();
    await lab.page.evaluate(axe);
    const { violations } = await lab.page.evaluate(() => window.axe.run({ resultTypes: ["violations"] }));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target).join(", ")}`), []);
  });
}

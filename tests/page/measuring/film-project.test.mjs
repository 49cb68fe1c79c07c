// Projects of Tracker with their film in the archive: the record comes, and the film opens with positions and scale of the project.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { eventually, number, sight, visit } from "../lab.mjs";
import { freeSwing, goTo, swing, truth } from "../films.mjs";
import { fit, openTheory, records } from "../measured.mjs";
import { dropProject, packed } from "../tracker.mjs";

const messages = (lab) => lab.page.locator("#messages").innerText();

for (const deflated of [false, true]) {
  visit(`the film of a project opens from the archive, ${deflated ? "unpacked" : "as it is stored"}, and its times win`, async (lab) => {
    await openTheory(lab, "Damped cosine");
    await dropProject(lab.page, packed("swing.webm", readFileSync(freeSwing), deflated));
    await eventually(async () => assert.equal(await lab.page.locator("#film-name").innerText(), "swing.webm"), 30);
    await eventually(async () => assert.match(await messages(lab), /film of the project is open.*Times are now those of the film's frames/s));
    assert.equal(await records(lab).count(), 1);
    // A click in each frame, where the project has it.
    await goTo(lab.page, 60);
    const text = await lab.page.locator("#film-values").innerText();
    const [, height] = text.match(/y = (\S+) ±/);
    assert.ok(Math.abs(number(height) - (truth.rest - truth.frames[60][1]) / truth.pixels_per_metre) < 1e-4, text);
    assert.match(await sight(lab.page.locator("article.record")), /Times are those of the frames of its film, and not the constant step of 33 ms/);
    // With the step of the project the period would be 0.6534 s.
    const found = await fit(lab);
    const { value, spread } = found.get("Period");
    assert.ok(Math.abs(value - truth.period) < Math.max(4 * spread, 5e-4), `${value} ± ${spread}`);
    assert.ok(Math.abs(found.get("Amplitude").value / truth.amplitude - 1) < 0.01);
  });
}

visit("an archive that is larger than any record is not read whole", async (lab) => {
  await lab.page.evaluate(() => {
    const whole = Blob.prototype.arrayBuffer;
    window.read = 0;
    Blob.prototype.arrayBuffer = function () {
      window.read += this.size;
      return whole.call(this);
    };
  });
  await dropProject(lab.page, packed("swing.webm", readFileSync(freeSwing), false, [["videos/other.mov", 80_000_000, false]]));
  await eventually(async () => assert.equal(await lab.page.locator("#film-name").innerText(), "swing.webm"), 30);
  assert.equal(await records(lab).count(), 1);
  const read = await lab.page.evaluate(() => window.read);
  assert.ok(read < 1_000_000, `${read} bytes were read`);
});

visit("where the film cannot be decoded the record alone comes, and that is said", async (lab) => {
  // The same file with the name of a coding that the browser does not have.
  const unknown = Buffer.from(readFileSync(swing).toString("latin1").replaceAll("avc1", "hvc1").replaceAll("avcC", "hvcC"), "latin1");
  const files = [unknown, Buffer.from("no film at all, but long enough to be looked at")];
  for (const [before, bytes] of files.entries()) {
    await dropProject(lab.page, packed("swing.mp4", bytes));
    await eventually(async () => assert.equal(await records(lab).count(), before + 1), 30);
    await eventually(async () => assert.match(await messages(lab), /positions of the project are a record; its film was not opened: swing\.mp4/), 30);
    assert.equal(await lab.page.locator("#film-name").count(), 0);
    assert.match(await sight(lab.page.locator("article.record").last()), /constant step of 33 ms/);
  }
});

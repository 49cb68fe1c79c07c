// Films open wherever the page does, and each frame is the right one: from a file, from this computer's server, in a sandboxed frame.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { after, before } from "node:test";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { beside, eventually, labPage, temporary, visit } from "../lab.mjs";
import { SOME, difference, dropFilm, isRight, pictures, swing } from "../films.mjs";

const fixtures = beside("../../crates/film/tests/films");
const at = (name) => join(fixtures, name);

const FILMS = ["h264.mp4", "fragments.mp4", "fragments-of-old.mp4", "variable.mp4", "late.mov", "trimmed.mp4", "h264.mkv", "vp8.webm", "vp9.webm", "live.webm", "av1.mp4", "mjpeg.avi", "mjpeg.mov"];

/** The times of the frames that are shown, as ffprobe has them. */
const times = (name) => readFileSync(at(`${name}.csv`), "utf8").split("\n").filter((line) => line.startsWith("frame,")).map((line) => Number(line.split(",")[1]));

visit("every frame of a film with frames out of order is the right one", async (lab) => isRight(lab.page, lab.page, [...Array(60).keys()]));

visit("frames come in any order", async (lab) => isRight(lab.page, lab.page, SOME));

visit("every container opens, and its frames are shown at their times", async (lab) => {
  for (const name of FILMS) {
    await dropFilm(lab.page, at(name));
    const expected = times(name);
    const seen = await pictures(lab.page);
    assert.equal(seen.length, expected.length, name);
    seen.forEach(({ time, grey }, frame) => {
      assert.ok(Math.abs(time - expected[frame]) < 6e-4, `${name}, frame ${frame + 1}: ${time} s, not ${expected[frame]} s`);
      assert.ok(Math.max(...grey) > 300, `${name}, frame ${frame + 1} is dark`);
    });
  }
  assert.equal(await lab.page.locator(".message.error").count(), 0);
});

visit("a film that was turned stands upright", async (lab) => {
  await dropFilm(lab.page, at("h264.mp4"));
  const [stored] = await pictures(lab.page, [0]);
  const turned = [["rotated-90.mp4", (x, y) => [y, 63 - x]], ["rotated-180.mp4", (x, y) => [95 - x, 63 - y]], ["rotated-270.mp4", (x, y) => [95 - y, x]]];
  for (const [name, back] of turned) {
    await dropFilm(lab.page, at(name));
    const [upright] = await pictures(lab.page, [0]);
    assert.equal(upright.width, name.includes("180") ? 96 : 64);
    const again = { grey: new Array(96 * 64).fill(0) };
    upright.grey.forEach((value, place) => {
      const [x, y] = back(place % upright.width, Math.floor(place / upright.width));
      again.grey[y * 96 + x] = value;
    });
    assert.ok(difference(again, stored) < 3, `${name}: ${difference(again, stored)}`);
  }
});

visit("what cannot be opened is refused with what to do", async (lab) => {
  const refused = async (name, text, bytes) => {
    await dropFilm(lab.page, name, lab.page, bytes);
    await eventually(async () => assert.match(await lab.page.locator(".message.error").last().innerText(), text));
  };
  await refused(at("hevc.mp4"), /HEVC.*Most Compatible/);
  await refused("swing.gif", /animated GIF/, Buffer.from("GIF89a and so on"));
  await refused("notes.mp4", /not a film/, Buffer.from("a text, and nothing else in it at all"));
});

visit("in a sandboxed frame, as in a course page", async (lab) => {
  const file = temporary("course.html");
  writeFileSync(file, `<!doctype html><title>Course</title><h1>Course</h1><iframe sandbox="allow-scripts" style="width:1400px;height:820px" src="${pathToFileURL(labPage).href}"></iframe>`);
  await lab.go(pathToFileURL(file).href);
  const frame = lab.page.frames().find((frame) => frame !== lab.page.mainFrame());
  await frame.locator("#apparatus").waitFor();
  await frame.locator("[role=tab][aria-busy=true]").first().waitFor({ state: "detached" });
  await isRight(lab.page, frame, SOME);
});

let server;
before(() => {
  server = createServer((request, response) => {
    if (request.url === "/") response.writeHead(200, { "content-type": "text/html; charset=utf-8" }).end(readFileSync(labPage));
    else response.writeHead(404).end();
  });
  return new Promise((ready) => server.listen(0, "0.0.0.0", ready));
});
after(() => server.close());

visit("from this computer's server", { address: () => `http://localhost:${server.address().port}/` }, async (lab) => {
  lab.requests.length = 0;
  await isRight(lab.page, lab.page, SOME);
});

visit("over the network without encryption no film opens, and the page says what to do", { address: () => `http://lan.test:${server.address().port}/` }, async (lab) => {
  lab.requests.length = 0;
  await dropFilm(lab.page, "swing.mp4", lab.page, readFileSync(swing));
  await eventually(async () => assert.match(await lab.page.locator(".message.error").innerText(), /save the page and open the file/));
});

visit("the camera films, and the film opens", async (lab) => {
  await lab.page.locator("#tab-measure").click();
  await lab.page.locator("#other-ways summary").click();
  await lab.press("Record film");
  await lab.button("Stop recording").waitFor();
  await new Promise((done) => setTimeout(done, 1500));
  await lab.press("Stop recording");
  await lab.page.locator("#film-frame[data-frame]").waitFor();
  assert.match(await lab.page.locator("#film-name").innerText(), /^film-.*\.(webm|mp4)$/);
  await lab.page.locator("#other-ways summary").click();
  await lab.button("Record film").waitFor();
});

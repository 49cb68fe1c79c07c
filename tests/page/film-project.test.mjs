// Projects of Tracker with their film in the archive: the record comes, and the film opens with positions and scale of the project.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { crc32, deflateRawSync } from "node:zlib";
import { eventually, number, visit } from "./lab.mjs";
import { freeSwing, goTo, swing, truth } from "./films.mjs";
import { fit, openTheory, records } from "./measured.mjs";

/** A ZIP archive (APPNOTE.TXT 6.3.3) of files, each with its content and whether it is deflated, in parts: the bytes, or a number of zeros. */
function archive(files) {
  const [parts, directory] = [[], []];
  let at = 0;
  for (const [name, content, deflated] of files) {
    const [packed, title] = [deflated ? deflateRawSync(content) : content, Buffer.from(name)];
    const length = (bytes) => bytes.length ?? bytes;
    const common = Buffer.alloc(26);
    common.writeUInt16LE(20, 0);
    common.writeUInt16LE(deflated ? 8 : 0, 4);
    common.writeUInt32LE(content.length === undefined ? 0 : crc32(content), 10);
    common.writeUInt32LE(length(packed), 14);
    common.writeUInt32LE(length(content), 18);
    common.writeUInt16LE(title.length, 22);
    const place = Buffer.alloc(14);
    place.writeUInt32LE(at, 10);
    parts.push(Buffer.from("PK\x03\x04"), common, title, packed);
    directory.push(Buffer.from("PK\x01\x02\x14\x00"), common, place, title);
    at += 30 + title.length + length(packed);
  }
  const end = Buffer.alloc(22);
  end.write("PK\x05\x06");
  end.writeUInt16LE(files.length, 8);
  end.writeUInt16LE(files.length, 10);
  end.writeUInt32LE(directory.reduce((sum, part) => sum + part.length, 0), 12);
  end.writeUInt32LE(at, 16);
  return [...parts, ...directory, end].map((part) => (typeof part === "number" ? part : part.toString("latin1")));
}

/** The text of a project in which every frame of the swing is marked by hand, with frames of 33 ms: the film has 33.3. */
function project(film) {
  const property = (name, type, value) => `<property name="${name}" type="${type}">${value}</property>`;
  const object = (name, inside) => `<object class="org.opensourcephysics.${name}">${inside}</object>`;
  const numbers = (values) => Object.entries(values).map(([name, value]) => property(name, "double", value)).join("");
  const mark = ([, y], frame) =>
    property(`[${frame}]`, "object", object("cabrillo.tracker.PointMass$FrameData", numbers({ x: truth.arms[0], y })));
  const axes = numbers({ xorigin: truth.arms[0], yorigin: truth.rest, angle: 0, xscale: truth.pixels_per_metre, yscale: truth.pixels_per_metre });
  const fixed = ["fixedorigin", "fixedangle", "fixedscale"].map((name) => property(name, "boolean", "true")).join("");
  return Buffer.from(`<?xml version="1.0" encoding="UTF-8"?>` + object("cabrillo.tracker.TrackerPanel", [
    property("videoclip", "object", object("media.core.VideoClip",
      property("video", "object", object("media.xuggle.XuggleVideo", property("path", "string", `videos/${film}`))) + property("stepcount", "int", 120))),
    property("clipcontrol", "object", object("media.core.StepperClipControl", property("delta_t", "double", "33.0"))),
    property("coords", "object", object("media.core.ImageCoordSystem",
      fixed + property("framedata", "array", property("[0]", "object", object("media.core.ImageCoordSystem$FrameData", axes))))),
    property("length_unit", "string", "m"),
    property("tracks", "collection", property("item", "object", object("cabrillo.tracker.PointMass",
      property("name", "string", "surface") + property("framedata", "array", truth.frames.map(mark).join(""))))),
  ].join("")));
}

const packed = (film, bytes, deflated = false, before = []) =>
  archive([...before, ["swing.trk", project(film), true], [`videos/${film}`, bytes, deflated]]);

/** Lets a project fall on the page. */
async function dropProject(lab, parts) {
  await lab.page.evaluate((parts) => {
    const bytes = (part) => (typeof part === "number" ? new Uint8Array(part) : Uint8Array.from(part, (character) => character.charCodeAt(0)));
    const transfer = new DataTransfer();
    transfer.items.add(new File(parts.map(bytes), "swing.trz"));
    document.querySelector("#apparatus").dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, parts);
}

const messages = (lab) => lab.page.locator("#messages").innerText();

for (const deflated of [false, true]) {
  visit(`the film of a project opens from the archive, ${deflated ? "unpacked" : "as it is stored"}, and its times win`, async (lab) => {
    await openTheory(lab, "Damped cosine");
    await dropProject(lab, packed("swing.webm", readFileSync(freeSwing), deflated));
    await eventually(async () => assert.equal(await lab.page.locator("#film-name").innerText(), "swing.webm"), 30);
    await eventually(async () => assert.match(await messages(lab), /film of the project is open.*Times are now those of the film's frames/s));
    assert.equal(await records(lab).count(), 1);
    // A click in each frame, where the project has it.
    await goTo(lab.page, 60);
    const text = await lab.page.locator("#film-values").innerText();
    const [, height] = text.match(/y = (\S+) ±/);
    assert.ok(Math.abs(number(height) - (truth.rest - truth.frames[60][1]) / truth.pixels_per_metre) < 1e-4, text);
    assert.match(await lab.page.locator("article.record").innerText(), /Times are those of the frames of its film, and not the constant step of 33 ms/);
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
  await dropProject(lab, packed("swing.webm", readFileSync(freeSwing), false, [["videos/other.mov", 80_000_000, false]]));
  await eventually(async () => assert.equal(await lab.page.locator("#film-name").innerText(), "swing.webm"), 30);
  assert.equal(await records(lab).count(), 1);
  const read = await lab.page.evaluate(() => window.read);
  assert.ok(read < 1_000_000, `${read} bytes were read`);
});

visit("where the film cannot be decoded the record alone comes, and that is said", async (lab) => {
  // The same file with the name of a coding that the browser does not have.
  const unknown = Buffer.from(readFileSync(swing).toString("latin1").replaceAll("avc1", "hvc1").replaceAll("avcC", "hvcC"), "latin1");
  for (const bytes of [unknown, Buffer.from("no film at all, but long enough to be looked at")]) {
    await dropProject(lab, packed("swing.mp4", bytes));
    await eventually(async () => assert.match(await messages(lab), /positions of the project are a record; its film was not opened: swing\.mp4/), 30);
    assert.equal(await lab.page.locator("#film-name").count(), 0);
    assert.match(await lab.page.locator("article.record").last().innerText(), /constant step of 33 ms/);
  }
  assert.equal(await records(lab).count(), 2);
});

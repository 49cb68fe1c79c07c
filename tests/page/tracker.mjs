// Projects of Tracker with their film in the archive, as tests make them and let them fall on the page.

import { crc32, deflateRawSync } from "node:zlib";
import { truth } from "./films.mjs";

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

/** A project of the swing with its film, after other files. */
export const packed = (film, bytes, deflated = false, before = []) =>
  archive([...before, ["swing.trk", project(film), true], [`videos/${film}`, bytes, deflated]]);

/** Lets a project fall on the page. */
export async function dropProject(page, parts) {
  await page.evaluate((parts) => {
    const bytes = (part) => (typeof part === "number" ? new Uint8Array(part) : Uint8Array.from(part, (character) => character.charCodeAt(0)));
    const transfer = new DataTransfer();
    transfer.items.add(new File(parts.map(bytes), "swing.trz"));
    document.querySelector("#apparatus").dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, parts);
}

// An exported page on a cheap phone, as far as a computer can play one: a small screen of two pixels to a point, a processor that is
// slowed down, and a slow connection. For `measure.mjs`.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { framesIn, median, usableAfter } from "./timing.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };
const OPENINGS = 3;
const SECONDS = 4;
/** As the developer tools of browsers have it: bits a second, and milliseconds there and back. */
const SLOW_4G = { offline: false, downloadThroughput: (1.6e6 / 8) * 0.9, uploadThroughput: (750e3 / 8) * 0.9, latency: 150 * 3.75 };
/** The browser's own names of what the main thread does for a frame. */
const PHASES = {
  script: ["FunctionCall"],
  style: ["UpdateLayoutTree"],
  layout: ["Layout"],
  paint: ["PrePaint", "Paint", "Layerize"],
  commit: ["Commit"],
  thread: ["RunTask"],
};

/** Says how long opening takes and what a frame costs. */
export async function measurePhone(browser, address, say) {
  for (const [name, slowed] of [["full", 1], ["quarter", 4], ["sixth", 6]]) {
    say(`phone-opening-${name}`, await opening(browser, address, { slowed }));
  }
  const html = gzipSync(readFileSync(fileURLToPath(address)));
  const server = createServer((_, response) => {
    response.writeHead(200, { "Content-Type": "text/html; charset=utf-8", "Content-Encoding": "gzip" }).end(html);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  try {
    const served = `http://127.0.0.1:${server.address().port}/`;
    say("phone-opening-slow-4g", await opening(browser, served, { slowed: 4, network: SLOW_4G }));
  } finally {
    server.close();
  }
  await frames(browser, address, say);
}

async function phone(browser, slowed) {
  const context = await browser.newContext(PHONE);
  const page = await context.newPage();
  const devtools = await context.newCDPSession(page);
  await devtools.send("Emulation.setCPUThrottlingRate", { rate: slowed });
  return { context, page, devtools };
}

/** Milliseconds from the start of the navigation until the play button can be pressed, each time in a fresh context. */
async function opening(browser, address, { slowed, network }) {
  const times = [];
  for (let time = 0; time < OPENINGS; time += 1) {
    const { context, page, devtools } = await phone(browser, slowed);
    if (network) {
      await devtools.send("Network.enable");
      await devtools.send("Network.emulateNetworkConditions", network);
    }
    times.push(await usableAfter(page, address));
    await context.close();
  }
  return median(times);
}

/** Frames in a second, and milliseconds of the main thread for each of them by what it does, in processor time at full speed. */
async function frames(browser, address, say) {
  const { context, page, devtools } = await phone(browser, 4);
  await page.goto(address);
  await page.locator("#play").tap();
  await page.waitForTimeout(2000);
  const events = [];
  devtools.on("Tracing.dataCollected", ({ value }) => events.push(...value));
  await devtools.send("Tracing.start", {
    transferMode: "ReportEvents",
    traceConfig: { includedCategories: ["devtools.timeline", "disabled-by-default-devtools.timeline", "toplevel"] },
  });
  const drawn = await framesIn(page, SECONDS);
  const complete = new Promise((done) => devtools.once("Tracing.tracingComplete", done));
  await devtools.send("Tracing.end");
  await complete;
  say("phone-frames-per-second", drawn / SECONDS);
  const threads = events.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain");
  const main = new Set(threads.map(({ pid, tid }) => `${pid} ${tid}`));
  for (const [phase, names] of Object.entries(PHASES)) {
    const own = events.filter(({ name, ph, pid, tid }) => ph === "X" && names.includes(name) && main.has(`${pid} ${tid}`));
    say(`phone-${phase}`, own.reduce((sum, { tdur, dur }) => sum + (tdur ?? dur), 0) / 1000 / drawn / 4);
  }
  await context.close();
}

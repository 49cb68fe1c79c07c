// The pages on a cheap phone, as far as a computer can play one: a small screen of two pixels to a point, a processor that is
// slowed down, and a slow connection. For `measure.mjs`.

import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { basename, dirname, extname, join } from "node:path";
import { pathToFileURL } from "node:url";
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

/** A button of the published page: the first that its script makes. */
const PUBLISHED_BUTTON = "button, input[type=button]";

/** Says how long the pages `laboratory`, `exported` and, if it is there, `published` take to open, in turns, and what a frame of the exported
    one costs. The published page has files beside it; the others are one file each. */
export async function measurePhone(browser, { laboratory, exported, published }, say) {
  const pages = Object.entries({ laboratory, exported, published }).filter(([, path]) => path);
  const site = await served(Object.fromEntries(pages.map(([name, path]) => [name, dirname(path)])));
  const settings = {
    full: { slowed: 1 },
    quarter: { slowed: 4 },
    sixth: { slowed: 6 },
    "slow-4g": { slowed: 4, network: SLOW_4G },
  };
  try {
    for (const [setting, { slowed, network }] of Object.entries(settings)) {
      const times = Object.fromEntries(pages.map(([name]) => [name, []]));
      for (let turn = 0; turn < OPENINGS; turn += 1) {
        for (const [name, path] of pages) {
          const address = network ? `${site.address}/${name}/${basename(path)}` : pathToFileURL(path).href;
          times[name].push(await opening(browser, address, { slowed, network, play: name === "published" ? PUBLISHED_BUTTON : "#play" }));
        }
      }
      for (const [name, taken] of Object.entries(times)) say(`phone-${name}-${setting}`, median(taken));
    }
  } finally {
    site.close();
  }
  await frames(browser, pathToFileURL(exported).href, say);
}

/** Serves each of these folders, gzipped, at its name. */
async function served(folders) {
  const types = { ".html": "text/html", ".xhtml": "application/xhtml+xml", ".js": "text/javascript", ".css": "text/css" };
  const server = createServer((request, response) => {
    const [, name, ...rest] = decodeURIComponent(new URL(request.url, "http://localhost").pathname).split("/");
    const path = join(folders[name] ?? "", ...rest);
    if (!folders[name] || !existsSync(path)) return response.writeHead(404).end();
    const type = types[extname(path)];
    const content = readFileSync(path);
    if (!type) return response.end(content);
    response.writeHead(200, { "Content-Type": `${type}; charset=utf-8`, "Content-Encoding": "gzip" }).end(gzipSync(content));
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return { address: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

async function phone(browser, slowed) {
  const context = await browser.newContext(PHONE);
  const page = await context.newPage();
  const devtools = await context.newCDPSession(page);
  await devtools.send("Emulation.setCPUThrottlingRate", { rate: slowed });
  return { context, page, devtools };
}

/** Milliseconds from the start of the navigation until the play button can be pressed, in a fresh context. */
async function opening(browser, address, { slowed, network, play }) {
  const { context, page, devtools } = await phone(browser, slowed);
  if (network) {
    await devtools.send("Network.enable");
    await devtools.send("Network.emulateNetworkConditions", network);
  }
  const time = await usableAfter(page, address, play);
  await context.close();
  return time;
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

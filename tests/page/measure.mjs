// Measures the built page in the browser, and the engine's pace in WebAssembly, for `cargo xtask bench`. Prints one
// `name value` in each line. Needs PROBE, the directory with the probe's JavaScript and module; PAGE, the laboratory; EXPORTED,
// a page that `meniscus export` has made; PROFILES, the directory with the exported pages `chain.html`, of 200 masses, and
// `string.html`, of 1,000 points; and CHROME, without which the pace is that of Node. Without PAGE or CHROME only the pace is measured.

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import vm from "node:vm";
import { measurePhone } from "./phone.mjs";
import { framesIn, median, usableAfter } from "./timing.mjs";

const STEPS = 1_000_000;
const ROUNDS = 5;
/** Greatest number of rows of runs side by side. */
const MOST_ROWS = 400;
/** Systems of many equal parts, and how many steps are measured at a time. */
const SYSTEMS = { chain: 10_000, string: 2000, gas: 200 };
/** How many rows of the published simulation are to be recorded before frames are measured, its step, and for how many seconds to measure: in
    100 s it would pause. */
const ROWS = 1500;
const STEP = 0.05;
const SECONDS = 5;
const OPENINGS = 9;
/** How many rows the long record has. */
const LONG = 1_000_000;

/** Defines `probe`, which loads the module; as a value and not as a script, since a blank page has no address. */
const glue = `globalThis.probe = (() => { ${readFileSync(join(process.env.PROBE, "probe.js"), "utf8")}; return wasm_bindgen; })(); 0`;
const module = readFileSync(join(process.env.PROBE, "probe_bg.wasm"));

const say = (name, value) => console.log(name, value.toFixed(3));

/** Million steps in a second in the virtual machine, in emitted code and by hand, in turns, the best of each. */
async function pace({ bytes, steps, systems, rounds, most, record, shipped }) {
  const { probe } = globalThis;
  await probe({ module_or_path: Uint8Array.from(atob(bytes), (character) => character.charCodeAt(0)) });
  const tube = new probe.Pace();
  const emitted = new probe.Pace();
  emitted.emit();
  const beside = new probe.SideBySideTubes();
  if (beside.steps(64 * 500) !== tube.machine(500)) throw new Error("runs side by side have other bits");
  const best = { machine: 0, emitted: 0, beside: 0, hand: 0, best: 0 };
  const measure = (name, work) => {
    const start = performance.now();
    work();
    best[name] = Math.max(best[name], steps / (performance.now() - start) / 1000);
  };
  for (let round = 0; round < rounds; round += 1) {
    measure("machine", () => tube.machine(steps));
    measure("emitted", () => emitted.machine(steps));
    measure("beside", () => beside.steps(steps));
    measure("hand", () => tube.by_hand(steps));
    measure("best", () => tube.best_by_hand(steps));
  }
  // A damped cosine at 30 frames a second, as the native measurement makes it without the measured record.
  const times = Float64Array.from({ length: 207 }, (_, frame) => frame / 30);
  const level = times.map((time) => 0.056 * Math.exp(-0.387 * time) * Math.sin(9.61 * time - 1.6) - 0.0027);
  const fits = new probe.Fits(record?.times ?? times, record?.level ?? level);
  const each = (work, count) => {
    work(1);
    const start = performance.now();
    work(count);
    return (performance.now() - start) / count;
  };
  best.formula = each((count) => fits.formula(count), 200);
  best.motion = each((count) => fits.motion(count), 20);
  fits.emit();
  best.emittedMotion = each((count) => fits.motion(count), 20);
  // Microseconds of a step, and milliseconds of a check of a long document, the best of some.
  best.systems = {};
  const least = (name, count, work) => {
    const start = performance.now();
    work();
    best.systems[name] = Math.min(best.systems[name] ?? Infinity, (performance.now() - start) / count);
  };
  for (const [name, count] of Object.entries(systems)) {
    const system = new probe.System(name);
    const emitted = new probe.System(name);
    emitted.emit();
    if (system.machine(20).join() !== emitted.machine(20).join()) throw new Error(`${name} has other bits in emitted code`);
    for (let round = 0; round < rounds; round += 1) {
      least(`${name}-machine`, count / 1000, () => system.machine(count));
      least(`${name}-emitted`, count / 1000, () => emitted.machine(count));
      least(`${name}-hand`, count / 1000, () => system.by_hand(count));
    }
  }
  // Each document with its own method: nanoseconds of a row interpreted and in emitted code, or why it is interpreted.
  best.shipped = {};
  // How many times as fast 64 runs side by side are as emitted runs one by one, with what a plot reads at each row, or why they are none.
  best.lanes = {};
  for (const [name, text] of Object.entries(shipped)) {
    const [machine, emitted] = [new probe.Shipped(text), new probe.Shipped(text)];
    try {
      emitted.emit();
    } catch (reason) {
      best.shipped[name] = reason;
      continue;
    }
    if (machine.rows(500) !== emitted.rows(500)) throw new Error(`${name} has other bits in emitted code`);
    const time = (document, rows) => {
      const start = performance.now();
      document.rows(rows);
      return performance.now() - start;
    };
    let rows = 200;
    while (rows < 1_000_000 && time(machine, rows) < 10) rows *= 2;
    const least = [Infinity, Infinity];
    for (let round = 0; round < rounds; round += 1) {
      least[0] = Math.min(least[0], time(machine, rows));
      least[1] = Math.min(least[1], time(emitted, rows));
    }
    best.shipped[name] = least.map((milliseconds) => (milliseconds / rows) * 1e6);
    try {
      emitted.emit_side_by_side();
    } catch (reason) {
      best.lanes[name] = reason;
      continue;
    }
    const ways = ["runs_one_by_one", "runs_side_by_side"];
    const duration = (way, rows) => {
      const start = performance.now();
      emitted[way](rows);
      return performance.now() - start;
    };
    // Whole runs, as a plot needs them: to start one takes as long as many rows.
    rows = Math.min(most, emitted.rows_of_run());
    if (emitted[ways[0]](rows) !== emitted[ways[1]](rows)) throw new Error(`${name} has other bits side by side`);
    // The browser compiles the code again, for speed, while it runs.
    const warm = performance.now() + 300;
    while (performance.now() < warm) emitted.runs_side_by_side(rows);
    const shortest = [Infinity, Infinity];
    for (let round = 0; round < rounds; round += 1)
      ways.forEach((way, place) => (shortest[place] = Math.min(shortest[place], duration(way, rows))));
    best.lanes[name] = shortest[0] / shortest[1];
  }
  const text = probe.long_document();
  for (let round = 0; round < rounds; round += 1) least("check-lines", 3, () => probe.check(text, 3));
  return best;
}

/** The measured record U3 beside the project, if it is there. */
function measured() {
  const path = new URL("../../../shared/data/utube/U3.txt", import.meta.url);
  if (!existsSync(path)) return undefined;
  const rows = readFileSync(path, "utf8").trim().split("\n").map((line) => line.split(" ").map(Number));
  return { times: rows.map((row) => row[0]), level: rows.map((row) => row[1]) };
}

/** Texts of the documents that ship, by name. */
function shipped() {
  const folder = fileURLToPath(new URL("../../simulations/", import.meta.url));
  const names = readdirSync(folder).filter((name) => name.endsWith(".md") && !name.endsWith(".es.md"));
  return Object.fromEntries(names.map((name) => [name.slice(0, -3), readFileSync(join(folder, name), "utf8")]));
}

const task = {
  bytes: module.toString("base64"),
  steps: STEPS,
  systems: SYSTEMS,
  rounds: ROUNDS,
  most: MOST_ROWS,
  record: measured(),
  shipped: shipped(),
};

function sayPace(best) {
  say("wasm-machine", best.machine);
  say("wasm-emitted", best.emitted);
  say("wasm-side-by-side", best.beside);
  say("wasm-hand", best.hand);
  say("wasm-best", best.best);
  for (const [name, times] of Object.entries(best.shipped)) {
    if (Array.isArray(times)) {
      say(`shipped-${name}`, times[0] / times[1]);
      say(`row-${name}`, times[1]);
    } else console.log(`interpreted: ${name}: ${times}`);
  }
  for (const [name, times] of Object.entries(best.lanes)) {
    if (typeof times === "number") say(`lanes-${name}`, times);
    else console.log(`one by one: ${name}: ${times}`);
  }
  say("fit-formula", best.formula);
  say("fit-motion", best.motion);
  say("fit-motion-emitted", best.emittedMotion);
  for (const [name, value] of Object.entries(best.systems)) say(name, value);
}

if (!process.env.CHROME) {
  vm.runInThisContext(glue);
  sayPace(await pace(task));
  process.exit(0);
}

const { chromium } = await import("playwright-core");
const browser = await chromium.launch({
  executablePath: process.env.CHROME,
  args: ["--no-sandbox", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});
const address = process.env.PAGE && pathToFileURL(process.env.PAGE).href;

try {
  await measurePace();
  if (address) await measurePage();
} finally {
  await browser.close();
}

async function measurePage() {
  await measureOpening();
  await measureFrames();
  await measureLongRecord();
  for (const name of ["chain", "string"]) await measureProfile(name);
  await measurePhone(browser, { laboratory: process.env.PAGE, exported: process.env.EXPORTED, published: process.env.PUBLISHED_PAGE }, say);
}

async function measurePace() {
  const page = await browser.newPage();
  await page.evaluate(glue);
  sayPace(await page.evaluate(pace, task));
  await page.close();
}

/** Milliseconds from the start of the navigation until the play button is there, each time in a fresh context. */
async function measureOpening() {
  const times = [];
  for (let opening = 0; opening < OPENINGS; opening += 1) {
    const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, offline: true });
    const page = await context.newPage();
    times.push(await usableAfter(page, address));
    await context.close();
  }
  say("opening", median(times));
}

/** Milliseconds of script, and of the main thread altogether, for each drawn frame of a run with all plots shown. */
async function measureFrames() {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, offline: true });
  const page = await context.newPage();
  await page.goto(`${address}#1&d=utube.md`);
  await page.locator("#play").waitFor();
  const hidden = page.locator(".plots-bar .chip[aria-pressed=false]:visible");
  while (await hidden.count()) await hidden.first().click();
  // All plots on the screen: what is out of sight might not be drawn.
  const height = await page.evaluate(() => document.documentElement.scrollHeight);
  await page.setViewportSize({ width: 1440, height: Math.max(900, height) });
  await page.locator("#speed").selectOption("8");
  await page.locator("#play").click();
  while ((await clock(page)) < ROWS * STEP) await page.waitForTimeout(250);
  await page.locator("#speed").selectOption("1");
  const { frames, script, thread } = await framesOf(context, page);
  say("plots", await page.locator("#plots canvas").count());
  say("frames-per-second", frames / SECONDS);
  say("script-per-frame", script / frames);
  say("thread-per-frame", thread / frames);
  await context.close();
}

/** The time that the page shows, in the unit of the model. */
async function clock(page) {
  return parseFloat(await page.locator("#clock").textContent());
}

/** What a playing page does in some seconds: its frames, and milliseconds of script and of the main thread altogether. */
async function framesOf(context, page) {
  const devtools = await context.newCDPSession(page);
  // Processor time of the thread, so that what else the machine does counts little.
  await devtools.send("Performance.enable", { timeDomain: "threadTicks" });
  const read = async () => {
    const { metrics } = await devtools.send("Performance.getMetrics");
    const value = (name) => metrics.find((metric) => metric.name === name).value * 1000;
    return { script: value("ScriptDuration"), thread: value("TaskDuration") };
  };
  await page.waitForTimeout(500);
  const start = await clock(page);
  const before = await read();
  const frames = await framesIn(page, SECONDS);
  const after = await read();
  if ((await clock(page)) === start) throw new Error("the simulation does not play while its frames are measured");
  return { frames, script: after.script - before.script, thread: after.thread - before.thread };
}

/** Frames of a system of many parts, its profile and its drawing in sight. */
async function measureProfile(name) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, offline: true });
  const page = await context.newPage();
  await page.goto(pathToFileURL(join(process.env.PROFILES, `${name}.html`)).href);
  await page.locator("#play").click();
  await page.waitForTimeout(1000);
  const { frames, script, thread } = await framesOf(context, page);
  say(`${name}-frames-per-second`, frames / SECONDS);
  say(`${name}-script-per-frame`, script / frames);
  say(`${name}-thread-per-frame`, thread / frames);
  await context.close();
}

/** Seconds until a long record is there, the longest task meanwhile, and frames a second over it. */
async function measureLongRecord() {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, offline: true });
  const page = await context.newPage();
  await page.goto(address);
  await page.locator("#play").waitFor();
  const reading = await page.evaluate(async (rows) => {
    const lines = ["t [s]\ty [m]"];
    for (let row = 0; row < rows; row += 1) {
      const time = (row * 60) / rows;
      const noise = 0.02 * (((row * 48271) % 65537) / 65537 - 0.5);
      lines.push(`${time.toFixed(6)}\t${(0.5 * Math.exp(-0.05 * time) * Math.cos(1.7 * time) + noise).toFixed(6)}`);
    }
    const transfer = new DataTransfer();
    transfer.items.add(new File([lines.join("\n")], "long.txt"));
    lines.length = 0;
    // What a person does comes between two tasks: the longest is how late the page may answer.
    await new Promise((done) => setTimeout(done, 200));
    let longest = 0;
    const take = (list) => list.forEach(({ duration }) => (longest = Math.max(longest, duration)));
    const observer = new PerformanceObserver((list) => take(list.getEntries()));
    observer.observe({ type: "longtask" });
    const start = performance.now();
    document.getElementById("apparatus").dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true }));
    while (!document.querySelector(".record") && performance.now() - start < 300_000) {
      await new Promise((done) => setTimeout(done, 20));
    }
    const seconds = (performance.now() - start) / 1000;
    // The record is drawn in the frames that follow.
    await new Promise((done) => setTimeout(done, 1000));
    take(observer.takeRecords());
    observer.disconnect();
    return { seconds, longest };
  }, LONG);
  say("long-record-seconds", reading.seconds);
  say("long-record-task", reading.longest);
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.locator("#play").click();
  await page.waitForTimeout(2000);
  say("long-record-frames", (await framesIn(page, SECONDS)) / SECONDS);
  await context.close();
}

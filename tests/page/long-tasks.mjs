// A measure, not a part of the tests: for each situation the longest task of the main thread and the number of tasks above 50 ms,
// as the Long Tasks API counts them, and the processor time of the tasks, which depends less on what else the machine does.
//
//     CHROME=.. PAGE=.. node --test long-tasks.mjs
//
// Each situation is repeated TIMES times (3), and the smallest of the longest counts: other programs make tasks longer, never shorter.
// ONLY="opening, fit" chooses situations. With TRACE=1 each long animation frame tells its scripts, and a profile is written to /tmp.
// A situation that did not take place fails. `workers` compares the time of a ranking by one worker with that by two, and `sweeps` the time
// of a plot over a parameter by the page itself, by one worker and by two.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { Lab, beside, eventually, labPage, temporary } from "./lab.mjs";
import { records } from "./measured.mjs";
import { withoutWorkers } from "./workers.mjs";

const TIMES = Number(process.env.TIMES ?? 3);
const ROWS = 1_000_000;
const PARTS = 50;
const LONG_TASK = 50;
const only = process.env.ONLY?.split(",").map((name) => name.trim());

/** Document of about 2,000 lines, as `crates/probe/src/long.rs` makes it. */
function longDocument() {
  const part = readFileSync(new URL("./../../crates/probe/systems/oscillator.md", import.meta.url), "utf8");
  const parts = Array.from({ length: PARTS }, (_, index) => part.replaceAll("@", String(index + 1)));
  return `---\ntitle: Fifty oscillators\nmethod: dormand-prince\nstep: 0.05 [s]\nuntil: 10 [s]\n---\n${parts.join("")}`;
}

/** A level in centimetres at 1,000 frames a second. */
function longRecord() {
  const rows = ["t [s],y [cm]"];
  for (let row = 0; row < ROWS; row += 1) rows.push(`${(row / 1000).toFixed(3)},${(5 * Math.exp(-row / 3e5) * Math.cos(row / 100)).toFixed(5)}`);
  return rows.join("\n");
}

/** Notes every long task of the page from its beginning, and with LoAF the scripts in it. */
function watch() {
  const noted = { tasks: [], frames: [] };
  window.noted = noted;
  const observe = (type, take) => new PerformanceObserver((list) => list.getEntries().forEach(take)).observe({ type, buffered: true });
  observe("longtask", ({ startTime, duration }) => noted.tasks.push([startTime, duration]));
  observe("long-animation-frame", ({ startTime, duration, scripts, styleAndLayoutStart }) => {
    const script = ({ invoker, duration, forcedStyleAndLayoutDuration }) => `${invoker} ${Math.round(duration)} (layout ${Math.round(forcedStyleAndLayoutDuration)})`;
    const layout = styleAndLayoutStart ? Math.round(startTime + duration - styleAndLayoutStart) : 0;
    noted.frames.push(`${Math.round(startTime)}: ${Math.round(duration)}, layout ${layout}; ${scripts.map(script).join(", ")}`);
  });
}

/** Chooses a file with the button of the header. */
const choose = (lab, path) => lab.page.locator("input[type=file]").first().setInputFiles(path);

async function openLong(lab) {
  const path = temporary("fifty.md");
  writeFileSync(path, longDocument());
  await choose(lab, path);
  await lab.page.getByRole("heading", { level: 1, name: "Fifty oscillators" }).waitFor({ timeout: 60_000 });
}

/** Takes the sample of the laboratory's tube. */
async function sample(lab) {
  await lab.tab("Measure");
  await lab.page.locator("#panel").getByRole("button", { name: /Column of 18 cm/ }).click();
  await records(lab).waitFor();
}

const isSwept = (lab) => eventually(async () => assert.equal(await lab.page.locator("figure.plot:visible .progress").count(), 0), 300);

/** Opens a pendulum that is started from 681 angles. */
async function openSweep(lab) {
  const path = temporary("swings.md");
  writeFileSync(path, readFileSync(beside("swings.md"), "utf8").replace("until: 60 ", "until: 600 "));
  await choose(lab, path);
  await lab.page.getByRole("heading", { level: 1, name: "Swings" }).waitFor();
  await eventually(async () => assert.equal(await lab.page.locator("figure.plot:visible .progress").count(), 1));
  await isSwept(lab);
}

const results = (lab) => lab.page.locator(".fits tbody tr").count();
const hasEnded = (lab, count) =>
  eventually(async () => {
    assert.ok((await results(lab)) >= count, "fits have arrived");
    assert.equal(await lab.page.locator("#cancel-fit").count(), 0);
  }, 120);

/** Situations: what comes before, and what is measured. Each measured part sees that it took place. */
const situations = {
  opening: [() => {}, (lab) => lab.page.reload()],
  typing: [
    async (lab) => {
      await openLong(lab);
      await lab.tab("Write");
      await lab.page.locator(".cm-content").waitFor();
      const line = lab.page.locator(".cm-line").filter({ hasText: /^parameter/ }).first();
      await line.click();
      await lab.page.keyboard.press("End");
    },
    async (lab) => {
      await lab.page.keyboard.type(" # the first of fifty", { delay: 60 });
      await lab.page.keyboard.press("Enter");
      await lab.page.keyboard.type("wrong +", { delay: 60 });
      await lab.page.locator(".cm-lintRange, .cm-lint-marker").first().waitFor({ timeout: 20_000 });
      for (let key = 0; key < 7; key += 1) await lab.page.keyboard.press("Backspace", { delay: 60 });
      await eventually(async () => assert.equal(await lab.page.locator(".cm-lint-marker-error").count(), 0), 20);
    },
  ],
  fit: [
    sample,
    async (lab) => {
      await lab.page.locator("#fit").click();
      await hasEnded(lab, 1);
    },
  ],
  ranking: [
    sample,
    async (lab) => {
      await lab.page.locator("#rank").click();
      await hasEnded(lab, 5);
    },
  ],
  import: [
    async () => writeFileSync(temporary("million.csv"), longRecord()),
    async (lab) => {
      await choose(lab, temporary("million.csv"));
      await records(lab).waitFor({ timeout: 120_000 });
    },
  ],
  document: [() => {}, openLong],
  sweep: [
    openSweep,
    async (lab) => {
      const slider = lab.slider(/^Friction/);
      await lab.play(slider);
      await slider.focus();
      for (let press = 0; press < 10; press += 1) await lab.page.keyboard.press("ArrowRight", { delay: 100 });
      await isSwept(lab);
    },
  ],
};

/** Processor time in milliseconds of the tasks of the page's main thread in a trace, the longest first. */
function ownTasks(trace) {
  const { traceEvents: events } = JSON.parse(trace.toString("utf8"));
  const place = ({ pid, tid }) => `${pid} ${tid}`;
  const mains = new Set(events.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain").map(place));
  const tasks = events.filter((event) => event.name === "RunTask" && event.tdur && mains.has(place(event)));
  return tasks.map(({ tdur }) => Math.round(tdur / 1000)).toSorted((one, other) => other - one);
}

/** One visit: its long tasks and the processor time of its tasks, in milliseconds, the longest first. */
async function once(name) {
  const [before, measured] = situations[name];
  const lab = await Lab.open({ fragment: "" });
  const browser = lab.context.browser();
  try {
    await lab.page.addInitScript(watch);
    if (name !== "opening") {
      await lab.page.reload();
      await before(lab);
      await lab.page.waitForTimeout(1500);
    }
    const begun = await lab.page.evaluate(() => performance.now());
    await browser.startTracing(lab.page, { categories: ["toplevel", "disabled-by-default-devtools.timeline", "__metadata", ...(process.env.TRACE ? ["disabled-by-default-v8.cpu_profiler"] : [])] });
    await measured(lab);
    // What follows in further tasks belongs to it.
    await lab.page.waitForTimeout(1500);
    const trace = await browser.stopTracing();
    const { tasks, frames } = await lab.page.evaluate(() => window.noted);
    const since = name === "opening" ? 0 : begun;
    if (process.env.TRACE) {
      frames.filter((frame) => parseInt(frame) >= since).forEach((frame) => console.log(`  ${name}, at ${frame}`));
      writeFileSync(`/tmp/long-tasks-${name}.json`, trace);
    }
    lab.wasQuiet();
    const own = tasks.filter(([start]) => start >= since).map(([, duration]) => Math.round(duration));
    return { tasks: own.toSorted((one, other) => other - one), processor: ownTasks(trace) };
  } finally {
    await lab.context.close();
  }
}

/** The list of the visit whose longest task is the shortest. */
const best = (lists) => lists.toSorted(([one = 0], [other = 0]) => one - other)[0];
const told = (list) => {
  const above = list.filter((duration) => duration > LONG_TASK);
  return `${list[0] ?? "below 50"} ms, ${above.length} above 50 ms${above.length > 1 ? ` (${above.slice(0, 8).join(", ")})` : ""}`;
};

for (const name of Object.keys(situations).filter((name) => only?.includes(name) ?? true)) {
  test(name, async () => {
    const visits = [];
    for (let time = 0; time < TIMES; time += 1) visits.push(await once(name));
    const [tasks, processor] = ["tasks", "processor"].map((list) => best(visits.map((visit) => visit[list])));
    console.log(`${name}: longest task ${told(tasks)}; processor time of a task ${told(processor)}`);
  });
}

/** Seconds until a sample is ranked by so many workers: the page has one for each processor, at most two. */
async function rankingTime(workers) {
  const lab = await Lab.open({ fragment: "" });
  try {
    await lab.page.addInitScript((workers) => Object.defineProperty(Navigator.prototype, "hardwareConcurrency", { get: () => workers }), workers);
    await lab.page.reload();
    await sample(lab);
    await lab.page.waitForTimeout(1500);
    const begun = Date.now();
    await situations.ranking[1](lab);
    return (Date.now() - begun) / 1000;
  } finally {
    await lab.context.close();
  }
}

if (only?.includes("workers") ?? true) {
  test("workers", async () => {
    const least = { 1: Infinity, 2: Infinity };
    for (let time = 0; time < TIMES; time += 1) for (const workers of [1, 2]) least[workers] = Math.min(least[workers], await rankingTime(workers));
    console.log(`ranking: ${least[1].toFixed(1)} s by one worker, ${least[2].toFixed(1)} s by two: ${(least[1] / least[2]).toFixed(2)} times faster`);
  });
}

/** Seconds until a plot over a parameter is complete after a change, with so many workers. */
async function sweepTime(workers) {
  const lab = await Lab.open({ fragment: "", file: workers ? labPage : withoutWorkers() });
  try {
    await lab.page.addInitScript((workers) => Object.defineProperty(Navigator.prototype, "hardwareConcurrency", { get: () => workers }), workers || 1);
    await lab.page.reload();
    await openSweep(lab);
    const slider = lab.slider(/^Friction/);
    await lab.play(slider);
    await slider.focus();
    const begun = Date.now();
    await lab.page.keyboard.press("ArrowRight");
    await eventually(async () => assert.equal(await lab.page.locator("figure.plot:visible .progress").count(), 1));
    await isSwept(lab);
    assert.equal(lab.page.workers().length, workers);
    return (Date.now() - begun) / 1000;
  } finally {
    await lab.context.close();
  }
}

if (only?.includes("sweeps") ?? true) {
  test("sweeps", async () => {
    const least = [Infinity, Infinity, Infinity];
    for (let time = 0; time < TIMES; time += 1) for (const workers of [0, 1, 2]) least[workers] = Math.min(least[workers], await sweepTime(workers));
    const [here, one, two] = least;
    console.log(`plot over a parameter: ${here.toFixed(2)} s by the page, ${one.toFixed(2)} s by one worker, ${two.toFixed(2)} s by two: ${(here / two).toFixed(2)} times faster`);
  });
}

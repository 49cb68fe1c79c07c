// A measure, not a part of the tests: COUNT hand-ins of a folder in the dashboard. How long it takes until all are shown and until all
// are computed, the tasks above 50 ms meanwhile, and the frames a second.
//
//     cargo run --release -p class --example hand_ins -- /tmp/class 2000
//     FOLDER=/tmp/class CHROME=.. PAGE=.. node --test measuring/class-pace.mjs
//
// 40 curves of 500 points: `hand_ins -- /tmp/forty 40 500`. The hand-ins arrive once more while frames are counted.

import { readdirSync } from "node:fs";
import { visit } from "../lab.mjs";
import { framesIn } from "../timing.mjs";

const { FOLDER } = process.env;
const SECONDS = 5;
const LIMIT = Number(process.env.LIMIT ?? 600);

/** Notes in the page when the folder was chosen, when all its files were shown and computed, and every task above 50 ms. */
function watch(count) {
  const noted = { begun: 0, shown: 0, computed: 0, tasks: [] };
  window.noted = noted;
  document.addEventListener("change", () => (noted.begun = performance.now()), { capture: true, once: true });
  const look = () => {
    const said = document.querySelector("#class-said")?.textContent ?? "";
    const sum = (said.match(/\d+/g) ?? []).reduce((sum, one) => sum + Number(one), 0);
    if (!noted.shown && sum >= count) noted.shown = performance.now();
    if (noted.shown && !said.includes("still to be computed")) noted.computed = performance.now();
    else requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
  const take = (list) => noted.tasks.push(...list.getEntries().map(({ startTime, duration }) => [startTime, duration]));
  new PerformanceObserver(take).observe({ type: "longtask" });
}

/** Chooses the folder. */
async function choose(lab) {
  await lab.page.locator("#class-folder-files").setInputFiles(FOLDER);
}

/** Until all are computed, or for LIMIT seconds. Data are compared afterwards. */
const computed = (lab) => lab.page.waitForFunction(() => window.noted.computed, undefined, { timeout: LIMIT * 1000 }).catch(() => {});

/** Frames a second, and milliseconds of processor time of the main thread for each, so that what else the machine does counts less. */
async function frames(lab) {
  const devtools = await lab.context.newCDPSession(lab.page);
  await devtools.send("Performance.enable", { timeDomain: "threadTicks" });
  const thread = async () => (await devtools.send("Performance.getMetrics")).metrics.find(({ name }) => name === "TaskDuration").value * 1000;
  const before = await thread();
  const count = await framesIn(lab.page, SECONDS);
  const work = (await thread()) - before;
  return `${(count / SECONDS).toFixed(1)} frames a second, ${(work / count).toFixed(1)} ms of the main thread for each`;
}

visit("hand-ins of a folder", async (lab) => {
  const count = readdirSync(FOLDER).length;
  await lab.tab("Class");
  await lab.page.locator("#open-class").click();
  await lab.page.evaluate(watch, count);
  await choose(lab);
  await computed(lab);
  await lab.page.waitForTimeout(500);
  const { begun, shown, computed: end, tasks } = await lab.page.evaluate(() => window.noted);
  const own = tasks.filter(([start]) => start >= begun).map(([, duration]) => Math.round(duration));
  const seconds = (from, to) => ((to - from) / 1000).toFixed(2);
  const said = await lab.page.locator("#class-said").innerText();
  console.log(`${count} hand-ins: shown after ${seconds(begun, shown)} s, ${end ? `computed after ${seconds(begun, end)} s` : said}`);
  console.log(`${own.length} tasks above 50 ms: ${own.toSorted((one, other) => other - one).slice(0, 20).join(", ")}`);
  if (process.env.TRACE) for (const [start, duration] of tasks) console.log(`  at ${Math.round(start - begun)} ms: ${Math.round(duration)} ms`);

  const scrolled = () => lab.page.evaluate(() => {
    const room = document.querySelector("#class");
    let direction = 8;
    const step = () => {
      if (room.scrollTop + room.clientHeight >= room.scrollHeight - 1) direction = -8;
      if (room.scrollTop <= 0) direction = 8;
      room.scrollTop += direction;
      window.scrolling = requestAnimationFrame(step);
    };
    step();
  });
  await scrolled();
  const still = await frames(lab);
  await choose(lab);
  const arriving = await frames(lab);
  console.log(`while scrolling: ${still}`);
  console.log(`and while they arrive once more: ${arriving}`);
});

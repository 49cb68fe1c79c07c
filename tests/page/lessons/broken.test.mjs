// What breaks in a lesson: the network of a student, a tab that is killed while it sends, the teacher's computer that sleeps, and a proxy
// that keeps streams back.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { eventually, temporary } from "../lab.mjs";
import { Proxy, answer, join, school, shows, start, status, stored, teach } from "./class.mjs";

const { visitor, faults } = school();

/** A test with a class of its own. `proxy` puts a proxy before the server, `what` names the documents. */
const lesson = (title, does, what) =>
  test(title, async () => {
    const server = await start({ what });
    const proxies = [];
    const proxy = async (options) => {
      proxies.push(await Proxy.before(server.port, options));
      return proxies.at(-1);
    };
    try {
      await does(server, proxy);
      assert.deepEqual(faults, []);
    } finally {
      server.child.kill("SIGKILL");
      proxies.forEach((one) => one.end());
    }
  });

const DOCUMENT = "/d/utube.md";
const MINUTE = 60_000;

/** The answers to the first question that the server has of the student of this page. */
async function answers(page, server) {
  const { "hand-ins": handIns, events } = await stored(page, server.base);
  assert.equal(new Set(events.map(({ seq }) => seq)).size, events.length, "each number is stored once");
  const items = handIns.flatMap((text) => JSON.parse(text).work.items);
  return items.flatMap(({ item }) => item.item.answer?.attempts ?? []).map(({ typed }) => typed);
}

lesson("a minute without network: the page goes on, also after a reload of the file; afterwards all is handed in", async (server) => {
  const student = await visitor();
  await student.clock.install();
  await join(student, server.code, `${server.base}${DOCUMENT}`);
  await answer(student, "0.21");
  await status(student, /^Everything is handed in/);
  // The file for the class, which opens without a network.
  await student.getByText("My seat").click();
  const download = student.waitForEvent("download");
  await student.getByRole("button", { name: "Get the file for this class" }).click();
  const file = temporary("minute.html");
  await (await download).saveAs(file);
  const text = readFileSync(file, "utf8");
  await student.getByText("My seat").click();
  writeFileSync(file, text.replaceAll(text.match(/connect-src (http:[^"]*)"/)[1], server.base));
  const disk = await visitor();
  await disk.clock.install();
  await disk.goto(pathToFileURL(file).href);

  for (const [page, before, first, second] of [
    [student, ["0.21"], "0.22", "0.23"],
    // The file is another device of the seat: its answers follow what the server has.
    [disk, ["0.21", "0.22", "0.23"], "0.24", "0.25"],
  ]) {
    const context = page.context();
    await status(page, /^(Nothing|Everything) is handed in/);
    await context.setOffline(true);
    await answer(page, first);
    await status(page, /not handed in yet.*cannot be reached/);
    // The clock of the page is moved on by half a minute, twice.
    await page.clock.fastForward(MINUTE / 2);
    if (page === disk) {
      await page.reload();
      await page.locator("#class-bar strong").waitFor();
    }
    await answer(page, second);
    await page.clock.fastForward(MINUTE / 2);
    await status(page, /not handed in yet.*cannot be reached/);
    await context.setOffline(false);
    await status(page, /^Everything is handed in/);
    assert.deepEqual(await answers(student, server), [...before, first, second]);
  }
});

lesson("a tab is killed while it sends, before the server has stored the part and after: nothing is lost, nothing doubled", async (server, proxy) => {
  const teacher = await visitor();
  await teach(teacher, server);
  let [hold, reached] = ["", () => {}];
  // A request that is held is never passed on, or its answer never is.
  const at = (place) => ({ url }) => {
    if (url !== "/api/events" || hold !== place) return undefined;
    hold = "";
    reached();
    return new Promise(() => {});
  };
  const between = await proxy({ asked: at("asked"), answered: at("answered") });
  const student = await visitor();
  await join(student, server.code, `${between.base}${DOCUMENT}`);
  await answer(student, "0.31");
  await status(student, /^Everything is handed in/);
  let tab = student;
  for (const [place, text, count] of [["asked", "0.32", 2], ["answered", "0.33", 3]]) {
    const held = new Promise((done) => (reached = done));
    hold = place;
    await answer(tab, text);
    await held;
    const before = (await stored(tab, server.base)).events.length;
    const crashed = tab.waitForEvent("crash");
    const devtools = await tab.context().newCDPSession(tab);
    devtools.send("Page.crash").catch(() => {});
    await crashed;
    const again = await tab.context().newPage();
    await tab.close();
    tab = again;
    await tab.goto(`${between.base}${DOCUMENT}`);
    await status(tab, /^Everything is handed in/);
    assert.deepEqual(await answers(tab, server), ["0.31", "0.32", "0.33"].slice(0, count));
    const more = (await stored(tab, server.base)).events.length - before;
    assert.ok(place === "asked" ? more > 0 : more === 0, `${place}: ${more} more events`);
    await shows(teacher, new RegExp(`${text} instead of`.replace(".", "\\.")));
  }
});

lesson("two tabs of a seat add to one outbox at the same moment: both parts are handed in", async (server) => {
  const one = await visitor();
  await join(one, server.code, `${server.base}${DOCUMENT}`);
  const other = await one.context().newPage();
  await other.goto(`${server.base}/d/pendulum.md`);
  await status(other, /^Nothing is handed in/);
  await one.context().setOffline(true);
  // Another process sees what this one stores a little later: until `late` ends, this tab sees the storage as it was.
  await one.evaluate(() => {
    const before = { ...localStorage };
    const { getItem, removeItem } = Storage.prototype;
    const whole = window.localStorage;
    Storage.prototype.getItem = (key) => before[key] ?? null;
    Object.defineProperty(window, "localStorage", { configurable: true, get: () => new Proxy(whole, {
      ownKeys: () => Object.keys(before),
      get: (_, name) => (typeof whole[name] === "function" ? whole[name].bind(whole) : whole[name]),
    }) });
    window.late = () => {
      Object.assign(Storage.prototype, { getItem, removeItem });
      Object.defineProperty(window, "localStorage", { configurable: true, get: () => whole });
    };
  });
  await answer(other, "1.5");
  await status(other, /not handed in yet/);
  await answer(one, "0.71");
  const waiting = () => Object.entries(localStorage).filter(([key]) => key.includes(":waiting:")).map(([, text]) => text);
  await eventually(async () => assert.match((await other.evaluate(waiting)).join(), /0\.71/));
  await one.evaluate(() => window.late());
  await one.context().setOffline(false);
  for (const tab of [one, other]) await status(tab, /^Everything is handed in/);
  assert.deepEqual((await answers(one, server)).toSorted(), ["0.71", "1.5"]);
}, ["simulations/utube.md", "simulations/pendulum.md"]);

lesson("what a tab could not hand in, another tab of the seat does: no tab goes on to say that the class cannot be reached", async (server) => {
  const one = await visitor();
  await join(one, server.code, `${server.base}${DOCUMENT}`);
  await status(one, /^(Nothing|Everything) is handed in/);
  // The stream of this tab goes on, so that nothing else tells it.
  await one.route("**/api/events", (route) => route.abort());
  await answer(one, "0.81");
  await status(one, /not handed in yet.*cannot be reached/);
  const other = await one.context().newPage();
  await other.goto(`${server.base}${DOCUMENT}`);
  for (const tab of [other, one]) await status(tab, /^Everything is handed in/);
  assert.deepEqual(await answers(one, server), ["0.81"]);
});

lesson("the teacher's computer sleeps while students go on; when it wakes, the dashboard shows all without a reload", async (server, proxy) => {
  const between = await proxy();
  const teacher = await visitor();
  await teach(teacher, { link: server.link.replace(server.base, between.base) });
  const [one, other] = [await visitor(), await visitor()];
  await join(one, server.code, `${server.base}${DOCUMENT}`);
  await answer(one, "0.41");
  await shows(teacher, /0\.41 instead of/);
  await teacher.evaluate(() => (window.unbroken = true));

  // All connections stay open and silent, and no script runs.
  const devtools = await teacher.context().newCDPSession(teacher);
  between.sleep();
  await devtools.send("Page.setWebLifecycleState", { state: "frozen" });
  await answer(one, "0.42");
  await join(other, server.code, `${server.base}${DOCUMENT}`);
  await answer(other, "0.43");
  for (const page of [one, other]) await status(page, /^Everything is handed in/);
  await devtools.send("Page.setWebLifecycleState", { state: "active" });
  assert.doesNotMatch(await teacher.locator("#class").innerText(), /0\.4[23]/, "nothing comes through a dead connection");
  between.wake();
  // The clock has gone on meanwhile.
  await teacher.evaluate(() => {
    const { now } = Date;
    Date.now = () => now() + 3_600_000;
  });
  await shows(teacher, /2 groups/);
  await shows(teacher, /0\.42 instead of[^]*0\.43 instead of|0\.43 instead of[^]*0\.42 instead of/);
  assert.match(await teacher.locator("#class-bar").innerText(), /2 joined, 2 have handed in/);
  assert.equal(await teacher.evaluate(() => window.unbroken), true, "without a reload");
});

lesson("a proxy keeps streams back: teacher and students ask instead", async (server, proxy) => {
  const between = await proxy({ swallows: true });
  const teacher = await visitor();
  await teach(teacher, { link: server.link.replace(server.base, between.base) });
  const student = await visitor();
  await join(student, server.code, `${between.base}${DOCUMENT}`);
  await answer(student, "0.51");
  await shows(teacher, /0\.51 instead of/);
  await teacher.getByLabel("Class paused", { exact: true }).check();
  await student.getByText("Your teacher has paused the class.").waitFor();
});

lesson("a request that took too long, and one that was too large: each is said in its own words, and all is handed in later", async (server) => {
  const student = await visitor();
  await join(student, server.code, `${server.base}${DOCUMENT}`);
  await answer(student, "0.61");
  await status(student, /^Everything is handed in/);
  const typed = ["0.61"];
  for (const [code, why, sentence, text] of [
    [408, "slow", /not handed in yet.*took too long/, "0.62"],
    [413, "large", /not handed in yet.*too large for the class/, "0.63"],
    [413, "seat_full", /not handed in yet.*seat has no more room/, "0.64"],
  ]) {
    await student.route("**/api/events", (route) => route.fulfill({ status: code, json: { why } }));
    await answer(student, text);
    await status(student, sentence);
    await student.unroute("**/api/events");
    await status(student, /^Everything is handed in/, 60);
    typed.push(text);
    assert.deepEqual(await answers(student, server), typed);
  }
});

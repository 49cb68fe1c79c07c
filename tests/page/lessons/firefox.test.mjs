// One lesson in Firefox, driven by WebDriver BiDi: from joining to a part that the server has on disk, over a server that is down.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch } from "puppeteer-core";
import { eventually } from "../lab.mjs";
import { start, stop } from "./class.mjs";

let browser;
before(async () => {
  const executablePath = process.env.FIREFOX ?? assert.fail("FIREFOX must name the browser; `cargo xtask test` finds it");
  const preferences = { "intl.accept_languages": "en-GB" };
  browser = await launch({ browser: "firefox", executablePath, headless: true, defaultViewport: null, extraPrefsFirefox: preferences });
});
after(() => browser?.close());

test("a student joins, answers, sees that the server is down and back, and everything is handed in", async () => {
  let server = await start();
  try {
    const page = await browser.newPage();
    const faults = [];
    page.on("pageerror", (error) => faults.push(String(error)));
    const status = (pattern, seconds = 20) =>
      eventually(async () => assert.match(await page.$eval("#class-status", (line) => line.textContent), pattern), seconds);
    const find = (selector) => page.waitForSelector(selector, { visible: true });
    const answer = async (text) => {
      const field = await find("[role=tabpanel]:not([hidden]) input");
      await field.click({ count: 3 });
      await field.type(text);
      await page.keyboard.press("Enter");
    };
    await page.goto(`${server.base}/#join=${server.code}`);
    await (await find("#class-bar form button")).click();
    await find("#class-mine summary");
    await (await find("#tab-questions")).click();
    await answer("0.31");
    await status(/^Everything is handed in/);
    await stop(server, "SIGKILL");
    await status(/^The class cannot be reached/);
    server = await start(server);
    await status(/^Everything is handed in/, 60);
    await answer("0.32");
    const token = await page.evaluate(() => JSON.parse(Object.entries(localStorage).find(([key]) => key.endsWith(":seat"))[1]).token);
    const mine = async () => (await fetch(`${server.base}/api/mine`, { headers: { authorization: `Bearer ${token}` } })).json();
    const typed = async () => {
      const { work } = JSON.parse((await mine())["hand-ins"][0]);
      return work.items.flatMap(({ item }) => item.item.answer?.attempts ?? []).map(({ typed }) => typed);
    };
    await eventually(async () => assert.deepEqual(await typed(), ["0.31", "0.32"]), 20);
    const { events } = await mine();
    assert.equal(new Set(events.map(({ seq }) => seq)).size, events.length);
    await status(/^Everything is handed in/);
    assert.deepEqual(faults, []);
  } finally {
    server.child.kill("SIGKILL");
  }
});

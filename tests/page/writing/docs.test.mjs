// The documentation as a site (`cargo xtask docs`): its examples play where they stand and can be edited, search finds, nothing is
// loaded before it is needed, and without scripts text and pictures remain.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { dirname, extname, join, normalize } from "node:path";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { Lab, eventually, labPage } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const TYPES = { ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".json": "application/json", ".svg": "image/svg+xml", ".png": "image/png" };
const folder = join(dirname(labPage), "docs");

let server;
let address;
/** Bytes of each file that was sent, as servers compress it. */
let sent = new Map();

before(async () => {
  assert.ok(existsSync(folder), `${folder} is missing: cargo xtask docs`);
  server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://host").pathname));
    try {
      const content = readFileSync(join(folder, path));
      const type = TYPES[extname(path)] ?? "application/octet-stream";
      sent.set(path, /text|json|svg/.test(type) ? gzipSync(content).length : content.length);
      response.writeHead(200, { "Content-Type": type }).end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  address = `http://127.0.0.1:${server.address().port}/`;
});

after(() => server?.close());

function visit(name, title, does, options = {}) {
  test(title, async () => {
    const lab = await Lab.open({ ...options, address: () => address + name });
    try {
      await does(lab.page, lab);
      assert.deepEqual(lab.faults, [], "errors in the page");
      assert.deepEqual(lab.requests.filter((url) => !url.startsWith(address)), [], "requests to others");
    } finally {
      await lab.context.close();
    }
  });
}

/** The frame of an example plays. */
async function plays(page, example) {
  await example.locator("meniscus-simulation").scrollIntoViewIfNeeded();
  const inside = example.frameLocator("iframe");
  await inside.locator("#play").waitFor();
  if (!(await inside.locator("#play.playing").count())) await inside.locator("#play").click();
  await eventually(async () => assert.ok(parseFloat((await inside.locator("#clock").innerText()).replace(",", ".")) > 0));
}

visit("language.html", "the reference is small before an example comes near; its first example plays", async (page) => {
  await page.getByRole("heading", { level: 1 }).waitFor();
  await page.waitForLoadState("networkidle");
  const bytes = [...sent.values()].reduce((sum, size) => sum + size, 0);
  console.log(`first load of the reference: ${bytes} bytes; ${[...sent].filter(([, size]) => size > 20_000).join(" ")}`);
  assert.ok(bytes <= 700_000, `${bytes} bytes`);
  await plays(page, page.locator(".example:has(meniscus-simulation)").first());
});

visit("index.html", "the example of the first page is edited: it follows its text, which is told what is wrong", async (page) => {
  const example = page.locator(".example").first();
  await plays(page, example);
  await example.getByRole("button", { name: "Edit" }).click();
  const text = example.getByRole("textbox", { name: "Text of the example" });
  const before = await text.inputValue();
  await text.fill(before.replace('"Stiffness"', '"Hardness"'));
  const inside = example.frameLocator("iframe");
  await inside.getByRole("slider", { name: "Hardness" }).waitFor();
  await text.fill(before.replace("m*x''", "m*x'"));
  await eventually(async () => assert.match(await example.locator("[role=status]").innerText(), /^4: .+/));
  await text.fill(before);
  await inside.getByRole("slider", { name: "Stiffness" }).waitFor();
  assert.ok(await example.locator("[role=status]").isHidden());
});

visit("language.html", "an example that is wrong on purpose says so when it is edited, as the text below it does", async (page) => {
  const wrong = await page.evaluate(() => [...document.querySelectorAll(".example")].findIndex((example) => !example.querySelector("meniscus-simulation")));
  const example = page.locator(".example").nth(wrong);
  const expected = await example.locator("xpath=following-sibling::pre[1]").innerText();
  await example.getByRole("button", { name: "Edit" }).click();
  await eventually(async () => {
    const [, message] = /^(?:error|warning): (.*)/.exec(expected);
    assert.ok((await example.locator("[role=status]").innerText()).includes(message), message);
  });
});

visit("index.html", "search finds a section, by keyboard", async (page) => {
  await page.keyboard.press("/");
  await page.keyboard.type("dry friction");
  await page.locator("#search li a", { hasText: /^Dry friction/ }).first().click();
  await page.waitForURL(/language\.html#dry-friction$/);
});

for (const [theme, width] of [["light", 1440], ["dark", 390]]) {
  visit("questions.html", `axe finds nothing: ${theme}, ${width}`, async (page) => {
    await page.getByRole("heading", { level: 1 }).waitFor();
    await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth || document.title === "").then((fits) => assert.ok(fits, "wider than the window"));
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run(document, { iframes: false }));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html)}`), []);
  }, { theme, width, motion: "reduce" });
}

test("without scripts there are text and pictures", async () => {
  const lab = await Lab.open({ address: () => `${address}index.html` });
  const context = await lab.context.browser().newContext({ javaScriptEnabled: false });
  try {
    const page = await context.newPage();
    await page.goto(`${address}index.html`);
    const picture = page.locator(".example img").first();
    await picture.scrollIntoViewIfNeeded();
    assert.ok(await picture.isVisible());
    assert.ok((await picture.boundingBox()).height > 50);
    assert.ok(await page.locator(".example pre").first().isVisible());
  } finally {
    await context.close();
    await lab.context.close();
  }
});

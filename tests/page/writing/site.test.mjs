// The site that `meniscus build` makes: on a web server, in a folder of it, without a network after the first visit, and
// from a disk.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { extname, join, normalize } from "node:path";
import { after, before, test } from "node:test";
import { readCode } from "../codes.mjs";
import { Lab, STILL, eventually, meniscus, temporary, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const TYPES = { ".html": "text/html", ".css": "text/css", ".js": "text/javascript" };

let site;
let server;
let address;
/** What was asked of the server since it was last looked at. */
let asked = [];

before(async () => {
  site = temporary("site");
  meniscus("build", "simulations", "--output", site);
  server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://host").pathname);
    asked.push(path);
    try {
      if (!path.startsWith("/physics/")) throw new Error("not in the folder");
      const file = join(site, normalize(path.slice("/physics".length)).replace(/[/\\]$/, "/index.html"));
      const content = readFileSync(file);
      response.writeHead(200, { "Content-Type": TYPES[extname(file)] ?? "application/octet-stream" }).end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  address = `http://127.0.0.1:${server.address().port}/physics/`;
});

after(() => server?.close());

/** A test: somebody visits the site, with a network until it is taken away. */
function online(title, options, does) {
  test(title, async () => {
    const lab = await Lab.open({ ...options, address: () => address });
    try {
      await does(lab);
      assert.deepEqual(lab.faults, [], "errors in the page");
      const elsewhere = lab.requests.filter((url) => !url.startsWith(address));
      assert.deepEqual(elsewhere, [], "requests to others");
    } finally {
      await lab.context.close();
    }
  });
}

/** Until the service worker has kept everything. */
const kept = (page) => eventually(() => page.evaluate(async () => {
  if (!navigator.serviceWorker.controller) throw new Error("no service worker yet");
}));

online("from the list to a simulation, and on to the laboratory with what was set", {}, async (lab) => {
  const { page } = lab;
  await page.getByRole("link", { name: "Oscillations of a liquid in a U-tube" }).click();
  await page.getByRole("heading", { level: 1, name: "Oscillations of a liquid in a U-tube" }).waitFor();
  await lab.enter("Damping", "321");
  await page.getByRole("link", { name: "Open in the laboratory" }).click();
  await page.getByRole("tab", { name: "Measure" }).waitFor();
  assert.equal(await lab.number("Damping"), 321);
  await page.goBack();
  await page.getByRole("link", { name: "All simulations" }).click();
  await page.getByRole("heading", { name: "A bouncing ball" }).waitFor();
});

online("the editor of the laboratory is asked for when it is first opened, and kept for visits without a network", {}, async (lab) => {
  const { page } = lab;
  await kept(page);
  await lab.context.setOffline(true);
  await page.goto(`${address}laboratory.html`);
  await page.getByRole("heading", { level: 1 }).waitFor();
  const scripts = () => page.locator('script[src*="editor-"]').count();
  assert.equal(await scripts(), 0);
  await lab.tab("Write");
  await page.locator(".cm-content").waitFor();
  assert.equal(await scripts(), 1);
  await eventually(async () => assert.match(await page.locator("#writing-status").innerText(), /^No errors/));
});

online("a document of the site is published: the player comes when it is wanted, and the frame has the address of its page", {}, async (lab) => {
  const { page } = lab;
  await kept(page);
  await lab.context.setOffline(true);
  await page.goto(`${address}laboratory.html#1&d=pendulum.md`);
  await page.getByRole("heading", { level: 1, name: /The pendulum/ }).waitFor();
  const scripts = () => page.locator('script[src*="publish-"]').count();
  assert.equal(await scripts(), 0);
  await page.locator("#share").click();
  await eventually(async () => assert.match(await page.locator("#page-size").innerText(), /^[0-9]+ kB$/));
  assert.equal(await scripts(), 1);
  assert.equal(await page.locator("#frame-address").inputValue(), `${address}pendulum.html`);
  const { text } = await lab.save(page.locator("#save-page"));
  const file = temporary("from-site.html");
  writeFileSync(file, text);
  const played = await Lab.open({ file });
  try {
    await played.press("Play");
    await played.watchUntil(0.2);
    played.wasQuiet();
  } finally {
    await played.context.close();
  }
});

test("the QR code of a laboratory on the web holds its link", async () => {
  const web = address.replace("127.0.0.1", "lan.test");
  const lab = await Lab.open({ address: () => `${web}laboratory.html#1&d=pendulum.md` });
  try {
    await lab.page.locator("#share").click();
    await lab.page.locator("#qr").click();
    const link = await eventually(() => readCode(lab.page));
    assert.match(link, /^http:\/\/lan\.test:[0-9]+\/physics\/laboratory\.html#1&d=pendulum\.md/);
  } finally {
    await lab.context.close();
  }
});

online("after one visit every page opens without a network", {}, async (lab) => {
  const { page } = lab;
  await kept(page);
  await lab.context.setOffline(true);
  asked = [];
  for (const [path, title] of [
    ["", "Simulations"],
    ["pendulum.html", "The pendulum, small swings and large"],
    // Many hosts leave out the ending.
    ["theories/linear", "Linear damping"],
    ["laboratory.html", "A bouncing ball"],
  ]) {
    await page.goto(address + path);
    await page.getByRole("heading", { level: 1, name: title }).waitFor();
  }
  await page.goto(`${address}utube.html`);
  await lab.press("Play");
  await lab.watchUntil(0.2);
  assert.deepEqual(asked, []);
});

online("pages share their files: the second one asks for its own text alone", {}, async (lab) => {
  await kept(lab.page);
  asked = [];
  await lab.go(`${address}pendulum.html`);
  await lab.go(`${address}utube.html`);
  assert.deepEqual(asked.filter((path) => !path.endsWith(".html")), []);
});

online("a new version of the site reaches who has visited the last one", {}, async (lab) => {
  const { page } = lab;
  await kept(page);
  const changed = temporary("changed");
  const before = site;
  meniscus("build", "simulations/theories", "--output", changed);
  site = changed;
  try {
    // The browser looks for another service worker once the page has been there for a moment.
    await page.reload();
    await eventually(async () => assert.equal(await page.evaluate(async () => (await caches.keys()).length), 2));
    await eventually(async () => assert.equal(await page.evaluate(async () => (await navigator.serviceWorker.ready).installing), null));
    await page.reload();
    assert.equal(await page.getByRole("heading", { name: "A bouncing ball" }).count(), 0);
    assert.equal(await page.getByRole("heading", { name: "Linear damping", exact: true }).count(), 1);
  } finally {
    site = before;
  }
});

online("the list in Spanish, on a phone, leads to Spanish pages", { language: "es-CO", width: 390, height: 844, theme: "dark" }, async (lab) => {
  const { page } = lab;
  await page.getByRole("heading", { level: 1, name: "Simulaciones" }).waitFor();
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing is cut at the side");
  await page.getByRole("link", { name: "EN", exact: true }).click();
  await page.getByRole("heading", { level: 1, name: "Simulations" }).waitFor();
  await page.getByRole("link", { name: "Español" }).first().click();
  await page.getByRole("tab", { name: "Explorar" }).waitFor();
});

for (const theme of ["light", "dark"]) {
  online(`the list can be used by everyone (${theme})`, { ...STILL, theme }, async (lab) => {
    await lab.page.addScriptTag({ content: axe }).catch(() => lab.page.evaluate(axe));
    const { violations } = await lab.page.evaluate(() => globalThis.axe.run());
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(" ")}`), []);
    lab.faults = lab.faults.filter((fault) => !fault.includes("Content Security Policy"));
  });
}

visit("a page of the site opens from a disk as well", { file: () => join(site, "pendulum.html") }, async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(0.2);
  // A disk is not asked over a network; all its files are those of the site.
  lab.requests = lab.requests.filter((url) => !url.startsWith("file:"));
});

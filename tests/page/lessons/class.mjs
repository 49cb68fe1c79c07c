// A lesson with `meniscus class serve`: the program, the teacher and students in their browsers, and networks between them that fail.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { Agent, createServer, request } from "node:http";
import { after, before } from "node:test";
import { chromium } from "playwright-core";
import { eventually, program, temporary } from "../lab.mjs";

let stores = 0;

/** A port on which nothing listens. Another test that takes the next free one does not get it while a server is down. */
async function free() {
  const server = createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = server.address();
  await new Promise((done) => server.close(done));
  return String(port);
}

/** Starts the program, at the port of an earlier start if there was one; what the screen says. `begin`: `--new` begins another class. */
export async function start({ port, what = ["simulations/utube.md"], store = temporary(`class-${(stores += 1)}.sqlite`), begin = "--continue" } = {}) {
  const words = ["class", "serve", ...what, "--store", store, begin, "--port", port ?? (await free())];
  const child = spawn(program, words, { cwd: new URL("../../..", import.meta.url).pathname, stdio: ["ignore", "ignore", "pipe"] });
  let said = "";
  child.stderr.on("data", (data) => (said += data));
  const find = (pattern) => eventually(() => said.match(pattern)?.[1] ?? assert.fail(said), 30);
  const [code, link] = [await find(/code: (\w{6})\n/), await find(/(http:\S+#link=\S+)\n/)];
  return { child, code, link, store, base: link.split("/teacher")[0], port: link.match(/:(\d+)\//)[1] };
}

export async function stop({ child }, signal = "SIGINT") {
  if (child.exitCode !== null || child.signalCode !== null) return;
  child.kill(signal);
  await once(child, "exit");
}

/** Chromium for the tests of a file: `visitor` opens a page in a browser of its own, `faults` collects the errors of all pages. */
export function school() {
  const faults = [];
  let browser;
  before(async () => {
    assert.ok(process.env.CHROME, "CHROME must name the browser; `cargo xtask test` finds it");
    browser = await chromium.launch({ executablePath: process.env.CHROME, args: ["--no-sandbox", "--disable-gpu"] });
  });
  after(() => browser?.close());
  const watched = (page) => page.on("pageerror", (error) => faults.push(String(error)));
  const visitor = async (options = {}) => {
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, acceptDownloads: true, ...options });
    context.setDefaultTimeout(30_000);
    context.on("page", watched);
    return context.newPage();
  };
  return { visitor, faults };
}

/** A student joins with a code; the pseudonym. */
export async function join(page, code, address) {
  await page.goto(address);
  await page.getByLabel("Code of the class").fill(code);
  await page.getByRole("button", { name: "Join" }).click();
  await page.getByText("My seat").waitFor();
  return page.locator("#class-bar strong").innerText();
}

/** The teacher opens the one-time link; the dashboard is open. */
export async function teach(page, { link }) {
  await page.goto(link);
  await page.locator("#class[open] #class-live").waitFor();
}

export async function answer(page, text) {
  await page.getByRole("tab", { name: "Questions" }).click();
  const field = page.getByRole("tabpanel").getByRole("textbox").first();
  await field.fill(text);
  await field.press("Enter");
}

export const status = (page, pattern, seconds = 30) =>
  eventually(async () => assert.match(await page.locator("#class-status").innerText(), pattern), seconds);

export const shows = (page, pattern, seconds = 30) =>
  eventually(async () => assert.match(await page.locator("#class").innerText(), pattern), seconds);

/** All that the server has of the student of this page: events, and the hand-ins that follow from them. */
export async function stored(page, base) {
  const token = await page.evaluate(() => {
    const key = Object.keys(localStorage).find((key) => key.endsWith(":seat"));
    return JSON.parse(localStorage.getItem(key)).token;
  });
  return (await fetch(`${base}/api/mine`, { headers: { authorization: `Bearer ${token}` } })).json();
}

/** A proxy before the server. `asked` and `answered` are awaited before a request is passed on and before its answer is; streams are kept
    back if `swallows`. `sleep` leaves all connections open and silent, for ever; those made after `wake` work. */
export class Proxy {
  static async before(port, { asked = () => {}, answered = () => {}, swallows = false } = {}) {
    const proxy = Object.assign(new Proxy(), { asked, answered, swallows, agent: new Agent(), dead: new WeakSet(), live: new Set(), asleep: false });
    proxy.server = createServer((from, to) => proxy.pass(from, to, port).catch(() => to.destroy()));
    await new Promise((done) => proxy.server.listen(0, "127.0.0.1", done));
    proxy.base = `http://127.0.0.1:${proxy.server.address().port}`;
    return proxy;
  }

  async pass(from, to, port) {
    const body = await from.toArray();
    this.live.add(to);
    to.on("close", () => this.live.delete(to));
    if (this.asleep) this.dead.add(to);
    await this.asked(from);
    const { method, url: path, headers } = from;
    const answer = await new Promise((done, failed) => {
      const onward = request({ host: "127.0.0.1", port, method, path, headers, agent: this.agent }, done).on("error", failed);
      to.on("close", () => onward.destroy());
      onward.end(Buffer.concat(body));
    });
    await this.answered(from);
    if (this.dead.has(to)) return;
    const isKept = this.swallows && answer.headers["content-type"] === "text/event-stream";
    if (!isKept) to.writeHead(answer.statusCode, answer.headers).flushHeaders();
    answer.on("data", (piece) => isKept || this.dead.has(to) || to.write(piece));
    answer.on("end", () => isKept || this.dead.has(to) || to.end());
    answer.on("error", () => {});
  }

  sleep() {
    this.asleep = true;
    for (const one of this.live) this.dead.add(one);
  }

  wake() {
    this.asleep = false;
  }

  end() {
    this.server.close();
    this.server.closeAllConnections();
    this.agent.destroy();
  }
}

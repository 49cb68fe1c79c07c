// A person at the laboratory: finds things by what they are called, as a screen reader does, and does with them what
// hands do. Every visit is without a network, and fails if the page asks anyone for anything or throws an error.
//
// | folder | tests |
// |---|---|
// | `playing` | simulations, player and courses in Chromium; the main path in Firefox |
// | `measuring` | records, films, fits, hand-ins and classes |
// | `writing` | editor, forms, drawing, publishing and sites |
// | `lessons` | the class server with its students and teacher |
// | `browsers` | browsers that are too old or just new enough |
// | `films` | films with their truth, for `films.mjs` |

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const root = join(dirname(fileURLToPath(import.meta.url)), "..", "..");
export const program = process.env.MENISCUS ?? join(root, "target", "debug", "meniscus");
export const labPage = process.env.PAGE ?? join(root, "target", "page", "meniscus.html");

/** What of the browser has no part in a page. Each window would begin two pages for the suggestions of its address bar, which take as
    much of the processor as ours; the rest is what Playwright turns off, whose list this one replaces. */
const FEATURES = [
  "WebUIOmniboxPopup",
  "WebUIOmniboxAimPopup",
  "AimEnabled",
  "AvoidUnnecessaryBeforeUnloadCheckSync",
  "DestroyProfileOnBrowserClose",
  "HttpsFirstBalancedModeAutoEnable",
  "HttpsUpgrades",
  "LensOverlay",
  "MediaRouter",
  "NetworkTimeServiceQuerying",
  "OptimizationHints",
  "PaintHolding",
  "PreconnectToSearch",
  "ThirdPartyStoragePartitioning",
];

const SWITCHES = [
  `--disable-features=${FEATURES}`,
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  // A name that is not this computer's, for pages that come over the network; and a camera that films a drawing.
  "--host-resolver-rules=MAP lan.test 127.0.0.1",
  "--use-fake-device-for-media-stream",
  "--use-fake-ui-for-media-stream",
];

let browser;
let directory;

before(() => {
  directory = mkdtempSync(join(tmpdir(), "meniscus-"));
});

/** Chromium, started by the first visit: the tests in Firefox use this file without it. */
async function started() {
  assert.ok(process.env.CHROME, "CHROME must name the browser; `cargo xtask test` finds it");
  const more = process.env.CHROME_SWITCHES?.split(" ") ?? [];
  browser ??= await chromium.launch({ executablePath: process.env.CHROME, args: [...SWITCHES, ...more] });
  return browser;
}

after(async () => {
  await browser?.close();
  if (directory) rmSync(directory, { recursive: true });
});

/** A file for this test run alone. */
export const temporary = (name) => join(directory, name);

/** A file of the tests. */
export const beside = (name) => join(root, "tests", "page", name);

/** The program's output for these words, run at the root of the project. */
export const meniscus = (...words) => execFileSync(program, words, { cwd: root, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

/** For axe, which judges the colours of the moment: what would fade stays until it goes. */
export const STILL = { motion: "reduce" };

/** A test: somebody opens a page and does something with it. `skip` is the reason why it cannot be run here, if there is one. */
export function visit(title, ...rest) {
  const does = rest.pop();
  const { skip = false, ...options } = rest.pop() ?? {};
  test(title, { skip }, async () => {
    const lab = await Lab.open(options);
    try {
      await does(lab);
      lab.wasQuiet();
    } catch (failure) {
      console.log(`${title}: the page, when this failed: ${await lab.described()}`);
      throw failure;
    } finally {
      await lab.context.close();
    }
  });
}

/** Until it holds: `check` throws as long as it does not. */
export async function eventually(check, seconds = 30) {
  const end = Date.now() + seconds * 1000;
  for (;;) {
    try {
      return await check();
    } catch (failure) {
      if (Date.now() > end) throw failure;
      await new Promise((done) => setTimeout(done, 50));
    }
  }
}

/** Holds what the page puts off to a later task (`setTimeout` without a time); it is done in its order once `release` is called. */
export async function hold(lab) {
  await lab.page.evaluate(() => {
    const { setTimeout } = window;
    window.held = [];
    window.setTimeout = (does, time, ...rest) => (time ? setTimeout(does, time, ...rest) : window.held.push(does));
    window.release = async () => {
      window.setTimeout = setTimeout;
      for (const does of window.held.splice(0)) setTimeout(does);
      // What is done goes on in further tasks.
      for (let task = 0; task < 20; task += 1) await new Promise((done) => setTimeout(done));
    };
  });
  return { begun: () => lab.page.waitForFunction(() => window.held.length), release: () => lab.page.evaluate(() => window.release()) };
}

/** The text of an element that may be out of sight: what the page does not draw there (`content-visibility`) has none until one scrolls to it. */
export async function sight(element) {
  await element.scrollIntoViewIfNeeded();
  return eventually(async () => {
    const text = await element.innerText();
    assert.notEqual(text, "");
    return text;
  });
}

export class Lab {
  /** Opens a page file without a network, or with one the page at `address`: `language`, `theme`, `width`, `height`, `touch`, `motion`; `idle`: false
      for a page that is never idle until `rest` is called, so that the laboratory comes only when it is asked for.
      Without a `fragment` the laboratory opens the published simulation, whose numbers the tests know. */
  static async open({ file = labPage, address, fragment = file === labPage && !address ? "#1&d=utube.md" : "", language = "en-GB", theme = "light", width = 1440, height = 900, touch = false, motion = "no-preference", idle = true } = {}) {
    const context = await (await started()).newContext({
      viewport: { width, height },
      locale: language,
      colorScheme: theme,
      reducedMotion: motion,
      hasTouch: touch,
      acceptDownloads: true,
    });
    await context.setOffline(!address);
    context.setDefaultTimeout(30_000);
    const page = await context.newPage();
    if (!idle) {
      await page.addInitScript(() => {
        window.resting = [];
        window.requestIdleCallback = (does) => window.resting.push(does);
      });
    }
    const lab = new Lab(context, page, address?.() ?? pathToFileURL(typeof file === "function" ? file() : file).href, idle);
    await lab.go(lab.address + fragment);
    return lab;
  }

  constructor(context, page, address, idle = true) {
    this.idle = idle;
    this.context = context;
    this.page = page;
    this.address = address;
    this.faults = [];
    this.requests = [];
    for (const way of ["goto", "reload", "goBack", "goForward"]) {
      const goes = page[way].bind(page);
      page[way] = async (...words) => {
        const response = await goes(...words);
        await this.whole();
        return response;
      };
    }
    page.on("pageerror", (error) => this.faults.push(String(error)));
    page.on("console", (message) => {
      if (message.type() === "error") this.faults.push(`${message.text()} (${message.location().url.slice(0, 120)})`);
    });
    page.on("request", (request) => {
      if (!request.isNavigationRequest() && !/^(data|blob):/.test(request.url())) this.requests.push(request.url());
    });
    page.on("dialog", (dialog) => {
      this.faults.push(`a dialog: ${dialog.message()}`);
      dialog.dismiss();
    });
  }

  async go(address) {
    await this.page.goto(address);
  }

  /** Until the page is there as a whole: the laboratory opens with a simulation alone, and its other tabs wait. */
  async whole() {
    if (!(await this.page.locator("#lab").count())) return;
    await this.page.locator("h1, [role=alert]").first().waitFor();
    if (this.idle) await this.taken();
  }

  /** Until the laboratory is there. */
  async taken() {
    await this.page.locator("[role=tab][aria-busy=true]").first().waitFor({ state: "detached" });
  }

  /** The page is idle, once. */
  async rest() {
    await this.page.evaluate(() => window.resting.splice(0).forEach((does) => does()));
    await this.drawn();
  }

  /** The state of the page in one line, for a failure that is not seen again: faults, heading, history and names of what is stored. */
  async described() {
    const page = this.page.evaluate(() => ({
      heading: document.querySelector("h1")?.innerText,
      visibility: document.visibilityState,
      messages: document.querySelector("#messages")?.innerText,
      fragment: location.hash.slice(0, 80),
      history: String(history.state).slice(0, 80),
      stored: Object.keys(localStorage),
    }));
    const state = await page.catch((failure) => ({ silent: String(failure) }));
    return JSON.stringify({ faults: this.faults, ...state });
  }

  /** Nobody was asked for anything, and nothing went wrong. */
  wasQuiet() {
    assert.deepEqual(this.requests, [], "requests");
    assert.deepEqual(this.faults, [], "errors in the page");
  }

  button(name) {
    return this.page.getByRole("button", { name, exact: true });
  }

  async press(name) {
    await this.button(name).click();
    await this.drawn();
  }

  /** Copies a link to what is seen: in the laboratory with the dialog *Share*, elsewhere with the button itself. What the dialog says. */
  async copyLink() {
    await this.page.locator("#share").click();
    let said = "";
    if (await this.page.locator("#publish").count()) {
      await this.page.locator("#copy-link").click();
      said = await eventually(async () => {
        const said = await this.page.locator("#link-copied").innerText();
        assert.ok(said);
        return said;
      });
      await this.page.keyboard.press("Escape");
    }
    await this.drawn();
    return said;
  }

  /** Until what was done before has been drawn: a person sees it no earlier, either. */
  async drawn() {
    await this.page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
  }

  field(name) {
    return this.page.getByRole("textbox", { name, exact: true });
  }

  slider(name) {
    return this.page.getByRole("slider", { name });
  }

  /** Goes to the tab of parameters and values, and unfolds *More* there, unless what is wanted is in sight. */
  async play(wanted) {
    if (await wanted.isVisible()) return;
    await this.page.locator("#tab-explore").click();
    await this.drawn();
    if (!(await wanted.isVisible())) await this.openMore();
  }

  /** Unfolds the parameters beyond the main ones, state, method and recorded values. */
  async openMore() {
    if (!(await this.page.locator("#more").evaluate((more) => more.open))) await this.page.locator("#more > summary").click();
    await this.drawn();
  }

  /** Chooses a preset: with its button, or from the list of its group where there are many. */
  async preset(name) {
    const choice = this.page.locator(".preset-choice select").filter({ has: this.page.getByRole("option", { name, exact: true }) });
    const chip = this.page.locator(".preset-group .chip").filter({ has: this.page.getByText(name, { exact: true }) });
    await this.play(choice.or(chip));
    await ((await choice.count()) ? choice.selectOption({ label: name }) : chip.click());
    await this.drawn();
  }

  /** Opens the menu of the page, with files, keys, colours and languages. */
  async openMenu() {
    if ((await this.page.locator("#menu").getAttribute("aria-expanded")) === "false") await this.page.locator("#menu").click();
  }

  /** Presses a button of the menu. A language is there when its texts are. */
  async pressInMenu(name) {
    await this.openMenu();
    await this.press(name);
    const [, language] = /^([A-Z]{2}) – /.exec(name) ?? [];
    if (language) await this.page.locator(`html[lang=${language.toLowerCase()}]`).waitFor();
  }

  /** Shows all plots. */
  async showPlots() {
    const hidden = this.page.locator(".plots-bar .chip[aria-pressed=false]:visible");
    while (await hidden.count()) await hidden.first().click();
    await this.drawn();
  }

  /** Shows the table of the recorded values. */
  async openTable() {
    await this.play(this.page.locator("#recorded"));
    if (!(await this.page.locator(".data").isVisible())) await this.page.locator("#recorded summary").click();
  }

  /** Shows the text of the document. */
  async openSource() {
    await this.everything();
    await this.page.locator("#tab-theory").click();
    await this.page.locator("#source > summary").click();
  }

  /** Types into a field and presses Enter. */
  async enter(name, text) {
    await this.play(this.field(name));
    await this.field(name).fill(text);
    await this.field(name).press("Enter");
    await this.drawn();
  }

  /** The number a field shows. */
  async number(name) {
    await this.play(this.field(name));
    await this.drawn();
    return number(await this.field(name).inputValue());
  }

  /** What stands beside a name among the values. */
  async value(name) {
    const row = this.page.locator(".readouts dl > div").filter({ has: this.page.getByText(name, { exact: true }) });
    await this.play(row);
    await this.drawn();
    return (await sight(row.locator("dd"))).trim();
  }

  /** The time shown, in seconds, once what was done before has been drawn. */
  async time() {
    await this.drawn();
    return number(await this.page.locator("#clock").innerText());
  }

  /** Waits until the time shown is at least this. */
  async watchUntil(seconds) {
    await eventually(async () => assert.ok((await this.time()) >= seconds, `the time is ${await this.time()}`), 20);
  }

  /** Opens a tab of the panel. If a student does not see it, turns *Everything* on first. */
  async tab(name) {
    const tab = this.page.locator("#panel > .tabs").getByRole("tab", { name, exact: true, includeHidden: true });
    await tab.waitFor({ state: "attached" });
    if (!(await tab.isVisible())) await this.everything();
    await tab.click();
    await this.drawn();
  }

  /** Shows what teachers and authors need, or only what a student does. */
  async everything(on = true) {
    const button = this.page.locator("#everything");
    if ((await button.getAttribute("aria-pressed")) !== String(on)) await button.click();
    await this.drawn();
  }

  /** How many rows are recorded; the table must be open. */
  async rows() {
    await this.drawn();
    const text = await this.page.locator(".data .range").innerText();
    return Number(text.split("/")[1].replace(/[^0-9]/g, ""));
  }

  /** The last thing a screen reader was told. */
  async told() {
    await this.drawn();
    return (await this.page.locator("#spoken").innerText()).trim();
  }

  /** Presses a button that saves a file: its name and text. */
  async save(button) {
    const [download] = await Promise.all([this.page.waitForEvent("download"), button.click()]);
    return { name: download.suggestedFilename(), text: readFileSync(await download.path(), "utf8") };
  }

  /** Saves what the menu of a plot offers under this name. */
  async saveOfPlot(plot, name) {
    const more = plot.locator("[id^=plot-more]");
    if ((await more.getAttribute("aria-expanded")) === "false") await more.click();
    return this.save(plot.getByRole("button", { name, exact: true }));
  }

  /** Presses keys one after the other. */
  async keys(...keys) {
    for (const key of keys) await this.page.keyboard.press(key);
    await this.drawn();
  }

  /** The name and role of what has the focus. */
  async focused() {
    return this.page.evaluate(() => {
      const element = document.activeElement;
      const labels = [...(element.labels ?? [])].map((label) => label.innerText);
      return { tag: element.tagName, id: element.id, name: element.getAttribute("aria-label") ?? (labels.join(" ") || element.innerText || "") };
    });
  }

  /** Goes on with Tab until the focus is on what `selector` names. */
  async tabTo(selector, most = 150) {
    for (let presses = 0; presses < most; presses += 1) {
      const found = await this.page.evaluate((selector) => {
        let element = document.activeElement;
        // The scene stands in a tree of its own.
        while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
        return element?.matches(selector);
      }, selector);
      if (found) return;
      await this.page.keyboard.press("Tab");
    }
    assert.fail(`Tab does not reach ${selector}`);
  }
}

/** A number as people see it: decimal point or comma, a real minus. */
export function number(text) {
  const plain = text.replace(/\s/g, "").replace("−", "-").replace(",", ".");
  return parseFloat(plain.replace(/^[^0-9.+-]*(?=[-+.0-9])/, ""));
}

/** Lets files fall on the page, as a hand does. */
export async function drop(lab, ...files) {
  const transfer = await lab.page.evaluateHandle((files) => {
    const transfer = new DataTransfer();
    files.forEach(({ name, bytes }) => transfer.items.add(new File([new Uint8Array(bytes)], name)));
    return transfer;
  }, files.map(({ name, text }) => ({ name, bytes: [...Buffer.from(text)] })));
  await lab.page.locator("#apparatus").dispatchEvent("drop", { dataTransfer: transfer });
}

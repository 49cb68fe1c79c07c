// The element <meniscus-simulation>, as docs/element.md says: its recipes in Chromium and Firefox, under a policy that forbids all
// scripts in the page; attributes, properties and events; twelve of them in one page.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { dirname, extname, join, normalize } from "node:path";
import { after, before, test } from "node:test";
import { launch } from "puppeteer-core";
import { Lab, beside, eventually, labPage, meniscus, temporary } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const POLICY = "script-src 'self' 'wasm-unsafe-eval'";
const TYPES = { ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".md": "text/markdown" };
const guide = readFileSync(beside("../../docs/element.md"), "utf8");
const modules = beside("node_modules");

/** The block of this kind below a heading of the guide. */
const recipe = (heading, kind) => {
  const [, below] = guide.split(`\n# `).join("\n## ").split(`## ${heading}\n`);
  const [, block] = new RegExp(`\`\`\`${kind}\n(.*?)\`\`\``, "s").exec(below);
  return block;
};

let address;
let server;
let folder;
let firefox;

before(async () => {
  folder = temporary("element");
  mkdirSync(folder);
  for (const name of ["utube", "pendulum"]) meniscus("export", `simulations/${name}.md`, "--output", join(folder, `${name}.html`));
  meniscus("export", "tests/page/course.md", "--output", join(folder, "course.html"));
  const save = (name, text) => writeFileSync(join(folder, name), text);
  save("choices.md", readFileSync(beside("choices.md")));
  const plain = /```html\n(<!doctype.*?)```/s.exec(guide)[1];
  save("plain.html", plain);
  // The parts of a page of Quarto 1.7 around a raw block.
  const [, raw] = /```\{=html\}\n(.*?)```/s.exec(guide);
  save(
    "quarto.html",
    `<!DOCTYPE html><html xmlns="http://www.w3.org/1999/xhtml" lang="en" xml:lang="en"><head><meta charset="utf-8"><meta name="generator" content="quarto-1.7.32"><meta name="viewport" content="width=device-width, initial-scale=1.0, user-scalable=yes"><title>A liquid swings</title></head><body class="fullcontent quarto-light"><div id="quarto-content" class="page-columns page-rows-contents page-layout-article"><main class="content" id="quarto-document-content"><header id="title-block-header" class="quarto-title-block default"><div class="quarto-title"><h1 class="title">A liquid swings</h1></div></header>\n${raw}\n</main></div></body></html>`,
  );
  save("reveal.html", `<!doctype html><html lang="en"><title>Slides</title>${recipe("reveal.js", "html")}</html>`);
  save("deck.js", "Reveal.initialize();");
  save("tube.jsx", recipe("React", "jsx"));
  const editor = beside("../../crates/lab/editor/node_modules/esbuild/bin/esbuild");
  const bundled = ["--bundle", "--jsx=automatic", "--format=esm", "--define:process.env.NODE_ENV='production'", `--outfile=${join(folder, "tube.js")}`];
  execFileSync(process.execPath, [editor, join(folder, "tube.jsx"), ...bundled], { env: { ...process.env, NODE_PATH: modules }, stdio: "pipe" });
  save("react.html", '<!doctype html><html lang="en"><title>React</title><div id="root"></div><script type="module" src="meniscus/meniscus.js"></script><script type="module" src="tube.js"></script></html>');
  const element = (words, inside = "") => `<meniscus-simulation ${words}>${inside}</meniscus-simulation>`;
  const page = (name, ...elements) => save(name, `<!doctype html><html lang="en"><title>Simulations</title><script type="module" src="meniscus/meniscus.js"></script><main><h1>Simulations</h1>${elements.join("\n")}</main></html>`);
  page("locked.html", element('src="course.html" lock language="es" title="Pregunta"'));
  page("twelve.html", ...Array.from({ length: 12 }, (_, number) => element(`src="${number % 2 ? "pendulum" : "utube"}.html" show="scene" title="Number ${number + 1}"`)));
  page("one.html", element('src="utube.html" show="scene"'));
  page("text.html", element('src="choices.md"'), element("inline", '<script type="text/markdown">```model\nx\'\' = -x*1 [1/s^2]\nx(0) = 1\nx\'(0) = 0\n```\n</script>'));
  page("lost.html", element('src="missing.html"', "<p>A picture</p>"));
  const roots = { meniscus: join(dirname(labPage), "npm"), "reveal.js": join(modules, "reveal.js") };
  server = createServer((request, response) => {
    const [, first, rest] = /^\/([^/]*)\/?(.*)/.exec(decodeURIComponent(new URL(request.url, "http://host").pathname));
    const file = roots[first] ? join(roots[first], normalize(rest)) : join(folder, first);
    try {
      const content = readFileSync(file);
      response.writeHead(200, { "Content-Type": TYPES[extname(file)] ?? "application/octet-stream", "Content-Security-Policy": POLICY }).end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  address = `http://127.0.0.1:${server.address().port}/`;
});

after(async () => {
  server?.close();
  await firefox?.close();
});

/** A test in Chromium. */
function visit(name, title, does, { faults = 0, ...options } = {}) {
  test(title, async () => {
    const lab = await Lab.open({ ...options, address: () => address + name });
    try {
      await does(lab.page, lab);
      assert.equal(lab.faults.length, faults, lab.faults.join("\n"));
      assert.deepEqual(lab.requests.filter((url) => !url.startsWith(address)), [], "requests to others");
    } finally {
      await lab.context.close();
    }
  });
}

/** Something about the frames of the elements, once it holds. `look` runs in the page and gets the documents of the frames. */
const sees = (page, look, expected = true) =>
  eventually(async () => {
    const seen = await page.evaluate(
      `(${look})([...document.querySelectorAll("meniscus-simulation")].map((element) => element.shadowRoot.querySelector("iframe")?.contentDocument))`,
    );
    assert.deepEqual(seen, expected, `${look}`);
  });

/** The simulation is there, the liquid moves when it is played, and the page around it has nothing of its style. */
async function swings(page) {
  await sees(page, "([frame]) => Boolean(frame?.querySelector('#play') && frame.querySelector('#scene svg, #scene .drawing'))");
  await page.evaluate(() => {
    const element = document.querySelector("meniscus-simulation");
    window.statuses = [];
    element.addEventListener("run", ({ detail }) => window.statuses.push(detail.status));
    const play = element.shadowRoot.querySelector("iframe").contentDocument.querySelector("#play");
    if (!play.classList.contains("playing")) play.click();
  });
  await sees(page, "([frame]) => parseFloat(frame.querySelector('#clock').innerText.replace(',', '.')) > 0.2");
}

const recipes = {
  "plain.html": async (page) => {
    await swings(page);
    assert.deepEqual(await page.evaluate(() => { const { b, h_l } = document.querySelector("meniscus-simulation").parameters; return [b, h_l]; }), [200, 3]);
  },
  "quarto.html": swings,
  "reveal.html": async (page) => {
    // The first slide has no simulation, so none is loaded.
    await page.waitForFunction?.(() => window.Reveal?.isReady());
    await eventually(async () => assert.ok(await page.evaluate(() => window.Reveal?.isReady())));
    assert.equal(await page.evaluate(() => document.querySelector("meniscus-simulation").shadowRoot.querySelector("iframe")), null);
    await page.evaluate(() => window.Reveal.next());
    await swings(page);
  },
  "react.html": async (page) => {
    await swings(page);
    // Python's way and the reader's way: from a slider of the page to the simulation, and back.
    await page.evaluate(() => { document.querySelector("meniscus-simulation").parameters = { b: 321 }; });
    await eventually(async () => assert.equal(await page.evaluate(() => document.querySelector("input").value), "321"));
    await page.evaluate(() => {
      const input = document.querySelector("input");
      Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value").set.call(input, "50");
      input.dispatchEvent(new Event("input", { bubbles: true }));
    });
    await eventually(async () => assert.equal(await page.evaluate(() => document.querySelector("meniscus-simulation").parameters.b), 50));
  },
};

for (const [name, does] of Object.entries(recipes)) {
  visit(name, `in Chromium: ${name}`, (page) => does(page));
  test(`in Firefox: ${name}`, async () => {
    const executablePath = process.env.FIREFOX ?? assert.fail("FIREFOX must name the browser; `cargo xtask test` finds it");
    firefox ??= await launch({ browser: "firefox", executablePath, headless: true, defaultViewport: null, extraPrefsFirefox: { "intl.accept_languages": "en-GB" } });
    const context = await firefox.createBrowserContext();
    try {
      const page = await context.newPage();
      const faults = [];
      page.on("pageerror", (error) => faults.push(String(error)));
      await page.goto(address + name);
      await does(page);
      assert.deepEqual(faults, []);
    } finally {
      await context.close();
    }
  });
}

visit("locked.html", "a question of a locked simulation is answered in Spanish, and the page around it hears of it", async (page) => {
  await page.evaluate(() => {
    window.heard = [];
    for (const type of ["ready", "answer"]) document.querySelector("meniscus-simulation").addEventListener(type, ({ detail }) => window.heard.push([type, detail]));
  });
  const inside = page.frameLocator('iframe[title="Pregunta"]');
  await sees(page, "([frame]) => frame?.documentElement.lang", "es");
  await inside.getByRole("tab", { name: "Preguntas" }).click();
  await inside.locator(".question input, .question textarea").first().fill("1");
  await inside.locator(".question button").filter({ hasText: /Comprobar/ }).first().click();
  const heard = await eventually(async () => {
    const heard = await page.evaluate(() => window.heard);
    assert.deepEqual(heard.map(([type]) => type), ["ready", "answer"]);
    return heard;
  });
  const [, { question, typed, grade }] = heard[1];
  assert.deepEqual([question, typed], [1, "1"]);
  assert.match(grade, /^[a-z]+$/);
  await inside.getByRole("tab", { name: "Explorar" }).click();
  assert.ok(await inside.locator("#panel input[type=range]").count());
  assert.equal(await inside.locator("#panel input[type=range]:enabled").count(), 0, "sliders");
  assert.equal(await page.evaluate(() => localStorage.getItem("meniscus:language")), null, "the language of other pages of the site is theirs");
});

visit("text.html", "texts are compiled in the page, by address and inside; a changed text is told what is wrong with it", async (page) => {
  await sees(page, "(frames) => frames.map((frame) => Boolean(frame?.querySelector('#play')))", [true, true]);
  await page.evaluate(() => {
    const [, element] = document.querySelectorAll("meniscus-simulation");
    element.addEventListener("findings", ({ detail }) => (window.findings = detail));
    element.text = "```model\nx' = y\nx(0) = 1\n```\n";
  });
  const [first] = await eventually(async () => (await page.evaluate(() => window.findings)) ?? assert.fail("no findings"));
  assert.deepEqual([first.severity, first.line, first.column], ["error", 2, 6]);
  assert.match(first.message, /y/);
  await sees(page, "(frames) => Boolean(frames[1]?.querySelector('#play'))");
});

visit("lost.html", "where a simulation cannot be loaded, what the element contains stays, with the reason", async (page) => {
  const element = page.locator("meniscus-simulation");
  assert.match(await element.getByRole("alert").innerText(), /missing\.html\s+404/);
  assert.ok(await element.getByText("A picture").isVisible());
}, { faults: 1 });

visit("plain.html", "axe finds nothing in the page and in the frame", async (page) => {
  await swings(page);
  await page.evaluate(() => document.documentElement.setAttribute("lang", "en"));
  for (const frame of page.frames()) {
    // As a debugger does, past the policy.
    await frame.evaluate(axe);
  }
  const { violations } = await page.evaluate(() => window.axe.run(document, { rules: { region: { enabled: false }, "landmark-one-main": { enabled: false } } }));
  assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html)}`), []);
}, { motion: "reduce" });

visit("twelve.html", "twelve simulations of a page: those in sight play, the others stand still", async (page) => {
  await sees(page, "(frames) => Boolean(frames[0]?.querySelector('#play'))");
  const begun = await page.evaluate(() => [...document.querySelectorAll("meniscus-simulation")].filter(({ shadowRoot }) => shadowRoot.querySelector("iframe")).length);
  assert.ok(begun < 12, `${begun} have begun`);
  const time = () => page.evaluate(() => document.querySelector("meniscus-simulation").shadowRoot.querySelector("iframe").contentDocument.querySelector("#clock").innerText);
  await swings(page);
  await page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight));
  await sees(page, "(frames) => Boolean(frames[11]?.querySelector('#play'))");
  await page.waitForTimeout(300);
  const held = await time();
  await page.waitForTimeout(700);
  assert.equal(await time(), held);
  await page.evaluate(() => scrollTo(0, 0));
  await eventually(async () => assert.notEqual(await time(), held));
  assert.ok(parseFloat(await time()) < parseFloat(held) + 0.6, "it goes on where it was");
});

// Versions of what is written, two tabs with one document, and a document that is written in another program.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { Lab, STILL, beside, eventually, program, temporary, visit } from "../lab.mjs";
import { test } from "node:test";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const editor = (page) => page.locator(".cm-content");
const text = (page) => editor(page).evaluate((content) => content.cmTile?.view?.state.doc.toString() ?? content.innerText);

/** The clock of the page goes on by so many seconds. */
const later = (page, seconds) => page.evaluate((seconds) => {
  const now = Date.now;
  Date.now = () => now() + 1000 * seconds;
}, seconds);

async function begin(lab) {
  await lab.tab("Write");
  await editor(lab.page).waitFor();
  await lab.press("New");
  await lab.press("A mass on a spring");
  await eventually(async () => assert.ok(await editor(lab.page).evaluate((content) => content === document.activeElement)));
}

/** Until the draft with these words is in the storage, and in the step of the history. */
const kept = (page, words) => eventually(async () => assert.ok(await page.evaluate((words) => {
  const drafts = Object.entries(localStorage).filter(([key]) => key.startsWith("meniscus:written:"));
  return drafts.some(([, text]) => text.includes(words)) && history.state.includes(words);
}, words)));

/** Types at the end of the text, and waits until that is kept. */
async function type(page, words) {
  await editor(page).click();
  await page.keyboard.press("Control+End");
  await page.keyboard.insertText(words);
  await kept(page, words.trim().split("\n")[0]);
}

const versions = (page) => page.locator("#version-list li button");

visit("versions are listed with what has changed; opening one is a step that can be undone", async (lab) => {
  await begin(lab);
  await lab.press("Versions");
  await lab.page.getByText("There are no versions yet").waitFor();
  await type(lab.page, "\nFirst line.\n");
  await later(lab.page, 100);
  await type(lab.page, "Second line.\nThird line.\n");
  await eventually(async () => assert.equal(await versions(lab.page).count(), 2));
  assert.match(await versions(lab.page).nth(0).innerText(), /\+1 −0 lines/);
  assert.match(await versions(lab.page).nth(1).innerText(), /first version/);
  await versions(lab.page).nth(0).click();
  await eventually(async () => assert.ok(!(await text(lab.page)).includes("Second line.")));
  assert.ok((await text(lab.page)).includes("First line."));
  // What stood there before is a version, too.
  await eventually(async () => assert.equal(await versions(lab.page).count(), 3));
  await editor(lab.page).click();
  await lab.keys("Control+z");
  await eventually(async () => assert.ok((await text(lab.page)).includes("Third line.")));
  await kept(lab.page, "Third line.");
  // They are there after a reload.
  await lab.page.reload();
  await lab.tab("Write");
  await editor(lab.page).waitFor();
  await type(lab.page, "Fourth line.\n");
  await lab.press("Versions");
  await eventually(async () => assert.ok((await versions(lab.page).count()) >= 3));
  // Never more than fifty, and the first one stays.
  const first = await versions(lab.page).last().innerText();
  for (let round = 0; round < 55; round += 1) {
    await later(lab.page, 100);
    await type(lab.page, `Round ${round}.\n`);
  }
  await eventually(async () => assert.equal(await versions(lab.page).count(), 50));
  assert.equal(await versions(lab.page).last().innerText(), first);
});

visit("a translation is begun in the same draft: what was typed can be undone, and the versions stay", async (lab) => {
  await begin(lab);
  await type(lab.page, "\nFirst line.\n");
  await later(lab.page, 100);
  await type(lab.page, "Second line.\n");
  await lab.page.locator("#writing-tab-translation").click();
  await lab.press("Begin a translation");
  await lab.page.locator(".sides-count").waitFor();
  await lab.page.locator("#writing-tab-text").click();
  await lab.press("Versions");
  await eventually(async () => assert.equal(await versions(lab.page).count(), 3));
  await editor(lab.page).click();
  await lab.keys("Control+z");
  await eventually(async () => assert.ok(!(await text(lab.page)).includes("Second line.")));
  assert.ok((await text(lab.page)).includes("First line."));
  await kept(lab.page, "translates: a-mass-on-a-spring.md");
  const drafts = await lab.page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("meniscus:written:")));
  assert.equal(drafts.length, 1);
});

visit("two tabs that write one document keep both texts", async (lab) => {
  await begin(lab);
  await type(lab.page, "\nShared words.\n");
  const other = await lab.context.newPage();
  await other.goto(lab.address);
  await other.getByRole("tab", { name: "Write" }).click();
  await editor(other).waitFor();
  await other.getByRole("button", { name: "New", exact: true }).click();
  await other.getByRole("button", { name: "A mass on a spring", exact: true }).last().click();
  await eventually(async () => assert.ok((await text(other)).includes("Shared words.")));
  await type(other, "Words of the other tab.\n");
  await type(lab.page, "Words of this tab.\n");
  await type(other, "More of the other.\n");
  // What one page stores reaches the other a moment later.
  await eventually(async () => {
    const kept = await lab.page.evaluate(() => Object.entries(localStorage).filter(([key]) => key.startsWith("meniscus:written:")).map(([, value]) => value));
    assert.equal(kept.length, 2);
    assert.ok(kept.some((text) => text.includes("Words of this tab.") && !text.includes("other")));
    assert.ok(kept.some((text) => text.includes("Words of the other tab.") && text.includes("More of the other.")));
  });
  await other.close();
});

/** Serves a document, and gives its address. */
async function serve(file) {
  const server = spawn(program, ["serve", file, "--no-open"], { stdio: ["ignore", "pipe", "pipe"] });
  const address = await new Promise((found, failed) => {
    let said = "";
    const listen = (chunk) => {
      said += chunk;
      const address = /http:\/\/127\.0\.0\.1:\d+\//.exec(said);
      if (address) found(address[0]);
    };
    server.stdout.on("data", listen);
    server.stderr.on("data", listen);
    server.on("exit", () => failed(new Error(said)));
  });
  return { server, address };
}

test("a served page follows its file: time, parameters and view stay, errors are shown, and Undo brings back what was typed", async () => {
  const file = temporary("followed.md");
  const original = readFileSync(beside("../../crates/document/templates/en/oscillator.md"), "utf8");
  writeFileSync(file, original);
  const { server, address } = await serve(file);
  let lab;
  try {
    lab = await Lab.open({ address: () => address });
    const title = (expected) => eventually(async () => assert.match(await lab.page.getByRole("heading", { level: 1 }).innerText(), expected));
    await title(/^A mass on a spring/);
    await lab.enter("Damping", "0.123");
    await lab.press("Play");
    await lab.watchUntil(0.5);
    await lab.press("Pause");
    const time = await lab.time();
    const loaded = await lab.page.evaluate(() => performance.timeOrigin);
    writeFileSync(file, original.replace("title: A mass on a spring", "title: Followed"));
    await title(/^Followed/);
    assert.equal(await lab.time(), time);
    assert.equal(await lab.number("Damping"), 0.123);
    assert.equal(await lab.page.evaluate(() => performance.timeOrigin), loaded, "the page was not loaded again");
    await lab.tab("Write");
    await editor(lab.page).waitFor();
    await editor(lab.page).click();
    await lab.keys("Control+End");
    await lab.page.keyboard.insertText("\nTyped in the page.\n");
    await eventually(async () => assert.match(await lab.page.locator("#writing-status").innerText(), /No errors/));
    writeFileSync(file, original.replace("k*y = 0", "kk*y = 0"));
    await eventually(async () => assert.match(await lab.page.locator("#writing-status").innerText(), /^1 error/));
    assert.ok(!(await text(lab.page)).includes("Typed in the page."));
    // What was typed is said to be replaced, and can be brought back; the errors of the file stand in sight in each tab.
    await lab.tab("Explore");
    const message = (words) => lab.page.locator(".message", { hasText: words });
    await message("has replaced the text written here").getByRole("button", { name: "Undo" }).click();
    await lab.tab("Write");
    await eventually(async () => assert.ok((await text(lab.page)).includes("Typed in the page.")));
    await lab.tab("Explore");
    await message("followed.md: 1 error. The last version without errors is running.").getByRole("button", { name: "Show" }).click();
    await eventually(async () => assert.equal(await lab.page.locator("#tab-write").getAttribute("aria-selected"), "true"));
    writeFileSync(file, original.replace("title: A mass on a spring", "title: Mended"));
    await title(/^Mended/);
    await eventually(async () => assert.equal(await message("1 error").count(), 0));
    rmSync(file);
    await message("followed.md cannot be read").waitFor();
    lab.faults.length = 0;
    writeFileSync(file, original.replace("title: A mass on a spring", "title: Mended"));
    await eventually(async () => assert.equal(await message("cannot be read").count(), 0));
    await lab.page.reload();
    await title(/^Mended/);
    assert.deepEqual(lab.faults, []);
  } finally {
    await lab?.context.close();
    server.kill();
  }
});

for (const [device, options] of [["desk", { theme: "dark" }], ["phone", { width: 390, height: 844, touch: true }]]) {
  visit(`axe finds nothing in the list of versions: ${device}`, { ...STILL, ...options }, async (lab) => {
    await begin(lab);
    await type(lab.page, "\nWords.\n");
    // While the text has the focus, a phone shows it without the stage; the button is hit nevertheless.
    await (options.touch ? lab.button("Versions").tap() : lab.press("Versions"));
    await versions(lab.page).first().waitFor();
    await lab.page.evaluate(axe);
    const { violations } = await lab.page.evaluate(() => window.axe.run("html"));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`), []);
    assert.equal(await lab.page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false);
  });
}

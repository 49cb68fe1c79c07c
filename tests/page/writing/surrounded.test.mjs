// A page around an exported simulation sets its parameters and follows them, as a notebook does: the simulation is the text of a
// sandboxed frame.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { eventually, meniscus, temporary, visit } from "../lab.mjs";

/** The page around it: the frame, its window, and what the page has heard. */
async function surrounded(lab) {
  const [file, outer] = [temporary("surrounded.html"), temporary("notebook.html")];
  meniscus("export", "tests/page/choices.md", "--output", file);
  writeFileSync(outer, "<!doctype html><title>Notebook</title><h1>Notebook</h1>");
  await lab.go(pathToFileURL(outer).href);
  await lab.page.evaluate((text) => {
    window.heard = [];
    window.runs = [];
    window.addEventListener("message", ({ data: { meniscus: { parameters, run } } }) => (run ? window.runs.push(run) : window.heard.push(parameters)));
    const frame = document.createElement("iframe");
    frame.setAttribute("sandbox", "allow-scripts");
    frame.style.cssText = "width: 900px; height: 640px";
    frame.srcdoc = text;
    document.body.append(frame);
  }, readFileSync(file, "utf8"));
  const inside = lab.page.frameLocator("iframe");
  await inside.locator("#parameter-0").waitFor();
  return {
    inside,
    say: (message) => lab.page.evaluate((message) => document.querySelector("iframe").contentWindow.postMessage(message, "*"), message),
    heard: () => lab.page.evaluate(() => window.heard.at(-1)),
    count: () => lab.page.evaluate(() => window.heard.length),
  };
}

visit("a page around a simulation sets its parameters, and hears of each change", async (lab) => {
  const { inside, say, heard, count } = await surrounded(lab);
  await inside.getByRole("slider", { name: "Radius" }).press("ArrowRight");
  assert.equal(await count(), 0, "nothing is said to who has not asked");
  await say({ meniscus: { parameters: {} } });
  const first = await eventually(async () => (await heard()) ?? assert.fail("no answer"));
  const names = Object.keys(first);
  const numbers = names.filter((name) => typeof first[name] === "number");
  const words = names.filter((name) => typeof first[name] === "string");
  assert.ok(numbers.length > 0 && words.length > 0, JSON.stringify(first));
  // A slider moves, and the page around hears it.
  await inside.getByRole("slider", { name: "Radius" }).press("ArrowRight");
  const moved = await eventually(async () => {
    const now = await heard();
    assert.notDeepEqual(now, first);
    return now;
  });
  // What is said comes back as it was.
  await say({ meniscus: { parameters: first } });
  await eventually(async () => assert.deepEqual(await heard(), first));
  await say({ meniscus: { parameters: { [numbers[0]]: moved[numbers[0]] } } });
  await eventually(async () => assert.deepEqual(await heard(), { ...first, [numbers[0]]: moved[numbers[0]] }));
});

visit("a page around a simulation hears when the run starts and stops", async (lab) => {
  const { inside, say, heard } = await surrounded(lab);
  await say({ meniscus: { parameters: {} } });
  await eventually(async () => (await heard()) ?? assert.fail("no answer"));
  await inside.locator("#play").click();
  await eventually(async () => assert.ok((await lab.page.evaluate(() => window.runs.map(({ status }) => status))).includes("playing"), JSON.stringify(await lab.page.evaluate(() => window.runs))));
  await eventually(async () => assert.ok(parseFloat(await inside.locator("#clock").innerText()) > 0.1));
  await inside.locator("#play").click();
  await eventually(async () => {
    const [{ status }, last] = await lab.page.evaluate(() => [window.runs[0], window.runs.at(-1)]);
    assert.deepEqual([status, last.status], ["paused", "paused"]);
    assert.ok(last.time > 0);
  });
});

for (const nonsense of [null, "meniscus", { meniscus: null }, { meniscus: { parameters: 5 } }, { meniscus: { parameters: { __proto__: 1, constructor: 2, "": 3 } } }]) {
  visit(`nonsense changes nothing: ${JSON.stringify(nonsense)}`, async (lab) => {
    const { say, heard } = await surrounded(lab);
    await say({ meniscus: { parameters: {} } });
    const first = await eventually(async () => (await heard()) ?? assert.fail("no answer"));
    await say(nonsense);
    await say({ meniscus: { parameters: { [Object.keys(first)[0]]: "no such word" } } });
    await lab.page.waitForTimeout(300);
    assert.deepEqual(await heard(), first);
  });
}

visit("a value that the document does not allow is refused in the picture", async (lab) => {
  const { inside, say, heard } = await surrounded(lab);
  await say({ meniscus: { parameters: {} } });
  const first = await eventually(async () => (await heard()) ?? assert.fail("no answer"));
  const name = Object.keys(first).find((name) => typeof first[name] === "number");
  await say({ meniscus: { parameters: { [name]: 1e300 } } });
  await inside.locator(".message.error").waitFor();
  assert.deepEqual(await heard(), first);
});

// Documents from strangers: whatever stands in them, nothing runs and nobody is asked for anything.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath, pathToFileURL } from "node:url";
import { beside, eventually, meniscus, temporary, visit } from "./lab.mjs";

/** No script of the document has run, and nothing of it is in the page. */
async function isHarmless(lab) {
  await lab.page.waitForTimeout(300);
  const found = await lab.page.evaluate(() => ({
    ran: window.harm ?? null,
    elements: [...document.querySelectorAll("#lab :is(script, iframe, object, embed, foreignObject, animate, set, base, meta, form[action])")].map((element) => element.outerHTML),
    handlers: [...document.querySelectorAll("#lab *")].flatMap((element) => [...element.attributes].filter((attribute) => /^on/i.test(attribute.name)).map((attribute) => attribute.name)),
    addresses: [...document.querySelectorAll("#lab [href], #lab [src]")]
      .flatMap((element) => [element.getAttribute("href"), element.getAttribute("src"), element.getAttribute("xlink:href")])
      .filter((address) => address !== null && !/^(https?:|mailto:|#|data:image\/)/.test(address)),
  }));
  assert.deepEqual(found, { ran: null, elements: [], handlers: [], addresses: [] });
}

visit("hostile words are only words", { file: exportedWords }, async (lab) => {
  await isHarmless(lab);
  for (const tab of await lab.page.getByRole("tab").all()) await tab.click();
  await lab.press("Play");
  await lab.watchUntil(0.3);
  await isHarmless(lab);
  assert.match(await lab.page.getByRole("heading", { level: 1 }).innerText(), /<\/script>/, "shown as it was written");
});

function exportedWords() {
  const file = temporary("words.html");
  meniscus("export", "tests/page/hostile-words.md", "--output", file);
  return file;
}

visit("hostile drawings and links are told and left out", async (lab) => {
  await lab.page.setInputFiles("#open-file", beside("hostile-scene.md"));
  await lab.tab("Source");
  await eventually(async () => assert.ok((await lab.page.locator(".finding.error").count()) >= 5, "each is told"));
  await isHarmless(lab);
  for (const tab of await lab.page.getByRole("tab").all()) await tab.click();
  await isHarmless(lab);
});

visit("a hostile link changes nothing but settings", async (lab) => {
  for (const fragment of ["<img src=x onerror=harm=1>", "b=1e999&h_l=-5&t=nan", "%00%ff%fe", "v=" + "9".repeat(10_000)]) {
    await lab.page.goto("about:blank");
    await lab.go(lab.address + "#" + fragment);
    await isHarmless(lab);
    await lab.press("Step forward");
    await eventually(async () => assert.ok((await lab.time()) > 0));
  }
});

visit("a page whose document was damaged says so", { file: damaged }, async (lab) => {
  await isHarmless(lab);
  assert.ok((await lab.page.locator(".broken").count()) === 1);
});

visit("a file that was damaged on its way says so", async (lab) => {
  const whole = readFileSync(fileURLToPath(lab.address), "utf8");
  const place = whole.indexOf('id="module"') + 300_000;
  const file = temporary("damaged-module.html");
  writeFileSync(file, whole.slice(0, place) + "A".repeat(100) + whole.slice(place + 100));
  await lab.page.goto(pathToFileURL(file).href);
  await lab.page.getByRole("alert").filter({ hasText: "This file is damaged" }).waitFor();
});

visit("a fault inside the module is told", async (lab) => {
  await lab.page.evaluate(() => setTimeout(() => { throw new WebAssembly.RuntimeError("unreachable"); }));
  const alert = lab.page.getByRole("alert").filter({ hasText: "Load the page again" });
  await alert.waitFor();
  assert.deepEqual(lab.faults.splice(0), ["RuntimeError: unreachable"]);
});

function damaged() {
  const whole = readFileSync(exportedWords(), "utf8");
  const file = temporary("damaged.html");
  writeFileSync(file, whole.replace("```model", "```modle"));
  return file;
}

// Documents from strangers: whatever stands in them, nothing runs and no request is made.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath, pathToFileURL } from "node:url";
import { beside, eventually, meniscus, temporary, visit } from "../lab.mjs";

/** Elements that a document must not be able to put into the page. */
const forbidden = "script, iframe, object, embed, foreignObject, animate, animateMotion, animateTransform, set, base, meta, link, image[href^='http'], form[action]";

/** No script of the document has run, and nothing of it is in the page, the drawing's own tree included. */
async function isHarmless(lab) {
  await lab.page.waitForTimeout(300);
  const found = await lab.page.evaluate((forbidden) => {
    const elements = [];
    const collect = (root) => {
      for (const element of root.querySelectorAll("*")) {
        elements.push(element);
        if (element.shadowRoot) collect(element.shadowRoot);
      }
    };
    collect(document.getElementById("lab"));
    const attributes = elements.flatMap((element) => [...element.attributes]);
    const styles = elements.filter((element) => element.localName === "style").map((element) => element.textContent);
    const painted = [...attributes.map((attribute) => attribute.value), ...styles];
    return {
      ran: window.harm ?? null,
      elements: elements.filter((element) => element.matches(forbidden)).map((element) => element.outerHTML),
      handlers: attributes.map((attribute) => attribute.name).filter((name) => /^on/i.test(name)),
      addresses: attributes
        .filter((attribute) => /^(href|src|xlink:href|action|formaction)$/i.test(attribute.name))
        .map((attribute) => attribute.value)
        .filter((address) => !/^(https?:|mailto:|#|data:image\/)/.test(address)),
      fetched: painted.filter((text) => /@import|url\(\s*["']?(?!#|data:)/i.test(text)),
    };
  }, forbidden);
  assert.deepEqual(found, { ran: null, elements: [], handlers: [], addresses: [], fetched: [] });
}

visit("what looks for harm finds it in the page and inside the drawing", async (lab) => {
  await isHarmless(lab);
  const harms = [
    '<script>harm = 1</script>',
    '<svg><animate attributeName="href"/></svg>',
    '<svg><g onclick="harm = 1"></g></svg>',
    '<a href="javascript:harm = 1">x</a>',
    '<svg><rect style="fill: url(http://example.invalid/b.svg#c)"/></svg>',
    '<style>@import url(http://example.invalid/a.css);</style>',
  ];
  for (const inside of [false, true]) {
    for (const harm of harms) {
      await lab.page.evaluate(
        ({ harm, inside }) => {
          const host = [...document.querySelectorAll("#lab *")].find((element) => element.shadowRoot);
          const place = document.createElement("div");
          place.id = "harm";
          place.innerHTML = harm;
          (inside ? host.shadowRoot : document.getElementById("lab")).append(place);
        },
        { harm, inside },
      );
      await assert.rejects(isHarmless(lab), assert.AssertionError, `${harm}, ${inside ? "inside the drawing" : "in the page"}`);
      await lab.page.evaluate(() => {
        const host = [...document.querySelectorAll("#lab *")].find((element) => element.shadowRoot);
        (document.getElementById("harm") ?? host.shadowRoot.getElementById("harm")).remove();
      });
    }
  }
  // The policy of the page has refused what was put in here, and said so.
  lab.faults.length = 0;
  lab.requests.length = 0;
});

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
  await lab.openSource();
  await eventually(async () => assert.ok((await lab.page.locator(".finding.error").count()) >= 5, "each is told"));
  await isHarmless(lab);
  for (const tab of await lab.page.locator("#panel > .tabs [role=tab]:visible").all()) await tab.click();
  await isHarmless(lab);
});

visit("a hostile link changes nothing but settings", async (lab) => {
  // Each is read as a link: what is sound in it is taken.
  for (const hostile of [
    "p=<img src=x onerror=harm=1>",
    "p=b:1e999,g:-5&t=nan&e=inf",
    "y=1,2,3,4&m=<script>harm=1</script>&h=-1&x=javascript:harm=1",
    "%00%ff%fe&c=0,b:1&c=99999999999999999999,b:1",
    "v=" + "9".repeat(10_000),
    "z=0,<b>:1,2:<i>&" + "k&".repeat(2000),
  ]) {
    await lab.page.goto("about:blank");
    await lab.go(lab.address + "#1&p=h_l:3.5&" + hostile);
    await isHarmless(lab);
    assert.equal(await lab.number("Height of the left column"), 3.5, hostile.slice(0, 60));
    await lab.press("Step forward");
    await eventually(async () => assert.ok((await lab.time()) > 0));
  }
  // Without the version of a link nothing is read.
  await lab.page.goto("about:blank");
  await lab.go(lab.address + "#<img src=x onerror=harm=1>&p=h_l:3.5");
  await isHarmless(lab);
  assert.notEqual(await lab.number("Height of the left column"), 3.5);
});

visit("a page whose document was damaged says so", { file: damaged }, async (lab) => {
  await isHarmless(lab);
  assert.ok((await lab.page.locator(".idle").count()) === 1);
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
  const laboratory = temporary("laboratory.html");
  meniscus("export", "tests/page/hostile-words.md", "--lab", "--output", laboratory);
  const whole = readFileSync(laboratory, "utf8");
  const file = temporary("damaged.html");
  writeFileSync(file, whole.replace("```model", "```modle"));
  return file;
}

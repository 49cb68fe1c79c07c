// What is there again: after a reload, behind Back and Forward, behind a link, in another language, in a second page.

import assert from "node:assert/strict";
import { randomBytes } from "node:crypto";
import { readFileSync } from "node:fs";
import { deflateRawSync } from "node:zlib";
import { Lab, beside, drop, eventually, visit } from "../lab.mjs";
import { film, openTheory, records } from "../measured.mjs";

const OWN = `---
title: My own oscillator
language: en
---

It swings.

\`\`\`model
parameter k = 4 [1/s^2] in 0..9 "Stiffness"
x'' + k*x = 0
x(0) = 1 "Place"
x'(0) = 0
\`\`\`

\`\`\`question
What is the angular frequency?
answer: sqrt(k) within 1 %
\`\`\`
`;

/** A text as it was stored before the present format. */

const OWN_SPANISH = `---
title: Mi propio oscilador
language: es
translates: own.md
---

Oscila.

\`\`\`translations
"Stiffness" = "Rigidez"
"Place" = "Lugar"
\`\`\`

\`\`\`question
¿Cuál es la frecuencia angular?
\`\`\`
`;

const file = (name, text) => ({ name, mimeType: "text/markdown", buffer: Buffer.from(text) });
const heading = (lab) => lab.page.getByRole("heading", { level: 1 });
const shows = (lab, title) => eventually(async () => assert.equal(await heading(lab).innerText(), title));

async function openOwn(lab, text = OWN) {
  await lab.page.setInputFiles("#open-file", [file("own.md", text), file("own.es.md", OWN_SPANISH)]);
  await shows(lab, "My own oscillator");
}

/** Another visitor with this address. */
async function other(address, does, options = {}) {
  const lab = await Lab.open(options);
  try {
    await lab.page.goto("about:blank");
    await lab.go(address);
    await does(lab);
    lab.wasQuiet();
  } finally {
    await lab.context.close();
  }
}

async function copyLink(lab) {
  const told = await lab.copyLink();
  return { address: lab.page.url(), told };
}

visit("a document of the library is open again after a reload, and a link leads to it", async (lab) => {
  await openTheory(lab, "Linear damping");
  await lab.enter("Damping rate", "0.7");
  await lab.page.reload();
  await shows(lab, "Linear damping");
  assert.equal(await lab.number("Damping rate"), 0.7);
  const { address } = await copyLink(lab);
  assert.match(address, /#1&d=theories\/linear\.md&p=gamma:0\.7/);
  await other(address, async (lab) => {
    await shows(lab, "Linear damping");
    assert.equal(await lab.number("Damping rate"), 0.7);
  });
  // The address alone names the document.
  await other(address.split("&p=")[0], async (lab) => {
    await shows(lab, "Linear damping");
    assert.notEqual(await lab.number("Damping rate"), 0.7);
  });
});

visit("an own document is open again after a reload, and a link holds it with its translation", async (lab) => {
  await openOwn(lab);
  await lab.enter("Stiffness", "2.25");
  await lab.page.reload();
  await shows(lab, "My own oscillator");
  assert.equal(await lab.number("Stiffness"), 2.25);
  const { address } = await copyLink(lab);
  assert.match(address, /#1&s=[A-Za-z0-9_-]+&p=k:2\.25$/);
  assert.ok(address.length < 9000);
  await other(address, async (lab) => {
    await shows(lab, "My own oscillator");
    assert.equal(await lab.number("Stiffness"), 2.25);
    await lab.pressInMenu("ES – Español");
    await shows(lab, "Mi propio oscilador");
    assert.equal(await lab.number("Rigidez"), 2.25);
    await lab.page.reload();
    await shows(lab, "Mi propio oscilador");
  });
});

visit("a document too long for a link is named in it, and the link waits for the file", async (lab) => {
  const long = OWN.replace("It swings.", `It swings.\n\n${randomBytes(20_000).toString("hex")}`);
  await openOwn(lab, long);
  await lab.enter("Stiffness", "2.25");
  const { address, told } = await copyLink(lab);
  assert.match(told, /too long for a link.*own\.md/);
  assert.match(address, /#1&f=own\.md&p=k:2\.25$/);
  await other(address, async (lab) => {
    await eventually(async () => assert.match(await lab.told(), /own\.md.*not in this page/));
    assert.match(await heading(lab).innerText(), /U-tube/);
    await openOwn(lab, long);
    assert.equal(await lab.number("Stiffness"), 2.25);
  });
  await other(address.replace("f=own.md", "d=theories/nothing.md"), async (lab) => {
    await eventually(async () => assert.match(await lab.told(), /theories\/nothing\.md.*not in this page/));
  });
});

visit("what a link cannot hold is said", async (lab) => {
  await drop(lab, { name: "film.csv", text: film() });
  await eventually(async () => assert.equal(await records(lab).count(), 1));
  const { told } = await copyLink(lab);
  assert.match(told, /Not in the link: records/);
});

visit("a link without a document means the published simulation, and a new one names its document", { fragment: "" }, async (lab) => {
  await shows(lab, "A liquid in a U-tube");
  assert.match((await copyLink(lab)).address, /#1&d=tube\.md$/);
  for (const fragment of ["1&p=b:200", "1"]) {
    const other = await Lab.open({ fragment: `#${fragment}` });
    await shows(other, "Oscillations of a liquid in a U-tube");
    await other.context.close();
  }
});

visit("hostile documents in links are words, and bombs are not unpacked", async (lab) => {
  const list = (text) => JSON.stringify([{ name: "own.md", text }]).replaceAll("<", "\\u003c");
  const packed = (text) => deflateRawSync(Buffer.from(text)).toString("base64url");
  const script = OWN.replace("It swings.", "It swings. <script>harm = 1</script><img src=x onerror='harm = 1'> [run](javascript:harm=1)").replace("My own oscillator", "<img src=x onerror=harm=1>");
  await lab.page.goto("about:blank");
  await lab.go(`${lab.address}#1&s=${packed(list(script))}`);
  await eventually(async () => assert.match(await heading(lab).innerText(), /<img/));
  assert.equal(await lab.page.evaluate(() => window.harm ?? null), null);
  assert.equal(await lab.page.locator("#lab :is(script, img[src=x], [href^=javascript])").count(), 0);
  const bomb = packed(list("0".repeat(5_000_000)));
  assert.ok(bomb.length < 8192, "it fits into a link");
  for (const fragment of [`1&s=${bomb}`, "1&s=AAAA", `1&s=${packed("[]")}`, `1&s=${packed("\u0000")}`, "1&s=%", `1&s=${"A".repeat(8193)}`, "1&d=%00", "1&d=", `1&d=${"a".repeat(300)}`]) {
    await lab.page.goto("about:blank");
    await lab.go(`${lab.address}#${fragment}`);
    await eventually(async () => assert.match(await lab.told(), /not understood|too long/, fragment.slice(0, 30)));
    assert.match(await heading(lab).innerText(), /U-tube/);
  }
});

visit("Back and Forward walk through the documents", async (lab) => {
  const first = await heading(lab).innerText();
  await lab.enter("Damping", "123");
  await openTheory(lab, "Linear damping");
  await openOwn(lab);
  await lab.enter("Stiffness", "2.25");
  await lab.page.goBack();
  await shows(lab, "Linear damping");
  await lab.page.goBack();
  await shows(lab, first);
  assert.equal(await lab.number("Damping"), 123);
  await lab.page.goForward();
  await lab.page.goForward();
  await shows(lab, "My own oscillator");
  assert.equal(await lab.number("Stiffness"), 2.25);
  // A heading of the prose is a place in the same document.
  await lab.page.evaluate(() => { location.hash = "panel"; });
  await lab.drawn();
  await lab.page.reload();
  await shows(lab, "My own oscillator");
});

visit("answers are kept in another language and after a reload", async (lab) => {
  await openOwn(lab);
  const question = () => lab.page.locator("section.question").first();
  const tab = async () => {
    for (const name of await lab.page.locator("#panel > .tabs [role=tab]:visible").allInnerTexts()) {
      await lab.tab(name);
      if (await question().isVisible()) return;
    }
    assert.fail("there is no question");
  };
  const stands = async (typed, grade, revealed) => {
    await tab();
    assert.equal(await question().getByRole("textbox").inputValue(), typed);
    assert.equal(await question().locator(".verdict").getAttribute("data-grade"), grade);
    assert.equal(await question().locator(".revealed strong").count(), revealed);
  };
  await tab();
  await question().getByRole("textbox").fill("2");
  await question().getByRole("button", { name: "Check" }).click();
  await stands("2", "right", 0);
  await lab.pressInMenu("ES – Español");
  await shows(lab, "Mi propio oscilador");
  await stands("2", "right", 0);
  assert.match(await question().locator(".verdict").innerText(), /Correcto/);
  await question().getByRole("button", { name: "Mostrar la respuesta" }).click();
  await question().getByRole("textbox").fill("7");
  await lab.page.reload();
  await shows(lab, "Mi propio oscilador");
  await stands("7", "", 1);
  // Another document has its own.
  await openTheory(lab, "Amortiguamiento lineal");
  await lab.page.goBack();
  await shows(lab, "Mi propio oscilador");
  await stands("7", "", 1);
});

visit("two pages keep each other's records, and what one removes is gone", async (lab) => {
  const second = new Lab(lab.context, await lab.context.newPage(), lab.address);
  await second.go(lab.address);
  const pages = [lab, second];
  const stored = () => lab.page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("meniscus:record:")).length);
  for (const [place, page] of pages.entries()) {
    await page.page.bringToFront();
    await drop(page, { name: `film ${place + 1}.csv`, text: film(0.2 + 0.05 * place, place + 1) });
    await eventually(async () => assert.equal(await records(page).count(), 1));
    // They come back in the order in which they were stored.
    await eventually(async () => assert.equal(await stored(), place + 1));
  }
  for (const page of pages) {
    await page.page.bringToFront();
    await page.page.reload();
    await page.tab("Measure");
    await eventually(async () => assert.deepEqual(await records(page).locator("h3").allInnerTexts(), ["film 1.csv", "film 2.csv"]));
  }
  await lab.page.bringToFront();
  await lab.page.getByRole("button", { name: "Remove the record: film 1.csv" }).click();
  await eventually(async () => assert.equal(await stored(), 1));
  for (const page of [second, lab]) {
    await page.page.bringToFront();
    await page.page.reload();
    await page.tab("Measure");
    await eventually(async () => assert.deepEqual(await records(page).locator("h3").allInnerTexts(), ["film 2.csv"]));
  }
  second.wasQuiet();
});

visit("a browser that refuses to store anything is reported once", async (lab) => {
  await lab.page.addInitScript(() => {
    Storage.prototype.setItem = () => { throw new DOMException("full", "QuotaExceededError"); };
  });
  await lab.page.reload();
  // An error stays in the line until it is dismissed. What is spoken does not: the record may be read before or after.
  const reports = () => lab.page.locator("#messages .error").filter({ hasText: "does not let this page store anything" }).count();
  await drop(lab, { name: "film.csv", text: film() });
  await eventually(async () => assert.equal(await reports(), 1));
  await lab.page.locator("#messages .error").getByRole("button", { name: "Dismiss" }).click();
  await drop(lab, { name: "other.csv", text: film(0.3, 3) });
  await eventually(async () => assert.equal(await records(lab).count(), 2));
  await lab.page.waitForTimeout(600);
  assert.equal(await reports(), 0);
});

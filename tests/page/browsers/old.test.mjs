// Browsers that are too old say so, those that are just new enough work, and what is missing or damaged is not blamed on them.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { eventually, labPage, temporary, visit } from "../lab.mjs";

const OLD = /This browser is too old for Meniscus\. Update it.*Actualízalo.*Atualize-o.*Safari 16\.4/;
const DAMAGED = /This file is damaged\. Download it again\./;

/** What a page says instead of the laboratory, after `before` has run in it. */
async function said(lab, before, file = labPage) {
  const page = await lab.context.newPage();
  await page.addInitScript(before);
  await page.goto(pathToFileURL(file).href);
  const text = await page.getByRole("alert").innerText();
  await page.close();
  return text;
}

visit("a browser that is too old says so, whatever it does not know", async (lab) => {
  for (const before of [
    () => delete globalThis.DecompressionStream,
    () => delete globalThis.WebAssembly,
    () => {
      const { DecompressionStream } = globalThis;
      globalThis.DecompressionStream = function (format) {
        if (format === "deflate-raw") throw new TypeError("Unsupported compression format");
        return new DecompressionStream(format);
      };
    },
    () => {
      WebAssembly.compile = async () => {
        throw new WebAssembly.CompileError("unknown opcode");
      };
    },
    () => {
      Document.prototype.querySelector = () => {
        throw new DOMException("not a valid selector", "SyntaxError");
      };
    },
    // It has read no script but the last.
    () => {
      Object.defineProperty(globalThis, "opening", { get: () => undefined, set() {} });
      delete globalThis.DecompressionStream;
    },
  ]) {
    assert.match(await said(lab, before), OLD, String(before));
  }
});

visit("a page that is damaged or cut off says so, and blames no browser", async (lab) => {
  const page = readFileSync(labPage, "utf8");
  const after = (part, bytes) => page.indexOf(`id="${part}"`) + bytes;
  const [module, laboratory] = [after("module", 2000), after("laboratory", 0)];
  const file = temporary("cut.html");
  for (const [what, text] of [
    ["other bytes", page.slice(0, module) + "A".repeat(60) + page.slice(module + 60)],
    ["a module without an end", page.slice(0, module) + page.slice(page.indexOf("</script>", module))],
    ["no module", page.slice(0, after("module", 0)) + 'id="other"' + page.slice(after("module", 'id="module"'.length))],
    ["no laboratory", page.slice(0, page.lastIndexOf("<script", laboratory))],
    ["half of the laboratory", page.slice(0, laboratory + 100_000)],
  ]) {
    assert.notEqual(text, page, what);
    writeFileSync(file, text);
    assert.match(await said(lab, () => {}, file), DAMAGED, what);
  }
});

visit("a browser without popovers opens the page, and its plots have read-outs", async (lab) => {
  // As Safari 16.4 to 16.6.
  await lab.page.addInitScript(() => {
    for (const method of ["showPopover", "hidePopover", "togglePopover"]) delete HTMLElement.prototype[method];
    delete HTMLElement.prototype.popover;
    for (const type of [Document, Element, ShadowRoot, DocumentFragment]) {
      for (const method of ["querySelector", "querySelectorAll", "matches", "closest"]) {
        const own = Object.getOwnPropertyDescriptor(type.prototype, method)?.value;
        if (!own) continue;
        type.prototype[method] = function (selector) {
          if (/:popover-open/.test(selector)) throw new DOMException(`'${selector}' is not a valid selector`, "SyntaxError");
          return own.call(this, selector);
        };
      }
    }
    const { setAttribute } = Element.prototype;
    Element.prototype.setAttribute = function (name, value) {
      if (name !== "popover") setAttribute.call(this, name, value);
    };
  });
  await lab.page.goto("about:blank");
  await lab.page.goto(lab.address);
  assert.equal(await lab.page.getByRole("alert").count(), 0);
  const tips = () => lab.page.locator(".tip:visible").count();
  assert.equal(await tips(), 0);
  await lab.press("Play");
  await lab.watchUntil(1.5);
  await lab.press("Pause");
  await lab.page.locator(".figures canvas:visible").first().hover();
  await eventually(async () => assert.equal(await tips(), 1));
  await lab.page.mouse.move(2, 2);
  await eventually(async () => assert.equal(await tips(), 0));
});

visit("a preview without scripts says what the page needs", async (lab) => {
  const context = await lab.context.browser().newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  await page.goto(lab.address);
  const text = await page.locator("body").innerText();
  await context.close();
  for (const words of ["Files on iPhones and iPads", "Archivos en iPhones y iPads", "Arquivos em iPhones e iPads"]) assert.ok(text.includes(words), words);
});

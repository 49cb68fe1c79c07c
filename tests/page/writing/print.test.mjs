// The worksheet that comes out of the printer.

import assert from "node:assert/strict";
import { visit } from "../lab.mjs";

/** Prints: the page as it is on paper stays, as while a browser's print window is open. */
async function print(lab) {
  await lab.page.emulateMedia({ media: "print" });
  await lab.page.evaluate(() => dispatchEvent(new Event("beforeprint")));
}

const documents = { "utube.md": /U-tube/, "pendulum.md": /endulum/, "bouncing-ball.md": /ball/ };

for (const [language, other] of [["en-GB", "EN"], ["es-ES", "ES"]]) {
  visit(`a worksheet is printed: ${other}`, { language, theme: "dark" }, async (lab) => {
    const words = language === "en-GB" ? { name: "Name", answer: "Answer", parameters: "Parameters" } : { name: "Nombre", answer: "Respuesta", parameters: "Parámetros" };
    for (let number = 0; number < Object.keys(documents).length; number += 1) {
      await lab.page.locator("#browse").click();
      await lab.page.locator("#library-list .entry").nth(number).click();
      await lab.page.locator("#step-forward").click();
      const title = await lab.page.locator("h1").innerText();
      await print(lab);
      const sheet = lab.page.locator(".worksheet");
      assert.equal(await sheet.getByRole("heading", { level: 1 }).innerText(), title);
      for (const word of Object.values(words)) assert.ok((await sheet.getByText(word, { exact: true }).count()) > 0, word);
      assert.ok((await sheet.locator("math").count()) > 3, "equations");
      assert.ok((await sheet.locator("tbody tr").count()) >= 2, "parameters");
      const questions = await sheet.locator(".sheet-question").count();
      assert.equal(await sheet.locator(".lines").count(), questions, "room for each answer");
      // Nothing to press, nothing that floats, nothing dark, no other parts of the page.
      const wrong = await lab.page.evaluate(() => {
        const visible = [...document.querySelectorAll("body *")].filter((node) => node.checkVisibility());
        const style = (node) => getComputedStyle(node);
        return visible
          .filter((node) => node.matches("button, input, select, canvas") || ["fixed", "sticky"].includes(style(node).position))
          .filter((node) => !node.matches(".visually-hidden"))
          .map((node) => node.outerHTML.slice(0, 100));
      });
      assert.deepEqual(wrong, []);
      assert.equal(await lab.page.evaluate(() => getComputedStyle(document.body).color), "rgb(0, 0, 0)");
      // Plots keep their shape.
      for (const plot of await sheet.locator("figure svg").all()) {
        const { width, height } = await plot.boundingBox();
        const [, , w, h] = (await plot.getAttribute("viewBox")).split(" ").map(Number);
        assert.ok(Math.abs(width / height - w / h) < 0.02, `${width} by ${height}`);
      }
      await lab.page.evaluate(() => dispatchEvent(new Event("afterprint")));
      await lab.page.emulateMedia({ media: "screen" });
      assert.equal(await sheet.count(), 0, "gone from the screen");
    }
  });
}

visit("the parts of the worksheet are chosen, and solutions come only if they are asked for", async (lab) => {
  const parts = { Theory: ".passage:not(:has(.sheet-question)) math", Scene: ".sheet-apparatus .drawing", "Table of the parameters": ".sheet-apparatus table", Plots: "figure", Questions: ".sheet-question", "Lines for answers": ".lines" };
  const sheet = lab.page.locator(".worksheet").first();
  const solutions = lab.page.locator(".worksheet.solutions");
  const isPrinted = async (part) => (await sheet.locator(parts[part]).filter({ visible: true }).count()) > 0;
  const printed = async () => {
    await print(lab);
    await sheet.waitFor();
    const all = [];
    for (const part of Object.keys(parts)) if (await isPrinted(part)) all.push(part);
    return all;
  };
  const back = async () => {
    await lab.page.evaluate(() => dispatchEvent(new Event("afterprint")));
    await lab.page.emulateMedia({ media: "screen" });
  };
  const tick = (name) => lab.page.locator("section[aria-label=Worksheet]").getByRole("checkbox", { name, exact: true });
  await lab.press("Step forward");
  assert.deepEqual(await printed(), Object.keys(parts));
  assert.equal(await solutions.count(), 0);
  const answers = await sheet.locator(".sheet-question").count();
  await back();
  await lab.press("Share");
  for (const name of ["Theory", "Plots", "Lines for answers"]) await tick(name).uncheck();
  await tick("Solutions").check();
  await lab.page.evaluate(() => (window.print = () => (window.printed = true)));
  await lab.page.locator("#print").click();
  assert.equal(await lab.page.evaluate(() => window.printed), true);
  assert.deepEqual(await printed(), ["Scene", "Table of the parameters", "Questions"]);
  assert.equal(await solutions.locator("section").count(), answers);
  assert.match(await solutions.locator("section").first().innerText(), /Answer: [0-9.]+/);
  await back();
  // The choice is still there when the dialog is opened again, also in another language.
  await lab.keys("Escape");
  await lab.pressInMenu("ES – Español");
  await lab.press("Compartir");
  const hoja = lab.page.locator("section[aria-label='Hoja de trabajo']");
  assert.deepEqual([await hoja.getByLabel("Teoría").isChecked(), await hoja.getByLabel("Soluciones").isChecked(), await hoja.getByLabel("Escena").isChecked()], [false, true, true]);
});

visit("the paper shows the scene as it stands", async (lab) => {
  const drawing = (place) => lab.page.evaluate((place) => document.querySelector(place).shadowRoot.querySelector("svg").outerHTML, place);
  await lab.press("Step forward");
  await print(lab);
  assert.equal(await drawing(".worksheet .drawing"), await drawing("#scene .drawing"));
  const { width, height } = await lab.page.locator(".worksheet .drawing").boundingBox();
  assert.ok(width > 150 && height > 150, `${width} by ${height}`);
});

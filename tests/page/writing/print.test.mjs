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

visit("the paper shows the scene as it stands", async (lab) => {
  const drawing = (place) => lab.page.evaluate((place) => document.querySelector(place).shadowRoot.querySelector("svg").outerHTML, place);
  await lab.press("Step forward");
  await print(lab);
  assert.equal(await drawing(".worksheet .drawing"), await drawing("#scene .drawing"));
  const { width, height } = await lab.page.locator(".worksheet .drawing").boundingBox();
  assert.ok(width > 150 && height > 150, `${width} by ${height}`);
});

// The seat of a student: by link, by a field, with the keyboard alone, in both languages. Hidden values are nowhere.

import assert from "node:assert/strict";
import { eventually, meniscus, temporary, visit } from "../lab.mjs";

const TUBE = "crates/play/tests/all/support/assigned.md";

/** Exports the document with assigned values. */
function tube() {
  const file = temporary("tube.player.html");
  meniscus("export", TUBE, "--output", file);
  return file;
}

/** The list of the teacher: damping and hidden damping of each seat. */
const list = () => JSON.parse(meniscus("class", "assign", TUBE, "--seats", "8", "--format", "json")).seats.map((seat) => seat.values);

/** Nothing that is on the page names the hidden parameter or has its value. */
async function keepsSecret(page, hidden) {
  const all = await page.page.evaluate(() => [document.body.innerText, document.body.innerHTML.replace(/<script[^]*?<\/script>/g, ""), location.hash].join(" "));
  for (const secret of ["zeta_q", "Unknown damping", hidden.toFixed(3)]) assert.ok(!all.includes(secret), secret);
}

visit("a seat typed with the keyboard sets values of its own, and a link carries it", { file: tube }, async (page) => {
  const [damping, hidden] = list()[6];
  assert.equal(await page.number("Damping"), 0.02);
  assert.match(await page.page.locator("#seat-note").innerText(), /^Type the number of your seat/);
  await page.tabTo("#seat");
  await page.keys("7", "Enter");
  await eventually(async () => assert.equal(await page.number("Damping"), damping));
  assert.equal(await page.page.locator("#seat-note").innerText(), "The values of this seat are set.");
  await keepsSecret(page, hidden);
  await page.context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.press("Copy link");
  await eventually(async () => assert.match(await page.page.evaluate(() => navigator.clipboard.readText()), /#1&seat=7$/));
  await page.enter("Seat", "seven");
  await page.page.getByText("A seat is a whole number from 1").waitFor();
});

visit("a link opens the page with the values of a seat", { file: tube }, async (page) => {
  const [damping, hidden] = list()[2];
  await page.page.goto("about:blank");
  await page.go(`${page.address}#1&seat=3`);
  await eventually(async () => assert.equal(await page.number("Damping"), damping));
  assert.equal(await page.field("Seat").inputValue(), "3");
  await keepsSecret(page, hidden);
});

visit("the seat is asked for in Spanish", { file: tube, language: "es-ES" }, async (page) => {
  assert.match(await page.page.locator("#seat-note").innerText(), /^Escribe el número de tu puesto/);
  await page.enter("Puesto", "2");
  await eventually(async () => assert.equal(await page.page.locator("#seat-note").innerText(), "Están los valores de este puesto."));
});

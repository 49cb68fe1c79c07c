// Workbooks and long records in the page: read with progress, given up, and drawn so that the run still plays.

import assert from "node:assert/strict";
import { drop, eventually, sight, visit } from "../lab.mjs";
import { film, ods, xls, xlsx } from "../tables.mjs";

/** Lets a file of so many rows fall on the page: a damped oscillation with noise, made in the page. */
async function dropRows(lab, name, rows) {
  await lab.page.evaluate(
    ({ name, rows }) => {
      const lines = ["t [s]\ty [m]"];
      let seed = 1;
      for (let row = 0; row < rows; row += 1) {
        seed = (seed * 48271) % 2147483647;
        const time = (row * 20) / rows;
        const y = 0.5 * Math.exp(-0.1 * time) * Math.cos(1.7 * time) + 0.02 * (seed / 2147483647 - 0.5);
        lines.push(`${time.toFixed(6)}\t${y.toFixed(6)}`);
      }
      // What of the bar is shown while the file is read.
      window.shown = [];
      new MutationObserver(() => {
        const bar = document.getElementById("reading");
        if (bar) window.shown.push({ part: bar.value, name: bar.getAttribute("aria-label") });
      }).observe(document.body, { childList: true, subtree: true, attributes: true });
      const transfer = new DataTransfer();
      transfer.items.add(new File([lines.join("\n")], name));
      document.getElementById("apparatus").dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true }));
    },
    { name, rows },
  );
}

visit("a long record is read with a bar, drawn, and the run plays over it", async (lab) => {
  const { page } = lab;
  await dropRows(lab, "long.txt", 300_000);
  await eventually(async () => assert.match(await sight(page.locator(".record")), /long\.txt[^]*300000/), 60);
  const shown = await page.evaluate(() => window.shown);
  assert.ok(shown.length > 3 && shown.every(({ name }) => name === "Reading long.txt"), JSON.stringify(shown.slice(0, 5)));
  const parts = shown.map(({ part }) => part);
  assert.deepEqual(parts, parts.toSorted((one, other) => one - other));
  assert.ok(parts.at(-1) >= 50, `${parts}`);
  assert.equal(await page.locator("#reading").count(), 0);
  // It is too long for the next visit, and that is said.
  assert.match(await sight(page.locator(".record")), /too long to be kept/);
  const clock = async () => parseFloat(await page.locator("#clock").textContent());
  await page.locator("#play").click();
  await eventually(async () => assert.ok((await clock()) > 1), 30);
});

visit("a long record can be given up, and another one read", async (lab) => {
  const { page } = lab;
  await dropRows(lab, "long.txt", 2_000_000);
  await page.locator("#cancel-reading").click({ timeout: 60_000 });
  await eventually(async () => assert.equal(await page.locator("#spoken").textContent(), "Not read: long.txt"));
  assert.equal(await page.locator(".record").count(), 0);
  await drop(lab, { name: "film.txt", text: film() });
  await eventually(async () => assert.match(await sight(page.locator(".record")), /film\.txt/), 30);
  assert.equal(await page.locator(".record").count(), 1);
});

visit("a record can be given up before the browser has fetched its bytes", async (lab) => {
  const { page } = lab;
  await page.evaluate(() => {
    const button = () => document.getElementById("cancel-reading");
    new MutationObserver((_, observer) => {
      if (button()) {
        observer.disconnect();
        button().click();
      }
    }).observe(document.body, { childList: true, subtree: true });
  });
  await dropRows(lab, "long.txt", 300_000);
  await eventually(async () => assert.equal(await page.locator("#spoken").textContent(), "Not read: long.txt"));
  assert.equal(await page.locator(".record").count(), 0);
});

visit("workbooks are read by the page as by the program", async (lab) => {
  const { page } = lab;
  for (const [name, bytes] of [["film.xlsx", xlsx()], ["film.ods", ods()], ["old.xls", xls()]]) {
    await drop(lab, { name, text: bytes });
    const record = page.locator(".record", { hasText: name });
    await eventually(async () => assert.match(await sight(record), /60 rows/), 30);
    const text = await sight(record);
    assert.match(text, /y \[cm\]/);
    assert.match(text, /several sheets[^]*Film/);
  }
});

visit("a workbook that would expand without bound is refused in words", async (lab) => {
  await drop(lab, { name: "bomb.xlsx", text: xlsx("<row><c><v>1</v></c></row>".repeat(500_000)) });
  await eventually(async () => assert.match(await lab.page.locator("#record-refusal").innerText(), /would expand to 13 MB/), 30);
  await drop(lab, { name: "far.xlsx", text: xlsx('<row r="4294967295"><c><v>1</v></c></row>') });
  await eventually(async () => assert.match(await lab.page.locator("#record-refusal").innerText(), /4294967295/), 30);
});

// The project file: document, translations, values, records and answers leave one browser and are there in another.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { Lab, eventually, meniscus, sight, temporary, visit } from "../lab.mjs";

const RECORD = "t [s],y [m]\n" + Array.from({ length: 40 }, (_, row) => `${row / 10},${(0.5 * Math.cos(1.67 * row / 10)).toFixed(4)}`).join("\n");

/** Saves a project with a record, a changed parameter and a changed text. */
async function saved(lab) {
  const record = temporary("swing.csv");
  writeFileSync(record, RECORD);
  await lab.page.locator("#open-file").setInputFiles(record);
  await eventually(async () => assert.equal(await lab.page.locator(".record").count(), 1));
  await lab.enter("Damping", "123");
  await lab.page.locator("#share").click();
  const { name, text } = await lab.save(lab.page.locator("#save-project"));
  assert.equal(name, "utube.meniscus");
  const file = temporary(name);
  writeFileSync(file, text);
  return { file, text };
}

visit("a project holds the document with its translation, its values and records, and opens in another browser", async (lab) => {
  const { file } = await saved(lab);
  const other = await Lab.open({ language: "es-ES" });
  try {
    await other.page.locator("#open-file").setInputFiles(file);
    await other.tab("Medir");
    await eventually(async () => assert.equal(await other.page.locator(".record").count(), 1));
    assert.match(await sight(other.page.locator(".record h3")), /swing\.csv/);
    assert.equal(await other.number("Amortiguamiento"), 123);
    await eventually(async () => assert.match(await other.page.getByRole("heading", { level: 1 }).innerText(), /tubo en U/));
    // Once more: what is there stays.
    await other.page.locator("#open-file").setInputFiles(file);
    await other.drawn();
    await other.tab("Medir");
    await eventually(async () => assert.equal(await other.page.locator(".record").count(), 1));
    other.wasQuiet();
  } finally {
    await other.context.close();
  }
  // The program takes it wherever it takes a document.
  meniscus("check", file);
  assert.match(meniscus("run", file, "--until", "0.1"), /^t \[s\],/);
});

visit("a project is dropped on the page; one that is damaged or of a later version is refused with the reason", async (lab) => {
  const { text } = await saved(lab);
  await lab.keys("Escape");
  for (const [content, reason] of [[text.slice(0, 500), /damaged or no project/], [text.replace('"meniscus project":1', '"meniscus project":7'), /later version/]]) {
    const file = temporary("wrong.meniscus");
    writeFileSync(file, content);
    await lab.page.locator("#open-file").setInputFiles(file);
    await eventually(async () => assert.match(await lab.page.locator("#messages").innerText(), reason));
  }
  await lab.page.evaluate((content) => {
    const data = new DataTransfer();
    data.items.add(new File([content], "dropped.meniscus"));
    window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, text.replace("title: Oscillations", "title: Dropped oscillations"));
  await eventually(async () => assert.match(await lab.page.getByRole("heading", { level: 1 }).innerText(), /^Dropped oscillations/));
});

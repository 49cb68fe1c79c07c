// What leaves the laboratory and comes back: tables, figures, links, the state after a reload, exported pages.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { Lab, eventually, meniscus, temporary, visit } from "../lab.mjs";

/** Plays at eight times the speed until `seconds`, and pauses. */
async function record(lab, seconds) {
  await lab.page.getByLabel("Speed").selectOption("8 ×");
  await lab.press("Play");
  await lab.watchUntil(seconds);
  await lab.press("Pause");
}

const downloadCsv = async (lab) => {
  await lab.openTable();
  return lab.save(lab.button("Download CSV"));
};

/** The rows of the program for as long as the page has recorded. */
function sameRun(csv, ...settings) {
  const last = csv.trimEnd().split("\n").at(-1).split(",")[0];
  return meniscus("run", "simulations/utube.md", "--until", last, ...settings);
}

visit("the table is that of the command line, byte for byte", async (lab) => {
  await record(lab, 20);
  const { name, text } = await downloadCsv(lab);
  assert.match(name, /\.csv$/);
  assert.match(text, /^t \[s\],y \[m\],y' \[m\/s\],/);
  assert.ok(text.split("\n").length > 400);
  assert.equal(text, sameRun(text));
});

visit("with other parameters and in Spanish too", { language: "es-ES" }, async (lab) => {
  await lab.pressInMenu("EN – English");
  await lab.enter("Height of the left column", "2");
  await lab.enter("Height of the right column", "6");
  await lab.enter("Density of the liquid", "13600");
  await lab.enter("Cross-section of the tube", "0.5");
  await lab.enter("Damping", "200");
  await record(lab, 5);
  await lab.pressInMenu("ES – Español");
  await lab.openTable();
  const { text } = await lab.save(lab.button("Descargar CSV"));
  const settings = ["h_l=2", "h_r=6", "rho=13600", "S=0.5", "b=200"].flatMap((setting) => ["--set", setting]);
  // As programs with decimal commas read it: the same numbers to the last digit.
  assert.match(text, /^\ufeff[^,]*;[^,]*\r?\n/);
  const plain = text.replace(/^\ufeff/, "").replaceAll("\r\n", "\n").replaceAll(",", ".").replaceAll(";", ",");
  assert.equal(plain, sameRun(plain, ...settings));
});

visit("figures are saved as SVG and PNG", async (lab) => {
  await record(lab, 2);
  const plot = lab.page.locator("figure.plot").first();
  const { name, text } = await lab.saveOfPlot(plot, "Download SVG");
  assert.match(name, /\.svg$/);
  assert.match(text, /^<svg /);
  assert.match(text, /<(path|polyline)/);
  const csv = await lab.saveOfPlot(plot, "Download CSV of this plot");
  assert.equal(csv.name, "displacement-and-velocity.csv");
  assert.match(csv.text, /^t \[s\],y \[m\],t \[s\],y′ \[m\/s\]\r\n0,0\.5,0,0\r\n/);
  await plot.locator("[id^=plot-more]").click();
  const [download] = await Promise.all([lab.page.waitForEvent("download"), plot.getByRole("button", { name: "Download PNG" }).click()]);
  const png = readFileSync(await download.path());
  assert.equal(png.subarray(1, 4).toString(), "PNG");
});

visit("the table on the page follows the run", async (lab) => {
  await lab.openTable();
  assert.equal(await lab.rows(), 1);
  await record(lab, 3);
  assert.ok((await lab.rows()) > 60);
  await lab.press("Back to start");
  await eventually(async () => assert.ok((await lab.page.locator(".data tbody tr").count()) >= 1));
});

visit("a link reopens the same state, and so does a reload", async (lab) => {
  await lab.enter("Damping", "20");
  await lab.preset("Moon");
  await record(lab, 2);
  const state = async (lab) => ({
    time: await lab.time(),
    damping: await lab.number("Damping"),
    gravity: await lab.number("Gravitational acceleration"),
    displacement: await lab.number("Displacement"),
  });
  const expected = await state(lab);
  await lab.copyLink();
  const link = lab.page.url();
  assert.match(link, /#.+/);

  const other = await Lab.open();
  await other.page.goto("about:blank");
  await other.go(link);
  await eventually(async () => assert.deepEqual(await state(other), expected));
  other.wasQuiet();
  await other.context.close();

  await lab.page.reload();
  await eventually(async () => assert.deepEqual(await state(lab), expected));
});

visit("an exported laboratory plays from a file, without a network", { file: exportedLaboratory }, async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(1);
  assert.match(await lab.page.title(), /U-tube/);
  assert.equal(await lab.page.getByRole("tab", { name: "Measure" }).count(), 1);
});

function exportedLaboratory() {
  const file = temporary("laboratory.html");
  meniscus("export", "simulations/utube.md", "--lab", "--output", file);
  return file;
}

function exported() {
  const file = temporary("exported.html");
  meniscus("export", "simulations/utube.md", "--output", file);
  return file;
}

visit("an exported page and a document can be opened", async (lab) => {
  await lab.page.setInputFiles("#open-file", exported());
  await eventually(async () => assert.equal(await lab.time(), 0));
  await lab.openSource();
  assert.match(await lab.page.locator(".source pre").first().innerText(), /^---\ntitle: /);
});

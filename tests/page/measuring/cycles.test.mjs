// A record without a theory: cycle by cycle, differentiated, read off the plots.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { STILL, drop, eventually, number, sight, temporary, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const measured = new URL("../../../../shared/data/utube/U3.txt", import.meta.url);

/** A film of a swinging level in centimetres: 9.6 rad/s, 0.39 /s, with a camera's noise. */
function film() {
  const rows = ["t [s]\ty [cm]"];
  for (let frame = 0; frame < 150; frame += 1) {
    const time = frame / 30;
    const level = 1 + 6 * Math.exp(-0.39 * time) * Math.cos(9.6 * time + 0.7) + 0.01 * Math.sin(1.7 * frame * frame);
    rows.push(`${time.toFixed(6)}\t${level.toFixed(6)}`);
  }
  return rows.join("\n");
}

const cycles = (lab) => lab.page.locator("#cycles");

async function look(lab, name = "Cycle by cycle") {
  await cycles(lab).getByText(name, { exact: true }).click();
  await cycles(lab).locator("tbody tr").first().waitFor();
}

visit("the cycles of a record: table, words, plots, files", async (lab) => {
  await drop(lab, { name: "film.txt", text: film() });
  await cycles(lab).waitFor();
  // Nothing is measured before somebody looks.
  assert.equal(await cycles(lab).locator("table").count(), 0);
  await look(lab);
  const rows = await cycles(lab).locator("tbody tr").evaluateAll((rows) => rows.map((row) => [...row.cells].map((cell) => cell.innerText)));
  assert.ok(rows.length >= 12, `${rows.length} turning points`);
  for (const [kind, , , , , frequency] of rows) {
    assert.match(kind, /^(maximum|minimum)$/);
    const [value, error] = frequency.split("±").map(number);
    assert.ok(Math.abs(value - 9.6) < 5 * error, frequency);
  }
  assert.match(await cycles(lab).locator(".verdicts").innerText(), /angular frequency is the same in all cycles/);
  assert.match(await cycles(lab).locator(".verdicts").innerText(), /damping is the same in all cycles/);

  // One plot at a time, of what is chosen, against what is chosen.
  const title = () => cycles(lab).locator("figure h3").innerText();
  assert.equal(await title(), "Period against time");
  await lab.page.getByRole("combobox", { name: "Drawn" }).selectOption("Damping");
  await eventually(async () => assert.equal(await title(), "Damping against time"));
  await cycles(lab).getByRole("button", { name: "amplitude", exact: true }).click();
  await eventually(async () => assert.equal(await title(), "Damping against amplitude"));
  const svg = await lab.saveOfPlot(cycles(lab).locator("figure"), "Download SVG");
  assert.equal(svg.name, "damping-against-amplitude.svg");
  assert.match(svg.text, /Damping against amplitude/);
  assert.ok((svg.text.match(/<circle/g) ?? []).length >= 12, "a point for each turning point");

  const csv = await lab.save(cycles(lab).getByRole("button", { name: "CSV", exact: true }));
  assert.equal(csv.name, "film-cycles.csv");
  assert.equal(csv.text.trim().split("\n").length, rows.length + 1);
  const book = await lab.save(cycles(lab).getByRole("button", { name: "XLSX", exact: true }));
  assert.equal(book.name, "film-cycles.xlsx");

  // The keyboard reads it, with errors.
  await lab.page.getByRole("combobox", { name: "Drawn" }).selectOption("Period");
  await cycles(lab).locator("canvas").focus();
  await eventually(async () => {
    await lab.keys("ArrowRight");
    assert.match(await lab.told(), /T = \(0\.6\d+ ± 0\.\d+\) s/);
  });
});

visit("a column that does not oscillate says so, and another record takes its place", async (lab) => {
  await drop(lab, { name: "flat.txt", text: "t;y\n0;1\n1;1\n2;1\n3;1\n" });
  await cycles(lab).getByText("Cycle by cycle", { exact: true }).click();
  await eventually(async () => assert.match(await cycles(lab).innerText(), /does not oscillate/));
  assert.equal(await cycles(lab).locator("figure").isVisible(), false);
  await drop(lab, { name: "film.txt", text: film() });
  await eventually(async () => assert.equal(await lab.page.getByRole("combobox", { name: "Column" }).locator("option").count(), 2));
  await lab.page.getByRole("combobox", { name: "Column" }).selectOption("film.txt: y [cm]");
  await cycles(lab).locator("tbody tr").first().waitFor();
});

visit("velocity and acceleration are computed and add no independent information", async (lab) => {
  await drop(lab, { name: "film.txt", text: film() });
  const record = lab.page.locator("article.record");
  await record.getByText("Velocity and acceleration").click();
  await record.getByRole("button", { name: "Make columns" }).click();
  await eventually(async () => assert.match(await lab.told(), /Velocity and acceleration made: film\.txt/));
  const head = record.locator(".table").first();
  assert.match(await head.innerText(), /y' \[cm\/s\]\s*central differences/);
  assert.equal(await lab.page.getByRole("combobox", { name: "Measures, y' [cm/s]" }).inputValue(), "y'");
  assert.equal(await lab.page.getByRole("checkbox", { name: "Fit it, y' [cm/s]" }).isChecked(), false);
  // The first row has no neighbour before it: a gap.
  assert.match(await sight(record.locator("tbody tr").nth(2).locator(".first-values")), /^– · /);
  // Polynomials in their place; a window that cannot be says so.
  await record.getByRole("combobox", { name: "By" }).selectOption("smoothing polynomials");
  await record.getByRole("textbox", { name: "Rows" }).fill("8");
  await record.getByRole("button", { name: "Make columns" }).click();
  await eventually(async () => assert.match(await lab.page.locator("#record-refusal").innerText(), /no such polynomial/));
  await record.getByRole("textbox", { name: "Rows" }).fill("7");
  await record.getByRole("button", { name: "Make columns" }).click();
  await eventually(async () => assert.match(await head.innerText(), /polynomials of degree 3 over 7 rows/));
  // They are there after a reload.
  await lab.page.reload();
  await lab.tab("Measure");
  await eventually(async () => assert.match(await head.innerText(), /polynomials of degree 3 over 7 rows/));
  await record.getByText("Velocity and acceleration").click();
  await record.getByRole("button", { name: "Remove them" }).click();
  await eventually(async () => assert.doesNotMatch(await head.innerText(), /polynomials/));
});

visit("the pointer reads the measured point beside the curve", async (lab) => {
  await drop(lab, { name: "film.txt", text: film() });
  const canvas = lab.page.locator("#canvas-0");
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const tip = lab.page.locator("figure").filter({ has: canvas }).locator(".tip");
  await eventually(async () => {
    await lab.page.mouse.move(box.x + box.width * 0.4, box.y + box.height / 2);
    await lab.page.mouse.move(box.x + box.width * 0.4 + 1, box.y + box.height / 2);
    assert.match(await tip.innerText(), /film\.txt: t = [\d.]+\ss, y = /);
  });
});

/** The first sheet of a workbook as LibreOffice reads it; nothing where there is none. */
function opened(book) {
  const directory = temporary("office");
  mkdirSync(directory, { recursive: true });
  const words = [`-env:UserInstallation=file://${join(directory, "profile")}`, "--headless", "--convert-to", "csv", "--outdir", directory, book];
  try {
    execFileSync("soffice", words, { stdio: "ignore" });
  } catch (failure) {
    if (failure.code !== "ENOENT") throw failure;
    console.error("left out: LibreOffice is not here");
    return null;
  }
  return readFileSync(book.replace(/^.*[/\\]/, `${directory}/`).replace(/\.xlsx$/, ".csv"), "utf8");
}

visit("LibreOffice opens the workbook of the page", async (lab) => {
  await drop(lab, { name: "film.txt", text: film() });
  await cycles(lab).waitFor();
  await look(lab);
  const rows = await cycles(lab).locator("tbody tr").count();
  const [download] = await Promise.all([lab.page.waitForEvent("download"), cycles(lab).getByRole("button", { name: "XLSX", exact: true }).click()]);
  const book = temporary("cycles.xlsx");
  await download.saveAs(book);
  const text = opened(book);
  if (text === null) return;
  assert.match(text, /^t \[s\],t_stderr \[s\],amplitude \[cm\]/);
  assert.equal(text.trim().split("\n").length, rows + 1);
});

visit("a real film has cycles that the linear theory does not allow", { language: "es-ES", skip: !existsSync(measured) && "needs ../shared/data/utube" }, async (lab) => {
  const file = temporary("U3.txt");
  writeFileSync(file, readFileSync(measured));
  await lab.tab("Medir");
  await lab.page.setInputFiles("#record-file", file);
  await cycles(lab).waitFor();
  await look(lab, "Ciclo a ciclo");
  assert.match(await cycles(lab).locator(".verdicts").innerText(), /La frecuencia angular cambia más de lo que explican sus errores/);
});

for (const [language, theme, size] of [["en-GB", "light", {}], ["es-ES", "dark", { width: 390, height: 844, touch: true }]]) {
  visit(`axe finds nothing in the cycles and derivatives: ${language}, ${theme}`, { ...STILL, language, theme, ...size }, async (lab) => {
    await drop(lab, { name: "film.txt", text: film() });
    await cycles(lab).waitFor();
    await lab.page.evaluate(() => document.querySelectorAll(".measurements details").forEach((details) => (details.open = true)));
    await cycles(lab).locator("tbody tr").first().waitFor();
    await lab.page.evaluate(axe);
    const found = (await lab.page.evaluate(() => window.axe.run("html"))).violations;
    assert.deepEqual(found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 160))}`), []);
    assert.equal(await lab.page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false, "no sideways scrolling");
  });
}

// Measured data in the page: dropped, looked at, fitted, ranked, handed in.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { Lab, STILL, drop, eventually, sight, temporary, visit } from "../lab.mjs";
import { DAMPING, LENGTH, film, fit, fitted, openTheory, records, unzip, unfold } from "../measured.mjs";
import { withoutWorkers } from "../workers.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const measured = new URL("../../../../shared/data/utube/U3.txt", import.meta.url);

visit("a dropped file is recognised, drawn, and fitted by one button", async (lab) => {
  await openTheory(lab, "Linear damping");
  await drop(lab, { name: "film.csv", text: film() });
  await records(lab).waitFor();
  assert.equal(await lab.page.getByRole("tab", { name: "Measure" }).getAttribute("aria-selected"), "true");
  const taken = await records(lab).locator(".table select").evaluateAll((selects) => selects.map((select) => select.value));
  assert.deepEqual(taken, ["t", "y"]);
  assert.equal(await lab.field("Unit, y [cm]").inputValue(), "cm");
  assert.ok(await lab.page.getByRole("checkbox", { name: "Fit it, y [cm]" }).isChecked());
  // Outline of the measured level in the scene.
  await eventually(async () => assert.ok((await lab.page.locator("#scene [part=measured]").count()) > 0));
  assert.equal(await lab.page.getByRole("heading", { name: "Residuals" }).isVisible(), false, "folded until it is asked for");
  await lab.press("Residuals");
  assert.equal(await lab.page.getByRole("heading", { name: "Residuals" }).isVisible(), true);

  const found = await fit(lab);
  const length = found.get("Length of the column");
  assert.ok(Math.abs(length.value - LENGTH) < 3 * length.spread, JSON.stringify([...found]));
  const damping = found.get("Damping rate");
  assert.ok(Math.abs(damping.value - DAMPING) < 3 * damping.spread + 1e-3, JSON.stringify([...found]));
  // It stands in the slider, and the run covers the record.
  assert.ok(Math.abs((await lab.number("Length of the column")) - LENGTH) < 1e-3);
  await eventually(async () => assert.match(await lab.told(), /fitted values/));

  // Records and fits outlive another document and a reload.
  await openTheory(lab, "Quadratic damping");
  await lab.tab("Measure");
  assert.equal(await records(lab).count(), 1);
  await lab.tab("Measure");
  assert.equal(await lab.page.locator(".fits tbody tr").count(), 1);
  await lab.page.reload();
  await lab.tab("Measure");
  await eventually(async () => assert.equal(await records(lab).count(), 1));
});

visit("a fit is handed in as report, workbook and CSV", { language: "es-ES" }, async (lab) => {
  await openTheory(lab, "Amortiguamiento lineal");
  await drop(lab, { name: "película.csv", text: film() });
  await records(lab).waitFor();
  await fit(lab);
  const download = async (name) => {
    const [file] = await Promise.all([lab.page.waitForEvent("download"), lab.page.locator(".detail").getByRole("button", { name, exact: true }).click()]);
    return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
  };
  const workbook = await download("XLSX");
  assert.equal(workbook.name, "película.xlsx");
  const files = unzip(workbook.bytes);
  const sheets = [...files.keys()].filter((name) => /^xl\/worksheets\/.*\.xml$/.test(name));
  assert.ok(sheets.length >= 3, `data, curves and results: ${[...files.keys()]}`);
  const rows = Math.max(...sheets.map((name) => files.get(name).split("<row").length - 1));
  assert.ok(rows >= 240, `${rows} rows`);

  const csv = (await download("CSV")).bytes.toString("utf8");
  assert.match(csv, /;/, "semicolons between");
  assert.match(csv, /\d,\d/, "decimal commas");
  const report = (await download("Informe")).bytes.toString("utf8");
  assert.match(report, /<html lang="es"/);
  assert.match(report, /<svg/);
  assert.doesNotMatch(report, /<script/);
});

visit("a virtual measurement is fitted, and the truth is found", async (lab) => {
  await openTheory(lab, "Linear damping");
  await lab.enter("Length of the column", "0.3");
  await lab.tab("Measure");
  await lab.page.locator("#virtual summary").click();
  await lab.page.getByRole("textbox", { name: "Duration" }).fill("6");
  await lab.page.getByRole("textbox", { name: "Noise of a reading" }).fill("0.5 mm");
  await lab.page.getByRole("textbox", { name: "Seed" }).fill("7");
  await lab.press("Measure");
  await records(lab).waitFor();
  assert.equal(await sight(records(lab).locator(".tag")), "synthetic");
  // Somewhere else, as if the answer were unknown.
  await lab.tab("Explore");
  await lab.press("Restore defaults");
  const found = await fit(lab);
  const length = found.get("Length of the column");
  assert.ok(Math.abs(length.value - 0.3) < 3 * length.spread, JSON.stringify(length));
  assert.match(length.remark, /^true value: 0.3 m; deviation −?\d/);
  // A field that cannot be says so.
  await lab.tab("Measure");
  await lab.page.getByRole("textbox", { name: "Frames per second" }).fill("none");
  await lab.press("Measure");
  assert.equal(await lab.page.getByRole("textbox", { name: "Frames per second" }).getAttribute("aria-invalid"), "true");
});

visit("the sample with a contact line is told from the others", async (lab) => {
  await lab.tab("Measure");
  await lab.page.locator("#other-ways summary").click();
  await lab.press("Column with a contact line");
  await records(lab).waitFor();
  await lab.tab("Measure");
  await lab.press("Rank all theories");
  // The page is not frozen meanwhile, and what is begun can be given up.
  await lab.page.locator("#cancel-fit").waitFor();
  await eventually(async () => assert.ok((await lab.page.locator(".fits tbody tr").count()) >= 2), 120);
  await lab.press("Cancel");
  await unfold(lab, "fit");
  await eventually(async () => assert.match(await lab.told(), /cancelled/));
  const before = await lab.page.locator(".fits tbody tr").count();
  // One of them is opened with what was found.
  await lab.page.getByRole("button", { name: /^Open: / }).first().click();
  await eventually(async () => assert.notEqual(await lab.page.getByRole("heading", { level: 1 }).innerText(), "Oscillations of a liquid in a U-tube"));
  await eventually(async () => assert.match(await lab.told(), /fitted values/));
  await lab.tab("Measure");
  assert.equal(await lab.page.locator(".fits tbody tr").count(), before);
});

visit("a fit takes a theory and a button, and the result stands beside the plots", async (lab) => {
  await drop(lab, { name: "film.csv", text: film() });
  await records(lab).waitFor();
  await lab.tab("Measure");
  await unfold(lab, "theory");
  const chips = lab.page.getByRole("group", { name: "Theories" }).getByRole("button");
  assert.match(await chips.first().innerText(), /U-tube/, "the open document is the theory");
  const linear = lab.page.locator(".theory-chip").filter({ has: lab.page.getByText("Linear damping", { exact: true }) });
  await eventually(async () => assert.equal(await linear.locator("math").count(), 1, "each has its equation"));
  await linear.scrollIntoViewIfNeeded();
  const place = () => lab.page.locator("#theory-step").evaluate((step) => step.getBoundingClientRect().top);
  const before = await place();
  await linear.click();
  await lab.page.getByRole("heading", { level: 1, name: "Linear damping" }).waitFor();
  assert.equal(await lab.page.getByRole("tab", { name: "Measure" }).getAttribute("aria-selected"), "true", "nobody is sent elsewhere");
  assert.ok(Math.abs((await place()) - before) < 2);
  await eventually(async () => assert.equal(await linear.getAttribute("aria-pressed"), "true"));
  // The part that counts is the one that a zoomed plot shows.
  await unfold(lab, "record");
  assert.equal(await lab.page.locator("#fit-part-in-plot").isVisible(), false);
  await lab.page.locator("#canvas-0").focus();
  await lab.keys("+", "+");
  await lab.press("Take the part in the plot");
  const ends = await Promise.all([0, 1].map(async (end) => Number(await lab.page.locator(`#fit-end-${end}`).inputValue())));
  assert.ok(ends[0] > 0.5 && ends[1] > ends[0] + 1 && ends[1] < 9, String(ends));
  await lab.page.locator("#fit").click();
  await fitted(lab);
  // The list of fits is not cut off.
  const cut = await lab.page.locator(".fits, .record .table").evaluateAll((boxes) => boxes.filter((box) => box.scrollWidth > box.clientWidth + 1).map((box) => box.className));
  assert.deepEqual(cut, []);
});

visit("what cannot be read says where and why, and nothing is lost", async (lab) => {
  await lab.enter("Damping", "60");
  await drop(lab, { name: "words.txt", text: "there is\nnothing here\n" }, { name: "film.csv", text: film() });
  await eventually(async () => assert.equal(await records(lab).count(), 1));
  await drop(lab, { name: "photo.png", text: "\x89PNG\r\n\x1a\n\0\0\0" });
  const refusal = lab.page.locator("#record-refusal");
  await eventually(async () => assert.match(await refusal.innerText(), /photo\.png could not be read/));
  assert.equal(await records(lab).count(), 1);
  assert.equal(await lab.number("Damping"), 60);
});

visit("a pasted table is read, its columns renamed and switched off", async (lab) => {
  await lab.tab("Measure");
  await lab.page.locator("#other-ways summary").click();
  await lab.page.locator("#paste-record").fill("0 1 2\n0.1 2 3\n0.2 3 5\n0.3 2 4\n");
  await lab.press("Read");
  await records(lab).waitFor();
  const column = lab.page.getByRole("combobox", { name: "Measures, 3" });
  assert.equal(await column.inputValue(), "y'");
  await column.selectOption("not used");
  await eventually(async () => assert.equal(await lab.page.getByRole("textbox", { name: "Unit, 3" }).count(), 0));
  const unit = lab.page.getByRole("textbox", { name: "Unit, 2" });
  await unit.fill("kg");
  await unit.press("Enter");
  await eventually(async () => assert.match(await lab.page.locator("#record-refusal").innerText(), /measures something else/));
});

visit("a real film is fitted", { skip: !existsSync(measured) && "needs ../shared/data/utube" }, async (lab) => {
  await openTheory(lab, "Damped cosine");
  const file = temporary("U3.txt");
  writeFileSync(file, readFileSync(measured));
  await lab.tab("Measure");
  await lab.page.setInputFiles("#record-file", file);
  await records(lab).waitFor();
  assert.match(await sight(records(lab)), /6 frames are missing/);
  assert.match(await sight(records(lab)), /no independent information/);
  const found = await fit(lab);
  // The published fit.
  for (const [name, expected] of [["Damping rate", 0.386718345], ["Angular frequency with damping", 9.60927046]]) {
    const { value, spread } = found.get(name);
    assert.ok(Math.abs(value - expected) < Math.max(spread / 10, 1e-3), `${name}: ${value}`);
  }
});

visit("from the sample to the result by keyboard alone", async (lab) => {
  await lab.tabTo("#browse");
  await lab.keys("Enter");
  await lab.page.getByRole("dialog").waitFor();
  await lab.page.getByRole("dialog").getByRole("link", { name: "Linear damping", exact: true }).focus();
  await lab.keys("Enter");
  await eventually(async () => assert.equal((await lab.focused()).id, "browse"));
  await lab.tabTo("[role=tab]");
  await lab.keys("End", "ArrowLeft");
  await lab.tabTo("#sample-record");
  await lab.keys("Enter");
  await records(lab).waitFor();
  await lab.tabTo("[id^=fitted-]");
  const ticked = (await lab.focused()).id;
  await lab.keys("Space");
  await eventually(async () => assert.equal((await lab.focused()).id, ticked, "the focus stays"));
  await lab.keys("Space");
  await eventually(async () => assert.equal(await lab.page.locator(`#${ticked}`).isChecked(), true));
  await lab.tabTo("#fit");
  await lab.keys("Enter");
  await fitted(lab);
  await lab.tabTo("[id^=fit-][aria-pressed]");
});

for (const language of ["en-GB", "es-ES"]) {
  for (const theme of ["light", "dark"]) {
    for (const [device, size] of [["desk", {}], ["phone", { width: 390, height: 844, touch: true }]]) {
      visit(`axe finds nothing in a fit: ${language}, ${theme}, ${device}`, { ...STILL, language, theme, ...size }, async (lab) => {
        const spanish = language === "es-ES";
        await openTheory(lab, spanish ? "Amortiguamiento lineal" : "Linear damping");
        await lab.tab(spanish ? "Medir" : "Measure");
        await lab.page.locator("#sample-record").click();
        await records(lab).waitFor();
        await fit(lab);
        await lab.page.evaluate(() => document.querySelectorAll("details").forEach((details) => (details.open = true)));
        await lab.page.evaluate(axe);
        const check = (part) => lab.page.evaluate((part) => window.axe.run(part), part);
        const found = (await check("html")).violations;
        await lab.page.locator("#browse").click();
        found.push(...(await check("#library-list")).violations);
        assert.deepEqual(found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 160))}`), []);
        assert.equal(await lab.page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false, "no sideways scrolling");
      });
    }
  }
}

visit("the part that is fitted is brushed in the plot", async (lab) => {
  await openTheory(lab, "Linear damping");
  await drop(lab, { name: "film.csv", text: film() });
  await records(lab).waitFor();
  await lab.tab("Measure");
  const end = async (number) => lab.page.locator(`#fit-end-${number}`).inputValue();
  assert.deepEqual(await Promise.all([end(0), end(1)]), ["", ""]);
  // An open end lies at the edge of the panel, on the vertical axis.
  const plot = await lab.page.locator("#canvas-0").boundingBox();
  const row = plot.y + plot.height / 2;
  const cursor = () => lab.page.locator("#canvas-0").evaluate((canvas) => canvas.style.cursor);
  /** Where the pointer says, from the left, that something can be dragged to the sides. */
  const grip = async () => {
    for (let x = plot.x + 20; x < plot.x + plot.width; x += 4) {
      await lab.page.mouse.move(x, row);
      if ((await cursor()) === "ew-resize") return x;
    }
    throw new Error("nothing can be dragged to the sides");
  };
  const edge = await eventually(grip);
  const middle = plot.x + plot.width / 2;
  const drag = async (from, to) => {
    await lab.page.mouse.move(from, row);
    await lab.page.mouse.down();
    await lab.page.mouse.move((from + to) / 2, row, { steps: 4 });
    await lab.page.mouse.move(to, row, { steps: 4 });
    await lab.page.mouse.up();
  };
  await drag(edge, middle);
  const half = await eventually(async () => {
    const from = Number(await end(0));
    assert.ok(from > 2 && from < 7, `from ${from}`);
    return from;
  });
  // Elsewhere a drag moves the plot, as ever; the brush goes with it and keeps its time.
  await drag(middle + 60, middle + 20);
  assert.equal(Number(await end(0)), half);
  await unfold(lab, "record");
  assert.equal(await lab.page.getByRole("button", { name: "Take the part in the plot" }).isVisible(), true, "it is zoomed");
  await lab.page.locator("#canvas-0").dblclick({ position: { x: plot.width * 0.8, y: 20 } });
  // What is fitted is the rest of the record.
  await lab.page.locator("#fit").click();
  await fitted(lab);
  const before = Number((await lab.page.locator(".detail").innerText()).match(/(\d+) values before/)[1]);
  assert.equal(before, Math.ceil(half * 30), "30 values a second");
  // Back at the edge it is open again, and in no other tab does it lie over the plots.
  await drag(await grip(), plot.x + 5);
  await eventually(async () => assert.equal(await end(0), ""));
  await lab.tab("Explore");
  await lab.page.mouse.move(edge, row);
  assert.equal(await cursor(), "");
});

/** A theory and a record, in the tab with the fits. */
async function measuredColumn(lab) {
  await openTheory(lab, "Linear damping");
  await drop(lab, { name: "film.csv", text: film() });
  await records(lab).waitFor();
  await lab.tab("Measure");
}

visit("theories are ranked by two workers", async (lab) => {
  await measuredColumn(lab);
  await lab.page.locator("#rank").click();
  await lab.page.locator("#cancel-fit").waitFor();
  await eventually(() => assert.equal(lab.page.workers().length, 2));
  await lab.page.locator("#cancel-fit").waitFor({ state: "detached", timeout: 120_000 });
  assert.equal(await lab.page.locator(".fits tbody tr").count(), 9);
});

visit("a fit finds the same without workers", async (lab) => {
  await measuredColumn(lab);
  const found = await fit(lab);
  assert.equal(lab.page.workers().length, 1);
  // The browser reports in its console what it refuses; this page is not asked whether it was quiet.
  const other = await Lab.open({ file: withoutWorkers() });
  try {
    await measuredColumn(other);
    assert.deepEqual([...(await fit(other))], [...found]);
    assert.equal(other.page.workers().length, 0);
  } finally {
    await other.context.close();
  }
});

visit("a ranking that is cancelled ends the workers that compute", async (lab) => {
  await measuredColumn(lab);
  await lab.page.locator("#rank").click();
  await eventually(() => assert.equal(lab.page.workers().length, 2));
  await lab.page.locator("#cancel-fit").click();
  // One that has just finished its fit may be kept.
  await eventually(() => assert.ok(lab.page.workers().length < 2));
  // The next one begins with a new one.
  const found = await fit(lab);
  assert.ok(found.size > 0);
});

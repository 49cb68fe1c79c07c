// What the page says to those who see it: a line for each thing that has happened, with a way back or there; the sign under
// a dragged file; legends for what is drawn.

import assert from "node:assert/strict";
import { drop, eventually, visit } from "../lab.mjs";

const TABLE = "t [s],y [m]\n0.1,0.40\n0.2,0.33\n0.3,0.24\n0.4,0.13\n0.5,0.02\n0.6,-0.1\n";
/** The first bytes of a PNG. */
const PNG = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x01";

const messages = (lab) => lab.page.locator(".message");
/** The words of all lines, once there is one that matches. */
async function reads(lab, words) {
  await eventually(async () => assert.match((await messages(lab).allInnerTexts()).join("\n"), words));
}
/** The time of a line is over. */
const letPass = (lab) => lab.page.evaluate(() => document.getAnimations().filter((one) => one.animationName === "pass").forEach((one) => one.finish()));

visit("a message is shown, spoken once, and passes", async (lab) => {
  const spoken = await lab.page.evaluateHandle(() => {
    const spoken = [];
    new MutationObserver(() => spoken.push(document.querySelector("#spoken").textContent.trim())).observe(document.querySelector("#spoken"), { childList: true, characterData: true, subtree: true });
    return spoken;
  });
  await lab.context.grantPermissions(["clipboard-write"]).catch(() => {});
  await lab.page.locator("#step-forward").click();
  await lab.press("Keep run");
  await reads(lab, /Run kept/);
  assert.deepEqual((await spoken.jsonValue()).filter((words) => /Run kept/.test(words)).length, 1, "spoken once");
  const live = await messages(lab).first().evaluate((line) => line.closest("[aria-live], [role=status], [role=alert]") !== null);
  assert.equal(live, false, "the line itself is not read out again");

  // It waits while it is read, and passes when it is not.
  const running = () => lab.page.evaluate(() => document.getAnimations().find((one) => one.animationName === "pass")?.playState);
  await messages(lab).first().hover();
  await eventually(async () => assert.equal(await running(), "paused"));
  await lab.page.mouse.move(5, 5);
  await eventually(async () => assert.equal(await running(), "running"));
  await letPass(lab);
  await eventually(async () => assert.equal(await messages(lab).count(), 0));
});

visit("an error stays until it is dismissed, ordinary messages follow one another", async (lab) => {
  await lab.page.locator("#step-forward").click();
  for (let runs = 0; runs < 6; runs += 1) await lab.press("Keep run");
  await reads(lab, /5 runs are kept already/);
  const error = lab.page.locator(".message.error");
  assert.equal(await error.evaluate((line) => getComputedStyle(line).animationName), "none");
  await lab.enter("Damping", "60");
  await lab.press("Restore defaults");
  await lab.preset("Mercury");
  assert.equal(await messages(lab).count(), 2, "the error, and the last of the others");
  await error.getByRole("button", { name: "Dismiss" }).click();
  assert.equal(await error.count(), 0);
  const covered = await lab.page.evaluate(() => {
    const line = document.querySelector(".message").getBoundingClientRect();
    const bar = document.querySelector("#transport").getBoundingClientRect();
    return line.bottom > bar.top + 1 && line.left < bar.right;
  });
  assert.equal(covered, false, "the transport is not covered");
});

visit("what was removed is brought back by Undo", async (lab) => {
  await drop(lab, { name: "level.csv", text: TABLE });
  await lab.page.getByRole("heading", { name: "level.csv" }).waitFor();
  await lab.press("Remove the record: level.csv");
  await lab.press("Undo");
  await lab.page.getByRole("heading", { name: "level.csv" }).waitFor();

  await lab.press("Step forward");
  await lab.press("Keep run");
  const kept = lab.page.getByRole("list", { name: "Kept runs" }).getByRole("checkbox");
  await lab.page.getByRole("button", { name: /^Remove: / }).first().click();
  assert.equal(await kept.count(), 0);
  await lab.press("Undo");
  assert.equal(await kept.count(), 1);

  await lab.enter("Damping", "77");
  await lab.page.locator("#tab-explore").click();
  await lab.press("Restore defaults");
  assert.equal(await lab.number("Damping"), 50);
  await lab.page.evaluate(() => document.activeElement.blur());
  await lab.keys("Control+z");
  assert.equal(await lab.number("Damping"), 77);
  await reads(lab, /Undone/);
});

visit("a file that cannot be read is told", async (lab) => {
  for (const [name, text] of [["photo.png", PNG], ["empty.csv", ""], ["binary.bin", "\0\x01\x02\xff\0\0"]]) {
    await drop(lab, { name, text });
    await reads(lab, new RegExp(name.replace(".", "\\.")));
  }
  assert.equal(await lab.page.locator(".message.error").count(), 3);
  await lab.page.setInputFiles("#open-file", { name: "page.html", mimeType: "text/html", buffer: Buffer.from("<p>no document</p>") });
  await reads(lab, /neither a simulation document nor an exported page/);
});

visit("a document that is not text is refused, and the open one stays", async (lab) => {
  const title = await lab.page.getByRole("heading", { level: 1 }).innerText();
  await lab.page.setInputFiles("#open-file", { name: "binary.md", mimeType: "text/markdown", buffer: Buffer.from([0x89, 0x50, 0x4e, 0x47, 0xff, 0xfe, 0x00]) });
  await reads(lab, /binary\.md is not text in UTF-8/);
  assert.equal(await lab.page.getByRole("heading", { level: 1 }).innerText(), title);
});

for (const [width, height] of [[1440, 900], [1024, 768], [768, 1024], [390, 844]]) {
  visit(`messages cover neither tabs nor the status line: ${width} by ${height}`, { width, height }, async (lab) => {
    await lab.tab("Write");
    const content = lab.page.locator(".cm-content");
    await content.waitFor();
    await lab.press("New");
    await lab.press("A mass on a spring");
    await eventually(async () => assert.match(await content.innerText(), /A mass/));
    await content.click();
    await lab.keys("Control+End");
    await lab.page.keyboard.insertText("\n```model\nq = zz\n```\n");
    await eventually(async () => assert.match(await lab.page.locator("#writing-status").innerText(), /^1 error/));
    await lab.press("Format");
    await reads(lab, /layout/);
    const covered = await lab.page.evaluate(() => {
      const line = document.querySelector(".message").getBoundingClientRect();
      const meets = (other) => line.left < other.right && other.left < line.right && line.top < other.bottom && other.top < line.bottom;
      return [".tabs", ".writing-tabs", "#writing-status", "#show-errors", "#transport", ".head-tools"].filter((name) => meets(document.querySelector(name).getBoundingClientRect()));
    });
    assert.deepEqual(covered, []);
  });
}

visit("scrubbing and playing leave the line alone", async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(0.5);
  await lab.press("Pause");
  await lab.slider("Time line").focus();
  await lab.keys("ArrowLeft", "ArrowLeft", "Home");
  await lab.slider(/^Damping/).focus();
  await lab.keys("ArrowRight", "ArrowRight");
  assert.equal(await messages(lab).count(), 0);
});

visit("a new record is shown where it lies", { width: 390, height: 700 }, async (lab) => {
  await drop(lab, { name: "level.csv", text: TABLE });
  await reads(lab, /level\.csv/);
  const record = lab.page.getByRole("article", { name: "level.csv" });
  assert.match(await record.getAttribute("class"), /new/, "it stands out");
  assert.equal(await record.evaluate((node) => node.getBoundingClientRect().top < innerHeight), false, "out of sight at first");
  await lab.press("Show");
  await eventually(async () => {
    const { top, bottom } = await record.evaluate((node) => ({ top: node.getBoundingClientRect().top, bottom: innerHeight }));
    assert.ok(top >= 0 && top < 0.7 * bottom, `at ${top}`);
  });
  assert.equal(await record.evaluate((node) => node === document.activeElement), true);
});

visit("files over the page are invited", async (lab) => {
  const drag = (kind, type) =>
    lab.page.evaluate(([kind, type]) => {
      const dataTransfer = new DataTransfer();
      if (type === "file") dataTransfer.items.add(new File(["1"], "a.csv"));
      else dataTransfer.setData("text/plain", "words");
      const event = new DragEvent(kind, { dataTransfer, bubbles: true, cancelable: true });
      document.querySelector("#apparatus").dispatchEvent(event);
      return event.defaultPrevented;
    }, [kind, type]);
  const sign = lab.page.getByText("Drop a document, a film or measured data");
  assert.equal(await drag("dragenter", "text"), false, "dragged words are the browser's business");
  assert.equal(await sign.count(), 0);
  assert.equal(await drag("dragenter", "file"), true);
  assert.equal(await drag("dragover", "file"), true);
  assert.equal(await sign.isVisible(), true);
  await drag("dragleave", "file");
  assert.equal(await sign.count(), 0);
  await drag("dragenter", "file");
  await drop(lab, { name: "level.csv", text: TABLE });
  assert.equal(await sign.count(), 0);
  await lab.page.getByRole("heading", { name: "level.csv" }).waitFor();
});

visit("what is drawn besides the curves is explained", async (lab) => {
  const plot = lab.page.locator("figure.plot").first();
  const svg = async () => (await lab.saveOfPlot(plot, "Download SVG")).text;
  assert.doesNotMatch(await svg(), /level\.csv|previous run/);
  await drop(lab, { name: "level.csv", text: TABLE });
  assert.match(await svg(), />y \(level\.csv\)</, "the points");
  assert.equal(await lab.page.locator("#scene").getByText("Dotted: measured: level.csv").isVisible(), true, "the outline in the scene");
  await lab.press("Play");
  await lab.watchUntil(1);
  await lab.press("Pause");
  await lab.slider("Time line").focus();
  await lab.keys("Home");
  await lab.press("Step forward");
  assert.match(await svg(), />previous run</);
  await lab.page.getByText("Previous run", { exact: true }).waitFor();
  await lab.pressInMenu("ES – Español");
  assert.equal(await lab.page.locator("#scene").getByText("A puntos: lo medido: level.csv").isVisible(), true);
});

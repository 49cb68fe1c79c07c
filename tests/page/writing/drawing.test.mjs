// The drawing by hand: elements are placed, sized, turned, named and bound to quantities by mouse, keys and fingers, and what comes of
// it is text that runs.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { STILL, eventually, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const editor = (lab) => lab.page.locator(".cm-content");
const text = (lab) => editor(lab).evaluate((content) => content.cmTile?.view?.state.doc.toString() ?? content.innerText);
/** An element of the scene as it is written, by the beginning of its tag. */
const written = async (lab, tag) => new RegExp(`<${tag}[ />][^\n]*`).exec(await text(lab))?.[0];
const becomes = (lab, tag, expected) => eventually(async () => assert.equal(await written(lab, tag), expected));
const runs = (lab, words = /^No errors/) =>
  eventually(async () => assert.match(await lab.page.locator("#writing-status").innerText(), words));
const canvas = (lab) => lab.page.locator("#drawing-canvas");

/** The panel View of a template. */
async function drawing(lab, { write = "Write", begin = "New", template = "A mass on a spring" } = {}) {
  await lab.tab(write);
  await editor(lab).waitFor();
  await lab.press(begin);
  await lab.press(template);
  await eventually(async () => assert.match(await text(lab), /```model/));
  await lab.page.locator("#writing-tab-view").click();
  await lab.page.locator("#drawing-add, #drawing-begin").first().waitFor();
}

/** Adds a part; it is chosen then. */
async function add(lab, part) {
  const before = await text(lab);
  await lab.page.locator("#drawing-add").click();
  await lab.page.locator(`#drawing-palette [data-part=${part}]`).click();
  await eventually(async () => assert.notEqual(await text(lab), before));
  await runs(lab);
  await eventually(async () => assert.ok(await lab.page.locator(".drawing-overlay .edges").count()));
}

/** Chooses an element in the list. */
async function choose(lab, name, options = {}) {
  await lab.page.locator(".layers").getByRole("button", { name, exact: true }).click(options);
}

/** Where a grip stands in the window. */
async function grip(lab, name) {
  const knob = lab.page.locator(`.drawing-overlay .grip.${name} .knob`);
  // A grip is another element as soon as a changed text has been read.
  return eventually(async () => {
    await knob.scrollIntoViewIfNeeded();
    const { x, y, width, height } = await knob.boundingBox();
    return [x + width / 2, y + height / 2];
  });
}

/** Drags from a place by a way, in CSS pixels. */
async function drag(lab, [x, y], [right, down]) {
  await lab.page.mouse.move(x, y);
  await lab.page.mouse.down();
  await lab.page.mouse.move(x + right / 2, y + down / 2);
  await lab.page.mouse.move(x + right, y + down);
  await lab.page.mouse.up();
}

/** How long a centimetre of the frame is on the canvas, in CSS pixels. */
async function centimetre(lab, centimetres = 60) {
  const height = await lab.page.locator("#drawing-canvas svg").first().evaluate((node) => node.getBoundingClientRect().height);
  return height / centimetres;
}

visit("parts are placed, sized and turned by pointing, come to lie on the grid, and are taken back", async (lab) => {
  await drawing(lab);
  const before = await text(lab);
  await choose(lab, "Spring");
  const cm = await centimetre(lab);
  // Its end is held where it follows the displacement.
  const end = await grip(lab, "end");
  await lab.page.mouse.move(...end);
  await lab.page.mouse.down();
  await lab.page.mouse.move(end[0] + 3 * cm, end[1]);
  // The way of the hand is seen.
  await eventually(async () => {
    const way = await lab.page.locator(".drawing-overlay .way").boundingBox();
    assert.ok(Math.abs(way.x - end[0]) < 3 && Math.abs(way.y - end[1]) < 3, `${JSON.stringify(way)} ${end}`);
  });
  await lab.page.mouse.move(end[0] + 6 * cm, end[1] - 2 * cm);
  await lab.page.mouse.up();
  await becomes(lab, "spring", '<spring from="(0, 28 [cm])" to="(6 [cm], y + 6 [cm])" width="24px"/>');
  await runs(lab);
  await lab.press("Undo");
  await eventually(async () => assert.equal(await text(lab), before));
  await add(lab, "block");
  await becomes(lab, "block", '<block at="(0, 0)" size="(6 [cm], 4 [cm])"/>');
  await drag(lab, await grip(lab, "corner"), [2 * cm, 2 * cm]);
  await becomes(lab, "block", '<block at="(0, 0)" size="(10 [cm], 8 [cm])"/>');
  await runs(lab);
  // A quarter turn clockwise: from above the middle to its right.
  await eventually(async () => {
    const [x, y] = await grip(lab, "turn");
    const box = await lab.page.locator(".drawing-overlay .edges").boundingBox();
    const middle = box.y + box.height / 2;
    await drag(lab, [x, y], [middle - y, middle - y]);
    assert.equal(await written(lab, "block"), '<block at="(0, 0)" size="(10 [cm], 8 [cm])" turn="-90 [deg]"/>');
  });
  await runs(lab);
  // Its sides are now upright: a corner that goes down makes it longer, one that goes to the left makes it higher.
  await drag(lab, await grip(lab, "corner"), [-cm, 2 * cm]);
  await becomes(lab, "block", '<block at="(0, 0)" size="(14 [cm], 10 [cm])" turn="-90 [deg]"/>');
  await runs(lab);
  // The picture itself is pressed: what lies there is chosen and moved.
  const box = await eventually(async () => {
    const edges = await lab.page.locator(".drawing-overlay .edges").boundingBox();
    assert.ok(edges, "what is chosen is shown");
    return edges;
  });
  await drag(lab, [box.x + box.width / 2, box.y + box.height / 2], [4 * cm, 0]);
  await becomes(lab, "block", '<block at="(4 [cm], 0)" size="(14 [cm], 10 [cm])" turn="-90 [deg]"/>');
  // Without the grid, a millimetre is enough.
  await lab.page.locator("#drawing-grid").click();
  await canvas(lab).focus();
  await lab.page.keyboard.press("ArrowUp");
  await eventually(async () => assert.match(await written(lab, "block"), /at="\(4 \[cm\], 0\.\d+ \[cm\]\)"/));
});

visit("a new part lands where its author has clicked, and beside what stands there", async (lab) => {
  await drawing(lab);
  await choose(lab, "Spring");
  const cm = await centimetre(lab);
  const [x, y] = await grip(lab, "beginning");
  // The spring hangs at (0, 28 cm). A drag leaves no mark.
  await lab.page.mouse.click(x + 10 * cm, y + 8 * cm);
  await add(lab, "bob");
  await becomes(lab, "bob", '<bob at="(10 [cm], 20 [cm])"/>');
  await add(lab, "block");
  await becomes(lab, "block", '<block at="(14 [cm], 16 [cm])" size="(6 [cm], 4 [cm])"/>');
  await lab.page.mouse.click(x - 10 * cm, y + 8 * cm);
  await add(lab, "wheel");
  await becomes(lab, "wheel", '<wheel at="(-10 [cm], 20 [cm])" r="4 [cm]"/>');
  await runs(lab);
});

visit("the fields show where an element is after each move, also in a text of the same length", async (lab) => {
  await drawing(lab);
  await add(lab, "block");
  const place = lab.page.locator("#attribute-at");
  await eventually(async () => assert.equal(await place.inputValue(), "(0, 0)"));
  await canvas(lab).focus();
  for (const expected of ["(2 [cm], 0)", "(4 [cm], 0)", "(6 [cm], 0)"]) {
    await lab.page.keyboard.press("ArrowRight");
    await eventually(async () => assert.equal(await place.inputValue(), expected));
  }
  await lab.page.locator("#drawing-name").fill("Left");
  await lab.page.locator("#drawing-name").press("Enter");
  await lab.page.locator(".layers").getByRole("button", { name: "Block: Left" }).waitFor();
  await lab.page.locator("#drawing-name").fill("Rest");
  await lab.page.locator("#drawing-name").press("Enter");
  await lab.page.locator(".layers").getByRole("button", { name: "Block: Rest" }).waitFor();
});

visit("an error in a field is told beside it, and the drawing stays in sight", async (lab) => {
  await drawing(lab);
  await add(lab, "block");
  const drawn = () => lab.page.locator("#drawing-canvas svg").first().evaluate((svg) => svg.querySelectorAll("path, rect").length);
  const before = await drawn();
  const size = lab.page.locator("#attribute-size");
  await size.fill("5 cm");
  await size.press("Enter");
  await runs(lab, /^\d error/);
  await eventually(async () => assert.equal(await size.getAttribute("aria-invalid"), "true"));
  await lab.page.locator("#attribute-size-faults .brief.error").waitFor();
  assert.equal(await drawn(), before);
  await size.fill("(5 [cm], 5 [cm])");
  await size.press("Enter");
  await runs(lab);
  await eventually(async () => assert.equal(await size.getAttribute("aria-invalid"), null));
});

visit("a point follows a quantity from where it is, and what is drawn follows the hand in the simulation", async (lab) => {
  await drawing(lab);
  await add(lab, "bob");
  await canvas(lab).focus();
  for (let steps = 0; steps < 3; steps += 1) await lab.page.keyboard.press("ArrowRight");
  await becomes(lab, "bob", '<bob at="(6 [cm], 0)"/>');
  await lab.page.locator("#follow-at-along").selectOption("y");
  await becomes(lab, "bob", '<bob at="(6 [cm], y)"/>');
  await lab.page.locator("#attribute-drag").selectOption("y");
  await becomes(lab, "bob", '<bob at="(6 [cm], y)" drag="y"/>');
  await lab.page.locator("#drawing-name").fill("Bob");
  await lab.page.locator("#drawing-name").press("Enter");
  await becomes(lab, "bob", '<bob at="(6 [cm], y)" drag="y"><title>Bob</title></bob>');
  await runs(lab);
  await lab.page.getByRole("slider", { name: "Bob" }).waitFor();
  // Moving it by hand keeps what it follows.
  await canvas(lab).focus();
  await lab.page.keyboard.press("ArrowUp");
  await eventually(async () => assert.match(await written(lab, "bob"), /at="\(6 \[cm\], y \+ 2 \[cm\]\)"/));
  // What no longer moves with the displacement cannot follow the hand by it.
  await lab.page.locator("#attribute-drag").selectOption("");
  await lab.page.locator("#follow-at-along").selectOption("");
  await eventually(async () => assert.match(await written(lab, "bob"), /at="\(6 \[cm\], 2 \[cm\]\)"/));
  // Something wrong is said, stands in its field, and the last good drawing stays.
  await lab.page.locator("#attribute-r").fill("2 [kg]");
  await lab.page.locator("#attribute-r").press("Enter");
  await eventually(async () => assert.match(await lab.page.locator("#writing-status").innerText(), /error/i));
  await lab.page.getByText("The text has errors: the drawing can be changed by hand again when they are gone.").waitFor();
  await lab.press("Undo");
  await runs(lab);
  await eventually(async () => assert.ok(await lab.page.locator(".drawing-overlay").count()));
});

visit("layers, copies and aligned elements", async (lab) => {
  await drawing(lab);
  const names = () => lab.page.locator(".layers button").allInnerTexts();
  assert.deepEqual(await names(), ["Frame", "Rectangle: Mass", "Line", "Spring", "Ground"]);
  await choose(lab, "Spring");
  await lab.press("Forward");
  await eventually(async () => assert.deepEqual(await names(), ["Frame", "Rectangle: Mass", "Spring", "Line", "Ground"]));
  await lab.press("Backward");
  await eventually(async () => assert.deepEqual(await names(), ["Frame", "Rectangle: Mass", "Line", "Spring", "Ground"]));
  await choose(lab, "Rectangle: Mass");
  await runs(lab);
  await lab.press("Copy");
  await eventually(async () => assert.equal((await names()).length, 6));
  await runs(lab);
  // Both by their left edges; the copy comes back to where the first one is.
  await lab.page.locator("#layer-4").click();
  await lab.page.locator("#layer-5").click({ modifiers: ["Shift"] });
  await lab.page.locator("#drawing-align").selectOption({ label: "Left edges" });
  await eventually(async () => {
    const places = [...(await text(lab)).matchAll(/<rect at="\(([^,]*),/g)].map((found) => found[1]);
    assert.deepEqual(places, ["0", "0"]);
  });
  await lab.page.locator("#layer-5").click();
  await canvas(lab).focus();
  await lab.page.keyboard.press("Delete");
  await eventually(async () => assert.equal((await names()).length, 5));
  await runs(lab);
});

visit("the drawing of the tutorial by hand: a ceiling, a spring, and a mass on it that follows the hand", async (lab) => {
  let actions = 0;
  const counted = async (act) => {
    actions += 1;
    await act;
    await runs(lab);
  };
  await drawing(lab);
  // Its drawing is removed from the template, and begun again.
  const model = (await text(lab)).replace(/```scene[^]*?```\n\n/, "");
  await lab.page.locator("#writing-tab-text").click();
  await editor(lab).click();
  await lab.page.keyboard.press("Control+a");
  await lab.page.keyboard.insertText(model);
  await runs(lab);
  await lab.page.locator("#writing-tab-view").click();
  await counted(lab.page.locator("#drawing-begin").click());
  const put = async (part) => {
    actions += 1;
    await counted(add(lab, part));
  };
  const move = async (name, [right, up]) => {
    const unit = await centimetre(lab, 30);
    await counted(drag(lab, await grip(lab, name), [right * unit, -up * unit]));
  };
  await put("ground");
  await becomes(lab, "ground", '<ground from="(-5 [cm], 0)" to="(5 [cm], 0)"/>');
  // The hatching stands to the right of its direction: from right to left it is above.
  await move("beginning", [10, 13]);
  await move("end", [-10, 13]);
  await becomes(lab, "ground", '<ground from="(5 [cm], 13 [cm])" to="(-5 [cm], 13 [cm])"/>');
  await put("spring");
  await move("beginning", [5, 13]);
  await move("end", [-5, 3]);
  await counted(lab.page.locator("#follow-to-along").selectOption("y"));
  await becomes(lab, "spring", '<spring from="(0, 13 [cm])" to="(0, y + 3 [cm])"/>');
  await put("block");
  await counted(lab.page.locator("#follow-at-along").selectOption("y"));
  await counted(lab.page.locator("#attribute-drag").selectOption("y"));
  await becomes(lab, "block", '<block at="(0, y)" size="(5 [cm], 3 [cm])" drag="y"/>');
  await lab.page.getByRole("slider", { name: "Block" }).waitFor();
  console.log(`drawing by hand: ${actions} actions`);
  assert.ok(actions < 20, `${actions} actions`);
});

visit("a document without a drawing gets one, by keys alone", async (lab) => {
  await drawing(lab, { template: "Empty document" });
  const begin = lab.page.locator("#drawing-begin");
  if (await begin.count()) {
    await begin.focus();
    await lab.page.keyboard.press("Enter");
  }
  await lab.page.locator("#drawing-add").waitFor();
  await runs(lab);
  await lab.page.locator("#drawing-add").focus();
  await lab.page.keyboard.press("Enter");
  await lab.page.locator("#drawing-palette [data-part=spring]").focus();
  await lab.page.keyboard.press("Enter");
  await eventually(async () => assert.match(await text(lab), /<spring from/));
  await eventually(async () => assert.equal(await lab.page.evaluate(() => document.activeElement.id), "drawing-canvas"));
  await runs(lab);
  await eventually(async () => assert.ok(await lab.page.locator(".drawing-overlay .edges").count()));
  const before = await written(lab, "spring");
  await lab.page.keyboard.press("Shift+ArrowUp");
  await eventually(async () => assert.notEqual(await written(lab, "spring"), before));
  await lab.page.keyboard.press("Control+d");
  await eventually(async () => assert.equal((await text(lab)).match(/<spring/g).length, 2));
  await runs(lab);
  await lab.page.keyboard.press("PageUp");
  await lab.page.keyboard.press("Delete");
  await eventually(async () => assert.equal((await text(lab)).match(/<spring/g).length, 1));
  await lab.page.keyboard.press("Control+z");
  await eventually(async () => assert.equal((await text(lab)).match(/<spring/g).length, 2));
  await runs(lab);
});

visit("a finger moves what it means and scrolls beside it", { width: 390, height: 844, touch: true }, async (lab) => {
  await drawing(lab);
  await canvas(lab).scrollIntoViewIfNeeded();
  await lab.page.evaluate(() => document.querySelector("#drawing-canvas").scrollIntoView({ block: "center" }));
  const cm = await centimetre(lab);
  const box = await lab.page.locator("#drawing-canvas svg").first().boundingBox();
  // The mass: 10 cm above the middle at the start.
  const mass = [box.x + box.width / 2, box.y + box.height / 2 - 10 * cm];
  const session = await lab.context.newCDPSession(lab.page);
  const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  const swipe = async ([x, y], [right, down]) => {
    await touch("touchStart", [[x, y]]);
    for (let part = 1; part <= 4; part += 1) await touch("touchMove", [[x + (right * part) / 4, y + (down * part) / 4]]);
    await touch("touchEnd", []);
  };
  const top = async () => (await canvas(lab).boundingBox()).y;
  const before = await top();
  await swipe(mass, [0, 8 * cm]);
  await eventually(async () => assert.match(await written(lab, "rect"), /at="\(0, y - 8 \[cm\]\)"/));
  // A swipe that scrolled would have moved it by much more.
  assert.ok(Math.abs((await top()) - before) < 2 * cm, "the page stands still");
});

for (const [language, names] of [
  ["en-GB", {}],
  ["es-ES", { write: "Escribir", begin: "Nuevo", template: "Una masa en un resorte" }],
]) {
  for (const theme of ["light", "dark"]) {
    visit(`the drawing by hand passes axe, ${language}, ${theme}`, { language, theme, ...STILL }, async (lab) => {
      await drawing(lab, names);
      await lab.page.locator("#layer-2").click();
      await lab.page.locator("#drawing-add").click();
      await lab.page.evaluate(axe);
      const { violations } = await lab.page.evaluate(() => window.axe.run("#panel"));
      assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map((node) => node.html)]), []);
    });
  }
}

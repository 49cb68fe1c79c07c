// The library: cards with pictures that move, found by words and by levels, with a mouse, by keys and with a finger.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { STILL, beside, drop, eventually, hold, visit } from "../lab.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const PHONE = { width: 390, height: 844, touch: true };

const library = (lab) => lab.page.locator("#library-list");
const cards = (lab) => library(lab).locator(".cards > li:visible");
const card = (lab, title) => cards(lab).filter({ has: lab.page.getByRole("link", { name: title, exact: true }) });
const titles = (lab) => cards(lab).locator("a.entry").allInnerTexts();
const count = async (lab) => (await library(lab).getByRole("status").innerText()).trim();
const heading = (lab) => lab.page.getByRole("heading", { level: 1 }).innerText();

async function openLibrary(lab) {
  await lab.page.locator("#browse").click();
  await library(lab).waitFor();
}

/** What the picture of a card shows, once it is there. */
async function picture(lab, title) {
  const drawing = card(lab, title).locator(".drawing");
  await drawing.waitFor();
  return drawing.evaluate((node) => node.shadowRoot.innerHTML);
}

/** Whether the picture of a card changes within half a second. */
async function moves(lab, title) {
  const before = await picture(lab, title);
  await lab.page.waitForTimeout(500);
  return (await picture(lab, title)) !== before;
}

for (const [language, words] of [
  ["en-GB", { typed: "pendul", with: "The double pendulum", without: "The pendulum, small swings and large", chaos: "chaos", level: "Advanced", count: /^Simulations found: (\d+) \/ (\d+)(?: · theories: (\d+))?$/ }],
  ["es-ES", { typed: "PENDULO", with: "El péndulo doble", without: "El péndulo, oscilaciones pequeñas y grandes", chaos: "caos", level: "Avanzado", count: /^Simulaciones encontradas: (\d+) \/ (\d+)(?: · teorías: (\d+))?$/ }],
]) {
  visit(`the library is searched by keyboard: ${language}`, { language }, async (lab) => {
    await lab.tabTo("#browse");
    await lab.keys("Enter");
    await eventually(async () => assert.equal((await lab.focused()).id, "library-search"));
    const all = (await titles(lab)).length;
    assert.ok(all > 25, `${all} documents`);
    const theories = await library(lab).locator("section:visible").last().locator(".cards > li").count();
    const simulations = all - theories;
    assert.match(await lab.page.locator("#browse").innerText(), new RegExp(`\\b${simulations}$`), "the button says how many there are");
    assert.deepEqual((await count(lab)).match(words.count).slice(1).map(Number), [simulations, simulations, theories]);
    // Each simulation stands in a course, with a level.
    assert.equal(await library(lab).locator(".library-level").count(), simulations);
    assert.equal(await library(lab).locator("section:visible").count(), 9, "eight courses and the theories");
    await lab.page.keyboard.type(words.typed);
    await eventually(async () => assert.ok((await titles(lab)).length < all));
    const found = await titles(lab);
    assert.ok(found.includes(words.with) && found.includes(words.without), found.join());
    assert.deepEqual((await count(lab)).match(words.count).slice(1, 3).map(Number), [found.length, simulations]);
    // Every word narrows the search, whatever their order.
    await lab.page.keyboard.type(`  ${words.chaos}`);
    await eventually(async () => assert.ok((await titles(lab)).length < found.length));
    assert.ok((await titles(lab)).includes(words.with));
    await lab.page.keyboard.type("xyz");
    await eventually(async () => assert.deepEqual(await titles(lab), []));
    await lab.page.locator("#library-search").fill("");
    // By a level, which every card found names.
    await library(lab).getByRole("button", { name: words.level, exact: true }).focus();
    await lab.keys("Space");
    await eventually(async () => assert.ok((await titles(lab)).length < all));
    for (const level of await cards(lab).locator(".library-level:visible").allInnerTexts()) assert.ok(level.endsWith(words.level), level);
    const advanced = await titles(lab);
    assert.ok(advanced.includes(words.with) && !advanced.includes(words.without));
    // Arrows go from card to card; Enter opens.
    await lab.keys("ArrowDown");
    assert.equal((await lab.focused()).name, advanced[0]);
    await lab.keys("ArrowRight", "ArrowRight", "ArrowLeft");
    assert.equal((await lab.focused()).name, advanced[1]);
    await lab.keys("Home", "ArrowUp");
    assert.equal((await lab.focused()).id, "library-search");
    await lab.keys("ArrowDown", "End");
    const last = advanced.at(-1);
    assert.equal((await lab.focused()).name, last);
    await lab.keys("Enter");
    await eventually(async () => assert.equal(await heading(lab), last));
    await eventually(async () => assert.equal((await lab.focused()).id, "browse"));
    assert.equal(await library(lab).isVisible(), false);
    await lab.page.goBack();
    await eventually(async () => assert.notEqual(await heading(lab), last));
  });
}

visit("a picture moves while the pointer is over its card or the focus in it", async (lab) => {
  await openLibrary(lab);
  const [one, other] = ["The pendulum, small swings and large", "A liquid in a U-tube"];
  await picture(lab, one);
  await lab.page.locator("#library-search").hover();
  assert.equal(await moves(lab, one), false, "it stands still by itself");
  await card(lab, one).hover();
  assert.equal(await moves(lab, one), true, "under the pointer");
  await card(lab, other).hover();
  assert.equal(await moves(lab, other), true, "the next one");
  assert.equal(await moves(lab, one), false, "and not the first any more");
  await lab.page.locator("#library-search").hover();
  await card(lab, one).getByRole("link").focus();
  assert.equal(await moves(lab, one), true, "with the focus");
  // A picture is a decoration; what a card is called stands in words.
  assert.equal(await card(lab, one).locator(".library-picture").getAttribute("aria-hidden"), "true");
  assert.equal(await card(lab, one).locator("[tabindex], [role=slider]").count(), 0);
});

visit("every document in sight has its picture, and few are there at once", { height: 1000 }, async (lab) => {
  await openLibrary(lab);
  const groups = lab.page.locator(".library-groups");
  const seen = new Set();
  for (let turn = 0; turn < 12; turn += 1) {
    await eventually(async () => {
      const missing = await cards(lab).evaluateAll((all) => {
        const box = document.querySelector(".library-groups").getBoundingClientRect();
        const inSight = all.filter((one) => one.firstChild.getBoundingClientRect().bottom > box.top + 1 && one.firstChild.getBoundingClientRect().top < box.bottom - 1);
        return inSight.filter((one) => !one.querySelector(".drawing")).map((one) => one.innerText);
      });
      assert.deepEqual(missing, []);
    });
    for (const title of await cards(lab).filter({ has: lab.page.locator(".drawing") }).locator("a.entry").allInnerTexts()) seen.add(title);
    assert.ok((await library(lab).locator(".drawing").count()) <= 24);
    await groups.evaluate((list) => list.scrollBy(0, list.clientHeight * 0.8));
    await lab.page.waitForTimeout(300);
  }
  assert.deepEqual([...seen].sort(), (await titles(lab)).sort());
  // Closed, it needs no memory.
  await lab.keys("Escape");
  await eventually(async () => assert.equal(await library(lab).locator(".drawing").count(), 0));
});

visit("a card is a link, to another tab too", async (lab) => {
  await openLibrary(lab);
  const link = library(lab).getByRole("link", { name: "The Lorenz equations", exact: true });
  assert.match(await link.getAttribute("href"), /#1&d=lorenz\.md$/);
  // The page leaves the middle button to the browser. The tab is opened by its address: Chromium 148 without a window ends tabs that a
  // middle click opens.
  const isLeft = await link.evaluate((one) => one.dispatchEvent(new MouseEvent("auxclick", { button: 1, bubbles: true, cancelable: true })));
  assert.ok(isLeft);
  const tab = await lab.context.newPage();
  await tab.goto(await link.evaluate((one) => one.href));
  await eventually(async () => assert.equal(await tab.getByRole("heading", { level: 1 }).innerText(), "The Lorenz equations"));
  assert.match(await heading(lab), /U-tube/);
  assert.equal(await library(lab).isVisible(), true);
  await tab.close();
  // The picture is part of the link.
  await card(lab, "The Lorenz equations").locator(".library-picture").click({ force: true });
  await eventually(async () => assert.equal(await heading(lab), "The Lorenz equations"));
  assert.match(lab.page.url(), /#1&d=lorenz\.md$/);
});

visit("nothing moves for those who want less motion", { ...STILL }, async (lab) => {
  await openLibrary(lab);
  await picture(lab, "The pendulum, small swings and large");
  await card(lab, "The pendulum, small swings and large").hover();
  assert.equal(await moves(lab, "The pendulum, small swings and large"), false);
});

const WORDS = {
  "en-GB": { write: "Write", begin: "New", mine: "My documents", remove: "Remove", removed: "Removed", undo: "Undo", changed: /^Last changed: / },
  "es-ES": { write: "Escribir", begin: "Nuevo", mine: "Mis documentos", remove: "Quitar", removed: "Se ha quitado", undo: "Deshacer", changed: /^Último cambio: / },
};

/** Writes documents with these titles, one after the other. */
async function write(lab, words, ...documents) {
  const editor = lab.page.locator(".cm-content");
  await lab.tab(words.write);
  for (const title of documents) {
    await editor.waitFor();
    await lab.press(words.begin);
    await lab.page.locator("#templates .chip").first().click();
    await eventually(async () => assert.match(await editor.innerText(), /```model/));
    await editor.evaluate((content, title) => {
      const { view } = content.cmTile;
      const place = /title: .*/.exec(view.state.doc.toString());
      view.dispatch({ changes: { from: place.index, to: place.index + place[0].length, insert: `title: ${title}` } });
    }, title);
    await eventually(async () => assert.equal(await heading(lab), title));
  }
}

const stored = (lab) => lab.page.evaluate(() => Object.entries(localStorage).filter(([key]) => /^meniscus:(written|changed|version):/.test(key)).sort());
const mine = (lab, words) => library(lab).locator("section:visible").filter({ has: lab.page.getByRole("heading", { name: words.mine }) });

for (const [language, words] of Object.entries(WORDS)) {
  visit(`documents that were written are listed, opened, removed and put back by keyboard: ${language}`, { language }, async (lab) => {
    await openLibrary(lab);
    assert.equal(await mine(lab, words).count(), 0);
    await lab.keys("Escape");
    await write(lab, words, "Alpha", "Beta");
    await openLibrary(lab);
    const entries = () => mine(lab, words).locator(".entry").allInnerTexts();
    // What was changed last stands first.
    assert.deepEqual(await entries(), ["Beta", "Alpha"]);
    assert.match(await mine(lab, words).locator(".library-own span").first().innerText(), words.changed);
    await lab.page.keyboard.type("alph");
    await eventually(async () => assert.equal(await mine(lab, words).locator(".cards > li:visible").count(), 1));
    await lab.keys("ArrowDown", "Enter");
    await eventually(async () => assert.equal(await heading(lab), "Alpha"));
    // A change puts it before the other one.
    await lab.page.locator(".cm-content").click();
    await lab.page.keyboard.type("x");
    await eventually(async () => assert.ok((await stored(lab)).some(([key, text]) => key.includes(":written:") && text.includes("Alpha") && /x/.test(text))));
    await openLibrary(lab);
    await eventually(async () => assert.deepEqual(await entries(), ["Alpha", "Beta"]));
    const before = await stored(lab);
    const remove = mine(lab, words).getByRole("button", { name: `${words.remove}: Beta` });
    await remove.focus();
    await lab.keys("Enter");
    await eventually(async () => assert.equal((await lab.focused()).name, words.undo));
    await library(lab).getByText(`${words.removed}: Beta`).waitFor();
    assert.equal((await stored(lab)).filter(([, text]) => text.includes("Beta")).length, 0);
    // Arrows still go over all of them.
    await lab.keys("ArrowLeft");
    assert.equal((await lab.focused()).name, "Alpha");
    await lab.keys("ArrowRight", "Enter");
    await eventually(async () => assert.equal((await lab.focused()).name, "Beta"));
    assert.deepEqual(await stored(lab), before);
    await remove.click();
    await library(lab).getByText(`${words.removed}: Beta`).waitFor();
    await lab.keys("Escape");
    await openLibrary(lab);
    await eventually(async () => assert.deepEqual(await entries(), ["Alpha"]));
    // They are there at the next visit.
    await lab.page.reload();
    await openLibrary(lab);
    await eventually(async () => assert.deepEqual(await entries(), ["Alpha"]));
  });
}

visit("a copy of a document with a translation has its title in the language of the page", { language: "es-ES" }, async (lab) => {
  await lab.tab("Escribir");
  await lab.page.locator(".cm-content").click();
  await lab.page.keyboard.press("Control+End");
  await lab.page.keyboard.type("x");
  await eventually(async () => assert.ok((await stored(lab)).some(([key]) => key.includes(":written:"))));
  await openLibrary(lab);
  assert.deepEqual(await mine(lab, WORDS["es-ES"]).locator(".entry").allInnerTexts(), ["Oscilaciones de un líquido en un tubo en U"]);
});

for (const language of ["en-GB", "es-ES"]) {
  for (const theme of ["light", "dark"]) {
    for (const [device, size] of [["desk", {}], ["phone", PHONE]]) {
      visit(`axe finds nothing in the library: ${language}, ${theme}, ${device}`, { ...STILL, language, theme, ...size }, async (lab) => {
        await write(lab, WORDS[language], "Alpha", "Beta");
        await openLibrary(lab);
        await library(lab).locator(".drawing").first().waitFor();
        await mine(lab, WORDS[language]).getByRole("button", { name: `${WORDS[language].remove}: Alpha` }).click();
        await library(lab).getByText(`${WORDS[language].removed}: Alpha`).waitFor();
        await lab.page.evaluate(axe);
        const { violations } = await lab.page.evaluate(() => window.axe.run("#library-list"));
        assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 160))}`), []);
        const wide = await lab.page.evaluate(() => [document.documentElement, document.querySelector(".library-groups")].filter((one) => one.scrollWidth > one.clientWidth).length);
        assert.equal(wide, 0, "no sideways scrolling");
      });
    }
  }
}

visit("a document that is still being opened does not replace one that was opened after it", async (lab) => {
  const text = readFileSync(beside("kicked.md"), "utf8");
  const held = await hold(lab);
  await drop(lab, { name: "kicked.md", text });
  await held.begun();
  await openLibrary(lab);
  await card(lab, "Linear damping").getByRole("link").first().click();
  await eventually(async () => assert.equal(await heading(lab), "Linear damping"));
  await held.release();
  assert.equal(await heading(lab), "Linear damping");
  // Dropped once more, it is opened.
  await drop(lab, { name: "kicked.md", text });
  await eventually(async () => assert.notEqual(await heading(lab), "Linear damping"));
});

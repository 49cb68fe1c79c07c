// Measures the layout of the laboratory's first screen, for every document of the gallery:
//
//     CHROME=/usr/bin/chromium node tests/page/layout.mjs [NAME ..] [--boxes] [--pictures FOLDER] [--size 390x844] [--dark]
//
// `picture` is the share of the window that the box around what the scene paints covers, without texts and without transparent
// areas, over the first seconds of a run at the highest speed. `controls` counts what Tab can reach on the first screen, `play` is
// the number of the Tab stop of the play button. `--boxes` prints two boxes instead, in the units of the drawing: around what is
// painted, and around texts as well. PAGE names the page, as for the tests.

import { readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { parseArgs } from "node:util";
import { fileURLToPath, pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const root = join(dirname(fileURLToPath(import.meta.url)), "..", "..");
const address = pathToFileURL(process.env.PAGE ?? join(root, "target", "page", "meniscus.html")).href;
const { values: options, positionals: named } = parseArgs({
  allowPositionals: true,
  options: {
    boxes: { type: "boolean" },
    dark: { type: "boolean" },
    pictures: { type: "string" },
    size: { type: "string", default: "1440x900" },
  },
});
const [width, height] = options.size.split("x").map(Number);

/** Names of the documents as links give them, the opening document first. */
function gallery() {
  const within = (folder) => readdirSync(join(root, "simulations", folder)).filter((name) => name.endsWith(".md") && !name.endsWith(".es.md"));
  const all = [...within(""), ...within("theories").map((name) => `theories/${name}`)];
  return named.length ? all.filter((name) => named.includes(name.replace(/\.md$/, ""))) : ["", ...all];
}

/** The drawing without its texts as a file of its own, and the box around its texts, in its units. */
function drawn() {
  const svg = document.querySelector(".scene .drawing").shadowRoot?.querySelector("svg");
  if (!svg) return undefined;
  const view = svg.viewBox.baseVal;
  const place = svg.getBoundingClientRect();
  const copy = svg.cloneNode(true);
  for (const node of copy.querySelectorAll("[part~=ring], title, text")) node.remove();
  copy.removeAttribute("part");
  copy.style.cssText = "display:block;color:#000";
  copy.setAttribute("viewBox", [view.x - view.width / 2, view.y - view.height / 2, 2 * view.width, 2 * view.height].join(" "));
  copy.setAttribute("width", 2 * view.width);
  copy.setAttribute("height", 2 * view.height);
  const toUnits = svg.getScreenCTM().inverse();
  let texts;
  for (const text of svg.querySelectorAll("text")) {
    const box = text.getBoundingClientRect();
    if (!text.textContent.trim() || !box.width || getComputedStyle(text).opacity === "0") continue;
    const [from, to] = [new DOMPoint(box.left, box.top), new DOMPoint(box.right, box.bottom)].map((point) => point.matrixTransform(toUnits));
    texts ??= [from.x, from.y, to.x, to.y];
    texts = [Math.min(texts[0], from.x), Math.min(texts[1], from.y), Math.max(texts[2], to.x), Math.max(texts[3], to.y)];
  }
  const scale = Math.min(place.width / view.width, place.height / view.height);
  return { shapes: new XMLSerializer().serializeToString(copy), texts, view: [view.x, view.y, view.width, view.height], scale };
}

/** Box around what a drawing paints visibly, in its units. */
async function boxOf([text, [x, y, width, height]]) {
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = new OffscreenCanvas(Math.round(2 * width), Math.round(2 * height));
  const context = canvas.getContext("2d");
  context.drawImage(image, 0, 0);
  const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
  let box;
  for (let row = 0; row < canvas.height; row += 1) {
    for (let column = 0; column < canvas.width; column += 1) {
      if (data[4 * (row * canvas.width + column) + 3] < 20) continue;
      box ??= [column, row, column, row];
      box = [Math.min(box[0], column), Math.min(box[1], row), Math.max(box[2], column + 1), Math.max(box[3], row + 1)];
    }
  }
  return box && [box[0] + x - width / 2, box[1] + y - height / 2, box[2] + x - width / 2, box[3] + y - height / 2];
}

const joined = (one, other) =>
  !one || !other ? (one ?? other) : [Math.min(one[0], other[0]), Math.min(one[1], other[1]), Math.max(one[2], other[2]), Math.max(one[3], other[3])];

/** Part of a box that lies in the view box of its drawing. */
const within = (box, [x, y, width, height]) =>
  box && [Math.max(box[0], x), Math.max(box[1], y), Math.min(box[2], x + width), Math.min(box[3], y + height)];

/** Presses Tab through the page: number of stops on the first screen, and which of them is the play button. */
async function stops(page) {
  let play = 0;
  const seen = new Set();
  for (let count = 1; count <= 200; count += 1) {
    await page.keyboard.press("Tab");
    const at = await page.evaluate(() => {
      let element = document.activeElement;
      while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
      if (!element || element === document.body) return undefined;
      element.dataset.stop ??= String(Math.random());
      return { id: element.id, stop: element.dataset.stop };
    });
    if (!at || seen.has(at.stop)) break;
    seen.add(at.stop);
    if (at.id === "play") play = count;
  }
  // What a person sees without scrolling, without the skip links.
  const visible = await page.evaluate(() => {
    const all = [];
    const within = (tree) => {
      for (const node of tree.querySelectorAll("*")) {
        if (node.shadowRoot) within(node.shadowRoot);
        if (node.dataset.stop) all.push(node);
      }
    };
    within(document);
    const seen = (node) => {
      const box = node.getBoundingClientRect();
      return box.bottom > 0 && box.top < innerHeight && box.right > 0 && box.left < innerWidth;
    };
    return all.filter(seen).length;
  });
  return { play, controls: visible };
}

const browser = await chromium.launch({ executablePath: process.env.CHROME, args: ["--no-sandbox", "--disable-gpu"] });
const context = await browser.newContext({ viewport: { width, height }, locale: "en-GB", colorScheme: options.dark ? "dark" : "light" });
const blank = await context.newPage();
for (const name of gallery()) {
  const page = await context.newPage();
  await page.goto(name ? `${address}#1&d=${name}` : address);
  await page.locator("#play").waitFor();
  await page.waitForTimeout(300);
  const counted = options.boxes ? undefined : await stops(page);
  await page.evaluate(() => document.activeElement?.blur());
  const speeds = await page.locator("#speed option").evaluateAll((all) => all.map((option) => option.value));
  await page.locator("#speed").selectOption(speeds.at(-1));
  await page.locator("#play").click();
  let [shapes, texts, view, scale] = [];
  const end = Date.now() + 3500;
  do {
    const now = await page.evaluate(drawn);
    if (!now) break;
    ({ view, scale } = now);
    shapes = joined(shapes, await blank.evaluate(boxOf, [now.shapes, view]));
    texts = joined(texts, now.texts);
    await page.waitForTimeout(60);
  } while (Date.now() < end);
  const title = (name || "(opening)").padEnd(34);
  if (options.boxes) {
    const rounded = (box) => box?.map(Math.round).join(" ") ?? "-";
    console.log(title, `view ${view?.join(" ")}`.padEnd(26), `painted ${rounded(shapes)}`.padEnd(30), `with texts ${rounded(joined(shapes, texts))}`);
  } else {
    const box = view && within(shapes, view);
    const share = box ? ((box[2] - box[0]) * (box[3] - box[1]) * scale * scale) / (width * height) : 0;
    console.log(title, `picture ${(100 * share).toFixed(1).padStart(5)} %   controls ${String(counted.controls).padStart(3)}   play ${counted.play}`);
  }
  if (options.pictures) {
    if (await page.locator("#play").getAttribute("aria-label") === "Pause") await page.locator("#play").click();
    await page.screenshot({ path: join(options.pictures, `${(name || "opening").replace(/\.md$/, "").replace("/", "-")}-${options.size}${options.dark ? "-dark" : ""}.png`) });
  }
  await page.close();
}
await browser.close();

// Eight rules of the page that can be measured: few controls, one accent, one ruler, a result in sight, a bubble that hides
// nothing, nothing that moves, folds that say what they hold, and room for data. A window of 1440x900 unless said.

import assert from "node:assert/strict";
import { drop, eventually, sight, visit } from "../lab.mjs";
import { film, records } from "../measured.mjs";

const FIRST = { fragment: "" };
const WINDOWS = [["desk", { width: 1440, height: 900 }], ["tablet", { width: 1024, height: 768 }], ["phone", { width: 390, height: 844, touch: true }]];

/** What can be pressed, dragged or typed into and is in sight: names of elements, and the moved quantities of the drawing. A quantity
    counts once, even if it can be taken at two places. The plots themselves, which the keyboard reads out, are no controls. */
const controls = (lab) =>
  lab.page.evaluate(() => {
    const inSight = (element) => {
      const { left, top, right, bottom } = element.getBoundingClientRect();
      const inside = right > 0 && bottom > 0 && left < innerWidth && top < innerHeight;
      return inside && element.checkVisibility({ opacityProperty: true, visibilityProperty: true });
    };
    const named = (element) => element.id || element.innerText || element.getAttribute("aria-label");
    const own = [...document.querySelectorAll("button, input, select, textarea, summary, a[href]")].filter(inSight).map(named);
    const handles = [...(document.querySelector("#scene .drawing")?.shadowRoot?.querySelectorAll("[role=slider]") ?? [])];
    const quantities = handles.filter(inSight).map((handle) => `drag ${handle.getAttribute("aria-label").split(": ").pop()}`);
    return [...own, ...new Set(quantities)];
  });

/** Runs a page at rest, with the pointer out of the way, until all that unfolds has unfolded. */
async function settled(lab) {
  await lab.page.mouse.move(2, 2);
  await lab.drawn();
}

async function few(lab, most) {
  await settled(lab);
  const seen = await controls(lab);
  assert.ok(seen.length > 5 && seen.length <= most, `${seen.length} of ${most}: ${seen.join(", ")}`);
}

/** Elements that pulse without an end, and filled buttons that are not round. */
const loud = (lab) =>
  lab.page.evaluate(() => {
    const pulsing = document.getAnimations().filter((animation) => animation.playState === "running" && animation.effect.getComputedTiming().iterations === Infinity);
    const probe = document.body.appendChild(document.createElement("i"));
    probe.style.color = "var(--accent)";
    const accent = getComputedStyle(probe).color;
    probe.remove();
    const filled = [...document.querySelectorAll("button, a[href]:not(.skip)")].filter((button) => {
      const { backgroundColor, borderTopLeftRadius } = getComputedStyle(button);
      const box = button.getBoundingClientRect();
      return backgroundColor === accent && button.checkVisibility() && !(borderTopLeftRadius.endsWith("%") || parseFloat(borderTopLeftRadius) >= box.height / 2);
    });
    return { pulsing: new Set(pulsing.map((animation) => animation.effect.target)).size, filled: filled.map((button) => button.id || button.innerText) };
  });

async function quiet(lab) {
  const { pulsing, filled } = await loud(lab);
  assert.ok(pulsing <= 1, `${pulsing} things pulse`);
  assert.ok(filled.length <= 1, filled.join(", "));
}

visit("rule 1: at most 25 controls on the first screen of a student, and one thing that pulses", FIRST, async (lab) => {
  await lab.page.locator(".level-ring > .bubble").waitFor();
  await few(lab, 25);
  await quiet(lab);
});

visit("rule 1: at most 34 controls with a run", FIRST, async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(0.5);
  await lab.press("Pause");
  await few(lab, 34);
  await quiet(lab);
});

visit("rule 1: few controls while a film waits for a click", FIRST, async (lab) => {
  await lab.tab("Measure");
  await lab.page.locator("#open-sample").click();
  await lab.page.locator("#film-frame[data-frame]").waitFor();
  await lab.page.locator("#film-asked").waitFor();
  await quiet(lab);
});

visit("rule 2: what is written in the accent can be pressed, and no curve has its colour", FIRST, async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(0.3);
  await lab.press("Pause");
  for (const tab of ["Explore", "Measure"]) {
    await lab.tab(tab);
    const idle = await lab.page.evaluate(() => {
      const probe = document.body.appendChild(document.createElement("i"));
      probe.style.color = "var(--accent)";
      const accent = getComputedStyle(probe).color;
      probe.remove();
      const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
      const found = new Set();
      while (walker.nextNode()) {
        const element = walker.currentNode.parentElement;
        if (!walker.currentNode.data.trim() || element.closest("script, style, noscript") || !element.checkVisibility()) continue;
        if (getComputedStyle(element).color === accent && !element.closest("button, a, summary, label, [role=tab], [role=slider], .bubble, .head-name, .brand")) {
          found.add(`${element.tagName} ${element.className}: ${element.textContent.slice(0, 40)}`);
        }
      }
      const style = getComputedStyle(document.documentElement);
      const series = [1, 2, 3, 4].map((number) => style.getPropertyValue(`--series-${number}`).trim()).filter((colour) => colour === style.getPropertyValue("--accent").trim());
      return [...found, ...series];
    });
    assert.deepEqual(idle, [], tab);
  }
});

for (const [device, size] of WINDOWS) {
  visit(`rule 2: no text is smaller than 12 px: ${device}`, { ...FIRST, ...size }, async (lab) => {
    await lab.openMore();
    for (const tab of ["Explore", "Questions", "Measure", "Theory"]) {
      await lab.tab(tab);
      const small = await lab.page.evaluate(() => {
        const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
        const found = new Set();
        while (walker.nextNode()) {
          const element = walker.currentNode.parentElement;
          if (!walker.currentNode.data.trim() || !element.checkVisibility() || element.closest("math, sub, sup, .symbol, script, style")) continue;
          const pixels = parseFloat(getComputedStyle(element).fontSize);
          if (pixels < 11.99) found.add(`${pixels}: ${element.className} ${element.textContent.slice(0, 40)}`);
        }
        return [...found];
      });
      assert.deepEqual(small, [], tab);
    }
  });
}

/** Heights of pen and surface in a frame, in pixels. */
const heights = (lab) =>
  lab.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
    const { top, width } = document.querySelector(".level-line").getBoundingClientRect();
    const root = document.querySelector("#scene .drawing").shadowRoot;
    const svg = root.querySelector("svg");
    const [, level] = /translate\(\s*[^ ,]+[ ,]+([^)]+)\)/.exec(root.querySelector(".skin").getAttribute("transform"));
    const matrix = svg.getScreenCTM();
    done({ pen: top + 1, surface: matrix.f + matrix.d * Number(level), shown: width > 0 });
  }))));

visit("rule 3: the pen is at the height of the surface in every frame", FIRST, async (lab) => {
  await lab.page.locator(".level-line").waitFor();
  const frames = [await heights(lab)];
  await lab.press("Play");
  for (let count = 0; count < 20; count += 1) frames.push(await heights(lab));
  const off = frames.map(({ pen, surface, shown }) => (shown ? Math.abs(pen - surface) : Infinity));
  assert.ok(Math.max(...off) <= 1, JSON.stringify(off.map((pixels) => pixels.toFixed(2))));
});

visit("rule 3: clock, tile, drawing and values show one instant", FIRST, async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(0.4);
  await lab.press("Pause");
  await lab.drawn();
  const shown = await lab.page.evaluate(() => {
    const root = document.querySelector("#scene .drawing").shadowRoot;
    const [, surface] = /translate\(\s*[^ ,]+[ ,]+([^)]+)\)/.exec(root.querySelector(".skin").getAttribute("transform"));
    const [, rest] = /^M[^ ]+ ([^H]+)H/.exec(root.querySelector(".rest").getAttribute("d"));
    return { drawn: (Number(rest) - Number(surface)) / 24, tile: document.querySelector("#show-plot-0 .value").innerText.replace("−", "-") };
  });
  assert.ok(Math.abs(shown.drawn - Number(shown.tile)) < 0.006, JSON.stringify(shown));
  // The exact solution at the time of the clock.
  const time = await lab.time();
  const [rho, area, length, damping] = [998, 1.1e-4, 0.22, 0.02];
  const gamma = damping / (2 * rho * area * length);
  const omega = Math.sqrt((2 * 9.8) / length - gamma ** 2);
  const expected = 3 * Math.exp(-gamma * time) * (Math.cos(omega * time) + (gamma / omega) * Math.sin(omega * time));
  // The clock shows hundredths of a second.
  assert.ok(Math.abs(expected - Number(shown.tile)) < 3 * omega * 0.0051, `${expected} at ${time}, ${shown.tile}`);
});

for (const [device, size] of WINDOWS) {
  visit(`rule 4: Fit stands in the window once, with the result directly under or beside it: ${device}`, { ...FIRST, ...size }, async (lab) => {
    await drop(lab, { name: "film.csv", text: film() });
    await records(lab).waitFor();
    assert.equal(await lab.page.getByRole("button", { name: "Fit", exact: true }).count(), 1);
    await lab.page.locator("#fit").click();
    await lab.page.locator("#fit-lines .nearness").waitFor({ timeout: 60_000 });
    const found = await lab.page.evaluate(() => {
      const [fit, lines] = ["#fit", "#fit-lines .nearness"].map((name) => document.querySelector(name).getBoundingClientRect());
      return { inside: [fit, lines].every((box) => box.top >= 0 && box.bottom <= innerHeight && box.left >= 0 && box.right <= innerWidth), apart: lines.top - fit.bottom, scrolled: scrollY };
    });
    assert.ok(found.inside && found.apart < 60 && found.scrolled === 0, JSON.stringify(found));
  });
}

for (const [device, size] of WINDOWS) {
  visit(`rule 5: the bubble is short and hides neither surface nor mark nor line: ${device}`, { ...FIRST, ...size }, async (lab) => {
    const bubble = lab.page.locator(".level-ring > .bubble");
    await bubble.waitFor();
    const words = (await bubble.locator("strong").innerText()).split(/\s+/);
    assert.ok(words.length <= 8, words.join(" "));
    const hidden = await lab.page.evaluate(() => {
      const over = document.querySelector(".level-ring > .bubble").getBoundingClientRect();
      const root = document.querySelector("#scene .drawing").shadowRoot;
      const below = [...root.querySelectorAll(".skin, .mark, text")].filter((part) => part.textContent.trim() || part.tagName !== "text");
      const line = document.querySelector(".level-line:not([hidden])");
      return [...below, line].filter(Boolean)
        .filter((part) => {
          const box = part.getBoundingClientRect();
          return box.width + box.height > 0 && box.left < over.right && box.right > over.left && box.top < over.bottom && box.bottom > over.top;
        })
        .map((part) => `${part.className.baseVal ?? part.className} ${part.textContent}`);
    });
    assert.deepEqual(hidden, []);
  });
}

/** Share of the window that has moved by itself, since the page was watched, and what moved. */
const moved = (lab) => lab.page.evaluate(() => window.shifts.map(({ value, what }) => `${value.toFixed(4)} ${what}`));
const watchShifts = (lab) =>
  lab.page.evaluate(() => {
    window.shifts = [];
    new PerformanceObserver((list) =>
      list.getEntries().forEach(({ value, sources }) => {
        const what = sources.map(({ node }) => node?.id || node?.className || node?.nodeName).join(" ");
        window.shifts.push({ value, what });
      }),
    ).observe({ type: "layout-shift" });
  });

const plotPlace = (lab) =>
  lab.page.locator("#canvas-0").evaluate((canvas) => {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    return [left, top, width, height].map(Math.round);
  });

visit("rule 6: nothing moves when a run begins, a tab changes, or a fit ends", FIRST, async (lab) => {
  await lab.page.locator(".level-line").waitFor();
  const before = await plotPlace(lab);
  await watchShifts(lab);
  await lab.press("Play");
  await lab.watchUntil(0.3);
  await lab.press("Pause");
  // Digits that change move their units by less than that.
  assert.deepEqual((await moved(lab)).filter((shift) => parseFloat(shift) > 0.001), [], "a run begins");
  assert.deepEqual(await plotPlace(lab), before);
  for (const tab of ["Questions", "Theory", "Explore"]) {
    await lab.tab(tab);
    assert.deepEqual(await plotPlace(lab), before, tab);
  }
  await drop(lab, { name: "film.csv", text: film() });
  await lab.page.locator("#fit").waitFor();
  await lab.drawn();
  const measuring = await plotPlace(lab);
  assert.deepEqual(measuring.slice(0, 1), before.slice(0, 1), "the plot keeps its side");
  await watchShifts(lab);
  await lab.page.locator("#fit").click();
  await lab.page.locator("#fit-lines .nearness").waitFor({ timeout: 60_000 });
  await lab.drawn();
  assert.deepEqual(await plotPlace(lab), measuring, "a fit has ended");
});

visit("rule 7: a fold says what it holds in at most six words", FIRST, async (lab) => {
  const note = await sight(lab.page.locator("#more > summary .note"));
  assert.match(note, /\d/);
  assert.ok(note.split(/\s+/).length <= 6, note);
  assert.equal(await lab.page.locator("#more > summary .note").count(), 1);
});

for (const [device, size] of WINDOWS.slice(1)) {
  visit(`rule 8: no plot is small: ${device}`, { ...FIRST, ...size }, async (lab) => {
    const { width, height } = await lab.page.locator(".figures canvas:visible").first().boundingBox();
    // Ticks and titles take 64 px at most.
    assert.ok(width >= 160 + 30 && height >= 160 + 64, `${width} by ${height}`);
    if (device === "tablet") {
      const panel = await lab.page.locator(".panel").boundingBox();
      assert.ok(panel.width >= 280, `the panel is ${panel.width} px wide`);
    } else {
      const [panel, stage] = [await lab.page.locator(".panel").boundingBox(), await lab.page.locator(".stage-body").boundingBox()];
      assert.ok(panel.y >= stage.y + stage.height - 1, "the panel stands under the stage");
    }
    assert.ok((await lab.page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
  });
}

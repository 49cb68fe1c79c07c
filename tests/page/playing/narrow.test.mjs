// Small windows: the scene above one plot on a phone, a time line that is long enough, targets for fingers, and nothing cut off.

import assert from "node:assert/strict";
import { eventually, visit } from "../lab.mjs";

const PHONE = { width: 390, height: 844, touch: true };
const TABLET = { width: 1024, height: 768 };

/** Opens a document of the library and plays it for a moment. */
async function open(lab, name) {
  await lab.page.goto("about:blank");
  await lab.go(`${lab.address}#1&d=${name}.md`);
  await lab.button("Play").or(lab.button("Reproducir")).click();
  await eventually(async () => assert.notEqual(await lab.page.locator("#time-line").inputValue(), "0"));
}

/** Where something is. */
const place = (lab, selector) => lab.page.locator(selector).first().boundingBox();

visit("on a phone a slim scene that is a scale of its plot stands beside it", PHONE, async (lab) => {
  for (const name of ["tube", "utube"]) {
    await open(lab, name);
    const [scene, plot, bar] = [await place(lab, "#scene"), await place(lab, ".figures canvas:visible"), await place(lab, "#transport")];
    assert.ok(scene.width > 150 && plot.width > 190 && plot.height >= 200, JSON.stringify([scene, plot]));
    assert.ok(scene.x + scene.width <= plot.x && plot.y + plot.height <= bar.y, "one beside the other, the transport below");
  }
});

for (const name of ["charge", "logistic-map", "gas", "pendulum", "string", "kepler", "two-tanks"]) {
  visit(`a phone shows the scene above one plot, both as wide as the window: ${name}`, PHONE, async (lab) => {
    await open(lab, name);
    const [scene, plot, bar] = [await place(lab, "#scene"), await place(lab, ".figures canvas:visible"), await place(lab, "#transport")];
    assert.ok(scene.width > 360 && plot.width > 350, `${scene.width}, ${plot.width}`);
    assert.ok(scene.y + scene.height <= plot.y && plot.y + plot.height <= bar.y, "one above the other, the transport below");
    assert.ok(plot.height >= 130, `the plot is ${plot.height} px high`);
    // As large as its place allows.
    const drawing = await lab.page.locator("#scene .drawing").evaluate((drawing) => {
      const svg = drawing.shadowRoot.querySelector("svg");
      const [scale, box] = [svg.getScreenCTM(), svg.viewBox.baseVal];
      return [box.width * scale.a, box.height * scale.d];
    });
    assert.ok(drawing[0] > 340 || drawing[1] > 210, `the drawing is ${drawing[0]} by ${drawing[1]}`);
  });
}

for (const [size, least, most] of [[PHONE, 12, 15], [TABLET, 14, 16], [{ width: 1440, height: 900 }, 14, 16]]) {
  visit(`texts in drawings are as large as those of the page: ${size.width} px`, size, async (lab) => {
    for (const name of ["tube", "projectile", "chain", "cooling", "inclined-plane"]) {
      await open(lab, name);
      const sizes = await lab.page.locator("#scene .drawing").evaluate((drawing) => {
        const svg = drawing.shadowRoot.querySelector("svg");
        const texts = [...svg.querySelectorAll("text")].filter((text) => text.getBoundingClientRect().width > 0);
        return texts.map((text) => parseFloat(getComputedStyle(text).fontSize) * svg.getScreenCTM().a);
      });
      assert.ok(sizes.length > 1 && sizes.every((pixels) => pixels >= least && pixels <= most), `${name}: ${sizes}`);
    }
  });
}

for (const size of [PHONE, { width: 844, height: 390, touch: true }]) {
  visit(`on a phone scene and plot stay in sight while the panel is read: ${size.width} px`, size, async (lab) => {
    await lab.page.locator(".readouts").first().evaluate((values) => values.scrollIntoView({ block: "end", behavior: "instant" }));
    const [scene, plot, bar] = [await place(lab, "#scene"), await place(lab, ".figures canvas:visible"), await place(lab, "#transport")];
    assert.ok(scene.y >= 0 && scene.height > 150 && plot.y >= 0 && plot.y + plot.height <= bar.y, JSON.stringify([scene, plot, bar]));
    const slider = await place(lab, "#panel [type=range]");
    assert.ok(slider.y < scene.y + scene.height || size.width > 400, "the panel was scrolled");
  });
}

for (const [language, size] of [["en-GB", PHONE], ["es-ES", PHONE], ["en-GB", TABLET], ["es-ES", TABLET]]) {
  visit(`the transport has room, and no legend is cut: ${language}, ${size.width} px`, { ...size, language }, async (lab) => {
    for (const name of ["string", "cooling", "decay-chain", "charge", "gas"]) {
      await open(lab, name);
      const line = await place(lab, ".line-place");
      assert.ok(line.width >= 120, `${name}: the time line is ${line.width} px long`);
      // The title of an only plot is in its button, and for screen readers alone.
      const cut = await lab.page.locator("#transport, .legend:visible, .plot:visible h3").evaluateAll((parts) =>
        parts.filter((part) => part.clientWidth > 1).filter((part) => part.scrollWidth > part.clientWidth + 1 || part.scrollHeight > part.clientHeight + 3).map((part) => part.innerText));
      assert.deepEqual(cut, [], name);
    }
  });
}

visit("what a finger presses is 40 pixels high", PHONE, async (lab) => {
  await open(lab, "cooling");
  const small = await lab.page.locator("button, select, summary, input:not([type=checkbox])").evaluateAll((parts) =>
    parts.filter((part) => part.checkVisibility()).map((part) => [part, part.getBoundingClientRect().height])
      .filter(([, height]) => height > 1 && height < 39.5).map(([part, height]) => `${part.id} ${part.innerText}: ${height}`));
  assert.deepEqual(small, []);
});

visit("an event that ends a run is named once, with a moment that can be read", PHONE, async (lab) => {
  await lab.go(`${lab.address}#1&d=projectile.md`);
  await lab.page.reload();
  await lab.page.locator("#speed").selectOption({ index: 6 });
  await lab.press("Play");
  await lab.button("Go on").waitFor();
  const words = await lab.page.locator("#transport .ended p").innerText();
  assert.match(words, /^The run ends at t = \d\.\d\d s: The ball has landed\.$/);
  assert.equal(await lab.page.locator("#transport .trouble:visible").count(), 0);
  await eventually(async () => assert.equal(await lab.told(), words));
});

visit("a document without a scene and plots gives its room to the panel", PHONE, async (lab) => {
  const text = "---\ntitle: Bare\nstep: 0.05 [s]\n---\n\n```model\nx'' = -4 [1/s^2]*x\nx(0) = 1 [m]\nx'(0) = 0 [m/s]\n```\n";
  await lab.page.setInputFiles("#open-file", { name: "bare.md", mimeType: "text/markdown", buffer: Buffer.from(text) });
  await lab.page.getByRole("heading", { level: 1, name: "Bare" }).waitFor();
  const note = await lab.page.getByText("This document draws no scene.").boundingBox();
  assert.ok(note.height < 30, `the note is ${note.height} px high`);
  assert.equal(await lab.page.getByText("All plots are hidden.").isVisible(), false);
  const panel = await place(lab, ".panel");
  assert.ok(panel.y < 220, `the panel begins at ${panel.y}`);
});

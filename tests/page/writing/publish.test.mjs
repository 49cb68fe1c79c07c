// The dialog Share: link, page, frame, QR code and files, as a teacher uses them; and a page inside another page.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import { gunzipSync } from "node:zlib";
import { readCode } from "../codes.mjs";
import { packaged, unzipped } from "../course.mjs";
import { Lab, STILL, eventually, meniscus, temporary, visit } from "../lab.mjs";

const require = createRequire(import.meta.url);
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

const share = async (lab) => {
  await lab.page.locator("#share").click();
  await lab.page.locator("#publish[open]").waitFor();
};
const size = (lab) => eventually(async () => {
  const size = /^([0-9]+) kB$/.exec(await lab.page.locator("#page-size").innerText());
  assert.ok(size, "the page is ready");
  return Number(size[1]);
});

/** Saves the page that plays the open document. */
async function savedPage(lab) {
  await share(lab);
  const kilobytes = await size(lab);
  const { name, text } = await lab.save(lab.page.locator("#save-page"));
  assert.equal(kilobytes, Math.ceil(Buffer.byteLength(text) / 1000), "the size beside the button is that of the file");
  const file = temporary(`published-${name}`);
  writeFileSync(file, text);
  return { name, text, file };
}

/** What `save-page` and `meniscus export` must agree on: everything, and the simulation after it is inflated. */
function partsOf(page) {
  const bundle = /id="bundle"[^>]*>([^<]*)</.exec(page)[1];
  return { page: page.replace(bundle, ""), bundle: gunzipSync(Buffer.from(bundle, "base64")).toString("base64") };
}

visit("a document is published as a page: it plays, has its controls and languages, and the laboratory opens its source", async (lab) => {
  const { name, text, file } = await savedPage(lab);
  assert.equal(name, "utube.html");
  const exported = temporary("exported.html");
  meniscus("export", "simulations/utube.md", "--output", exported);
  assert.deepEqual(partsOf(text), partsOf(readFileSync(exported, "utf8")), "the same file as the program writes");
  const played = await Lab.open({ file, language: "es-ES" });
  try {
    await played.press("Reproducir");
    await played.watchUntil(1);
    await played.press("Pausar");
    await played.enter("Amortiguamiento", "321");
    assert.equal(await played.number("Amortiguamiento"), 321);
    await played.pressInMenu("EN – English");
    await eventually(async () => assert.match(await played.page.getByRole("heading", { level: 1 }).innerText(), /U-tube/));
    played.wasQuiet();
  } finally {
    await played.context.close();
  }
  await lab.keys("Escape");
  await lab.page.locator("#open-file").setInputFiles(file);
  await lab.tab("Write");
  await lab.page.locator(".cm-content").waitFor();
  assert.equal(await lab.page.getByLabel("File", { exact: true }).locator("option").count(), 2, "with its translation");
});

visit("what is written is published; with an error nothing is, and the dialog says why", async (lab) => {
  await lab.tab("Write");
  await lab.press("New");
  await lab.press("A mass on a spring");
  const editor = lab.page.locator(".cm-content");
  await eventually(async () => assert.ok(await editor.evaluate((content) => content === document.activeElement)));
  await lab.keys("Control+End");
  await lab.page.keyboard.insertText("\nPublished words.\n");
  const { name, text } = await savedPage(lab);
  assert.equal(name, "a-mass-on-a-spring.html");
  assert.match(text, /Published words/);
  await lab.keys("Escape");
  await editor.click();
  await lab.keys("Control+End");
  await lab.page.keyboard.insertText("\n```model\nq = zz\n```\n");
  await share(lab);
  await eventually(async () => assert.match(await lab.page.locator("#page-size").innerText(), /^The text has errors/));
  assert.equal(await lab.page.locator("#save-page").getAttribute("aria-disabled"), "true");
});

visit("packages for courses are those that the program writes", async (lab) => {
  await share(lab);
  await size(lab);
  for (const kind of ["scorm12", "scorm2004", "cmi5", "web"]) {
    const [download] = await Promise.all([lab.page.waitForEvent("download"), lab.page.locator(`#save-${kind}`).click()]);
    assert.equal(download.suggestedFilename(), `utube.${kind}.zip`);
    const [own, others] = [unzipped(readFileSync(await download.path())), packaged("simulations/utube.md", kind)];
    const [page, other] = [own, others].map((files) => partsOf(files.get("index.html").toString()));
    assert.deepEqual(page, other);
    const rest = (files) => [...files].filter(([name]) => name !== "index.html").map(([name, text]) => [name, text.toString()]);
    assert.deepEqual(rest(own), rest(others));
  }
});

visit("a QR code is that of the address; of a laboratory on this computer the dialog says what to do", { theme: "dark" }, async (lab) => {
  await share(lab);
  await lab.page.locator("#qr").click();
  await lab.page.getByText("is on this computer alone").waitFor();
  const address = "https://example.org/física/péndulo.html?language=es#1&p=b:20";
  await lab.page.locator("#qr-address").fill(address);
  await eventually(async () => assert.equal(await readCode(lab.page), address));
  const { name, text } = await lab.save(lab.page.locator("#save-qr"));
  assert.equal(name, "utube-qr.svg");
  assert.match(text, /^<svg xmlns="http:\/\/www.w3.org\/2000\/svg" /);
  await lab.page.locator("#qr-address").fill(`https://example.org/${"long/".repeat(200)}`);
  await lab.page.getByText("too long for a QR code").last().waitFor();
  assert.equal(await lab.page.locator(".qr").count(), 0);
});

for (const [language, words] of [["en-GB", /^Link copied\. It opens only on this computer/], ["es-ES", /^Enlace copiado\. Solo se abre en este ordenador/]]) {
  visit(`of a link that nobody else can open the dialog says so, and it stays open: ${language}`, { language }, async (lab) => {
    await share(lab);
    await lab.page.locator("#copy-link").click();
    await eventually(async () => assert.match(await lab.page.locator("#link-copied").innerText(), words));
    assert.equal(await lab.page.locator("#publish[open]").count(), 1);
  });
}

/** A page of a stranger with the code of the frame in it, and the page that plays beside it. */
async function hostPage(lab, code) {
  const file = temporary(`host-${Math.random()}.html`);
  writeFileSync(file, `<!doctype html><html lang="en"><title>Host</title><h1>Lesson</h1>${code}`);
  await lab.page.goto(pathToFileURL(file).href);
  return lab.page.frameLocator("iframe");
}

visit("a frame has its language, its parts, fixed values and the height of its content", async (lab) => {
  const { file } = await savedPage(lab);
  await lab.page.locator("#frame-address").fill(pathToFileURL(file).href);
  await lab.page.locator("#frame-width").fill("700");
  await lab.page.locator("#frame-height").fill("300");
  await lab.page.locator("#frame-language").selectOption("es");
  await lab.page.locator("#frame-plots").uncheck();
  await lab.page.locator("#frame-text").uncheck();
  await lab.page.locator("#frame-follows").check();
  await lab.page.locator("#frame-locked").check();
  const code = await eventually(async () => {
    const code = await lab.page.locator("#frame-code").innerText();
    assert.match(code, /\.html\?language=es&amp;hide=plots,text&amp;lock&amp;height=content" title="Oscillations/);
    return code;
  });
  const inside = await hostPage(lab, code);
  await inside.getByRole("button", { name: "Reproducir", exact: true }).waitFor();
  assert.deepEqual(await inside.getByRole("tab").filter({ visible: true }).count(), 2);
  assert.equal(await inside.locator(".plots").isVisible(), false);
  assert.equal(await inside.locator("#tab-theory").count(), 0);
  await inside.locator("#more > summary").click();
  assert.equal(await inside.locator("#parameter-0").isDisabled(), true);
  assert.equal(await inside.locator("[part~=handle]").count(), 0, "nothing in the drawing can be dragged");
  await inside.getByRole("tab", { name: "Preguntas" }).click();
  assert.equal(await inside.locator(".question input").first().isEnabled(), true, "questions are answered");
  await inside.getByRole("tab").first().click();
  await inside.getByRole("button", { name: "Reproducir", exact: true }).click();
  await eventually(async () => assert.notEqual(await inside.locator("#clock").innerText(), "0 s"));
  // The frame is as high as the page in it, also after the page has grown.
  const heights = () => lab.page.evaluate(() => document.querySelector("iframe").clientHeight);
  const content = () => inside.locator("body").evaluate((body) => Math.ceil(body.getBoundingClientRect().height));
  const settled = () => eventually(async () => {
    const height = await heights();
    await lab.page.waitForTimeout(300);
    assert.deepEqual([await heights(), await content()], [height, height], "it does not creep");
    return height;
  });
  const before = await settled();
  await inside.locator("#recorded summary").click();
  await eventually(async () => assert.ok((await heights()) > before));
  await settled();
});

visit("a frame may hold the present values, and nothing but the drawing", { width: 1024, height: 768 }, async (lab) => {
  await lab.enter("Damping", "77");
  const { file } = await savedPage(lab);
  await lab.page.locator("#frame-address").fill(pathToFileURL(file).href);
  for (const part of ["head", "plots", "parameters", "values", "activities", "text"]) await lab.page.locator(`#frame-${part}`).uncheck();
  await lab.page.locator("#frame-state").check();
  const code = await eventually(async () => {
    const code = await lab.page.locator("#frame-code").innerText();
    assert.match(code, /#1&amp;.*b:77/);
    return code;
  });
  const inside = await hostPage(lab, code);
  await inside.locator("#scene").waitFor();
  assert.equal(await inside.locator(".panel, .head").count(), 0);
  const filled = await inside.locator(".stage").evaluate((stage) => stage.getBoundingClientRect().height / innerHeight);
  assert.ok(filled > 0.99, `the stage fills the frame: ${filled}`);
  assert.equal(await inside.getByRole("heading", { level: 1 }).count(), 1);
});

for (const [theme, width] of [["light", 390], ["dark", 800]]) {
  visit(`axe finds nothing in a page with locked values inside another: ${theme}, ${width}`, { ...STILL, theme, width, height: 700 }, async (lab) => {
    const file = temporary("embedded.html");
    meniscus("export", "simulations/utube.md", "--output", file);
    for (const query of ["?lock&height=content&language=es", "?hide=head,scene&lock"]) {
      await lab.page.goto(pathToFileURL(file).href + query);
      await lab.page.locator("#more").evaluate((more) => (more.open = true));
      await lab.page.locator("#parameter-0").waitFor({ state: "attached" });
      await lab.page.evaluate(axe);
      const { violations } = await lab.page.evaluate(() => window.axe.run("html"));
      assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`), []);
      assert.equal(await lab.page.evaluate(() => document.documentElement.scrollWidth > window.innerWidth), false);
    }
  });
}

for (const [device, options] of [["desk", {}], ["phone", { width: 390, height: 844, touch: true }]]) {
  for (const [theme, language] of [["light", "en-GB"], ["dark", "es-ES"]]) {
    visit(`axe finds nothing in the dialog: ${device}, ${theme}, ${language}`, { ...STILL, theme, language, ...options }, async (lab) => {
      await share(lab);
      await size(lab);
      await lab.page.locator("#qr").click();
      await lab.page.locator("#qr-address").fill("https://example.org/");
      await lab.page.locator(".qr").waitFor();
      await lab.page.evaluate(axe);
      const { violations } = await lab.page.evaluate(() => window.axe.run("html"));
      assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`), []);
      const [within, low] = await lab.page.locator("#publish").evaluate((dialog) => [
        dialog.scrollWidth <= dialog.clientWidth,
        [...dialog.querySelectorAll("button, select, .switch, input:not([type=checkbox])")].filter((node) => node.getBoundingClientRect().height < 35.5).map((node) => node.id || node.className),
      ]);
      assert.ok(within, "nothing sticks out");
      assert.deepEqual(low, []);
    });
  }
}

// How many actions the common ways through the laboratory take, from its first screen: clicks, drops, keys, and texts that are typed.

import assert from "node:assert/strict";
import { drop, eventually, visit } from "../lab.mjs";
import { clickFilmed, dropFilm, swing, truth } from "../films.mjs";
import { film, fitted, records } from "../measured.mjs";

/** A person who counts. */
class Walker {
  constructor(lab) {
    Object.assign(this, { lab, page: lab.page, actions: 0 });
  }

  async does(action) {
    this.actions += 1;
    await action;
    await this.lab.drawn();
  }

  click(name) {
    return this.does(this.lab.button(name).click());
  }

  tab(name) {
    return this.does(this.page.getByRole("tab", { name, exact: true }).click());
  }

  /** Clicks a point of the film, in its pixels. */
  clickFilm(at) {
    return this.does(clickFilmed(this.lab, at, truth.size));
  }

  async fit() {
    await this.does(this.page.locator("#fit").click());
    return fitted(this.lab);
  }
}

const walk = (title, most, does) =>
  visit(`${title}: actions, at most ${most}`, { fragment: "" }, async (lab) => {
    const walker = new Walker(lab);
    await does(walker, lab);
    assert.ok(walker.actions <= most, `${walker.actions} actions`);
  });

walk("the first fit of a record that is dropped", 3, async (walker, lab) => {
  await walker.does(drop(lab, { name: "U.txt", text: film() }));
  await eventually(async () => assert.equal(await records(lab).count(), 1));
  const found = await walker.fit();
  assert.ok(found.size > 2);
});

walk("the way from a film to its fit", 9, async (walker) => {
  await walker.does(dropFilm(walker.page, swing));
  await walker.clickFilm([truth.arms[0], truth.frames[0][1]]);
  await walker.page.locator("#film-record").waitFor({ timeout: 30_000 });
  for (const way of [-75, 75]) await walker.clickFilm([165, truth.rest + way]);
  await walker.does(walker.page.locator("#film-length").fill("20 cm"));
  await walker.does(walker.page.keyboard.press("Enter"));
  const found = await walker.fit();
  assert.ok(found.size > 2);
});

walk("comparing two runs", 4, async (walker, lab) => {
  await walker.click("Play");
  await lab.watchUntil(0.5);
  await walker.click("Keep run");
  await walker.does(lab.slider("Damping").press("PageUp"));
  await walker.click("Back to start");
  await eventually(async () => assert.equal(await walker.page.locator(".legend .of-run, .runs li").count() > 0, true));
});

walk("the projector's view", 1, async (walker) => {
  await walker.click("Projector's view");
  assert.equal(await walker.page.locator("#panel").isVisible(), false);
});

walk("a virtual measurement against its truth", 3, async (walker, lab) => {
  await walker.tab("Measure");
  await walker.does(walker.page.locator("#measure").click());
  await records(lab).waitFor();
  const found = await walker.fit();
  assert.match([...found.values()].map((one) => one.remark).join(" "), /true value/);
});

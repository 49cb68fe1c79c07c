// Takes the pictures of the README, which it puts into `docs`:
//
//     cd tests/page && CHROME=/usr/bin/chromium node --test pictures.mjs

import { STILL, visit } from "./lab.mjs";
import { clickFilmed, dropFilm, freeSwing, tracked, truth } from "./films.mjs";
import { fit } from "./measured.mjs";

const PAGE = { ...STILL, fragment: "", width: 1280, height: 800 };

const taken = (lab, name) => lab.page.screenshot({ path: new URL(`../../docs/${name}.png`, import.meta.url).pathname });

visit("a simulation", PAGE, async (lab) => {
  await lab.press("Play");
  await lab.watchUntil(1.2);
  await lab.press("Pause");
  await taken(lab, "simulation");
});

visit("a film with its fit", PAGE, async (lab) => {
  await dropFilm(lab.page, freeSwing);
  await clickFilmed(lab, [truth.arms[0], truth.frames[0][1]], truth.size);
  await tracked(lab);
  for (const way of [-75, 75]) await clickFilmed(lab, [165, truth.rest + way], truth.size);
  await lab.page.locator("#film-length").fill("20 cm");
  await lab.page.locator("#film-length").press("Enter");
  await fit(lab);
  await lab.page.locator("#messages").getByRole("button", { name: "Dismiss" }).click();
  await lab.page.mouse.move(0, 0);
  await lab.page.evaluate(() => scrollTo(0, 0));
  await taken(lab, "film");
});

visit("writing a simulation", PAGE, async (lab) => {
  await lab.tab("Write");
  await lab.press("Play");
  await lab.watchUntil(1.2);
  await lab.press("Pause");
  await lab.page.locator(".cm-scroller").evaluate((editor) => (editor.scrollTop = 1130));
  await lab.page.waitForTimeout(300);
  await taken(lab, "writing");
});

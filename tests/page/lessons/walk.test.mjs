// How many actions it takes from the start of the program to the first result of a student on the projector, guided by what the
// screen says: clicks, keys, texts that are typed, and codes that are scanned.

import assert from "node:assert/strict";
import { test } from "node:test";
import { readCode } from "../codes.mjs";
import { join, school, start } from "./class.mjs";

const { visitor, faults } = school();

/** A person who counts. */
class Walker {
  constructor(page) {
    Object.assign(this, { page, actions: 0 });
  }

  async does(action) {
    this.actions += 1;
    return action;
  }
}

test("from the start of the program to the first answer on the projector: actions, at most 4 of the teacher and 5 of the student", async () => {
  const server = await start();
  try {
    const teacher = new Walker(await visitor());
    await teacher.does(teacher.page.goto(server.link));
    // The projector shows the code at once; a student scans it and is at the document.
    const way = teacher.page.locator("#class-first");
    await way.getByText("Students scan the code").waitFor();
    const address = await readCode(teacher.page);
    assert.equal(address.split("#")[1], `join=${server.code}`);
    const student = new Walker(await visitor({ viewport: { width: 390, height: 844 }, hasTouch: true }));
    // The address is that of this computer in its network; tests stay on loopback.
    await student.does(student.page.goto(`${server.base}/#${address.split("#")[1]}`));
    await student.does(student.page.getByRole("button", { name: "Join", exact: true }).tap());
    await student.page.getByText("My seat").waitFor();
    await teacher.page.getByText("1 joined").waitFor();
    assert.equal(await way.isVisible(), true, "the others are still to join");
    await student.does(student.page.getByRole("tab", { name: "Questions" }).tap());
    const field = student.page.getByRole("tabpanel").getByRole("textbox").first();
    await student.does(field.fill("0.31"));
    await student.does(field.press("Enter"));
    // It arrives by itself, and the code makes room for it.
    const { page } = teacher;
    await teacher.does(page.locator("#class-answers summary").first().click());
    assert.equal(await way.isVisible(), false);
    await teacher.does(page.locator("#class-answers").getByRole("button", { name: /: 0\.31$/ }).click());
    await teacher.does(page.getByRole("button", { name: "Show on the wall" }).click());
    assert.equal(await page.locator("#wall .wall-answer").innerText(), "0.31");
    assert.ok(teacher.actions <= 4, `${teacher.actions} actions of the teacher`);
    assert.ok(student.actions <= 5, `${student.actions} actions of the student`);

    // What is shown stays while the student goes on.
    await field.fill("0.32");
    await field.press("Enter");
    await page.locator("#class").getByText("0.32").first().waitFor({ state: "attached" });
    assert.match(await page.locator("#wall .wall-answer").innerText(), /0\.3[12]/);

    // A dashboard that was closed is opened again from the line of the class.
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
    await page.locator("#class").waitFor({ state: "hidden" });
    await page.getByRole("region", { name: "Seats" }).getByRole("button", { name: "Open the class" }).click();
    await page.locator("#class[open]").waitFor();
    assert.deepEqual(faults, []);
  } finally {
    server.child.kill("SIGKILL");
  }
});

test("a seat is kept on the way from the list of the documents to a document", async () => {
  const server = await start({ what: ["simulations/utube.md", "simulations/tube.md"] });
  try {
    const page = await visitor();
    await join(page, server.code, `${server.base}/`);
    await page.getByRole("link", { name: "A liquid in a U-tube", exact: true }).click();
    await page.getByRole("tab", { name: "Questions" }).waitFor();
    await page.getByText("My seat").waitFor();
    assert.deepEqual(faults, []);
  } finally {
    server.child.kill("SIGKILL");
  }
});

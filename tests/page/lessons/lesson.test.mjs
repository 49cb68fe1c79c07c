// A lesson with `meniscus class serve`: students join, lose the network, come back; the teacher follows them.

import assert from "node:assert/strict";
import { writeFileSync, readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { eventually, meniscus, temporary } from "../lab.mjs";
import { answer, join, school, shows, start, status, stop, stored, teach } from "./class.mjs";

const { visitor, faults } = school();
let server;
before(async () => (server = await start()));
after(() => server?.child.kill("SIGKILL"));

const address = () => `${server.base}/d/utube.md`;

test("a lesson: joining, a cut network, a reload in it, a killed server, a second device, a file from disk", async () => {
  const teacher = await visitor();
  await teach(teacher, server);
  await teacher.getByText("0 joined").waitFor();
  assert.equal(new URL(teacher.url()).hash, "", "the one-time link does not stay in the address");

  const student = await visitor();
  const wrong = await visitor();
  await wrong.goto(`${server.base}/#join=222222`);
  assert.equal(await wrong.getByLabel("Code of the class").inputValue(), "222222");
  await wrong.getByRole("button", { name: "Join" }).click();
  await status(wrong, /No class has this code/);
  const name = await join(student, server.code.toLowerCase(), address());
  assert.match(name, /^\w+ \w+ 1$/);
  await answer(student, "0.31");
  await shows(teacher, /0\.31 instead of/);
  await status(student, /^Everything is handed in/);

  // Without a network, also over a reload; nothing is lost.
  await student.context().setOffline(true);
  await answer(student, "0.32");
  await status(student, /not handed in yet.*cannot be reached/);
  await student.close({ runBeforeUnload: false });
  const again = await student.context().newPage();
  await student.context().setOffline(false);
  await again.goto(address());
  await status(again, /^Everything is handed in/);
  await shows(teacher, /0\.32 instead of/);

  // The server is killed and comes back; students and teacher go on by themselves.
  await stop(server, "SIGKILL");
  await answer(again, "0.33");
  await status(again, /not handed in yet/);
  server = await start(server);
  await status(again, /^Everything is handed in/, 60);
  await shows(teacher, /0\.33 instead of/, 60);

  // The same seat on another device.
  await again.getByText("My seat").click();
  const key = await again.locator("#class-bar .key").innerText();
  const device = await visitor();
  assert.equal(await join(device, key, address()), name);
  await answer(device, "0.34");
  await status(device, /^Everything is handed in/);
  await shows(teacher, /0\.34 instead of/);

  // The file for this class opens from disk, has the seat, and hands in.
  const download = again.waitForEvent("download");
  await again.getByRole("button", { name: "Get the file for this class" }).click();
  const file = temporary("class.html");
  await (await download).saveAs(file);
  // The address is that of this computer in its network; tests stay on loopback.
  const text = readFileSync(file, "utf8");
  const own = text.match(/connect-src (http:[^"]*)"/)[1];
  writeFileSync(file, text.replaceAll(own, server.base));
  const disk = await visitor();
  await disk.goto(pathToFileURL(file).href);
  assert.equal(await disk.locator("#class-bar strong").innerText(), name);
  assert.equal(await disk.evaluate(() => window.isSecureContext), true);
  await answer(disk, "0.35");
  await status(disk, /^Everything is handed in/);
  await shows(teacher, /0\.35 instead of/);
  assert.deepEqual(faults, []);
});

test("the teacher pauses, closes, lets in, shows answers; a student erases what is stored", async () => {
  const teacher = await visitor();
  await stop(server);
  server = await start(server);
  await teach(teacher, server);
  const [one, other] = [await visitor(), await visitor()];
  await join(one, server.code, address());
  await join(other, server.code, address());
  await answer(one, "0.41");
  await answer(other, "0.42");
  await status(one, /^Everything is handed in/);
  await status(other, /^Everything is handed in/);

  await teacher.getByLabel("Class paused", { exact: true }).check();
  await one.getByText("Your teacher has paused the class.").waitFor();
  await teacher.getByLabel("Class paused", { exact: true }).uncheck();
  await one.locator("#class-pause").waitFor({ state: "detached" });

  await teacher.getByLabel("Class open", { exact: true }).uncheck();
  await status(one, /The class is closed/);
  await answer(one, "0.43");
  await status(one, /not handed in yet.*The class is closed/);
  await teacher.getByLabel("Class open", { exact: true }).check();
  await status(one, /^Everything is handed in/, 60);

  await teacher.getByLabel("Others' answers after one's own").check();
  await one.getByText("Answers of the class").click();
  await eventually(async () => assert.match(await one.locator("#class-others").innerText(), /0\.42/));

  await Promise.all([teacher.waitForResponse(/teacher\/settings/), teacher.getByLabel("Approve late joiners").check()]);
  await teacher.getByText("Seats", { exact: true }).click();
  const late = await visitor();
  await late.goto(address());
  await late.getByLabel("Code of the class").fill(server.code);
  await late.getByRole("button", { name: "Join" }).click();
  await status(late, /Wait until your teacher lets you in/);
  await teacher.getByRole("button", { name: "Let in" }).click();
  await status(late, /(Nothing|Everything) is handed in/);

  one.on("dialog", (dialog) => dialog.accept());
  await one.getByText("My seat").click();
  await one.getByRole("button", { name: "Erase what is stored of me" }).click();
  await status(one, /Erased/);
  assert.equal(await (await one.context().cookies()).length, 0);
  assert.deepEqual(faults, []);
});

test("students with the laboratory: a fit reaches the dashboard by itself", async () => {
  const lesson = await start({ what: ["simulations/tube.md", "--lab"] });
  try {
    const teacher = await visitor();
    await teach(teacher, lesson);
    const student = await visitor();
    await join(student, lesson.code, `${lesson.base}/d/tube.md`);
    await student.getByRole("tab", { name: "Measure", exact: true }).click();
    await student.locator("#panel").getByRole("button", { name: /Column of 18 cm/ }).click();
    await student.locator("#fit").click();
    await eventually(async () => assert.match(await student.locator("#fit-lines").innerText(), /9\.4\d* ± 0\.0\d*\s+cm/), 60);
    await shows(teacher, /1 group\b[^]*± 0\.0/, 90);
    await status(student, /^Everything is handed in/);
    assert.deepEqual(faults, []);
  } finally {
    await stop(lesson);
  }
});

test("each student has the assigned values of the own seat: those of `class assign`", async () => {
  const document = "tests/page/course.md";
  const assigned = JSON.parse(meniscus("class", "assign", document, "--seats", "3", "--format", "json")).seats.map(({ values }) => values[0]);
  const lesson = await start({ what: [document] });
  try {
    const address = `${lesson.base}/d/course.md`;
    const damping = (page) => page.getByRole("textbox", { name: /^Damping/ }).first();
    for (const [place, value] of assigned.entries()) {
      const student = await visitor({ locale: "en-GB" });
      await join(student, lesson.code, address);
      await eventually(async () => assert.equal(await student.getByLabel("Seat", { exact: true }).inputValue(), String(place + 1)));
      assert.equal(Number(await damping(student).inputValue()), value);
      assert.equal(await student.getByText("The link was not understood").count(), 0);
      // A link that sets something else keeps the seat.
      await student.goto("about:blank");
      await student.goto(`${address}#1&p=k:5`);
      await eventually(async () => assert.equal(Number(await student.getByRole("textbox", { name: /^Stiffness/ }).first().inputValue()), 5));
      assert.equal(Number(await damping(student).inputValue()), value);
    }
    assert.deepEqual(faults, []);
  } finally {
    await stop(lesson);
  }
});

test("a browser that keeps a seat of an earlier class is told, and joins the present one", async () => {
  const lesson = await start();
  let present = lesson;
  try {
    const address = `${lesson.base}/d/utube.md`;
    const student = await visitor();
    await join(student, lesson.code, address);
    await answer(student, "0.51");
    await status(student, /^Everything is handed in/);
    await stop(lesson);
    present = await start({ ...lesson, begin: "--new" });
    await status(student, /belongs to an earlier class/, 60);
    const teacher = await visitor();
    await teach(teacher, present);
    await student.getByLabel("Code of the class").fill(present.code);
    await student.getByRole("button", { name: "Join" }).click();
    await status(student, /^Everything is handed in/);
    await shows(teacher, /0\.51 instead of/);
    // A code that was scanned is typed already.
    const other = await visitor();
    await join(other, present.code, address);
    await stop(present);
    present = await start({ ...lesson, begin: "--new" });
    await other.goto("about:blank");
    await other.goto(`${address}#join=${present.code}`);
    await status(other, /belongs to an earlier class/, 60);
    assert.equal(await other.getByLabel("Code of the class").inputValue(), present.code);
    assert.deepEqual(faults, []);
  } finally {
    await stop(present);
  }
});

test("a student leaves a shared computer: the class keeps the work, and the browser nothing of it", async () => {
  const lesson = await start({ what: ["simulations/utube.md", "--lab"] });
  try {
    const address = `${lesson.base}/d/utube.md`;
    const student = await visitor();
    const name = await join(student, lesson.code, address);
    await answer(student, "0.7151");
    await status(student, /^Everything is handed in/);
    await student.getByText("My seat").click();
    const key = await student.locator("#class-bar .key").innerText();
    // The open list would cover the tabs.
    await student.keyboard.press("Escape");
    const tab = await student.context().newPage();
    await tab.goto(address);
    await tab.getByText("My seat").waitFor();
    await answer(student, "0.7252");
    const asked = [];
    student.on("dialog", (dialog) => (asked.push(dialog.message()), dialog.accept()));
    await student.getByText("My seat").click();
    await student.getByRole("button", { name: "Leave this computer" }).click();
    for (const page of [student, tab]) {
      await page.getByLabel("Code of the class").waitFor();
      await page.getByRole("tab", { name: "Questions" }).click();
      assert.equal(await page.getByRole("tabpanel").getByRole("textbox").first().inputValue(), "");
      assert.doesNotMatch(await page.locator("body").innerText(), /0\.7151|0\.7252/);
    }
    assert.equal(asked.length, 1, asked.join(" "));
    const left = await student.evaluate(() => Object.entries(localStorage).flat().join("\n"));
    for (const secret of ["0.7151", "0.7252", name, key, "meniscus-class", "hand-in-name"]) assert.ok(!left.includes(secret), `${secret}: ${left}`);

    // The next person has a seat without work; the first one goes on elsewhere.
    assert.notEqual(await join(student, lesson.code, address), name);
    await status(student, /^Nothing is handed in/);
    const home = await visitor();
    assert.equal(await join(home, key, address), name);
    await status(home, /^Everything is handed in/);
    const { "hand-ins": [text] } = await stored(home, lesson.base);
    const typed = JSON.parse(text).work.items.flatMap(({ item }) => item.item.answer?.attempts ?? []).map((one) => one.typed);
    assert.deepEqual(typed, ["0.7151", "0.7252"]);

    // Without a network it is asked once more, and refused here: everything stays.
    const offline = await visitor();
    await offline.clock.install();
    await join(offline, lesson.code, address);
    await answer(offline, "0.73");
    await status(offline, /^Everything is handed in/);
    await offline.context().setOffline(true);
    await answer(offline, "0.74");
    await status(offline, /not handed in yet.*cannot be reached/);
    const questions = [];
    offline.on("dialog", (dialog) => {
      questions.push(dialog.message());
      return questions.length === 1 ? dialog.accept() : dialog.dismiss();
    });
    await offline.getByText("My seat").click();
    await offline.getByRole("button", { name: "Leave this computer" }).click();
    await status(offline, /Handing in/);
    await offline.clock.fastForward(30_000);
    await eventually(() => assert.match(questions[1] ?? "", /^Not handed in yet: \d/));
    await offline.context().setOffline(false);
    await status(offline, /^Everything is handed in/, 60);
    assert.deepEqual(faults, []);
  } finally {
    await stop(lesson);
  }
});

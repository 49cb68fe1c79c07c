// Course packages on platforms that misbehave, and answers of every kind to the questions of the documents that ship.
// `ALL=1` answers the questions of every document in every language and in both versions of SCORM (some ten minutes).

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { beside, eventually } from "../lab.mjs";
import { Platform, Visit, verified } from "../course.mjs";

const COURSE = "tests/page/course.md";

/** A platform of SCORM 1.2 whose functions are given by name; the others do what a good one does. */
const platform = (own) => `
const values = {};
window.API = {
  LMSInitialize: () => "true", LMSFinish: () => "true", LMSCommit: () => "true", LMSGetLastError: () => "0",
  LMSGetValue: (name) => values[name] ?? "", LMSSetValue: (name, value) => ((values[name] = value), "true"), ${own} };`;
const every = (answer) => `window.API = new Proxy({}, { get: () => () => { ${answer} } });`;
const later = (own, milliseconds) => `setTimeout(() => { ${platform(own)} }, ${milliseconds});`;

/** Message to the student, and the platform that gives the reason. */
const MISSING = "The course does not answer";
const REFUSED = "The course has not accepted everything";
const UNREAD = "The work in the course could not be read";
const STARTED = "The course keeps your work";
const HOSTILE = [
  ["is not there", MISSING, ""],
  ["has no functions", MISSING, "window.API = {};"],
  ["throws at every call", MISSING, every("throw new Error('no');")],
  ["answers undefined", MISSING, every("")],
  ["answers what cannot be read", MISSING, every("return { toString() { throw 1; } };")],
  ["cannot even be looked at", MISSING, "Object.defineProperty(window, 'API', { get() { throw new Error('no'); } });"],
  ["is of another site", MISSING, platform(""), (address) => address.replace("127.0.0.1", "localhost") + `?from=${address.slice(0, -1)}`],
  ["refuses to begin", MISSING, platform("LMSInitialize: () => 'false'")],
  ["refuses every value", REFUSED, platform("LMSSetValue: () => 'false', LMSGetLastError: () => '405'")],
  ["throws at every value", REFUSED, platform("LMSSetValue() { throw new Error('no'); }, LMSGetLastError() { throw 0; }")],
  ["loses every commit", REFUSED, platform("LMSCommit: () => 'false'")],
  ["answers true instead of a text", STARTED, platform("LMSInitialize: () => true, LMSSetValue: () => true, LMSCommit: () => true")],
  ["comes late", STARTED, later("", 2500)],
  ["gives another state", UNREAD, platform("LMSGetValue: () => '<img src=x onerror=alert(1)>'")],
  ["gives a damaged state", UNREAD, platform("LMSGetValue: (name) => name === 'cmi.suspend_data' ? 'zAAAA\\0' : ''")],
  ["gives a state that inflates", UNREAD, platform("LMSGetValue: (name) => name === 'cmi.suspend_data' ? 'z' + '7cEBDQAAAMKg'.repeat(1e6) : ''")],
];

for (const [what, told, script, elsewhere] of HOSTILE) {
  test(`a page works on a platform that ${what}`, async () => {
    const { address } = await Platform.begin(COURSE, "scorm12", script);
    const visit = await Visit.open({ address: elsewhere?.(address) ?? address });
    await visit.page.locator("#course-start").click();
    await visit.page.locator("#messages").getByText(told).first().waitFor();
    if (told !== STARTED) assert.match(await visit.page.locator("#messages").innerText(), /Hand in/);
    await visit.enter("Stiffness", "5");
    assert.equal(await visit.value("Stiffness"), 5);
    await visit.answer(0, "17");
    assert.equal((await visit.answers(1))[0][1], "wrong");
    const { text } = await visit.handIn("otter");
    assert.equal(verified(text).code, 0);
    await visit.lab.page.goto("about:blank");
    await visit.close();
  });
}

/** Texts that nobody expects as an answer, different for each question. */
const texts = (question) => [
  `${question} ñ 🎉 \u2028\u2029\t"'<&>`.repeat(900).slice(0, 10_000),
  Array.from({ length: 9_999 }, (_, place) => String.fromCodePoint(33 + ((place * 7919 * (question + 3)) % 9_000))).join(""),
  `{lang=es}[,]a[.]b[:]c ${question}`,
  `{${question}`,
  `1.${question}e-3`,
  "1e-30",
  "-1e12",
  `49,5${question}`,
  `49.5${question} kg/s`,
  `3 ± 0.${question}`,
  "",
];

/** Answers all questions with all texts, then rightly. Runs in the page. How many questions there are. */
async function answerAll(all) {
  const drawn = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const answer = (question, text) => {
    const field = document.getElementById(`answer-${question}`);
    field.value = text;
    field.dispatchEvent(new Event("input", { bubbles: true }));
    field.form.requestSubmit();
  };
  let question = 0;
  for (; document.getElementById(`question-${question}`); question += 1) {
    for (const text of all[question]) answer(question, text);
    document.getElementById(`answer-${question}`).form.querySelector("button.quiet").click();
    await drawn();
    const right = document.getElementById(`answer-${question}`).closest("section").querySelector(".revealed strong").textContent;
    answer(question, right);
    await drawn();
  }
  return question;
}

const folders = ["simulations/theories", "simulations"];
const documents = folders.flatMap((folder) => readdirSync(beside(`../../${folder}`)).filter((name) => /^[^.]+\.md$/.test(name)).map((name) => `${folder}/${name}`));
const asking = documents.filter((document) => readFileSync(beside(`../../${document}`), "utf8").includes("```question"));
const ways = ["scorm12", "scorm2004"].flatMap((kind) => ["en-GB", "es-ES"].map((language) => [kind, language]));
const sessions = process.env.ALL
  ? documents.flatMap((document) => ways.map((way) => [document, ...way]))
  : asking.map((document, place) => [document, ...ways[place % ways.length]]);

for (const [document, kind, language] of sessions) {
  test(`${kind}: no value is refused when all questions of ${document} are answered, ${language}`, async () => {
    const platform = await Platform.begin(document, kind);
    const visit = await Visit.open(platform, { language });
    await visit.start();
    let count = 0;
    if (asking.includes(document)) {
      await visit.tab("questions");
      const all = Array.from({ length: 20 }, (_, question) => texts(question));
      count = await visit.page.locator("body").evaluate((_, [code, all]) => new Function(`return (${code})`)()(all), [answerAll.toString(), all]);
      assert.ok(count > 0);
      // The state of many long answers has to be packed first.
      await eventually(async () => assert.equal(await visit.noted("calls.at(-1)[0]"), "Commit"));
    }
    assert.deepEqual(await visit.noted("refused"), []);
    const interactions = await visit.noted("calls.filter(([, name]) => /interactions.\\d+.id$/.test(name)).length");
    assert.ok(interactions >= count * 8, `${interactions} interactions`);
    await visit.lab.page.goto("about:blank");
    const status = kind === "scorm12" ? "lesson_status" : "completion_status";
    await eventually(() => assert.equal(platform.core[status], "completed"));
    await visit.close();

    const later = await Visit.open(platform, { language });
    await later.start();
    if (count) assert.ok((await later.answers(count)).every(([, grade]) => grade === "right"));
    assert.deepEqual(await later.noted("refused"), []);
    await later.close();
  });
}

// Course packages of cmi5 with a small store for statements.

import assert from "node:assert/strict";
import { randomUUID } from "node:crypto";
import { test } from "node:test";
import { Lab, eventually } from "../lab.mjs";
import { Visit, packaged, served } from "../course.mjs";

/** Ends a visit. That a store has nothing yet is an answer of its protocol, which the browser notes as an error. */
async function close(visit, ...others) {
  visit.lab.faults = visit.lab.faults.filter((fault) => !["404 (Not Found)", ...others].some((known) => fault.includes(known)));
  await visit.close();
}

/** A store. It notes statements, gives a token once for each launch, and checks the headers. */
class Store {
  static async begin() {
    const store = Object.assign(new Store(), { statements: [], states: {}, tokens: new Set(), wrong: [], setting: { contextTemplate: { contextActivities: { grouping: [{ id: "urn:test:group" }] } } } });
    const files = packaged("tests/page/course.md", "cmi5");
    store.page = await served((_, response) => response.writeHead(200, { "Content-Type": "text/html" }).end(files.get("index.html")));
    store.address = await served(({ request: { method, headers }, url, body }, response) => {
      const send = (status, content = "") => response.writeHead(status, { "Access-Control-Allow-Origin": "*", "Access-Control-Allow-Headers": "*, Authorization", "Access-Control-Allow-Methods": "GET, PUT, POST" }).end(content);
      if (method === "OPTIONS") return send(204);
      if (url.pathname === "/fetch") {
        const token = url.searchParams.get("launch");
        if (store.tokens.has(token)) return send(200, '{"error-code":"1","error-text":"used"}');
        store.tokens.add(token);
        return send(200, JSON.stringify({ "auth-token": token }));
      }
      if (!store.tokens.has(headers.authorization?.replace("Basic ", "")) || headers["x-experience-api-version"] !== "1.0.3") store.wrong.push(url.pathname);
      if (url.pathname === "/xapi/statements") return store.statements.push(...JSON.parse(body)), send(200, "[]");
      if (url.pathname === "/xapi/agents/profile") return send(404);
      const state = url.searchParams.get("stateId");
      if (method === "PUT") return (store.states[state] = body), send(204);
      const stored = state === "LMS.LaunchData" ? JSON.stringify(store.setting) : store.states[state];
      send(stored ? 200 : 404, stored);
    });
    return store;
  }

  /** Address of the page for a launch of its own; platforms end the address of the store with a slash or without. */
  launch(end = "/") {
    return `${this.page}?${new URLSearchParams({
      endpoint: `${this.address}xapi${end}`,
      fetch: `${this.address}fetch?launch=${randomUUID()}`,
      actor: JSON.stringify({ objectType: "Agent", account: { homePage: "https://school.test", name: "s1042" } }),
      registration: "6f0f1f1e-27f9-4b3c-8f0e-2d5a9c3c1a10",
      activityId: "urn:test:page",
    })}`;
  }

  verbs() {
    return this.statements.map(({ verb }) => verb.id.split("/").at(-1));
  }
}

test("cmi5: initialized first, answers, completed and passed once, terminated last; another device goes on", async () => {
  const store = await Store.begin();
  const lab = await Lab.open({ address: () => store.launch() });
  const first = new Visit(lab, lab.page);
  assert.match(await first.page.locator("#course").innerText(), new RegExp(`It is sent to ${new URL(store.address).host}`));
  assert.deepEqual(store.tokens.size, 0, "nothing is asked before");
  await first.start();
  const damping = await first.value("Damping");
  await first.enter("Stiffness", "7");
  await first.answer(0, String(damping));
  await first.answer(1, "1000");
  await lab.page.goto("about:blank");
  await eventually(() => assert.equal(store.verbs().at(-1), "terminated"));
  assert.deepEqual(store.verbs(), ["initialized", "answered", "answered", "completed", "terminated"]);
  await close(first);

  const again = await Lab.open({ address: () => store.launch(""), language: "es-ES" });
  const second = new Visit(again, again.page);
  await second.start();
  assert.deepEqual([await second.value("Amortiguamiento"), await second.value("Rigidez")], [damping, 7]);
  assert.deepEqual(await second.answers(2), [[String(damping), "right"], ["1000", "wrong"]]);
  await second.answer(1, String(2 / damping));
  await again.page.goto("about:blank");
  await eventually(() => assert.equal(store.verbs().at(-1), "terminated"));
  assert.deepEqual(store.verbs().slice(5), ["initialized", "answered", "passed", "terminated"]);
  await close(second);

  assert.deepEqual(store.wrong, []);
  const passed = store.statements.find(({ verb }) => verb.id.endsWith("passed"));
  assert.deepEqual([passed.result.score.scaled, passed.result.success], [1, true]);
  assert.equal(new Set(store.statements.map(({ id }) => id)).size, store.statements.length);
  for (const { verb, context, actor } of store.statements) {
    const own = context.contextActivities.category?.map(({ id }) => id.split("/").at(-1)) ?? [];
    assert.equal(own.includes("cmi5"), !verb.id.endsWith("answered"), verb.id);
    assert.equal(own.includes("moveon"), /completed|passed/.test(verb.id), verb.id);
    assert.deepEqual(context.contextActivities.grouping, [{ id: "urn:test:group" }]);
    assert.deepEqual([context.registration, actor.account.name], ["6f0f1f1e-27f9-4b3c-8f0e-2d5a9c3c1a10", "s1042"]);
  }
});

test("cmi5: a page that is looked at sends no answers, a used launch is refused, and nobody else is asked", async () => {
  const store = await Store.begin();
  store.setting.launchMode = "Review";
  const launch = store.launch();
  const lab = await Lab.open({ address: () => launch });
  const teacher = new Visit(lab, lab.page);
  await teacher.start();
  await teacher.answer(0, "17");
  await lab.page.reload();
  await eventually(() => assert.deepEqual(store.verbs(), ["initialized", "terminated"]));
  assert.deepEqual(Object.keys(store.states), []);
  await teacher.page.locator("#course-start").click();
  await teacher.page.locator("#messages").getByText("The course does not answer").waitFor();
  await teacher.answer(0, "17");
  const elsewhere = await lab.page.evaluate((address) => fetch(address).then(() => "asked", () => "refused"), `${store.address}other`);
  assert.equal(elsewhere, "refused");
  await close(teacher, "Content Security Policy");
});

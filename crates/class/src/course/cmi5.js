// Platform of cmi5: a store for statements, whose address comes with the launch.
const launch = new URLSearchParams(location.search);
const [endpoint, actor, registration, activityId] = ["endpoint", "actor", "registration", "activityId"].map((name) => launch.get(name));
const own = "https://w3id.org/xapi/cmi5/context/";
const headers = { "X-Experience-API-Version": "1.0.3", "Content-Type": "application/json" };
let setting, began, isSending, wasRefused, waiting = [];
// What is stored: the state, and whether the statements that may be sent once have been sent.
let stored = { text: "" };

const refuse = (what) => {
  if (!wasRefused) page("refused", what);
  wasRefused = true;
};
// Kept alive, so that it is sent also while the page is left.
const ask = (path, method, body) =>
  fetch(endpoint.replace(/\/?$/, "/") + path, { method, headers, body: body && JSON.stringify(body), keepalive: true });
const place = (stateId) => `activities/state?${new URLSearchParams({ stateId, activityId, agent: actor, registration })}`;
const read = async (path) => {
  const answer = await ask(path, "GET");
  return answer.ok ? answer.json() : undefined;
};
const send = async (path, method, body) => {
  const answer = await ask(path, method, body).catch((error) => ({ status: error.message }));
  if (!answer.ok) refuse(`${path.split("?")[0]}, ${answer.status}`);
};
// One request at a time: the order counts.
const flush = async () => {
  if (isSending || !waiting.length) return;
  isSending = true;
  await send("statements", "POST", waiting.splice(0));
  isSending = false;
  flush();
};
const duration = () => `PT${Math.round((Date.now() - began) / 1000)}S`;
// A statement. `categories` are those of cmi5, none for statements that it only allows.
const state = (verb, result, categories = [], object = { id: activityId }) => {
  const context = structuredClone(setting.contextTemplate ?? {});
  context.registration = registration;
  for (const name of categories) ((context.contextActivities ??= {}).category ??= []).push({ id: `${own}categories/${name}` });
  if (verb === "passed" && setting.masteryScore) {
    (context.extensions ??= {})[`${own}extensions/masteryscore`] = setting.masteryScore;
  }
  waiting.push({
    id: crypto.randomUUID(),
    timestamp: new Date().toISOString(),
    actor: JSON.parse(actor),
    verb: { id: `http://adlnet.gov/expapi/verbs/${verb}` },
    object: { objectType: "Activity", ...object },
    result,
    context,
  });
};

const platform = {
  host: endpoint && new URL(endpoint).host,
  async start() {
    const { "auth-token": token } = await (await fetch(launch.get("fetch"), { method: "POST" })).json();
    if (!token) throw 0;
    headers.Authorization = `Basic ${token}`;
    began = Date.now();
    setting = (await read(place("LMS.LaunchData"))) ?? {};
    await read(`agents/profile?${new URLSearchParams({ profileId: "cmi5LearnerPreferences", agent: actor })}`);
    stored = (await read(place("meniscus"))) ?? stored;
    state("initialized", undefined, ["cmi5"]);
    flush();
    const { homePage, name } = JSON.parse(actor).account;
    return { learner: `${homePage} ${name}`, state: stored.text, writes: !["Browse", "Review"].includes(setting.launchMode) };
  },
  keep(text) {
    stored.text = text;
  },
  answered(id, type, response, result) {
    const definition = { type: "http://adlnet.gov/expapi/activities/cmi.interaction", interactionType: type };
    if (type === "choice") response = response.replaceAll(",", "[,]");
    state("answered", { response, success: result === "correct" }, [], { id: `${activityId}#${id}`, definition });
  },
  result(score, done) {
    if (!done) return;
    const both = ["cmi5", "moveon"];
    if (!stored.completed) state("completed", { completion: true, duration: duration() }, both);
    stored.completed = true;
    if (stored.passed || !(score >= (setting.masteryScore ?? 1))) return;
    state("passed", { success: true, score: { scaled: +score.toFixed(7) }, duration: duration() }, both);
    stored.passed = true;
  },
  commit() {
    send(place("meniscus"), "PUT", stored);
    flush();
  },
  end(writes) {
    if (writes) send(place("meniscus"), "PUT", stored);
    state("terminated", { duration: duration() }, ["cmi5"]);
    isSending = false;
    flush();
  },
};

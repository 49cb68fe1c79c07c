// Platform of SCORM 1.2 and 2004: an object in a window around or before this one.
const old = kind === "scorm12";
const [object, prefix, core] = old ? ["API", "LMS", "cmi.core."] : ["API_1484_11", "", "cmi."];
let api, count, began, wasRefused;

// The nearest object among the windows around this one, then around the one that opened it.
const find = () => {
  for (const first of [() => window, () => opener, () => top.opener]) {
    let frame = first();
    for (let step = 0; frame && step < 500; step += 1) {
      try {
        if (frame[object]) return frame[object];
      } catch {
        // A window of another site.
      }
      frame = frame === frame.parent ? null : frame.parent;
    }
  }
};
// A function of the platform; undefined if it fails.
const call = (name, ...words) => {
  try {
    return String(api[prefix + name](...words));
  } catch {}
};
const accepted = (what, answer) => {
  if (answer === "true") return true;
  // One message is enough.
  if (!wasRefused) page("refused", `${what}, ${call("GetLastError")}`);
  wasRefused = true;
};
const put = (name, value) => accepted(name, call("SetValue", name, String(value)));
const get = (name) => call("GetValue", name) ?? "";
// One line of at most 250 characters, without what has a meaning in SCORM 2004.
const short = (text) => {
  const line = text.replace(/[\0-\x1f\x7f\u2028\u2029]/g, " ").replace(/^\{/, " {").replace(/\[([,.:])\]/g, "($1)");
  if (line.length > 250) page("cut");
  return line.slice(0, 250).replace(/[\ud800-\udbff]$/, "");
};
const time = () => {
  const [seconds, two] = [Math.round((Date.now() - began) / 1000), (part) => String(Math.floor(part)).padStart(2, 0)];
  const clock = `${two(seconds / 3600).padStart(4, 0)}:${two((seconds / 60) % 60)}:${two(seconds % 60)}`;
  put(core + "session_time", old ? clock : `PT${seconds}S`);
};

const platform = {
  host: "",
  // Waits for five seconds: the object may come after the page.
  async start() {
    for (let tries = 0; !(api = find()) || call("Initialize", "") !== "true"; tries += 1) {
      if (tries === 20) throw 0;
      await new Promise((done) => setTimeout(done, 250));
    }
    began = Date.now();
    count = Number(get("cmi.interactions._count")) || 0;
    const writes = !["browse", "review"].includes(get(core + (old ? "lesson_mode" : "mode")));
    if (writes) {
      const status = core + (old ? "lesson_status" : "completion_status");
      if (!["completed", "passed", "failed"].includes(get(status))) put(status, "incomplete");
      put(core + "exit", "suspend");
    }
    return { learner: get(core + (old ? "student_id" : "learner_id")), state: get("cmi.suspend_data"), writes };
  },
  keep: (state) => put("cmi.suspend_data", state),
  answered(id, type, response, result) {
    const entry = `cmi.interactions.${count}.`;
    if (!put(entry + "id", id)) return;
    count += 1;
    put(entry + "type", type);
    put(entry + (old ? "time" : "timestamp"), new Date().toISOString().slice(...(old ? [11, 19] : [0, 19])));
    // Chosen options are separated by a comma in SCORM 1.2, by `[,]` in SCORM 2004.
    const said = type === "choice" && !old ? response.replaceAll(",", "[,]") : short(response);
    put(entry + (old ? "student_response" : "learner_response"), said);
    put(entry + "result", result === "wrong" && !old ? "incorrect" : result);
  },
  result(score, done) {
    if (score >= 0) {
      put(core + "score.min", 0);
      put(core + "score.max", 100);
      put(core + "score.raw", +(100 * score).toFixed(2));
      if (!old) put(core + "score.scaled", +score.toFixed(7));
    }
    if (done) put(core + (old ? "lesson_status" : "completion_status"), "completed");
  },
  commit() {
    time();
    accepted("Commit", call("Commit", ""));
  },
  // The end stores everything. A commit while the page is left would be refused by the browser.
  end(writes) {
    if (writes) time();
    call(old ? "Finish" : "Terminate", "");
  },
};

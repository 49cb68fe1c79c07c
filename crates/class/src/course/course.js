// Keeps the state of the page with the platform. The page gives a function that answers requests:
//   state, level    the state as a text; each level leaves out more, undefined beyond the last
//   score           mean credit of the questions, from 0 to 1, NaN without questions
//   done            true if every question has been answered or its answer shown
//   restore         takes a stored state and the learner's id
//   left            parts were left out, at this level
//   refused, cut    tells that the platform refused a value, and that an answer was shortened
const MOST = 4096;
let page, isRunning, writes, last, told = 0, turn = 0;

const through = async (stream, bytes) =>
  new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
const packed = async (text) => {
  const bytes = await through(new CompressionStream("deflate-raw"), text);
  return "z" + (bytes.length < MOST ? btoa(String.fromCharCode(...bytes)) : "z".repeat(MOST));
};
const unpacked = async (text) => {
  // This script writes no longer ones. The bound is that of a text which inflates.
  if (text.length > MOST) throw 0;
  if (text[0] !== "z") return text;
  const bytes = Uint8Array.from(atob(text.slice(1)), (letter) => letter.charCodeAt(0));
  return new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes));
};

// Stores the state with as little left out as fits. A short one is stored at once, also while the page is left; true if
// it was stored later.
const keep = async () => {
  const [whole, mine] = [page("state", 0), ++turn];
  if (whole === last) return;
  let waited = false;
  let level = 0;
  for (let text = whole; text !== undefined; text = page("state", ++level)) {
    if (text.length > MOST) {
      text = await packed(text);
      waited = true;
    }
    if (mine !== turn) return;
    if (text.length <= MOST) {
      last = whole;
      platform.keep(text);
      if (level > told) page("left", level);
      told = level;
      return waited;
    }
  }
  last = whole;
  if (level > told) page("refused", `> ${MOST}`);
  told = level;
};
const give = () => {
  const later = keep();
  platform.result(page("score"), page("done"));
  return later;
};
const save = () => {
  if (!isRunning || !writes) return;
  const later = give();
  platform.commit();
  later.then((stored) => stored && isRunning && platform.commit());
};
// `unload` is not fired on phones, and platforms forbid it.
addEventListener("pagehide", () => {
  if (!isRunning) return;
  if (writes) give();
  // What is still being packed comes too late.
  turn += 1;
  isRunning = false;
  platform.end(writes);
});
// A page that comes back from the browser's memory has ended its session.
addEventListener("pageshow", ({ persisted }) => persisted && location.reload());
document.addEventListener("visibilitychange", () => document.hidden && save());
setInterval(() => isRunning && page("state", 0) !== last && save(), 30_000);

globalThis.course = {
  host: platform.host,
  save,
  // Begins the session. False if the platform only shows it; fails if there is no platform.
  async start(given) {
    page = given;
    const stored = await platform.start();
    writes = stored.writes;
    page("restore", await unpacked(stored.state).catch(() => "?"), stored.learner);
    last = page("state", 0);
    isRunning = true;
    save();
    return writes;
  },
  answered: (...answer) => isRunning && writes && platform.answered(...answer),
};

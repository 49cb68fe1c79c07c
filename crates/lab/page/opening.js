// The page begins with the player and its simulation. The laboratory, whose parts stand further on in the page or in files
// of the site, takes the simulation over: when somebody asks for it, or when nothing else happens.
globalThis.opening = {
  // File name of the document with which the page opens.
  name: document.getElementById("bundle")?.dataset.name ?? "",
  // State in the address, for that document.
  state: "",
  // Element to be pressed in the laboratory.
  pressed: "",
  begin() {
    if (!isHome()) {
      opening.offer();
      takeOver();
      return;
    }
    start()
      .then(follow)
      .catch((error) => {
        opening.offer();
        failed(error);
      });
  },
  // Called by the player when it shows the simulation, with the function that hands it over; without one if there is none.
  offer(give) {
    opening.give =
      give &&
      (() => {
        listening.abort();
        return give();
      });
    offered();
  },
  // Until the laboratory may do the next part of its work, or with `isLast` replace what the player shows.
  turn: (isLast) => whenIdle(isLast ? mayReplace : mayWork),
  // The packed bytes of a part.
  bytes: (id) => packed(document.getElementById(id)),
  // A part of the player as text, for pages that the laboratory publishes.
  async part(id) {
    const part = document.getElementById(id);
    const bytes = await packed(part);
    return part.textContent || (bytes.toBase64?.() ?? btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join("")));
  },
  // Starts a worker with the laboratory's module. `heard` gets what it sends; `failed` is called if it cannot be had, or stops.
  worker(heard, failed) {
    const started = Promise.all([compiled, written()]).then(
      ([module, text]) =>
        new Promise((done, refused) => {
          const script = `${text};onmessage=({data})=>{onmessage=null;laboratory({module_or_path:data})}`;
          const worker = new Worker(`data:text/javascript,${encodeURIComponent(script)}`);
          worker.onerror = refused;
          // The first message says that the worker is ready; it is empty.
          worker.onmessage = ({ data }) => {
            worker.onmessage = ({ data }) => heard(data);
            worker.onerror = failed;
            done(worker);
            heard(data);
          };
          worker.postMessage(module);
        }),
    );
    started.catch(failed);
    const then = (use) => started.then(use, () => {});
    return {
      post: (bytes) => then((worker) => worker.postMessage(bytes, [bytes.buffer])),
      end: () => then((worker) => worker.terminate()),
    };
  },
  ask(pressed) {
    opening.pressed = pressed;
    takeOver();
  },
};
// True if the page shall show the document with which it opens. Of other documents only the laboratory knows the text.
const isHome = () => {
  if (!document.getElementById("bundle")) return false;
  const visited = typeof history.state === "string" && history.state.startsWith("meniscus ") ? history.state : "";
  if (visited) return visited.startsWith("meniscus home ");
  const [, subject = "", name = ""] = /^#[^&]*&([dsf])=([^&]*)/.exec(location.hash) ?? [];
  if (subject) return false;
  const state = /[&=]|^#1$/.test(location.hash) ? location.hash.slice(1) : "";
  // Without the name of a document it refers to that of an exported page, and in the laboratory to the published simulation.
  if (state && !document.getElementById("documents")) return false;
  opening.state = state;
  return true;
};
const parsed = new Promise((done) => {
  if (document.readyState === "loading") addEventListener("DOMContentLoaded", done, { once: true });
  else done();
});
// Runs a script of the site.
const run = (src) =>
  new Promise((onload, onerror) => document.head.append(Object.assign(document.createElement("script"), { src, onload, onerror })));
// Text of the script with which the laboratory's module runs, read once.
let scriptText;
const written = () => (scriptText ??= readScript());
const readScript = async () => {
  const glue = document.querySelector("script#laboratory-glue");
  if (glue.dataset.script) return (await fetch(glue.dataset.script)).text();
  return new TextDecoder().decode(await inflated(glue, "deflate-raw"));
};
let compiled;
// Loads the parts of the laboratory, once, and compiles its module beside what goes on.
const load = async () => {
  await parsed;
  const glue = document.querySelector("script#laboratory-glue");
  const part = document.querySelector("script#laboratory");
  if (!glue) broken(new Error("the page is cut off"));
  const begun = async () => {
    if (glue.dataset.script) return run(glue.dataset.script).catch(broken);
    document.head.append(Object.assign(document.createElement("script"), { textContent: await written() }));
  };
  const library = document.querySelector("script#library");
  const [module] = await Promise.all([
    inflated(part, "gzip", () => new Promise((done) => setTimeout(done))).then((bytes) => WebAssembly.compile(bytes)),
    begun(),
    library?.dataset.script && run(library.dataset.script).catch(broken),
  ]);
  return module;
};
// Until the player has offered what it shows.
let offered;
const isOffered = new Promise((done) => (offered = done));
let running;
// Starts the laboratory. It makes its page part by part, beside what the player shows, and then takes that over.
const begin = () => {
  compiled ??= load();
  running ??= compiled.then(async (module) => {
    await Promise.all([firstFrame, isOffered, texts.load(`laboratory-texts-${document.documentElement.lang}`)]);
    await whenIdle(mayWork);
    if (!opening.give) listening.abort();
    return laboratory({ module_or_path: module });
  });
  return running.catch(failed);
};
// True once somebody waits for the laboratory.
let isAwaited = false;
const takeOver = () => {
  isAwaited = true;
  lookAgain();
  return begin();
};
// Until the laboratory is there, what it would take is held.
const listening = new AbortController();
let isPressed = false;
// Time of the last key or press, in milliseconds.
let touched = -Infinity;
const on = (events, react) => events.forEach((event) => addEventListener(event, react, { signal: listening.signal, capture: true }));
on(["pointerdown", "keydown"], () => (isPressed = true));
on(["pointerdown", "pointerup", "keydown", "wheel"], () => (touched = performance.now()));
on(["pointerup", "pointercancel", "keyup"], () => (isPressed = false));
// Of the window: a press takes the focus from an element, too.
on(["blur"], ({ target }) => target === globalThis && (isPressed = false));
on(["dragenter", "dragover", "drop"], (event) => {
  if (!event.dataTransfer?.types.includes("Files")) return;
  event.preventDefault();
  takeOver();
});
on(["hashchange", "popstate"], takeOver);
// True if nobody is about to do anything that another page would interrupt.
const isAtRest = () =>
  !document.activeElement?.closest("#panel, #messages, dialog") &&
  !document.querySelector("dialog[open], .message.passing, .stage [aria-expanded=true], .tip:not(:empty)");
// Nothing is done while something is pressed: a button that is replaced then hears no click. A run that plays is disturbed only if
// nobody has touched anything for ten seconds.
const mayWork = () => !isPressed && (isAwaited || !document.querySelector("#play.playing") || performance.now() - touched > 10_000);
const mayReplace = () => mayWork() && (isAwaited || isAtRest());
// A page that is never idle, as where each frame takes all of its time, waits two seconds at most.
const idle = (then) => (globalThis.requestIdleCallback ? requestIdleCallback(then, { timeout: 2000 }) : setTimeout(then, 200));
let lookAgain = () => {};
// Until `may` holds while the page is idle, or, once somebody waits for the laboratory, in any task.
const whenIdle = (may) =>
  new Promise((done) => {
    const look = () => (may() ? done() : setTimeout(lookAgain, 50));
    lookAgain = () => (isAwaited ? setTimeout(look) : idle(look));
    lookAgain();
  });
// Loads the laboratory when the page is idle, and begins it.
const follow = () => idle(() => begin());

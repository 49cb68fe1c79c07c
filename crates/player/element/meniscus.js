// The element <meniscus-simulation>: a simulation in any page. Each is a frame with a style and keys of its own; all of a page
// play with one compiled module. `crates/player/src/surrounding.rs` has the other side of the messages.

const PARTS = ["head", "scene", "plots", "parameters", "values", "activities", "text"];
const at = (file) => new URL(file, import.meta.url).href;

// Loads once for all elements of the page.
const once = (load) => {
  let loaded;
  return () => (loaded ??= load());
};
const fetched = async (address) => {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
  return response;
};
const inflated = (bytes) => new Response(new Response(bytes).body.pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
const playerModule = once(async () => WebAssembly.compile(await inflated((await fetched(at("player.bin"))).body)));

// Compiles texts, one after the other, with the module of the laboratory in a worker: nothing of it is loaded before.
const compiler = once(
  () =>
    new Promise((done, refused) => {
      const worker = new Worker(at("compiler.js"));
      worker.onerror = () => refused(new Error("compiler.js cannot be loaded"));
      // Its first message says that it is ready.
      worker.onmessage = () => done(worker);
    }),
);
let last = Promise.resolve();
const compiled = (text) => {
  const answer = async () => {
    const worker = await compiler();
    return new Promise((done) => {
      worker.onmessage = ({ data }) => done(data);
      worker.postMessage(text);
    });
  };
  return (last = last.then(answer, answer));
};

// The compiled simulation at an address: a page that plays one, a bundle, or the text of a document.
const simulation = async (address) => {
  const bytes = new Uint8Array(await (await fetched(address)).arrayBuffer());
  if (bytes[0] === 0x1f) return { bundle: await inflated(bytes) };
  const text = new TextDecoder().decode(bytes);
  const [, inside] = /id="bundle"[^>]*>([^<]+)</.exec(text) ?? [];
  return inside ? { bundle: await inflated(Uint8Array.from(atob(inside), (letter) => letter.charCodeAt(0))) } : compiled(text);
};

const asText = (values) => JSON.stringify(Object.entries(values).sort());
const escaped = (text) => text.replace(/[&"<]/g, (letter) => `&#${letter.charCodeAt(0)};`);
// The page in a frame, without its simulation (`frame.html`).
const PLAYER = "<!--player-->";
// Height until the simulation has told its own.
const HEIGHT = "420px";
const LOST = ["This simulation cannot be shown", "No se puede mostrar esta simulación", "Não é possível mostrar esta simulação"];

// Starts an element when it comes near, and holds it while it is out of sight.
const sight = once(
  () =>
    new IntersectionObserver((entries) => entries.forEach(({ target, isIntersecting }) => target.seen(isIntersecting)), { rootMargin: "200px" }),
);

export class MeniscusSimulation extends HTMLElement {
  static observedAttributes = ["src", "inline", "parameters", "show", "lock", "language"];
  #frame;
  #text;
  #wanted = {};
  #values = {};
  #isReady = false;
  #isSeen = false;
  #asking;
  #begun = 0;

  constructor() {
    super();
    this.attachShadow({ mode: "open" }).innerHTML = "<slot></slot>";
  }

  connectedCallback() {
    this.style.display ||= "block";
    this.#reserve(HEIGHT);
    sight().observe(this);
    addEventListener("message", this.#hear);
  }

  disconnectedCallback() {
    sight().unobserve(this);
    removeEventListener("message", this.#hear);
    this.#end();
  }

  attributeChangedCallback(name, before, now) {
    if (name === "parameters") this.parameters = Object.fromEntries([...(now ?? "").matchAll(/([^\s=,;]+)\s*=\s*([^,;]*)/g)].map(([, name, value]) => [name, value.trim() && !isNaN(value) ? +value : value.trim()]));
    else if (before !== now) this.#renew();
  }

  /** Values of all parameters, once the simulation is ready. What is set is a change of those that it names. */
  get parameters() {
    return { ...(this.#isReady ? this.#values : this.#wanted) };
  }

  set parameters(values) {
    this.#wanted = { ...this.#wanted, ...values };
    if (this.#isReady && asText({ ...this.#values, ...values }) !== asText(this.#values)) this.#tell(values);
  }

  /** Text of the document, in place of an address. */
  get text() {
    return this.#text ?? "";
  }

  set text(text) {
    this.#text = text;
    this.#renew();
  }

  // Called by the observer of what is in sight.
  seen(isSeen) {
    this.#isSeen = isSeen;
    if (isSeen && !this.#begun) this.#begin();
    this.#frame?.hold?.(!isSeen);
  }

  // Room for a simulation that is not there yet, so that those behind it are out of sight.
  #reserve(height) {
    this.style.minHeight = height;
  }

  #renew() {
    if (this.#begun) this.#begin();
  }

  #end() {
    clearInterval(this.#asking);
    this.#frame?.remove();
    this.#frame = undefined;
    this.#isReady = false;
    this.#begun = 0;
    this.shadowRoot.replaceChildren(document.createElement("slot"));
  }

  async #begin() {
    const begun = (this.#begun = Math.random());
    try {
      const text = this.#text ?? (this.hasAttribute("inline") ? (this.querySelector("script") ?? this).textContent : undefined);
      const src = this.getAttribute("src");
      if (text === undefined && !src) return;
      const { bundle, findings } = await (text === undefined ? simulation(new URL(src, document.baseURI)) : compiled(text));
      if (begun !== this.#begun) return;
      if (findings) this.#say("findings", findings);
      // The last simulation that could be compiled stays.
      if (bundle) this.#play(bundle);
      else if (!this.#frame) throw new Error(findings.map(({ line, message }) => `${line}: ${message}`).join("\n"));
    } catch (error) {
      if (begun === this.#begun) this.#fail(error);
    }
  }

  #play(bundle) {
    const frame = document.createElement("iframe");
    const shown = this.getAttribute("show")?.split(/[\s,]+/) ?? PARTS.slice(1);
    const language = this.getAttribute("language");
    const options = `?height=content&hide=${PARTS.filter((part) => !shown.includes(part))}${this.hasAttribute("lock") ? "&lock" : ""}${language ? `&language=${language}` : ""}`;
    frame.title = this.title || "Meniscus";
    frame.style.cssText = `width:100%;height:${HEIGHT};border:0;display:block`;
    frame.given = Promise.all([playerModule(), bundle]);
    frame.given.catch((error) => this.#fail(error));
    frame.srcdoc = PLAYER.replace("<html", `<html data-options="${escaped(options)}"`).replaceAll("@/", at("./"));
    this.#frame?.remove();
    this.#frame = frame;
    this.#isReady = false;
    this.#values = {};
    this.shadowRoot.replaceChildren(frame);
    // The player is there some time after its frame: it is asked until it answers.
    clearInterval(this.#asking);
    this.#asking = setInterval(() => this.#tell(this.#wanted), 50);
  }

  #tell(parameters) {
    this.#frame?.contentWindow?.postMessage({ meniscus: { parameters } }, "*");
  }

  #hear = ({ source, data }) => {
    const said = data?.meniscus;
    if (!said || !this.#frame || source !== this.#frame.contentWindow) return;
    if (said.height) {
      this.#frame.style.height = `${said.height}px`;
      this.#reserve("");
    }
    if (said.run) this.#say("run", said.run);
    if (said.answer) this.#say("answer", said.answer);
    if (!said.parameters) return;
    const isNew = asText(said.parameters) !== asText(this.#values);
    this.#values = said.parameters;
    if (!this.#isReady) {
      clearInterval(this.#asking);
      this.#isReady = true;
      // What was set while the first message was on its way.
      this.parameters = this.#wanted;
      this.#frame.hold?.(!this.#isSeen);
      this.#say("ready", said.parameters);
    } else if (isNew) this.#say("parameters", said.parameters);
  };

  #say(type, detail) {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  // Words in the place of the simulation.
  #fail(error) {
    clearInterval(this.#asking);
    this.#reserve("");
    this.#frame = undefined;
    this.#isReady = false;
    const words = document.createElement("p");
    words.setAttribute("role", "alert");
    words.style.whiteSpace = "pre-wrap";
    words.textContent = `${LOST.join(" · ")}: ${this.getAttribute("src") ?? ""}\n${error.message}`;
    this.shadowRoot.replaceChildren(document.createElement("slot"), words);
  }
}

if (!customElements.get("meniscus-simulation")) customElements.define("meniscus-simulation", MeniscusSimulation);

// Storage of a student's browser for a class server: values by key, and the outbox with the parts of hand-ins that the server does not
// have yet. Several tabs share it without a lock, so each part that waits has a key of its own and is never changed: it is added, and
// removed once the server has it. Without storage everything lives as long as the page.
const classStorage = (server) => {
  "use strict";
  const PREFIX = `meniscus-class:${server}:`;
  const memory = new Map();
  let stores = true;

  const load = (key, otherwise) => {
    try {
      const text = localStorage.getItem(PREFIX + key);
      if (text !== null) return JSON.parse(text);
    } catch { stores = false; }
    return memory.has(key) ? memory.get(key) : otherwise;
  };
  const drop = (key) => {
    memory.delete(key);
    try { localStorage.removeItem(PREFIX + key); } catch { /* Nothing is stored. */ }
  };
  const keep = (key, value) => {
    try { localStorage.setItem(PREFIX + key, JSON.stringify(value)); memory.delete(key); stores = true; }
    catch {
      // A text that is outdated must not win over the one in memory.
      drop(key);
      memory.set(key, value);
      stores = false;
    }
  };
  /** The keys that begin so, in no order. */
  const keys = (start) => {
    const found = new Set([...memory.keys()].filter((key) => key.startsWith(start)));
    try {
      for (const key of Object.keys(localStorage)) if (key.startsWith(PREFIX + start)) found.add(key.slice(PREFIX.length));
    } catch { stores = false; }
    return [...found];
  };
  const dropAll = (start) => keys(start).forEach(drop);

  /** The parts that wait, in the order of their numbers: `{ key, seq, document, part, value }`. */
  const waiting = () => keys("waiting:").map((key) => ({ key, ...load(key, {}) })).filter(({ seq }) => seq)
    .sort((one, other) => one.seq - other.seq || (one.key < other.key ? -1 : 1));
  const add = ({ seq, document, part, value }) => {
    keep("seq", seq);
    const random = [...crypto.getRandomValues(new Uint32Array(2))].map((number) => number.toString(36)).join("");
    keep(`waiting:${random}`, { seq, document, part, value });
  };

  // Choices for the whole page, and what belongs to a teacher: all else that pages of this address have stored is work of a person.
  const CHOICES = ["language", "theme", "keys", "guide", "dragged", "everything", "class-names"].map((name) => `meniscus:${name}`);
  /** Removes the work of a person and all that belongs to the seat. */
  const clear = () => {
    dropAll("");
    try {
      for (const key of Object.keys(localStorage)) if (key.startsWith("meniscus:") && !CHOICES.includes(key)) localStorage.removeItem(key);
    } catch { /* Nothing is stored. */ }
  };

  const hash = (text) => {
    let [a, b] = [0x9e3779b9, 0x85ebca6b];
    for (let at = 0; at < text.length; at++) {
      const code = text.charCodeAt(at);
      a = Math.imul(a ^ code, 2654435761); b = Math.imul(b ^ code, 1597334677);
    }
    return `${(a >>> 0).toString(36)}.${(b >>> 0).toString(36)}.${text.length}`;
  };

  return {
    load, keep, drop, keys, dropAll, waiting, clear,
    stores: () => stores,
    /** Calls `react` when another tab removes the value of a key. */
    whenDropped: (key, react) => addEventListener("storage", (event) => { if (event.key === PREFIX + key && event.newValue === null) react(); }),
    /** True if parts of `document` were added. */
    knows: (document) => keys(`known:${document}\n`).length > 0,
    /** All parts of `document` count as changed. */
    forget: (document) => dropAll(`known:${document}\n`),
    /** Adds the parts of `document` that have changed since they were last added. `parts`: pairs of a name and a text, the head last: its time
        alone is no change. Parts that are replaced by later forms are removed. False if nothing has changed. */
    put(document, parts) {
      const before = waiting();
      let seq = before.reduce((most, { seq }) => Math.max(most, seq), load("seq", 0));
      let changed = false;
      for (const [part, value] of parts) {
        const key = `known:${document}\n${part}`;
        const [stamp, known] = [hash(value), load(key, null)];
        if (known === stamp || (part === "head" && !changed && known !== null)) continue;
        changed = true;
        seq += 1;
        add({ seq, document, part, value });
        keep(key, stamp);
        before.filter((one) => one.document === document && one.part === part).forEach(({ key }) => drop(key));
      }
      return changed;
    },
    /** Number of parts and of answers to surveys that the server does not have. */
    rest: () => keys("waiting:").length + keys("sheet:").filter((key) => !load(key, {}).sent).length,
    /** Answers to surveys that wait go to their own class; those that another class than that of `token` has are no answers to its surveys. */
    changeClass(token) {
      for (const key of keys("sheet:")) {
        const sheet = load(key, {});
        if (!sheet.token || sheet.token === token) continue;
        drop(key);
        if (!sheet.sent) keep(`sheet:${sheet.id}`, sheet);
      }
    },
    /** The server has these parts. `seq`: the highest number that it knows of the seat. */
    acknowledge(parts, seq) {
      keep("seq", Math.max(load("seq", 0), seq));
      parts.forEach(({ key }) => drop(key));
    },
    /** Gives all that wait numbers above `seq`, since another device of the seat has used theirs. */
    renumber(seq) {
      let next = Math.max(load("seq", 0), seq);
      for (const one of waiting()) {
        next += 1;
        add({ ...one, seq: next });
        drop(one.key);
      }
    },
  };
};

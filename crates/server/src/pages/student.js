// Class page of a student: joins, keeps each part of a hand-in in the browser until the server has it on disk, and follows the class.
(() => {
  "use strict";
  const { config, words, make, button, bar } = classBar;
  const server = config.server || location.origin;

  const storage = classStorage(server);
  const { load, keep } = storage;

  // The file for a class has the seat of the student who has saved it.
  let seat = load("seat", config.own);
  let state = null;
  let problem = "";
  let offset = 0;

  // The code of a QR code is in the fragment, which a simulation would take for a state of its own.
  const scanned = (location.hash.match(/^#join=([A-Za-z0-9]+)$/) || [])[1];
  if (scanned) history.replaceState(null, "", location.pathname + location.search);
  // Values of a seat are set before the simulation begins, also where a link sets others.
  const link = location.hash;
  if (seat && config.seats && (link === "" || link.startsWith("#1&")) && !link.includes("&seat=")) {
    history.replaceState(null, "", `${link || "#1"}&seat=${seat.seat}`);
  }

  // A connection may be dead without an end: a request has a time, and is tried again.
  const LIMIT = 120000;
  const ask = async (path, { body, token, signal = AbortSignal.timeout(LIMIT) } = {}) => {
    const headers = {};
    if (token) headers.authorization = `Bearer ${token}`;
    if (body !== undefined) headers["content-type"] = "application/json";
    const options = { method: body === undefined ? "GET" : "POST", body, headers, signal, cache: "no-store", credentials: "omit" };
    return fetch(server + path, options);
  };
  const why = async (response) => { try { return (await response.json()).why || ""; } catch { return ""; } };

  // What the server has of this seat, perhaps from another device, goes to the page before this device hands anything in: attempts are
  // merged there. Asked for after joining, and when another device has used the numbers of this one.
  const LEARNED = `learned:${config.document}`;
  const learns = () => Boolean(seat && config.document) && load(LEARNED, false) !== seat.seat;
  const learn = async () => {
    if (!globalThis.classPage) return false;
    const response = await ask(`/api/hand-in/${encodeURIComponent(config.document)}`, { token: seat.token });
    if (response.ok) globalThis.classPage.merge(await response.text());
    else if (response.status !== 404) return false;
    storage.forget(config.document);
    keep(LEARNED, seat.seat);
    rested = 0;
    byItself();
    return true;
  };

  // Less is sent at once where a request was too large, or took too long. What is too large by itself waits, and the rest goes.
  const LARGEST = 6 << 20, SMALLEST = 1 << 14, MOST = 5000;
  let limit = LARGEST;
  const tooLarge = new Set();
  // Reasons of a refusal for which there is a sentence.
  const REASONS = ["closed", "approval", "store", "slow", "large", "seat_full", "class_full"];
  const FIRST = 1000, LONGEST = 30000;
  let sending = false, pause = FIRST, timer = 0;
  const later = () => {
    clearTimeout(timer);
    timer = setTimeout(send, pause * (0.75 + Math.random() / 2));
    pause = Math.min(2 * pause, LONGEST);
  };
  const send = async () => {
    clearTimeout(timer);
    if (sending || !seat) return;
    if (learns()) {
      sending = true;
      let learned = false;
      try { learned = await learn(); } catch { /* It is tried again. */ }
      sending = false;
      // The page makes its hand-in with what it has learned.
      if (learned) timer = setTimeout(send, FIRST); else later();
      return;
    }
    const waiting = storage.waiting().filter(({ key }) => !tooLarge.has(key));
    if (!waiting.length) return problem === "unreachable" || problem === "store" ? again() : undefined;
    sending = true;
    let size = waiting[0].value.length;
    const batch = waiting.filter((one, at) => at === 0 || ((size += one.value.length) < limit && at < MOST));
    const body = `{"events":[${batch.map((one) => `{"seq":${one.seq},"document":${JSON.stringify(one.document)},` +
      `"part":${JSON.stringify(one.part)},"value":${one.value}}`).join(",")}]}`;
    try {
      const response = await ask("/api/events", { body, token: seat.token });
      if (response.ok) {
        const { highest } = await response.json();
        storage.acknowledge(batch, highest);
        // Another device of this seat has handed in under a greater number, and its parts count: both are merged.
        if (batch.every(({ seq }) => seq < highest)) storage.drop(LEARNED);
        [problem, pause, limit] = [storage.keys("waiting:").some((key) => tooLarge.has(key)) ? "large" : "", FIRST, Math.min(2 * limit, LARGEST)];
        if (learns() || storage.keys("waiting:").length) timer = setTimeout(send, 0);
      } else if (response.status === 409) {
        // Another device of this seat has used the numbers: what it has handed in is merged first.
        storage.renumber((await response.json()).highest);
        storage.drop(LEARNED);
        timer = setTimeout(send, 0);
      } else if (response.status === 401) {
        if (seat) leave(words().token);
      } else {
        const reason = await why(response);
        if (["slow", "large"].includes(reason)) limit = Math.max(limit / 2, SMALLEST);
        if (reason === "large" && batch.length === 1) tooLarge.add(batch[0].key);
        problem = REASONS.includes(reason) ? reason : response.status < 500 && response.status !== 429 ? "refused" : "unreachable";
        later();
      }
    } catch {
      problem = "unreachable";
      later();
    }
    sending = false;
    show();
  };
  // Nothing waits any more, since another tab of the seat has handed it in: asks for the state, and so whether the class is reached.
  const again = async () => {
    sending = true;
    try {
      const response = await ask("/api/state", { token: seat.token });
      sending = false;
      if (response.ok) take(await response.text()); else later();
    } catch {
      sending = false;
      later();
    }
  };
  // The page that can be asked for work may come long after this script.
  for (const kind of ["online", "class-ready"]) addEventListener(kind, () => { pause = FIRST; send(); });

  // A page hands in by itself when something was done, and every half minute. Then it rests ten times as long as it has computed.
  // Where nothing has been answered or measured there is nothing to hand in, unless there was before.
  const holdsWork = (parts) => parts.some(([name]) => name.startsWith("item:"));
  let making = false, isWanted = false, rested = 0;
  const byItself = async () => {
    if (!seat || !globalThis.classPage || Date.now() < rested) return;
    isWanted = making;
    if (making) return;
    const began = Date.now();
    making = true;
    try {
      const parts = await globalThis.classPage.handIn(seat.pseudonym);
      if (parts && seat && (holdsWork(parts) || storage.knows(config.document)) && storage.put(config.document, parts)) send();
    } catch { problem = "refused"; }
    making = false;
    rested = isWanted ? 0 : Date.now() + 10 * (Date.now() - began);
    show();
    if (isWanted) byItself();
  };
  let soon = 0;
  for (const kind of ["click", "change", "keyup"]) {
    addEventListener(kind, (event) => {
      if (!event.isTrusted || event.target.closest?.("#class-bar")) return;
      clearTimeout(soon);
      soon = setTimeout(byItself, 1500);
    }, { capture: true, passive: true });
  }
  setInterval(byItself, 30000);
  addEventListener("visibilitychange", () => { if (document.hidden) byItself(); else { pause = FIRST; send(); follow(); } });

  // The page gives answers to a survey. They go at a random time within ten minutes, without the seat.
  globalThis.classSurvey = (text) => {
    if (!seat) return;
    const key = `sheet:${config.document}`;
    if (load(key, null)?.sent) return;
    // The server knows by the number that it has the answers already, when they are sent again because its reply was lost.
    const id = crypto.getRandomValues(new Uint32Array(4)).join("-");
    keep(key, { text, id, token: seat.survey, due: Date.now() + 60000 + Math.random() * 540000 });
    said = words().sheet;
    show();
  };
  const sendSheets = async () => {
    for (const key of storage.keys("sheet:")) {
      const one = load(key, { sent: true });
      if (!seat || one.sent || one.due > Date.now()) continue;
      const token = one.token || seat.survey;
      try {
        const response = await ask("/api/survey", { body: `{"id":${JSON.stringify(one.id)},"sheet":${one.text}}`, token });
        if (response.ok) keep(key, { sent: true, token });
      } catch { /* It is tried again. */ }
    }
  };
  setInterval(sendSheets, 15000);

  // State of the class: as a stream, or by asking where a proxy keeps streams back.
  let following = null;
  const ASK = 4000;
  const take = (text) => {
    state = JSON.parse(text);
    offset = state.now - Date.now();
    const isOver = problem === "unreachable" || (problem === "store" && !storage.keys("waiting:").length) || (["closed", "approval"].includes(problem) && state.accepts && state.approved);
    if (isOver) { problem = ""; pause = FIRST; send(); }
    show();
  };
  const follow = async () => {
    if (!seat || following) return;
    const control = following = new AbortController();
    const alive = () => following === control && seat;
    const wait = (time) => new Promise((done) => setTimeout(done, time));
    while (alive()) {
      const open = (signal) => ask("/api/stream", { token: seat.token, signal });
      const { status } = await readStream(open, take, alive);
      // Erased or left here, meanwhile: that has been said.
      if (!alive()) return;
      if (status === 401) return leave(words().token);
      try {
        const response = await ask("/api/state", { token: seat.token });
        if (response.status === 401) return alive() && leave(words().token);
        if (response.ok) take(await response.text());
      } catch { problem = "unreachable"; show(); }
      await wait(ASK * (0.75 + Math.random() / 2));
    }
  };

  const join = async (code) => {
    try {
      const response = await ask("/api/join", { body: JSON.stringify({ code }) });
      if (!response.ok) {
        const reason = await why(response);
        said = ["closed", "full", "many"].includes(reason) ? words()[reason] : response.status === 429 ? words().code_wait : reason === "code" ? words().code_wrong : words().unreachable;
        return show();
      }
      const isOther = Boolean(state?.earlier);
      seat = await response.json();
      [state, following, problem, said] = [null, null, "", ""];
      keep("seat", seat);
      // All of the work here is handed in from the new seat, too.
      storage.dropAll("known:");
      storage.dropAll("learned:");
      // Another class may have other documents: its pages make their parts themselves.
      if (isOther) storage.dropAll("waiting:");
      storage.changeClass(seat.survey);
      try { localStorage.setItem("meniscus:hand-in-name", seat.pseudonym); } catch { /* The form asks for a name. */ }
      if (storage.stores()) { history.replaceState(null, "", location.pathname + location.search); location.reload(); return; }
      start();
    } catch {
      said = words().unreachable;
      show();
    }
  };
  const leave = (sentence) => {
    [seat, state, following, problem, said] = [null, null, null, "", sentence];
    keep("seat", null);
    storage.dropAll("known:");
    storage.dropAll("learned:");
    show();
  };

  // *Leave this computer*: hands in what waits, then removes seat, work and key from the browser, also for the other tabs of this address.
  const PATIENCE = 20000, LOOK = 250;
  const settle = async () => {
    const until = Date.now() + PATIENCE;
    const wait = () => new Promise((done) => setTimeout(done, LOOK));
    while (making && Date.now() < until) await wait();
    rested = 0;
    await byItself();
    for (const key of storage.keys("sheet:")) if (!load(key, {}).sent) keep(key, { ...load(key, {}), due: 0 });
    await sendSheets();
    while (storage.rest() > 0 && seat && Date.now() < until) {
      pause = FIRST;
      send();
      await wait();
    }
  };
  const leaveComputer = async () => {
    if (!confirm(words().leave_sure)) return;
    said = words().leaving;
    show();
    try { await settle(); } catch { /* What is left is counted below. */ }
    said = "";
    show();
    if (storage.rest() > 0 && !confirm(words().leave_lost.replace("#", storage.rest()))) return;
    gone();
  };
  const gone = () => {
    [seat, following] = [null, null];
    globalThis.classPage?.leave();
    storage.clear();
    // The file for a class has the seat in itself.
    if (config.own) keep("seat", null);
    // Not a reload, after which browsers fill fields in again.
    history.replaceState(null, "", location.pathname + location.search);
    location.replace(location.href);
  };
  storage.whenDropped("seat", () => { if (seat) gone(); });
  // A page that comes back from the browser's memory may be one that was left.
  addEventListener("pageshow", ({ persisted }) => { if (persisted && seat && load("seat", config.own)?.token !== seat.token) gone(); });

  const save = async (path, name, change = (text) => text) => {
    let response;
    try { response = await ask(path, { token: seat.token }); } catch { /* Said below. */ }
    if (!response?.ok) { said = words().unreachable; return show(); }
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([change(await response.text())], { type: response.headers.get("content-type") }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  };

  let said = "";
  const stored = () => make("a", { href: `${server}/stored`, target: "_blank", rel: "noreferrer", textContent: words().stored });
  const line = () => {
    const own = words();
    const count = storage.keys("waiting:").length;
    const waits = count === 0 ? "" : count === 1 ? own.waits_one : own.waits.replace("#", count);
    const closes = state?.settings.closes;
    const accepts = !state || (state.accepts && (!closes || Date.now() + offset < closes));
    const reason = state?.earlier ? own.earlier : state && !state.approved ? own.approval : !accepts ? own.closed : problem ? own[problem] : "";
    const whole = storage.keys("known:").length ? own.all_in : own.nothing;
    return [waits || (reason ? "" : whole), reason, storage.stores() ? "" : own.keep_open].filter(Boolean).join(" ");
  };
  const status = classBar.status("class-status");
  let built = "";
  const show = () => {
    const own = words();
    const settings = state?.settings || {};
    const form = JSON.stringify([seat && seat.seat, document.documentElement.lang, settings.pace, settings.results || settings.others, state?.earlier]);
    if (form !== built) { built = form; build(own, settings); }
    const left = settings.closes ? Math.ceil((settings.closes - Date.now() - offset) / 60000) : 0;
    const text = seat ? [line(), left > 0 ? own.closes.replace("#", left) : "", said].filter(Boolean).join(" ") : said;
    if (status.textContent !== text) status.textContent = text;
    cover(Boolean(settings.paused), own);
  };
  const cover = (covered, own) => {
    const before = document.getElementById("class-pause");
    if (!covered) return before?.remove();
    // A dialog, above any other that is open.
    const dialog = before || make("dialog", { id: "class-pause", textContent: own.paused, oncancel: (event) => event.preventDefault() });
    if (!before) document.body.append(dialog);
    if (!dialog.open) dialog.showModal();
  };
  const build = (own, settings) => {
    bar.setAttribute("aria-label", own.region);
    const joining = (typed) => {
      const code = make("input", { className: "code", id: "class-code", maxLength: 16, autocomplete: "off", spellcheck: false, required: true, value: typed });
      return make("form", { onsubmit: (event) => { event.preventDefault(); join(code.value); } },
        make("label", {}, own.code, code), make("button", { textContent: own.join }));
    };
    if (!seat) {
      bar.classList.remove("seated");
      return bar.replaceChildren(joining(config.code || scanned || ""), stored(), status, make("p", { className: "note", textContent: own.joining }));
    }
    bar.classList.add("seated");
    const parts = [make("strong", { textContent: seat.pseudonym }), status];
    if (state?.earlier) parts.push(joining(scanned || ""));
    if (settings.pace && settings.pace !== config.document) {
      parts.push(make("a", { href: `${server}/d/${encodeURIComponent(settings.pace)}`, textContent: `${own.pace} ${settings.pace}` }));
    }
    if (settings.results || settings.others) {
      const list = make("ul");
      const fill = async () => {
        const response = await ask("/api/others", { token: seat.token });
        const { questions } = response.ok ? await response.json() : { questions: [] };
        list.replaceChildren(...questions.map((one, at) => make("li", {},
          `${own.question} ${at + 1}. `, one.results ? `${own.right.replace("#", one.results.right).replace("$", one.results.answered)}. ` : "", one.others.join(" · "))));
      };
      const details = fold("class-others", own.others, list);
      details.addEventListener("toggle", () => { if (details.open) fill().catch(() => {}); });
      parts.push(details);
    }
    const mine = make("div", {});
    if (config.document && !config.server) {
      const withSeat = (text) => text.replace('"own":null', () => `"own":${JSON.stringify(seat)}`);
      mine.append(button(own.file, () => save(`/api/file/${encodeURIComponent(config.document)}`, `${config.document.split(".")[0]}-class.html`, withSeat)),
        make("p", { className: "note", textContent: own.file_why }));
    }
    if (seat.key) mine.append(make("span", {}, `${own.key}: `, make("span", { className: "key", textContent: seat.key })));
    mine.append(button(own.download, () => save("/api/mine", "my-class.json")), button(own.erase, async () => {
      if (!confirm(own.erase_sure)) return;
      try { if ((await ask("/api/erase", { body: "{}", token: seat.token })).ok) { storage.dropAll("waiting:"); storage.dropAll("sheet:"); leave(own.erased); } }
      catch { said = own.unreachable; show(); }
    }), button(own.leave, leaveComputer), stored());
    parts.push(fold("class-mine", own.more, mine));
    bar.replaceChildren(...parts);
  };
  // A part that lies over the page while it is open. One is open at a time; Escape closes it.
  const fold = (id, title, content) => make("details", { id, name: "class-fold", onkeydown: (event) => {
    if (event.key === "Escape" && event.currentTarget.open) { event.stopPropagation(); event.currentTarget.open = false; event.currentTarget.firstChild.focus(); }
  } }, make("summary", { textContent: title }), content);

  const start = () => { show(); if (seat) { send(); follow(); setTimeout(byItself, 4000); } };
  const begin = () => {
    classBar.begin(show);
    // The line of a seat stays in sight; the page keeps its height free.
    const { style } = document.documentElement;
    new ResizeObserver(() => style.setProperty("--over", bar.classList.contains("seated") ? `${bar.offsetHeight}px` : "0px")).observe(bar);
    addEventListener("pointerdown", (event) => {
      for (const open of bar.querySelectorAll("details[open]")) if (!open.contains(event.target)) open.open = false;
    });
    setInterval(show, 10000);
    start();
  };
  if (document.readyState === "loading") addEventListener("DOMContentLoaded", begin); else begin();
})();

// Class page of the teacher: exchanges the one-time link, sets the class, and passes hand-ins to the dashboard as they arrive.
(() => {
  "use strict";
  const { words, make, button, bar } = classBar;
  const KEY = "meniscus-class-teacher";
  const load = () => { try { return localStorage.getItem(KEY); } catch { return null; } };
  const keep = (token) => { try { localStorage.setItem(KEY, token); } catch { /* The token lives as long as the page. */ } };
  let token = load(), about = null, settings = null, seats = [], said = "", room = "";

  // A connection may be dead without an end, as after the computer has slept: a request has a time, and is tried again.
  const LIMIT = 30000;
  const ask = (path, { body, signal = AbortSignal.timeout(LIMIT) } = {}) => fetch(path, {
    method: body === undefined ? "GET" : "POST", body, signal, cache: "no-store", credentials: "omit",
    headers: { authorization: `Bearer ${token}`, ...(body === undefined ? {} : { "content-type": "application/json" }) },
  });

  // The link is in the fragment, which the browser sends to nobody. It is taken off before the simulation reads the fragment.
  const link = (location.hash.match(/^#link=([\w-]+)$/) || [])[1];
  if (link) history.replaceState(null, "", location.pathname);

  // Hand-ins go to the dashboard one after the other. It announces itself when it has been loaded.
  const changed = new Map();
  let passing = false;
  const isReady = () => document.documentElement.dataset.class === "ready";
  const pass = async () => {
    if (passing || !isReady()) return;
    passing = true;
    for (const [key, [seat, name]] of changed) {
      changed.delete(key);
      const owner = seats.find((one) => one.seat === seat);
      if (!owner) continue;
      try {
        const response = await ask("/api/teacher/hand-in", { body: JSON.stringify({ seat, document: name }) });
        if (!response.ok) continue;
        const file = new File([await response.blob()], about.documents.length > 1 ? `${owner.pseudonym} (${name}).hand-in` : `${owner.pseudonym}.hand-in`);
        dispatchEvent(new CustomEvent("class-hand-in", { detail: file }));
      } catch {
        changed.set(key, [seat, name]);
        break;
      }
    }
    passing = false;
  };
  const ready = () => {
    // The page announces itself before its dialogs exist.
    if (!document.getElementById("class")) return void setTimeout(ready, 100);
    dispatchEvent(new CustomEvent("class-documents", { detail: JSON.stringify(about.sources) }));
    dispatchEvent(new Event("class-open"));
    pass();
  };
  addEventListener("class-ready", () => { if (token && about) ready(); });
  setInterval(pass, 1000);

  const handed = new Set();
  let since = 0;
  const take = (news) => {
    since = news.last;
    skew = news.now - Date.now();
    if (!setting) settings = news.settings;
    seats = news.seats;
    for (const event of news.events) {
      if (event.kind !== "part") continue;
      handed.add(event.seat);
      changed.set(`${event.seat}\n${event.document}`, [event.seat, event.document]);
    }
    const share = Math.floor(100 * news.room.used / news.room.most);
    room = news.room.full ? words().room_full.replace("#", Math.round(news.room.most / 1048576)) : share >= 90 ? words().room_near.replace("#", share) : "";
    said = words().live;
    show();
    pass();
  };
  const follow = async () => {
    for (;;) {
      const open = (signal) => ask(`/api/teacher/stream?since=${since}`, { signal });
      const { heard, status } = await readStream(open, (data) => take(JSON.parse(data)));
      if (status === 401) { token = null; said = words().link; return show(); }
      try {
        // At once; where a proxy keeps streams back, several times more, each until something happens.
        for (const wait of heard ? [0] : [0, 20, 20, 20]) {
          const response = await ask(`/api/teacher/events?since=${since}&wait=${wait}`);
          if (response.ok) take(await response.json());
        }
      } catch { said = words().lost; show(); }
      await new Promise((done) => setTimeout(done, 1000));
    }
  };

  // Number of changes without an answer; news on their way have the settings before them.
  let setting = 0;
  const set = async (change) => {
    const before = settings;
    settings = { ...settings, ...change };
    setting += 1;
    try {
      const response = await ask("/api/teacher/settings", { body: JSON.stringify(settings) });
      settings = response.ok ? (await response.json()).settings : before;
    } catch { settings = before; said = words().lost; }
    setting -= 1;
    show();
  };
  const post = async (path, seat) => {
    try { await ask(path, { body: JSON.stringify({ seat }) }); } catch { said = words().lost; show(); }
  };
  const renew = async () => {
    const response = confirm(words().new_code_sure) && await ask("/api/teacher/renew-code", { body: "{}" });
    const news = response && response.ok && await ask("/api/teacher/class");
    if (!news || !news.ok) return;
    about = await news.json();
    built = "";
    show();
  };
  const revoke = async () => {
    if (!confirm(words().revoke_sure)) return;
    if (!(await ask("/api/teacher/revoke", { body: "{}" })).ok) failed();
  };
  const eraseUnused = async () => {
    if (confirm(words().erase_unused_sure)) await ask("/api/teacher/erase-unused", { body: "{}" });
  };
  const failed = () => { said = words().lost; show(); };
  // Address, code and QR code with which students join.
  const way = () => {
    const picture = make("div", { className: "qr" });
    picture.innerHTML = about.qr;
    return [picture, make("div", { className: "way" }, make("span", { textContent: about.address }), make("b", { textContent: about.code }))];
  };
  const large = () => {
    // A dialog of its own, above that of the dashboard.
    const cover = make("dialog", { id: "class-large", onclose: () => cover.remove() });
    cover.setAttribute("aria-label", words().qr);
    const [picture, text] = way();
    text.append(button(words().hide, () => cover.close()));
    cover.append(picture, text);
    document.body.append(cover);
    cover.showModal();
  };
  const status = classBar.status("class-live");
  const count = make("span");
  const first = make("div", { id: "class-first" });
  const dashboard = make("button", { type: "button", onclick: () => dispatchEvent(new Event("class-open")) });
  const list = make("ul", { className: "seats" });
  const boxes = [["open", "open"], ["paused", "pause"], ["joining", "joining_open"], ["approve", "approve_late"], ["results", "results"], ["others", "others_after"]];
  const inputs = {};
  const pace = make("select", { onchange: () => set({ pace: pace.value || null }) });
  const minutes = make("input", { type: "number", min: 0, className: "minutes", onchange: () => set({ closes: minutes.value ? Date.now() + skew + 60000 * minutes.value : null }) });
  let built = "", listed = "", skew = 0;
  const show = () => {
    const own = words();
    const form = JSON.stringify([Boolean(token && about), document.documentElement.lang]);
    if (form !== built) { built = form; build(own); }
    const text = [said, room].filter(Boolean).join(" ");
    if (status.textContent !== text) status.textContent = text;
    if (!settings || !token) return;
    for (const [key] of boxes) inputs[key].checked = settings[key];
    pace.value = settings.pace || "";
    count.textContent = own.seats_joined.replace("#", seats.length).replace("$", seats.filter((one) => handed.has(one.seat)).length);
    // Until there is something else to be shown.
    first.hidden = handed.size > 0;
    const now = JSON.stringify([seats, document.documentElement.lang]);
    if (now === listed) return;
    listed = now;
    list.replaceChildren(...seats.map((one) => {
      const parts = [make("span", { textContent: one.pseudonym })];
      if (!one.approved) parts.push(`(${own.waiting})`, button(own.let_in, () => post("/api/teacher/approve", one.seat)));
      parts.push(button(own.erase_seat, () => {
        if (confirm(own.erase_seat_sure.replace("#", one.pseudonym))) post("/api/teacher/erase", one.seat);
      }));
      return make("li", {}, ...parts);
    }));
  };
  const sheets = async () => {
    const response = await ask("/api/teacher/sheets");
    if (!response.ok) return;
    const files = (await response.json()).sheets.map((text, at) => new File([text], `${at + 1}.survey`));
    dispatchEvent(new CustomEvent("class-sheets", { detail: files }));
  };
  const build = (own) => {
    bar.setAttribute("aria-label", own.seats);
    if (!token || !about) return bar.replaceChildren(status);
    const choices = boxes.map(([key, label]) => {
      inputs[key] = make("input", { type: "checkbox", id: `class-${key}`, onchange: () => set({ [key]: inputs[key].checked }) });
      return make("label", {}, inputs[key], own[label]);
    });
    pace.replaceChildren(make("option", { value: "", textContent: own.free }),
      ...about.documents.map((one) => make("option", { value: one.name, textContent: one.title })));
    dashboard.textContent = own.dashboard;
    first.replaceChildren(...way(), make("p", { textContent: own.first }));
    const fold = (id, title, open, ...content) => make("details", { id, open }, make("summary", { textContent: title }), ...content);
    bar.replaceChildren(
      make("span", {}, `${own.address} `, make("b", { textContent: about.address }), ` ${own.with} `, make("b", { className: "key", textContent: about.code })),
      button(own.qr, large), dashboard, count, status, first,
      fold("class-settings", own.settings, innerWidth >= 760, make("div", {}, ...choices, make("label", {}, own.pace_at, pace),
        make("label", {}, own.close_in, minutes), button(own.new_code, () => renew().catch(failed)),
        button(own.revoke, () => revoke().catch(failed)), button(own.sheets, () => sheets().catch(failed)))),
      fold("class-seats", own.seats, false, button(own.erase_unused, () => eraseUnused().catch(failed)), list));
  };
  const start = async () => {
    classBar.begin(show);
    if (link) {
      const response = await fetch("/api/teacher/exchange", {
        method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify({ link }), credentials: "omit" });
      if (response.ok) { ({ token } = await response.json()); keep(token); }
    }
    const response = token && await ask("/api/teacher/class");
    if (!response || !response.ok) { token = null; said = words().link; return show(); }
    about = await response.json();
    settings = about.settings;
    skew = about.now - Date.now();
    show();
    if (isReady()) ready();
    follow();
  };
  // The dashboard is a dialog, beside which nothing else can be used: the line goes into it while it is open.
  setInterval(() => {
    const dialog = document.getElementById("class");
    const home = dialog?.open ? dialog : document.body;
    dashboard.hidden = home === dialog;
    if (bar.parentNode === home) return;
    home.prepend(bar);
    // The button beside which the dialog opens would close it.
    if (home === dialog) bar.querySelector("button")?.focus();
  }, 250);
  const begin = () => start().catch(() => { said = words().lost; show(); });
  if (document.readyState === "loading") addEventListener("DOMContentLoaded", begin); else begin();
})();

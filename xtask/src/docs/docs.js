// Search and examples of the documentation. The text needs neither.
import "./meniscus/meniscus.js";

// The list of pages is folded where it stands above the text.
const list = document.querySelector("nav details");
if (matchMedia("(max-width: 860px)").matches) list.open = false;

// Search: sections that contain all words, those with the words in their heading first.
const search = document.querySelector("#search");
const field = search.querySelector("input");
const results = search.querySelector("ol");
const MOST = 12;
let sections;
const folded = (text) => text.toLowerCase().normalize("NFD").replace(/[\u0300-\u036f]/g, "");
const loaded = () =>
  (sections ??= fetch("search.json")
    .then((response) => response.json())
    .then((all) => all.map(([address, page, heading, words]) => ({ address, page, heading, high: folded(`${heading} ${page}`), low: folded(words), words }))));
const entry = ({ address, page, heading, low, words }, wanted) => {
  const item = document.createElement("li");
  const link = Object.assign(document.createElement("a"), { href: address, textContent: heading });
  const place = Math.max(0, Math.min(...wanted.map((word) => low.indexOf(word)).filter((place) => place >= 0), words.length) - 30);
  const about = document.createElement("small");
  about.textContent = `${page}: ${words.slice(place, place + 90).trim()}`;
  link.append(about);
  item.append(link);
  return item;
};
const find = async () => {
  const wanted = folded(field.value).split(/\s+/).filter(Boolean);
  const all = await loaded();
  const count = ({ high }) => wanted.filter((word) => high.includes(word)).length;
  const found = wanted.length ? all.filter(({ high, low }) => wanted.every((word) => high.includes(word) || low.includes(word))) : [];
  found.sort((one, other) => count(other) - count(one));
  results.replaceChildren(...found.slice(0, MOST).map((section) => entry(section, wanted)));
  search.querySelector("[role=status]").textContent = wanted.length ? `${found.length} sections` : "";
};
search.hidden = false;
field.addEventListener("input", find);
field.addEventListener("focus", loaded, { once: true });
addEventListener("keydown", (event) => {
  if (event.key === "/" && !event.target.closest("input, textarea") && !event.ctrlKey && !event.metaKey && !event.altKey) {
    event.preventDefault();
    field.focus();
  }
});

// Examples: the text becomes editable, and the simulation follows it.
const PAUSE = 400;
const model = document.querySelector("#model")?.textContent.replaceAll("<\\/", "</") ?? "";
// The document with this text, and the number of lines before it.
const whole = ({ kind, plots = "" }, text) => {
  if (kind === "markdown") return [text + plots, 0];
  const before = kind === "model" ? "" : `\`\`\`model\n${model}\`\`\`\n\n`;
  return [`${before}\`\`\`${kind}\n${text.replace(/\n?$/, "\n")}\`\`\`\n${plots}`, before.split("\n").length];
};
const said = ({ severity, message, remedy, line }, lines) => {
  const item = Object.assign(document.createElement("li"), { className: severity, textContent: `${Math.max(1, line - lines)}: ${message}` });
  if (remedy) item.append(Object.assign(document.createElement("small"), { textContent: remedy }));
  return item;
};
for (const example of document.querySelectorAll(".example")) {
  const pre = example.querySelector("pre");
  const button = Object.assign(document.createElement("button"), { className: "edit", textContent: "Edit" });
  pre.after(button);
  button.addEventListener("click", () => {
    const text = Object.assign(document.createElement("textarea"), { value: pre.textContent, spellcheck: false });
    text.setAttribute("aria-label", "Text of the example");
    text.rows = Math.min(30, pre.textContent.split("\n").length);
    const findings = document.createElement("ul");
    findings.setAttribute("role", "status");
    findings.hidden = true;
    let element = example.querySelector("meniscus-simulation");
    if (!element) {
      element = document.createElement("meniscus-simulation");
      element.setAttribute("show", "scene plots parameters");
      example.append(element);
    }
    pre.replaceWith(text);
    button.replaceWith(findings);
    text.focus();
    let lines = 0;
    const write = () => {
      const [document, before] = whole(example.dataset, text.value);
      lines = before;
      element.text = document;
    };
    element.addEventListener("findings", ({ detail }) => {
      // Not of the plots that were added behind the text.
      const own = detail.filter(({ line }) => line <= lines + text.value.split("\n").length);
      findings.replaceChildren(...own.map((finding) => said(finding, lines)));
      findings.hidden = !own.length;
    });
    let later;
    text.addEventListener("input", () => {
      clearTimeout(later);
      later = setTimeout(write, PAUSE);
    });
    write();
  });
}

// The line of the class at the top of a page, and what its parts are made of.
const classBar = (() => {
  "use strict";
  const config = JSON.parse(document.getElementById("class-config").textContent);
  const words = () => config.texts[(document.documentElement.lang || "en").slice(0, 2)] || config.texts.en;
  const make = (kind, properties = {}, ...children) => {
    const node = Object.assign(document.createElement(kind), properties);
    node.append(...children);
    return node;
  };
  const button = (text, action) => make("button", { type: "button", textContent: text, onclick: action });
  const status = (id) => {
    const node = make("span", { id });
    node.setAttribute("role", "status");
    return node;
  };
  const bar = make("div", { id: "class-bar" });
  bar.setAttribute("role", "region");
  // Puts the line into the page; `show` is called again when the language of the page changes.
  const begin = (show) => {
    document.body.prepend(bar);
    new MutationObserver(show).observe(document.documentElement, { attributes: true, attributeFilter: ["lang"] });
  };
  return { config, words, make, button, status, bar, begin };
})();

// Parts of a hand-in, cut out of its text.
const handInParts = (() => {
  "use strict";
  // Members of an object and elements of a list in JSON, each as the text that it was: numbers keep their digits.
  const pieces = (text) => {
    const found = [];
    let depth = 0, start = -1, name = null;
    const end = (at) => { if (start >= 0) found.push([name, text.slice(start, at).trim()]); start = -1; name = null; };
    const token = /"(?:[^"\\]|\\.)*"|[[\]{},:]/g;
    for (let match; (match = token.exec(text));) {
      const one = match[0];
      if (one === "{" || one === "[") { if (++depth === 1) start = match.index + 1; }
      else if (one === "}" || one === "]") { if (--depth === 0) { if (text.slice(start, match.index).trim()) end(match.index); } }
      else if (depth === 1 && one === ",") { end(match.index); start = match.index + 1; }
      else if (depth === 1 && one === ":") { name = JSON.parse(text.slice(start, match.index)); start = match.index + 1; }
    }
    return found;
  };
  const parts = (text) => {
    const whole = new Map(pieces(text));
    const work = new Map(pieces(whole.get("work")));
    const items = pieces(work.get("items")).map(([, item]) => [JSON.parse(new Map(pieces(item)).get("name")), item]);
    return [
      ["documents", work.get("documents")],
      ["state", work.get("state")],
      ...items.map(([name, item]) => [`item:${name}`, item]),
      ["order", JSON.stringify(items.map(([name]) => name))],
      ["facts", whole.get("facts")],
      ["head", `{"format":${whole.get("meniscus hand-in")},"program":${whole.get("program")},"bits":${whole.get("bits") ?? null},"made":${whole.get("made")},"sender":${whole.get("sender")}}`],
    ];
  };
  // Times at which a file is made are no change.
  const hash = (text) => {
    let [a, b] = [0x9e3779b9, 0x85ebca6b];
    const plain = text.replace(/"(since|made)":\d+/g, "");
    for (let at = 0; at < plain.length; at++) {
      const code = plain.charCodeAt(at);
      a = Math.imul(a ^ code, 2654435761); b = Math.imul(b ^ code, 1597334677);
    }
    return `${(a >>> 0).toString(36)}.${(b >>> 0).toString(36)}.${plain.length}`;
  };

  return { parts, hash };
})();

// The colours of a document: Markdown around blocks, and in each block the words of the equation language. It goes by lines and words;
// what a text means is checked in Rust.

import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { tags } from "@lezer/highlight";

/** Words that begin a statement or a part of one. */
const WORDS = new Set(
  (
    "parameter independent when in if then else and or not discrete every button size table function choice switch next for " +
    "step from until as let stop by hidden true false on off while smooth linear against set answer attempts hint explanation within hide supposing group at always end " +
    "histogram scatter section"
  ).split(" "),
);
const BLOCK = /^(`{3,}|~{3,})\s*(?:(model|scene|plots|presets|question|check|translations)(?!\w))?/;

/** A word, number, unit, text or comment of the equation language. */
function equation(stream) {
  if (stream.eatSpace()) return null;
  if (stream.peek() === "#") {
    stream.skipToEnd();
    return "comment";
  }
  if (stream.match(/^"[^"]*"?/) || stream.match(/^[“«][^”»]*[”»]?/)) return "string";
  if (stream.match(/^(\d+\.?\d*|\.\d+)(e[+-]?\d+)?/i)) return "number";
  // An index stands directly behind its name, a unit behind a blank.
  const isUnit = stream.peek() === "[" && (stream.pos === 0 || /\s/.test(stream.string[stream.pos - 1]));
  if (isUnit && stream.match(/^\[[^\]]*\]?/)) return "unit";
  const name = stream.match(/^[\p{L}_][\p{L}\p{N}_]*/u);
  if (name) {
    if (WORDS.has(name[0])) return "keyword";
    return stream.match(/^\s*\(/, false) ? "function" : "variable";
  }
  stream.next();
  return "operator";
}

/** A tag, attribute or text of a drawing; before the drawing stand definitions. */
function scene(stream, state) {
  if (!state.drawing && !stream.match(/^\s*</, false)) return equation(stream);
  state.drawing = true;
  if (stream.match(/^<!--.*?(-->|$)/)) return "comment";
  if (stream.match(/^<\/?[\w-]*/) || stream.match(/^\/?>/)) return "keyword";
  if (stream.match(/^"[^"]*"?/)) return "string";
  if (stream.match(/^[\w-]+(?==")/)) return "function";
  stream.next();
  return null;
}

function prose(stream) {
  if (stream.sol() && stream.match(/^#{1,6}\s.*/)) return "heading";
  if (stream.match(/^`[^`]*`/)) return "string";
  if (stream.match(/^\$\$?[^$]+\$\$?/)) return "unit";
  if (stream.match(/^\*\*[^*]+\*\*/)) return "strong";
  if (stream.match(/^\*[^*\s][^*]*\*/)) return "emphasis";
  stream.next();
  stream.eatWhile(/[^`$*\\]/);
  return null;
}

/** The words of a question are prose; what is computed stands behind `set`, `hide` and `answer`. */
function question(stream, state) {
  const key = stream.sol() && stream.match(/^\s*(after|set|hide|answer|attempts|hint|explanation)(?=\s*:)/);
  if (!key) return state.computed ? equation(stream) : prose(stream);
  state.computed = !["after", "hint", "explanation"].includes(key[1]);
  return "keyword";
}

const documents = StreamLanguage.define({
  name: "meniscus",
  startState: () => ({ block: "", fence: "", drawing: false, computed: false, front: false, first: true }),
  token(stream, state) {
    if (stream.sol()) {
      const edge = /^---\s*$/.test(stream.string);
      const wasFirst = state.first;
      state.first = false;
      if (edge && (wasFirst || state.front)) {
        state.front = wasFirst;
        stream.skipToEnd();
        return "meta";
      }
      const fence = !state.front && stream.string.match(BLOCK);
      if (fence && !state.fence) {
        Object.assign(state, { fence: fence[1], block: fence[2] ?? "code", drawing: false, computed: false });
        stream.skipToEnd();
        return "meta";
      }
      if (fence && fence[1].startsWith(state.fence)) {
        Object.assign(state, { fence: "", block: "" });
        stream.skipToEnd();
        return "meta";
      }
    }
    if (state.front) {
      if (stream.match(/^[\w-]+(?=\s*:)/)) return "keyword";
      stream.skipToEnd();
      return "string";
    }
    if (state.block === "scene") return scene(stream, state);
    if (state.block === "question") return question(stream, state);
    if (state.block === "code") return stream.skipToEnd(), "string";
    return state.block ? equation(stream) : prose(stream);
  },
  tokenTable: {
    unit: tags.unit,
    function: tags.function(tags.variableName),
    variable: tags.variableName,
    heading: tags.heading,
    strong: tags.strong,
    emphasis: tags.emphasis,
  },
  // A prime is no quotation mark: x[i]' is a first derivative.
  languageData: { commentTokens: { line: "#" }, closeBrackets: { brackets: ["(", "[", "{", '"'] } },
});

/** In the colours of the page. */
const colours = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--accent)", fontWeight: "600" },
  { tag: tags.unit, color: "var(--right)" },
  { tag: tags.number, color: "var(--liquid-deep)" },
  { tag: tags.string, color: "var(--near)" },
  { tag: tags.comment, color: "var(--soft)", fontStyle: "italic" },
  { tag: tags.meta, color: "var(--soft)", fontWeight: "600" },
  { tag: tags.heading, fontWeight: "700" },
  { tag: tags.strong, fontWeight: "700" },
  { tag: tags.emphasis, fontStyle: "italic" },
]);

export const language = [documents, syntaxHighlighting(colours)];

// Proposals while a block is written: units in brackets, elsewhere names, functions and words of the language. Prose is left alone.

/** Whether a place stands in a block that means something to Meniscus. */
function inBlock(document, place) {
  for (let number = document.lineAt(place).number - 1; number > 0; number -= 1) {
    const fence = document.line(number).text.match(/^(?:`{3,}|~{3,})\s*(\w*)/);
    if (fence) return ["model", "scene", "plots", "presets", "question", "check"].includes(fence[1]);
  }
  return false;
}

/** The proposals at a place, out of those that `words` gives. */
export const completions = (words) => (context) => {
  const line = context.state.doc.lineAt(context.pos);
  const before = line.text.slice(0, context.pos - line.from);
  // Not in a comment or a text.
  if (/#/.test(before) || before.split('"').length % 2 === 0 || !inBlock(context.state.doc, context.pos)) return null;
  const unit = before.match(/(?:^|\s)\[([^\]]*)$/);
  if (unit) {
    const options = words().filter((word) => word.type === "unit");
    return { from: context.pos - unit[1].length, options, validFor: /^[^\]]*$/ };
  }
  const name = context.matchBefore(/[\p{L}_][\p{L}\p{N}_]*/u);
  if (!name && !context.explicit) return null;
  const options = words().filter((word) => word.type !== "unit");
  return { from: name ? name.from : context.pos, options, validFor: /^[\p{L}_][\p{L}\p{N}_]*$/u };
};

// Proposals while a document is written. The laboratory knows what can stand at a place; here it is only asked.

/** The source of proposals that asks `propose(text, place)`, which answers `{ from, options }`. */
export const completions = (propose) => (context) => {
  const { from, options } = propose(context.state.doc.toString(), context.pos);
  // Between words nothing is proposed unless somebody asks, but after the brackets and marks that begin something.
  const begins = /[\[<`{]$/.test(context.state.sliceDoc(Math.max(0, context.pos - 1), context.pos));
  if (!options.length || (from === context.pos && !context.explicit && !begins)) return null;
  return { from, options, validFor: /^[\p{L}\p{N}_-]*$/u };
};

// How the editor looks: the colours, faces and distances of the page, by its custom properties, so that both themes hold.

import { EditorView } from "@codemirror/view";

export const theme = EditorView.theme({
  "&": { height: "100%", color: "var(--ink)", backgroundColor: "var(--paper)", fontSize: "13px" },
  // The place of the editor shows the focus, around the gutters too.
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.55", overflow: "auto" },
  ".cm-content": { caretColor: "var(--accent)", padding: "8px 0" },
  ".cm-line": { padding: "0 10px 0 4px" },
  ".cm-cursor, .cm-dropCursor": { borderLeftColor: "var(--accent)", borderLeftWidth: "2px" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground, ::selection": {
    backgroundColor: "color-mix(in srgb, var(--accent) 26%, transparent)",
  },
  ".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--tint) 38%, transparent)" },
  ".cm-gutters": { backgroundColor: "var(--paper)", color: "var(--soft)", border: "0" },
  ".cm-activeLineGutter": { backgroundColor: "transparent", color: "var(--accent)" },
  ".cm-lineNumbers .cm-gutterElement": { minWidth: "26px", padding: "0 4px 0 6px" },
  ".cm-gutter-lint": { width: "14px" },
  ".cm-gutter-lint .cm-gutterElement": { padding: "0" },
  ".cm-lint-marker": { width: "12px", height: "12px", margin: "4px 1px" },
  // A square for an error and a disc for a warning: not by colour alone.
  ".cm-lint-marker-error": { content: "none", borderRadius: "3px", backgroundColor: "var(--wrong)" },
  ".cm-lint-marker-warning": { content: "none", borderRadius: "50%", backgroundColor: "var(--near)" },
  ".cm-lintRange": { backgroundImage: "none", paddingBottom: "0" },
  ".cm-lintRange-error": { textDecoration: "underline wavy var(--wrong) 1.5px", textUnderlineOffset: "4px", backgroundColor: "var(--wrong-tint)" },
  ".cm-lintRange-warning": { textDecoration: "underline wavy var(--near) 1.5px", textUnderlineOffset: "4px" },
  ".cm-lintPoint::after": { borderBottomColor: "var(--wrong)" },
  ".cm-matchingBracket, &.cm-focused .cm-matchingBracket": { backgroundColor: "var(--tint)", outline: "1px solid var(--edge)" },
  ".cm-searchMatch": { backgroundColor: "var(--tint)" },
  ".cm-searchMatch-selected": { backgroundColor: "color-mix(in srgb, var(--accent) 40%, transparent)" },
  ".cm-panels": { backgroundColor: "var(--sunken)", color: "var(--ink)", fontFamily: "var(--sans)" },
  ".cm-panels.cm-panels-top": { borderBottom: "1px solid var(--line)" },
  ".cm-panel.cm-search": { padding: "6px 32px 6px 8px" },
  ".cm-panel.cm-search label": { fontSize: "13px" },
  ".cm-panel input[type=checkbox]": { accentColor: "var(--accent)" },
  ".cm-textfield": { minHeight: "30px", border: "1px solid var(--edge)", borderRadius: "7px", backgroundColor: "var(--paper)", color: "inherit", fontSize: "13px" },
  ".cm-button": { minHeight: "30px", border: "1px solid var(--line)", borderRadius: "7px", background: "var(--paper)", color: "var(--accent)", fontSize: "13px" },
  ".cm-panel.cm-search [name=close]": { width: "32px", minHeight: "32px", fontSize: "20px", color: "var(--soft)" },
  ".cm-tooltip": { border: "1px solid var(--line)", borderRadius: "8px", backgroundColor: "var(--paper)", color: "var(--ink)", boxShadow: "var(--shadow)", fontFamily: "var(--sans)", maxWidth: "min(420px, 90vw)" },
  ".cm-diagnostic": { padding: "6px 10px", fontSize: "13px", borderLeft: "4px solid var(--near)", whiteSpace: "pre-wrap" },
  ".cm-diagnostic-error": { borderLeftColor: "var(--wrong)" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul": { fontFamily: "var(--mono)", fontSize: "13px" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li": { padding: "3px 8px" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]": { backgroundColor: "var(--tint)", color: "var(--ink)" },
  ".cm-completionDetail": { color: "var(--soft)", fontFamily: "var(--sans)", fontStyle: "normal" },
  ".cm-completionInfo": { padding: "6px 10px", fontSize: "13px" },
});

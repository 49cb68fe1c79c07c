// The editor of the tab Write: CodeMirror around the texts of a document. It knows nothing of what they mean; the laboratory checks
// them and gives back what was found.

import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab, redo, undo } from "@codemirror/commands";
import { bracketMatching } from "@codemirror/language";
import { diagnosticCount, lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, search, searchKeymap } from "@codemirror/search";
import { Compartment, EditorState } from "@codemirror/state";
import {
  EditorView,
  drawSelection,
  dropCursor,
  highlightActiveLine,
  highlightActiveLineGutter,
  highlightSpecialChars,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import { completions } from "./completion.js";
import { language } from "./language.js";
import { theme } from "./theme.js";

/** So many milliseconds after the last key a text is checked, unless that is quick. */
const REST = 150;
/** Where a check takes no longer than so many milliseconds, each key has its own. */
const QUICK = 100;
/** Who never rests has the text checked after so many. */
const LONGEST = 2000;

/**
 * Makes an editor. `changed(file, text)` is called when a text has changed and its writer rests, `propose(text, place)` for what can
 * stand at a place: `{ from, options }`, `moved(text, place)` when the cursor has come to rest somewhere else.
 */
globalThis.meniscusEditor = (changed, propose, moved) => {
  let states = [];
  let file = 0;
  let timer = 0;
  let since = 0;
  /** How long the last check took, on this machine and with this text. */
  let took = 0;
  const words = new Compartment();
  let phrases = [];

  /** The files whose last change has not been checked. */
  const unchecked = new Set();
  const state = (number) => (number === file ? view.state : states[number]);

  const flush = () => {
    if (!timer) return;
    clearTimeout(timer);
    timer = since = 0;
    const files = [...unchecked];
    unchecked.clear();
    const begun = performance.now();
    for (const number of files) changed(number, state(number).doc.toString());
    took = performance.now() - begun;
  };
  const later = (number) => {
    unchecked.add(number);
    since ||= Date.now();
    clearTimeout(timer);
    const rest = took <= QUICK ? 0 : REST;
    timer = setTimeout(flush, Math.max(0, Math.min(rest, since + LONGEST - Date.now())));
  };
  let resting = 0;
  const rest = () => {
    clearTimeout(resting);
    resting = setTimeout(() => moved(view.state.doc.toString(), view.state.selection.main.head), REST);
  };
  const extensions = () => [
    words.of(phrases),
    lineNumbers(),
    lintGutter(),
    highlightActiveLine(),
    highlightActiveLineGutter(),
    highlightSpecialChars(),
    history(),
    drawSelection(),
    dropCursor(),
    bracketMatching(),
    closeBrackets(),
    // Nothing is chosen until an arrow key does: Enter ends the line of who has typed a name to its end.
    autocompletion({ override: [completions(propose)], icons: false, selectOnOpen: false }),
    search({ top: true }),
    highlightSelectionMatches(),
    EditorView.lineWrapping,
    EditorState.tabSize.of(4),
    keymap.of([indentWithTab, ...closeBracketsKeymap, ...completionKeymap, ...searchKeymap, ...historyKeymap, ...lintKeymap, ...defaultKeymap]),
    EditorView.updateListener.of((update) => {
      if (update.docChanged) later(file);
      if (update.docChanged || update.selectionSet) rest();
    }),
    EditorView.contentAttributes.of({ tabindex: "0", spellcheck: "false", autocorrect: "off", autocapitalize: "off" }),
    language,
    theme,
  ];
  const view = new EditorView();
  const show = (state) => {
    view.setState(state);
    // Tab leads out of the text, as everywhere in the page, until Control with M lets it indent.
    view.setTabFocusMode(true);
  };

  return {
    /** The element of the editor. */
    dom: view.dom,
    /** Opens other texts; what could be undone of the ones before is forgotten. */
    open(texts) {
      clearTimeout(timer);
      timer = since = 0;
      unchecked.clear();
      states = texts.map((doc) => EditorState.create({ doc, extensions: extensions() }));
      file = 0;
      if (states[0]) show(states[0]);
    },
    /** Opens one more text beside the others, whose history stays. */
    add(doc) {
      states.push(EditorState.create({ doc, extensions: extensions() }));
    },
    /** Shows another file. */
    select(next) {
      if (next === file || !states[next]) return;
      flush();
      states[file] = view.state;
      file = next;
      show(states[file]);
      rest();
      view.dispatch({ effects: words.reconfigure(phrases) });
    },
    /** The name of the text for screen readers, and the editor's own texts by their English ones. */
    speak(label, own) {
      phrases = [EditorState.phrases.of(own), EditorView.contentAttributes.of({ "aria-label": label, "aria-describedby": "editor-keys" })];
      view.dispatch({ effects: words.reconfigure(phrases) });
    },
    /** Marks what was found in the text shown: `{ from, to, severity, message }`, in UTF-16. */
    mark(found) {
      const most = view.state.doc.length;
      const within = found.map((one) => ({ ...one, from: Math.min(one.from, most), to: Math.min(one.to, most) }));
      if (within.length || diagnosticCount(view.state)) view.dispatch(setDiagnostics(view.state, within));
    },
    /** Changes the text shown: `{ from, to, insert }`. One that has not been checked since its last change is checked instead. */
    change(changes) {
      if (timer) return flush();
      view.dispatch({ changes, userEvent: "input" });
      view.focus();
      flush();
    },
    /** Takes another text for a file, as a step that can be undone. Only the part between what both begin and end with changes. */
    take(number, text) {
      const before = state(number)?.doc.toString();
      if (before === undefined || before === text) return;
      const most = Math.min(before.length, text.length);
      let from = 0;
      while (from < most && before[from] === text[from]) from += 1;
      let same = 0;
      while (same < most - from && before[before.length - 1 - same] === text[text.length - 1 - same]) same += 1;
      const transaction = state(number).update({
        changes: { from, to: before.length - same, insert: text.slice(from, text.length - same) },
        userEvent: "input",
      });
      if (number === file) view.dispatch(transaction);
      else states[number] = transaction.state;
      clearTimeout(timer);
      timer = since = 0;
      unchecked.clear();
    },
    /** The text of a file as it stands. */
    text: (number) => state(number)?.doc.toString() ?? "",
    /** Changes any file, shown or not, as typing would: the focus stays, and the history of the file can take it back. */
    edit(number, changes, isTyped) {
      // What is typed joins in the history with what was typed just before.
      const change = { changes, userEvent: isTyped ? "input.type" : "input.complete" };
      if (number === file) view.dispatch(change);
      else if (states[number]) {
        states[number] = states[number].update(change).state;
        later(number);
      }
    },
    /** Takes back the last change of a file, or what was taken back last. */
    undo(number, forwards) {
      const dispatch = (change) => {
        if (number === file) return view.dispatch(change);
        states[number] = change.state;
        later(number);
      };
      if (states[number]) (forwards ? redo : undo)({ state: state(number), dispatch });
      flush();
    },
    /** Goes to a place in the text shown. */
    go(from, to) {
      const most = view.state.doc.length;
      const selection = { anchor: Math.min(from, most), head: Math.min(to, most) };
      view.dispatch({ selection, effects: EditorView.scrollIntoView(selection.anchor, { y: "center" }) });
      view.focus();
    },
    focus: () => view.focus(),
    /** Measures again what was out of sight. */
    measure: () => view.requestMeasure(),
    /** Has a pending change checked now. */
    flush,
  };
};

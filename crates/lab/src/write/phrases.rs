//! The editor's own texts.

use units::{Words, words};

/// Texts of CodeMirror, as it states them.
pub const PHRASES: [Words; 22] = [
    words("Find"),
    words("Replace"),
    words("next"),
    words("previous"),
    words("all"),
    words("match case"),
    words("by word"),
    words("regexp"),
    words("replace"),
    words("replace all"),
    words("close"),
    words("current match"),
    words("replaced match on line $"),
    words("replaced $ matches"),
    words("on line"),
    words("Go to line"),
    words("go"),
    words("Control character"),
    words("Selection deleted"),
    words("Completions"),
    words("Diagnostics"),
    words("No diagnostics"),
];

//! Check that pages ask for nothing that the oldest browsers for which they are made do not have: Safari 16.4, by which the minimum in
//! `docs/publishing.md` is determined.

use crate::texts::{product, root, texts};
use std::path::Path;

/// Features that throw or drop a whole rule in Safari 16.4, with the version of Safari that has them. Properties, which an older
/// browser merely leaves out, are not among them.
const NEWER: [(&str, &str); 44] = [
    // Selectors.
    (":popover-open", "17.0"),
    (":user-valid", "16.5"),
    (":user-invalid", "16.5"),
    (":active-view-transition", "18.0"),
    ("::details-content", "18.4"),
    ("::highlight(", "17.2"),
    // Rules and functions of style sheets.
    ("@scope", "17.4"),
    ("@starting-style", "17.5"),
    ("@function", "none"),
    ("light-dark(", "17.5"),
    // Methods and functions.
    ("checkVisibility(", "17.4"),
    ("check_visibility(", "17.4"),
    ("showPopover(", "17.0"),
    ("hidePopover(", "17.0"),
    ("togglePopover(", "17.0"),
    ("startViewTransition(", "18.0"),
    ("requestClose(", "18.4"),
    ("getHTML(", "18.0"),
    ("setHTMLUnsafe(", "17.4"),
    ("parseHTMLUnsafe(", "17.4"),
    ("moveBefore(", "none"),
    ("showOpenFilePicker(", "none"),
    ("showSaveFilePicker(", "none"),
    ("requestIdleCallback(", "none"),
    ("scheduler.", "none"),
    ("withResolvers(", "17.4"),
    ("Promise.try(", "18.2"),
    ("Object.groupBy(", "17.4"),
    ("Map.groupBy(", "17.4"),
    ("URL.canParse(", "17.0"),
    ("URL.parse(", "18.0"),
    ("AbortSignal.any(", "17.4"),
    ("Iterator.", "18.4"),
    ("fromBase64(", "18.2"),
    ("toBase64(", "18.2"),
    ("fromHex(", "18.2"),
    ("toHex(", "18.2"),
    ("isSubsetOf(", "17.0"),
    ("symmetricDifference(", "17.0"),
    ("RegExp.escape(", "18.2"),
    ("Math.sumPrecise(", "26.2"),
    ("Error.isError(", "26.0"),
    ("Temporal.", "none"),
    ("float16", "18.2"),
];

/// Uses that are right: with the check before, or with `?.`.
const CHECKED: [&str; 3] = [
    "globalThis.requestIdleCallback ? requestIdleCallback(",
    "Uint8Array.fromBase64 ? Uint8Array.fromBase64(",
    "bytes.toBase64?.(",
];

/// Syntax that is newer than ES2018: the script that tells of old browsers must be read by them.
const SYNTAX: [&str; 9] = ["?.", "??", "||=", "&&=", "**=", "catch {", "static {", "#private", "import("];

#[test]
fn pages_need_nothing_newer_than_their_oldest_browser() {
    let mut found = Vec::new();
    for (path, text) in &sources() {
        let text = CHECKED.iter().fold(text.clone(), |text, right| text.replace(right, ""));
        let newer = NEWER.iter().filter(|(feature, _)| text.contains(feature));
        found.extend(newer.map(|(feature, version)| format!("{path}: `{feature}`, Safari {version}")));
    }
    assert!(found.is_empty(), "Safari 16.4 does not have:\n{}", found.join("\n"));
}

#[test]
fn old_browsers_read_the_script_that_tells_them() {
    let script = std::fs::read_to_string(root().join("crates/view/page/boot.js")).expect("the script");
    let code: Vec<&str> = script.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
    let code = code.join("\n");
    let newer: Vec<_> = SYNTAX.iter().filter(|syntax| code.contains(**syntax)).collect();
    assert!(newer.is_empty(), "crates/view/page/boot.js has syntax that is newer than ES2018: {newer:?}");
}

/// Scripts and styles of pages, and the Rust that runs in them, with their paths; without comments of lines.
fn sources() -> Vec<(String, String)> {
    let mut sources = Vec::new();
    for folder in
        ["view/page", "lab/page", "lab/editor", "player/page", "server/src/pages", "class/src/course", "cli/src/site"]
    {
        let entries = std::fs::read_dir(root().join("crates").join(folder)).expect("a folder of scripts");
        for path in entries.map(|entry| entry.expect("an entry").path()) {
            let is_source =
                |path: &Path| path.extension().is_some_and(|end| ["js", "css", "html"].iter().any(|own| end == *own));
            // The bundle of the editor is made of packages, for the same browsers.
            if is_source(&path) && !path.ends_with("editor/bundle.js") {
                let text = std::fs::read_to_string(&path).expect("a source");
                let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
                sources.push((path.display().to_string(), code.collect::<Vec<_>>().join("\n")));
            }
        }
    }
    assert!(sources.len() > 30, "only {} scripts and styles were found", sources.len());
    let mut rust = Vec::new();
    ["view", "lab", "player", "host"]
        .iter()
        .for_each(|name| texts(&root().join("crates").join(name).join("src"), &mut rust));
    sources.extend(rust.into_iter().map(|(path, text)| (path.display().to_string(), product(&text).to_owned())));
    sources
}

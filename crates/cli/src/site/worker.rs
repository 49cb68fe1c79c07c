//! The service worker of a site.

use super::files::{Files, hash};
use super::names::FROM_DISK;
use std::collections::BTreeMap;
use units::percent_encoded;

const SCRIPT: &str = include_str!("worker.js");

/// Service worker for these files. It contains their hashes, so that browsers detect a new worker when a file changes.
pub fn script(files: &Files) -> String {
    let kept = files.iter().filter(|(path, _)| !path.ends_with(FROM_DISK));
    let hashes: BTreeMap<String, String> = kept.map(|(path, content)| (percent_encoded(path), hash(content))).collect();
    // A map of texts can always be serialised.
    let list = serde_json::to_string_pretty(&hashes).unwrap_or_default();
    let script = SCRIPT.replace("const FILES = {};", &format!("const FILES = {list};"));
    let version = hash(script.as_bytes());
    script.replace("const VERSION = \"\";", &format!("const VERSION = \"{}\";", version.get(..16).unwrap_or(&version)))
}

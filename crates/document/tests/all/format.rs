//! One layout: it changes no meaning, keeps all comments, and is reached in one step.

use document::{Formatted, format, read};
use program::bundle;
use std::path::{Path, PathBuf};

/// All documents that come with Meniscus, translations included.
fn texts() -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folders = ["../simulations", "../simulations/theories", "desk/templates/en", "desk/templates/es"];
    let files = folders.iter().flat_map(|folder| std::fs::read_dir(root.join(folder)).unwrap());
    let files = files.map(|entry| entry.unwrap().path()).filter(|path| path.extension().is_some_and(|end| end == "md"));
    files.map(|path| (path.clone(), std::fs::read_to_string(path).unwrap())).collect()
}

fn formatted(text: &str) -> String {
    let Formatted { edits, .. } = format(&read(text));
    document::edit::apply(text, &edits).unwrap()
}

#[test]
fn dump() {
    for (path, text) in texts() {
        std::fs::write(format!("/tmp/fmt/{}", path.display().to_string().replace('/', "_")), formatted(&text)).unwrap();
        std::fs::write(format!("/tmp/fmt0/{}", path.display().to_string().replace('/', "_")), text).unwrap();
    }
}

//! Use of esbuild: bundles the editor of the laboratory, made of CodeMirror and `crates/lab/editor`, to one script, and
//! minifies scripts and styles. The bundle is committed, so that only those who change the editor need Node.

use crate::{steps, tools};
use anyhow::{Context, Result};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Copyright notice that the licence of CodeMirror requires.
const NOTICE: &str =
    "/*! CodeMirror. Copyright (C) 2018-2021 by Marijn Haverbeke and others. MIT License: https://codemirror.net */";

/// Newest syntax of scripts and styles: that of the oldest browsers for which the page is made. Properties get the prefixes that they need there.
const TARGET: &str = "--target=es2022,safari16.4";

/// Text of the committed bundle of the editor.
pub fn bundle() -> Result<String> {
    let path = committed();
    std::fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))
}

/// Bundles the editor again after a change of its sources or packages.
pub fn renew() -> Result<()> {
    let path = committed();
    std::fs::write(&path, bundled()?).with_context(|| format!("cannot write {}", path.display()))
}

fn directory() -> PathBuf {
    steps::root().join("crates").join("lab").join("editor")
}

fn committed() -> PathBuf {
    directory().join("bundle.js")
}

/// The editor as one script, made of its sources.
fn bundled() -> Result<String> {
    tools::node()?;
    let mut bundler = esbuild()?.context("npm is missing; it comes with Node: https://nodejs.org")?;
    bundler.args(["editor.js", "--bundle", "--format=iife", "--legal-comments=none"]);
    steps::output(bundler.arg(format!("--banner:js={NOTICE}")))
}

/// True if scripts and styles are minified. Without Node they are taken as they are: the page is larger and does the same.
pub fn minifies() -> bool {
    ["node", "npm"].iter().all(|name| tools::find(name).is_some())
}

/// Minifies a script or style sheet, if there is Node. Names used by other scripts of the page are kept.
pub fn minified(file: &Path) -> Result<String> {
    match esbuild()? {
        Some(mut minifier) => steps::output(minifier.arg(file)),
        None => std::fs::read_to_string(file).with_context(|| format!("cannot read {}", file.display())),
    }
}

/// Command for esbuild in the directory of the editor, whose lock file states its version; `None` without Node. Minification is
/// on.
fn esbuild() -> Result<Option<Command>> {
    if !minifies() {
        return Ok(None);
    }
    let directory = directory();
    tools::packages(&directory)?;
    let mut command = Command::new(tools::node()?);
    command
        .arg(directory.join("node_modules").join("esbuild").join("bin").join("esbuild"))
        .args(["--minify", "--charset=utf8", "--log-level=warning", TARGET])
        .current_dir(&directory);
    Ok(Some(command))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_committed_bundle_is_what_the_sources_give() {
        let is_same = bundle().unwrap() == bundled().unwrap();
        assert!(
            is_same,
            "crates/lab/editor/bundle.js is not made of the sources beside it: `cargo xtask editor` makes it"
        );
    }
}

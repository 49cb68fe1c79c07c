//! Use of esbuild: bundles the editor of the laboratory, made of CodeMirror and `crates/lab/editor`, to one script, and
//! minifies scripts and styles.

use crate::{steps, tools};
use anyhow::{Context, Result};
use std::path::Path;
use std::process::Command;

/// Copyright notice that the licence of CodeMirror requires.
const NOTICE: &str =
    "/*! CodeMirror. Copyright (C) 2018-2021 by Marijn Haverbeke and others. MIT License: https://codemirror.net */";

/// Newest syntax of scripts and styles: that of the oldest browsers for which the page is made. Properties get the prefixes that they need there.
const TARGET: &str = "--target=es2022,safari16.4";

/// Bundles the editor to one script and returns its text.
pub fn bundle() -> Result<String> {
    let script = steps::target().join("page").join("parts").join("editor.js");
    let mut bundler = esbuild()?;
    bundler
        .args(["editor.js", "--bundle", "--format=iife", "--legal-comments=none"])
        .arg(format!("--banner:js={NOTICE}"))
        .arg(format!("--outfile={}", script.display()));
    steps::run(&mut bundler)?;
    std::fs::read_to_string(&script).with_context(|| format!("cannot read {}", script.display()))
}

/// Minifies a script or style sheet. Names used by other scripts of the page are kept.
pub fn minified(file: &Path) -> Result<String> {
    steps::output(esbuild()?.arg(file))
}

/// Command for esbuild in the directory of the editor, whose lock file states its version. Minification is on.
fn esbuild() -> Result<Command> {
    let directory = steps::root().join("crates").join("lab").join("editor");
    tools::packages(&directory)?;
    let mut command = Command::new(tools::node()?);
    command
        .arg(directory.join("node_modules").join("esbuild").join("bin").join("esbuild"))
        .args(["--minify", "--charset=utf8", "--log-level=warning", TARGET])
        .current_dir(&directory);
    Ok(command)
}

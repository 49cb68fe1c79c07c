//! What esbuild makes of scripts and styles: the editor of the laboratory, CodeMirror and what stands in `crates/lab/editor`, bundled
//! to one script; and files without comments, long names and blanks.

use crate::{steps, tools};
use anyhow::{Context, Result};
use std::path::Path;
use std::process::Command;

/// Who wrote most of it; the licence asks for the notice.
const NOTICE: &str =
    "/*! CodeMirror. Copyright (C) 2018-2021 by Marijn Haverbeke and others. MIT License: https://codemirror.net */";

/// The script.
pub fn bundle() -> Result<String> {
    let script = steps::target().join("page").join("parts").join("editor.js");
    let mut bundler = esbuild()?;
    bundler
        .args(["editor.js", "--bundle", "--format=iife", "--target=es2022", "--legal-comments=none"])
        .arg(format!("--banner:js={NOTICE}"))
        .arg(format!("--outfile={}", script.display()));
    steps::run(&mut bundler)?;
    std::fs::read_to_string(&script).with_context(|| format!("cannot read {}", script.display()))
}

/// A script or a style sheet in fewer bytes. Names that other scripts of the page use stay.
pub fn minified(file: &Path) -> Result<String> {
    steps::output(esbuild()?.arg(file))
}

/// esbuild in the directory of the editor, whose lock file names it; it shortens what it writes.
fn esbuild() -> Result<Command> {
    let directory = steps::root().join("crates").join("lab").join("editor");
    tools::packages(&directory)?;
    let mut command = Command::new(tools::node()?);
    command
        .arg(directory.join("node_modules").join("esbuild").join("bin").join("esbuild"))
        .args(["--minify", "--charset=utf8", "--log-level=warning"])
        .current_dir(&directory);
    Ok(command)
}

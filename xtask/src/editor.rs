//! The editor of the laboratory: CodeMirror and what stands in `crates/lab/editor`, bundled to one script.

use crate::{steps, tools};
use anyhow::{Context, Result};
use std::process::Command;

/// Who wrote most of it; the licence asks for the notice.
const NOTICE: &str =
    "/*! CodeMirror. Copyright (C) 2018-2021 by Marijn Haverbeke and others. MIT License: https://codemirror.net */";

/// The script.
pub fn bundle() -> Result<String> {
    let directory = steps::root().join("crates").join("lab").join("editor");
    tools::packages(&directory)?;
    let script = steps::target().join("page").join("parts").join("editor.js");
    let mut bundler = Command::new(tools::node()?);
    bundler
        .arg(directory.join("node_modules").join("esbuild").join("bin").join("esbuild"))
        .args(["editor.js", "--bundle", "--minify", "--format=iife", "--target=es2022", "--charset=utf8"])
        .args(["--legal-comments=none", "--log-level=warning"])
        .arg(format!("--banner:js={NOTICE}"))
        .arg(format!("--outfile={}", script.display()))
        .current_dir(&directory);
    steps::run(&mut bundler)?;
    std::fs::read_to_string(&script).with_context(|| format!("cannot read {}", script.display()))
}

//! WebAssembly modules: built by cargo in the profile `page`, and given their JavaScript by wasm-bindgen's library, so
//! that no other program has to be installed.

use crate::{steps, tools};
use anyhow::{Context, Result};
use std::path::{Path, PathBuf};
use wasm_bindgen_cli_support::Bindgen;

/// What the JavaScript is for.
#[derive(Clone, Copy, Debug)]
pub enum Host {
    /// Node, as CommonJS.
    Node,
    /// A classic script inside a page: an inline script cannot import, and from `file://` nothing can be fetched.
    Page,
}

/// Builds a package of the workspace and returns where its module is.
pub fn build(package: &str) -> Result<PathBuf> {
    tools::wasm_target()?;
    steps::run(&mut steps::cargo(&[
        "build",
        "--package",
        package,
        "--target",
        "wasm32-unknown-unknown",
        "--profile",
        "page",
    ]))?;
    Ok(steps::target().join("wasm32-unknown-unknown").join("page").join(format!("{package}.wasm")))
}

/// Writes `NAME.js` and `NAME_bg.wasm` of a built module into a directory.
pub fn bind(module: &Path, host: Host, directory: &Path) -> Result<()> {
    let mut bindgen = Bindgen::new();
    bindgen.input_path(module).typescript(false);
    match host {
        Host::Node => bindgen.nodejs(true),
        Host::Page => {
            bindgen.no_modules(true).map(|bindgen| bindgen.remove_name_section(true).remove_producers_section(true))
        }
    }
    .and_then(|bindgen| bindgen.generate(directory))
    .with_context(|| format!("cannot make the JavaScript of {}", module.display()))
}

//! Builds of WebAssembly modules with the profile `page`. Their JavaScript is generated with wasm-bindgen's library, so
//! that no other program has to be installed.

use crate::tools::TARGET;
use crate::{steps, tools};
use anyhow::{Context, Result, ensure};
use std::fs;
use std::path::{Path, PathBuf};
use wasm_bindgen_cli_support::Bindgen;

/// Environment for which the JavaScript is generated.
#[derive(Clone, Copy, Debug)]
pub enum Host {
    /// Node, as CommonJS.
    Node,
    /// A page, as a classic script that defines this name. An inline script cannot import modules, and a page from
    /// `file://` cannot fetch anything.
    Page(&'static str),
}

/// Packages of the workspace that are modules.
const PACKAGES: [&str; 3] = ["player", "lab", "probe"];

/// Builds all modules, always together: alone, each would give the crates that they share other features, and build them again.
pub fn build() -> Result<()> {
    tools::wasm_target()?;
    let mut build = steps::cargo(&["build", "--target", TARGET, "--profile", "page"]);
    build.args(PACKAGES.iter().flat_map(|package| ["--package", package]));
    steps::run(&mut build)
}

/// Builds the module of one package, which shares no features with the others.
pub fn build_one(package: &str) -> Result<()> {
    tools::wasm_target()?;
    steps::run(&mut steps::cargo(&["build", "--target", TARGET, "--profile", "page", "--package", package]))
}

/// Path of the module of a package, which includes the names of its functions.
pub fn module(package: &str) -> PathBuf {
    steps::target().join(TARGET).join("page").join(format!("{package}.wasm"))
}

/// Writes `NAME.js` and `NAME_bg.wasm` of a module into a folder.
pub fn bind(module: &Path, host: Host, directory: &Path) -> Result<()> {
    let mut bindgen = Bindgen::new();
    bindgen.input_path(module).typescript(false);
    match host {
        Host::Node => bindgen.nodejs(true),
        Host::Page(name) => bindgen
            .no_modules(true)
            .and_then(|bindgen| bindgen.no_modules_global(name))
            .map(|bindgen| bindgen.remove_name_section(true).remove_producers_section(true)),
    }
    .and_then(|bindgen| bindgen.generate(directory))
    .with_context(|| format!("cannot make the JavaScript of {}", module.display()))?;
    match host {
        Host::Node => Ok(()),
        Host::Page(_) => without_own_address(module, directory),
    }
}

/// Removes from the JavaScript of a page the address of its script, which is needed only where the module is a file beside it. A
/// page that is the text of a frame (`srcdoc`) has no address that others could be completed with, and would not start.
fn without_own_address(module: &Path, directory: &Path) -> Result<()> {
    const ADDRESS: &str = "new URL(document.currentScript.src, location.href).toString()";
    let name = module.file_stem().unwrap_or_default();
    let path = directory.join(name).with_extension("js");
    let script = fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    ensure!(
        script.contains(ADDRESS),
        "{} does not have `{ADDRESS}`: look at what wasm-bindgen makes now",
        path.display()
    );
    fs::write(&path, script.replacen(ADDRESS, "document.currentScript.src", 1))
        .with_context(|| format!("cannot write {}", path.display()))
}

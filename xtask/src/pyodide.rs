//! The wheel of the Python package for Pyodide: the Python sources of the compiled one, and a module of WebAssembly.

use crate::wasm::{self, Host};
use crate::wheel::{self, File};
use crate::{steps, tools};
use anyhow::{Context, Result, ensure};
use std::fs;
use std::path::{Path, PathBuf};

/// Greatest size of the module in bytes: Chromium compiles no larger one at once outside workers.
const LARGEST: usize = 8_000_000;

/// Builds the wheel from the compiled one, beside it.
pub fn wheel(compiled: &Path) -> Result<PathBuf> {
    let folder = steps::target().join("python").join("pyodide");
    wasm::build_one("pyodide")?;
    wasm::bind(&wasm::module("pyodide"), Host::Page("wasm_bindgen"), &folder)?;
    let source = steps::root().join("crates").join("pyodide").join("core.py");
    let added = [
        ("meniscus/_core.py", source),
        ("meniscus/core.js", folder.join("pyodide.js")),
        ("meniscus/core.wasm", folder.join("pyodide_bg.wasm")),
    ];
    let mut files = wheel::files(&fs::read(compiled)?)?;
    files.retain(|file| !file.name.starts_with("meniscus/_core.") || file.name.ends_with(".pyi"));
    let first = files.first().context("the compiled wheel is empty")?.clone();
    for (name, path) in added {
        let content = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
        ensure!(content.len() <= LARGEST, "{} is larger than {LARGEST} bytes", path.display());
        files.push(File::like(&first, name, content));
    }
    described(&mut files)?;
    let name = compiled.file_name().unwrap_or_default().to_string_lossy();
    let named: Vec<&str> = name.split('-').take(2).collect();
    let path = folder.join(format!("{}-py3-none-any.whl", named.join("-")));
    fs::write(&path, wheel::archive(&files)?)?;
    Ok(path)
}

/// States that the wheel is for every platform, and lists its files.
fn described(files: &mut [File]) -> Result<()> {
    let place = |files: &[File], name: &str| files.iter().position(|file| file.name.ends_with(name));
    let tags = place(files, ".dist-info/WHEEL").context("the compiled wheel has no WHEEL")?;
    files[tags].content =
        b"Wheel-Version: 1.0\nGenerator: meniscus xtask\nRoot-Is-Purelib: true\nTag: py3-none-any\n".to_vec();
    let record = place(files, ".dist-info/RECORD").context("the compiled wheel has no RECORD")?;
    files[record].content = wheel::record(files, &files[record].name);
    Ok(())
}

/// Installs Pyodide, which the tests run in Node.
pub fn packages() -> Result<()> {
    tools::node().context("the tests of the Python package run Pyodide in Node")?;
    tools::packages(&steps::root().join("tests").join("pyodide"))
}

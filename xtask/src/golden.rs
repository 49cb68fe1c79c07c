//! Compares the golden runs in WebAssembly with the hashes in the repository, which the native tests also check.

use crate::{steps, tools, wasm};
use anyhow::{Context, Result, bail};
use std::path::Path;

/// Runs `probe` in Node and compares every line of its `golden()`, interpreted and in emitted code, with
/// `crates/probe/golden.txt`.
pub fn compare() -> Result<()> {
    let directory = steps::target().join("probe").join("node");
    wasm::build()?;
    wasm::bind(&wasm::module("probe"), wasm::Host::Node, &directory)?;
    for function in ["golden", "golden_emitted"] {
        compare_function(&directory.join("probe.js"), function)?;
    }
    Ok(())
}

fn compare_function(probe: &Path, function: &str) -> Result<()> {
    let script = format!("process.stdout.write(require({probe:?}).{function}())");
    let found = steps::output(&mut steps::program(tools::node()?, &["--eval", &script]))?;
    let expected = std::fs::read_to_string(steps::root().join("crates").join("probe").join("golden.txt"))
        .context("cannot read crates/probe/golden.txt")?;
    let differing: Vec<String> = (expected.lines().zip(found.lines()))
        .filter(|(expected, found)| expected != found)
        .map(|(expected, found)| format!("expected {expected}\nfound    {found}"))
        .collect();
    if !differing.is_empty() || expected.lines().count() != found.lines().count() {
        bail!("golden runs differ in WebAssembly ({function})\n{}\nall that was found:\n{found}", differing.join("\n"));
    }
    println!("{} golden runs have the same bits natively and in WebAssembly ({function})", expected.lines().count());
    Ok(())
}

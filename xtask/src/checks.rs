//! All checks of the project, ordered so that quick ones fail first and nothing is built twice.

use crate::steps::{cargo, run, step};
use crate::{docs, golden, needs, page, python, steps, tools};
use anyhow::Result;
use std::process::Command;

/// Runs all checks. Stops at the first failure.
pub fn all() -> Result<()> {
    needs::provide(needs::CHECKS)?;
    step("format", || run(&mut cargo(&["fmt", "--all", "--check"])))?;
    tools::wasm_target()?;
    // The program embeds the page if it was built, and only then can it export and serve in the checks. A minute of its build
    // keeps one processor busy, and lints need none of it: cargo has a folder and a lock for each profile.
    std::thread::scope(|scope| {
        let lints = scope.spawn(|| step("lints", lints));
        step("the page", page::build)?;
        lints.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })?;
    step("the documentation", || docs::build().map(drop))?;
    step("unit and integration tests", tests)?;
    step("the class server before Postgres", postgres)?;
    step("golden runs in WebAssembly", golden::compare)?;
    step("the main path in WebKit", webkit)?;
    step("the page in Chromium and Firefox", browsers)
}

/// Runs all checks, and then the long ones, whose short forms are among them.
pub fn full() -> Result<()> {
    all()?;
    step("the Python package", python::test)?;
    step("licences and sources of dependencies", || run(&mut tools::cargo_deny()?))?;
    step("the class server under load and killed", || {
        let server = ["test", "--release", "--package", "server", "--test", "all", "--"];
        // One after the other, so that the durations that they print are their own.
        let long = ["--ignored", "--skip", "durable::child", "--nocapture", "--test-threads", "1"];
        run(cargo(&server).args(long).env(tools::POSTGRES, tools::postgres()?))
    })
}

/// Tests of the workspace: one selection of packages for all steps, since another one would give them other features.
const WORKSPACE: [&str; 10] =
    ["test", "--workspace", "--exclude", "lab", "--exclude", "python", "--exclude", "pyodide", "--exclude", "xtask"];

fn tests() -> Result<()> {
    // Tested separately, as it was built to run this: in a common build its dependencies would get other features and
    // be built twice.
    run(&mut cargo(&["test", "--package", "xtask"]))?;
    // Generated cases are the same in each check, so that a change is judged by what it changed. `cargo test` draws others.
    // No comment has code that runs, and examples are compiled by the lints: to link them takes longer than to test many a crate.
    run(cargo(&WORKSPACE).args(["--lib", "--bins", "--tests"]).env("PROPTEST_RNG_SEED", "1"))
}

/// Tests of the class server that need Postgres, of which each test program starts one of its own.
fn postgres() -> Result<()> {
    let tests = ["--test", "all", "postgres::", "--", "--ignored"];
    run(cargo(&WORKSPACE).args(tests).env(tools::POSTGRES, tools::postgres()?))
}

fn lints() -> Result<()> {
    const STRICT: [&str; 3] = ["--", "-D", "warnings"];
    // One selection of packages: another one would give the crates of macros other features, and compile them again.
    run(cargo(&["clippy", "--workspace", "--exclude", "lab", "--exclude", "pyodide", "--all-targets"]).args(STRICT))?;
    let browser = ["clippy", "--package", "lab", "--package", "probe", "--package", "pyodide"];
    run(cargo(&browser).args(["--target", tools::TARGET]).args(STRICT))
}

/// The main path through the page in WebKitGTK, which exists on Linux alone.
fn webkit() -> Result<()> {
    if cfg!(not(target_os = "linux")) {
        println!("left out: WebKitGTK runs on Linux alone");
        return Ok(());
    }
    let mut tests = page_tests()?;
    run(tests.arg("main-path.mjs").env(tools::WEBKIT.variable, tools::WEBKIT.path()?))
}

fn browsers() -> Result<()> {
    let mut tests = page_tests()?;
    // Two files at a time, each with a browser and a profile of its own; more than two need more memory than a small machine has.
    tests.arg("--test-concurrency=2");
    for browser in [tools::CHROMIUM, tools::FIREFOX] {
        tests.env(browser.variable, browser.path()?);
    }
    // Visits are over before the optimizing compiler of WebAssembly pays: it took a tenth of the time of all tests.
    tests.env("CHROME_SWITCHES", "--js-flags=--liftoff-only");
    run(&mut tests)
}

/// Command that runs tests of the page.
fn page_tests() -> Result<Command> {
    let directory = steps::root().join("tests").join("page");
    tools::packages(&directory)?;
    let program = steps::target().join("debug").join(format!("meniscus{}", std::env::consts::EXE_SUFFIX));
    let mut tests = Command::new(tools::node()?);
    tests.args(["--test", "--test-reporter=spec"]).current_dir(directory);
    tests.env("MENISCUS", program).env("PAGE", steps::page());
    Ok(tests)
}

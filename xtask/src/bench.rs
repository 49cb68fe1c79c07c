//! Measurements of speed and size, printed beside their targets. A measurement never fails, because it depends on the
//! machine and its load.

use crate::ratios::{self, Ratios};
use crate::steps::{self, cargo, step};
use crate::wasm::{self, Host};
use crate::{page, tools, weight};
use anyhow::{Context, Result};
use std::collections::BTreeMap;

/// Named numbers, as printed by the measuring programs.
type Numbers = BTreeMap<String, f64>;

/// Page of the repository teaching-physics/liquid-oscillations-Utube, the first simulation of this experiment. Its folder is named by
/// the environment variable `PUBLISHED`.
const PUBLISHED_PAGE: &str = "Utube_oscillations_damped_Simulation.xhtml";

/// Runs and prints all measurements, and names the ratios that are more than a fifth below the committed ones; with `commit`
/// it replaces the committed ones of this processor instead.
pub fn all(commit: bool) -> Result<()> {
    // Before the builds, which are a load themselves.
    let load = ratios::load().map_or("unknown".to_owned(), |load| format!("{load:.2}"));
    let page = step("the page", page::build)?;
    let page = std::fs::read_to_string(&page).with_context(|| format!("cannot read {}", page.display()))?;
    let native = step("the pace of the engine, of fits and of the import natively", native)?;
    let browser = tools::CHROMIUM.path();
    if let Err(missing) = &browser {
        println!("{missing:#}");
    }
    step("the U-tube, a chain and a string as pages of their own", export)?;
    let place = if browser.is_ok() { "in the browser" } else { "in Node" };
    let web = step(&format!("the pace of the engine {place}, and the page"), || in_wasm(browser.ok()))?;
    let gzipped = page::gzip(page.as_bytes())?.len();
    let first = page::gzip(page::before_picture(&page).as_bytes())?.len();
    let exported = std::fs::read(exported()).context("cannot read the exported page")?;
    let exported_gzipped = page::gzip(&exported)?.len();

    println!();
    println!("processor: {}; load before the measurement: {load}", ratios::features());
    pace("natively", &native, "");
    ensembles(&native);
    pace(place, &web, "wasm-");
    emitted_rows(&web);
    systems("natively", &native, ["at most 0.88", "at most 6", ""]);
    systems(place, &web, [""; 3]);
    fits("natively", &native);
    fits(place, &web);
    for (place, numbers, aim) in [("natively", &native, ""), (place, &web, "at most 16")] {
        if let Some(milliseconds) = numbers.get("check-lines") {
            row(&format!("check of a document of 2,000 lines {place}"), *milliseconds, "ms", aim);
        }
    }
    for (name, title) in [("points", "import"), ("commas", "import with decimal commas")] {
        if let Some(rows) = native.get(name) {
            row(title, rows / 1e6, "million rows/s", "at least 1");
        }
    }
    row("size of the laboratory", page.len() as f64 / 1000.0, "kB", "");
    row("size of the laboratory, gzipped", gzipped as f64 / 1000.0, "kB", "");
    row("before its first picture, gzipped", first as f64 / 1000.0, "kB", "at most 600");
    row("size of the exported U-tube", exported.len() as f64 / 1000.0, "kB", "");
    row("size of the exported U-tube, gzipped", exported_gzipped as f64 / 1000.0, "kB", "at most 550");
    for package in ["player", "lab"] {
        println!("code of the module `{package}` by crate, not packed:");
        weight::print(&wasm::module(package))?;
    }
    let aims = [
        ("plots", "plots on the screen", "", ""),
        ("script-per-frame", "script for a frame, 2,000 rows", "ms", "at most 2"),
        ("thread-per-frame", "main thread for a frame", "ms", ""),
        ("frames-per-second", "frames in a second", "", ""),
        ("opening", "opening until the play button", "ms", "the predecessor: 350 to 460"),
        ("long-record-seconds", "reading a record of 1,000,000 rows", "s", "at most 10"),
        ("long-record-task", "longest task of the page meanwhile", "ms", "at most 100"),
        ("long-record-frames", "frames in a second over it", "", "at least 50"),
        ("chain-frames-per-second", "frames in a second, chain of 200 masses", "", "at least 60"),
        ("chain-script-per-frame", "script for a frame", "ms", ""),
        ("chain-thread-per-frame", "main thread for a frame", "ms", ""),
        ("string-frames-per-second", "frames in a second, string of 1,000 points", "", "at least 60"),
        ("string-script-per-frame", "script for a frame", "ms", ""),
        ("string-thread-per-frame", "main thread for a frame", "ms", ""),
        ("phone-laboratory-full", "opening of the laboratory on a phone", "ms", ""),
        ("phone-laboratory-quarter", "the same with a processor slowed four times", "ms", "the published page"),
        ("phone-laboratory-sixth", "the same slowed six times", "ms", ""),
        ("phone-laboratory-slow-4g", "slowed four times, over slow 4G", "ms", "the published page"),
        ("phone-exported-full", "opening of the exported U-tube on a phone", "ms", ""),
        ("phone-exported-quarter", "the same with a processor slowed four times", "ms", "the published page"),
        ("phone-exported-sixth", "the same slowed six times", "ms", ""),
        ("phone-exported-slow-4g", "slowed four times, over slow 4G", "ms", "the published page"),
        ("phone-published-full", "opening of the published page on a phone", "ms", ""),
        ("phone-published-quarter", "the same with a processor slowed four times", "ms", ""),
        ("phone-published-sixth", "the same slowed six times", "ms", ""),
        ("phone-published-slow-4g", "slowed four times, over slow 4G", "ms", ""),
        ("phone-frames-per-second", "frames in a second, slowed four times", "", "the predecessor: 30; at least 60"),
        ("phone-script", "a frame at full speed: script", "ms", ""),
        ("phone-style", "style", "ms", ""),
        ("phone-layout", "layout", "ms", ""),
        ("phone-paint", "paint", "ms", ""),
        ("phone-commit", "commit", "ms", ""),
        ("phone-thread", "main thread altogether", "ms", ""),
    ];
    for (name, title, unit, aim) in aims {
        if let Some(value) = web.get(name) {
            row(title, *value, unit, aim);
        } else if name == "phone-published-full" {
            println!("{:<44} not measured: PUBLISHED must name the folder of {PUBLISHED_PAGE}", title);
        }
    }
    let found = found_ratios(&native, &web);
    if commit { ratios::commit(found) } else { ratios::compare(&found) }
}

/// Prints the speed of emitted code alone: that of the U-tube and of each document that ships.
pub fn emitted() -> Result<()> {
    let web = step("the pace of emitted code", || pace_in_wasm(tools::CHROMIUM.path().ok(), &[]))?;
    println!("load: {:.2}", ratios::load().unwrap_or(f64::NAN));
    pace("in WebAssembly", &web, "wasm-");
    emitted_rows(&web);
    systems("in WebAssembly", &web, [""; 3]);
    fits("in WebAssembly", &web);
    Ok(())
}

/// Ratios of two figures of the same run; more is faster.
fn found_ratios(native: &Numbers, web: &Numbers) -> Ratios {
    let mut found = Ratios::new();
    let places = [("natively", native, ""), ("in the browser", web, "wasm-")];
    for (place, numbers, prefix) in places {
        let mut keep = |name: &str, above: &str, below: &str| {
            if let (Some(above), Some(below)) = (numbers.get(above), numbers.get(below)) {
                found.insert(format!("{name} {place}"), above / below);
            }
        };
        keep("U-tube, interpreted to the best loop", &format!("{prefix}machine"), &format!("{prefix}best"));
        keep("U-tube, emitted to the best loop", &format!("{prefix}emitted"), &format!("{prefix}best"));
        keep(
            "64 U-tubes, emitted to the best loop for one",
            &format!("{prefix}side-by-side"),
            &format!("{prefix}best"),
        );
        for system in ["chain", "string", "gas"] {
            let [hand, machine] = ["hand", "machine"].map(|one| format!("{system}-{one}"));
            keep(&format!("{system}, interpreted to the loops by hand"), &hand, &machine);
            keep(&format!("system {system}, emitted to interpreted"), &machine, &format!("{system}-emitted"));
        }
        keep("fit of an equation of motion, emitted to interpreted", "fit-motion", "fit-motion-emitted");
    }
    for (name, features, _) in ENSEMBLES {
        if let (Some(lanes), Some(best)) = (native.get(name), native.get("lanes-best")) {
            found.insert(format!("64 U-tubes {features} to the best loop for one"), lanes / best);
        }
    }
    let emitted = web.iter().filter_map(|(name, times)| Some((name.strip_prefix("shipped-")?, times)));
    found.extend(emitted.map(|(document, times)| (format!("{document}, emitted to interpreted"), *times)));
    let lanes = web.iter().filter_map(|(name, times)| Some((name.strip_prefix("lanes-")?, times)));
    found.extend(
        lanes.map(|(document, times)| (format!("64 runs of {document} side by side to emitted ones alone"), *times)),
    );
    found
}

/// Prints the rate of steps in the virtual machine, in emitted code and in hand-written loops.
fn pace(place: &str, numbers: &Numbers, prefix: &str) {
    let number = |name: &str| numbers.get(&format!("{prefix}{name}"));
    if let (Some(machine), Some(hand), Some(best)) = (number("machine"), number("hand"), number("best")) {
        let unit = "million/s";
        row(&format!("RK4 steps of the U-tube {place}"), *machine, unit, "");
        row("the same loop in Rust", *hand, unit, "");
        row("with coefficients computed beforehand", *best, unit, "");
        row("ratio to that", machine / best, "", "at least 0.3 natively");
        if let Some(emitted) = number("emitted") {
            row("in emitted code", *emitted, unit, "");
            row("ratio of that", emitted / best, "", "at least 0.85");
        }
        if let Some(beside) = number("side-by-side") {
            row("64 of them side by side", *beside, "million/s", "");
            row("ratio of that", beside / best, "", "at least 4.1 in Chromium");
        }
    }
}

/// Ensembles of the U-tube on one core: number of the measurement, features, aim of the ratio to the best loop for one run.
const ENSEMBLES: [(&str, &str, &str); 3] = [
    ("lanes-least", "with SSE2", "at least 2.6"),
    ("lanes-avx2", "with AVX2", "at least 4.5"),
    ("lanes", "with all features", "at least 5.5 with AVX-512"),
];

/// Prints the rate of steps of 64 runs side by side, and the speed of sweeps.
fn ensembles(numbers: &Numbers) {
    let Some(best) = numbers.get("lanes-best") else { return };
    for (name, features, aim) in ENSEMBLES {
        if let Some(lanes) = numbers.get(name) {
            row(&format!("RK4 steps of 64 U-tubes {features}"), *lanes, "million/s", "");
            row("ratio to the best loop for one", lanes / best, "", aim);
        }
    }
    for (name, title, unit, aim) in [
        ("sweep-call", "sweep of 64 short runs, prepared", "us", "at most 30"),
        ("sweep-utube", "sweep of 64 U-tubes side by side", "times as fast", "as one by one"),
        ("sweep-bouncing-ball", "sweep of 64 bouncing balls", "times as fast", "as one by one"),
        ("fit-profiles", "profiles of a fit of a motion side by side", "times as fast", "as one by one; at least 2"),
        ("fit-records", "fit of a motion to 8 records side by side", "times as fast", "as one by one"),
    ] {
        if let Some(value) = numbers.get(name) {
            row(title, *value, unit, aim);
        }
    }
}

/// Prints how many times as fast the documents that ship are in emitted code.
fn emitted_rows(numbers: &Numbers) {
    for (name, times) in numbers {
        if let Some(document) = name.strip_prefix("shipped-") {
            let row_time = numbers.get(&format!("row-{document}")).copied().unwrap_or(f64::NAN);
            let aim = format!("at least 2; {row_time:.0} ns a row");
            row(&format!("{document} in emitted code"), *times, "times as fast", &aim);
        }
    }
    for (name, times) in numbers {
        if let Some(document) = name.strip_prefix("lanes-") {
            row(&format!("64 runs of {document} side by side"), *times, "times as fast as emitted runs alone", "");
        }
    }
}

/// Prints the time per step of systems of many equal parts, in the virtual machine and in hand-written loops.
fn systems(place: &str, numbers: &Numbers, aims: [&str; 3]) {
    const SYSTEMS: [(&str, &str, &str); 3] = [
        ("chain", "chain of 200 masses", "at most 3"),
        ("string", "string of 1,000 points", ""),
        ("gas", "gas of 100 discs", ""),
    ];
    for ((name, title, ratio), aim) in SYSTEMS.into_iter().zip(aims) {
        let (machine, hand) = (numbers.get(&format!("{name}-machine")), numbers.get(&format!("{name}-hand")));
        if let (Some(machine), Some(hand)) = (machine, hand) {
            row(&format!("RK4 step of a {title} {place}"), *machine, "us", aim);
            row("steps of it in a second", 1e6 / machine, "", "");
            row("a step of the same loops in Rust", *hand, "us", "");
            row("the ratio of the times", machine / hand, "", ratio);
            if let Some(emitted) = numbers.get(&format!("{name}-emitted")) {
                row("a step in emitted code", *emitted, "us", "");
                row("ratio to the interpreted one", machine / emitted, "times as fast", "at least 3");
            }
        }
    }
}

/// Prints the time of fits of one record, including the estimate of the start.
fn fits(place: &str, numbers: &Numbers) {
    for (name, title, aim) in [
        ("fit-formula", "fit of a damped cosine", "at most 0.3; SciPy's curve_fit 1.7, lmfit 7"),
        ("fit-motion", "fit of its equation of motion", "at most 10; solve_ivp with least_squares 1900"),
        ("fit-motion-emitted", "the same in emitted code", ""),
    ] {
        if let Some(milliseconds) = numbers.get(name) {
            row(&format!("{title} {place}"), *milliseconds, "ms", aim);
        }
    }
}

fn row(title: &str, value: f64, unit: &str, aim: &str) {
    let aim = if aim.is_empty() { String::new() } else { format!("({aim})") };
    println!("{}", format!("{title:<44}{value:>10.2} {unit:<15}{aim}").trim_end());
}

fn native() -> Result<Numbers> {
    const EXAMPLES: [(&str, &str); 7] = [
        ("probe", "pace"),
        ("probe", "ensembles"),
        ("runner", "sweeps"),
        ("runner", "fits"),
        ("probe", "systems"),
        ("probe", "fits"),
        ("analysis", "import_rows"),
    ];
    let mut all = Numbers::new();
    for (package, example) in EXAMPLES {
        let arguments = ["run", "--release", "--quiet", "--package", package, "--example", example];
        all.extend(numbers(&steps::output(&mut cargo(&arguments))?));
    }
    Ok(all)
}

/// Path of the exported U-tube.
fn exported() -> std::path::PathBuf {
    steps::page().with_file_name("utube.html")
}

/// Folder of the exported pages of the chain and the string.
fn profiles() -> std::path::PathBuf {
    steps::page().with_file_name("profiles")
}

fn export() -> Result<()> {
    std::fs::create_dir_all(profiles())?;
    let export = |document: &std::path::Path, page: &std::path::Path| {
        let mut export = cargo(&["run", "--release", "--quiet", "--package", "meniscus", "--", "export"]);
        steps::run(export.arg(document).arg("--output").arg(page))
    };
    export(&steps::root().join("simulations").join("utube.md"), &exported())?;
    for name in ["chain", "string"] {
        let document = steps::root().join("crates/probe/systems").join(name).with_extension("md");
        export(&document, &profiles().join(name).with_extension("html"))?;
    }
    Ok(())
}

/// The pace in WebAssembly, and the measurements of the pages.
fn in_wasm(browser: Option<std::path::PathBuf>) -> Result<Numbers> {
    pace_in_wasm(browser, &[("PAGE", steps::page()), ("EXPORTED", exported()), ("PROFILES", profiles())])
}

/// Runs `measure.mjs` with these variables, in a browser or in Node.
fn pace_in_wasm(browser: Option<std::path::PathBuf>, pages: &[(&str, std::path::PathBuf)]) -> Result<Numbers> {
    let probe = steps::target().join("probe").join("page");
    wasm::build()?;
    wasm::bind(&wasm::module("probe"), Host::Page("wasm_bindgen"), &probe)?;
    let script = steps::root().join("tests").join("page").join("measure.mjs");
    let mut measure = steps::program(tools::node()?, &[]);
    measure.arg(script).env("PROBE", probe).env_remove("PAGE").envs(pages.iter().map(|(name, path)| (name, path)));
    if let Some(folder) = std::env::var_os("PUBLISHED") {
        measure.env("PUBLISHED_PAGE", std::path::Path::new(&folder).join(PUBLISHED_PAGE));
    }
    measure.env_remove("CHROME");
    if let Some(browser) = browser {
        tools::packages(&steps::root().join("tests").join("page"))?;
        measure.env("CHROME", browser);
    }
    let text = steps::output(&mut measure)?;
    text.lines()
        .filter(|line| line.starts_with("interpreted: ") || line.starts_with("one by one: "))
        .for_each(|line| println!("{line}"));
    Ok(numbers(&text))
}

/// Parses lines of `name value`.
fn numbers(text: &str) -> Numbers {
    let number = |line: &str| {
        let (name, value) = line.split_once(' ')?;
        Some((name.to_owned(), value.trim().parse().ok()?))
    };
    text.lines().filter_map(number).collect()
}

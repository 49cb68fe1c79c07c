//! Ratios of a measurement, and those that are committed for processors with the same features: a ratio of two times in one run
//! depends little on the machine.

use crate::steps;
use anyhow::{Context, Result};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Named ratios; more is faster.
pub type Ratios = BTreeMap<String, f64>;

/// Part of the committed ratio below which a ratio is named.
const LEAST: f64 = 0.8;

/// Features of the processor on which vectorised code depends, in one word.
pub fn features() -> String {
    #[cfg(target_arch = "x86_64")]
    let found = [
        ("sse4.2", is_x86_feature_detected!("sse4.2")),
        ("avx2", is_x86_feature_detected!("avx2")),
        ("fma", is_x86_feature_detected!("fma")),
        ("avx512f", is_x86_feature_detected!("avx512f")),
    ];
    #[cfg(not(target_arch = "x86_64"))]
    let found: [(&str, bool); 0] = [];
    let names = found.iter().filter(|(_, has)| *has).map(|(name, _)| *name);
    [std::env::consts::ARCH].into_iter().chain(names).collect::<Vec<_>>().join("+")
}

/// Load of the machine: number of running programs in the last minute; `None` where the system does not tell.
pub fn load() -> Option<f64> {
    std::fs::read_to_string("/proc/loadavg").ok()?.split(' ').next()?.parse().ok()
}

fn path() -> std::path::PathBuf {
    steps::root().join("xtask").join("ratios.txt")
}

/// Prints each ratio that is more than a fifth below the committed one.
pub fn compare(found: &Ratios) -> Result<()> {
    let text = std::fs::read_to_string(path()).context("cannot read xtask/ratios.txt")?;
    let features = features();
    let committed = read(&text).remove(&features);
    match committed {
        None => println!("no ratios are committed for {features}: `cargo xtask bench commit` writes them"),
        Some(committed) => below(found, &committed).iter().for_each(|line| println!("{line}")),
    }
    Ok(())
}

/// Writes the ratios as those of this processor. Ratios of other processors stay.
pub fn commit(found: Ratios) -> Result<()> {
    let text = std::fs::read_to_string(path()).unwrap_or_default();
    let mut all = read(&text);
    all.insert(features(), found);
    std::fs::write(path(), written(&all)).context("cannot write xtask/ratios.txt")
}

/// Sentences about the ratios that are missing or too small.
fn below(found: &Ratios, committed: &Ratios) -> Vec<String> {
    let sentence = |(name, before): (&String, &f64)| match found.get(name) {
        None => Some(format!("NOT MEASURED: {name} (committed {before:.2})")),
        Some(now) if *now < LEAST * before => Some(format!("SLOWER: {name} {now:.2} (committed {before:.2})")),
        Some(_) => None,
    };
    committed.iter().filter_map(sentence).collect()
}

/// Ratios by processor. A line without an indent names the features, an indented one a ratio and its value.
fn read(text: &str) -> BTreeMap<String, Ratios> {
    let mut all: BTreeMap<String, Ratios> = BTreeMap::new();
    let mut features = String::new();
    for line in text.lines() {
        match line.strip_prefix("  ").and_then(|line| line.rsplit_once(' ')) {
            Some((name, value)) => {
                if let Ok(value) = value.parse() {
                    all.entry(features.clone()).or_default().insert(name.trim().to_owned(), value);
                }
            }
            None => line.clone_into(&mut features),
        }
    }
    all
}

fn written(all: &BTreeMap<String, Ratios>) -> String {
    let mut text = String::new();
    for (features, ratios) in all {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{features}");
        for (name, value) in ratios {
            let _ = writeln!(text, "  {name} {value:.3}");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{Ratios, below, read, written};
    use std::collections::BTreeMap;

    fn ratios(all: &[(&str, f64)]) -> Ratios {
        all.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect()
    }

    #[test]
    fn ratios_are_read_as_they_are_written() {
        let all: BTreeMap<String, Ratios> = [
            ("x86_64+avx2".to_owned(), ratios(&[("RK4 steps of the U-tube natively", 0.21), ("the gas", 3.125)])),
            ("aarch64".to_owned(), ratios(&[("the gas", 2.0)])),
        ]
        .into();
        assert_eq!(read(&written(&all)), all);
    }

    #[test]
    fn what_is_a_fifth_slower_or_missing_is_named() {
        let committed = ratios(&[("equal", 1.0), ("a little slower", 1.0), ("slower", 1.0), ("missing", 1.0)]);
        let found = ratios(&[("equal", 1.0), ("a little slower", 0.81), ("slower", 0.79), ("new", 0.1)]);
        assert_eq!(
            below(&found, &committed),
            ["NOT MEASURED: missing (committed 1.00)", "SLOWER: slower 0.79 (committed 1.00)"]
        );
    }
}

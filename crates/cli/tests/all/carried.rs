//! Reports of the program carry their data, hold when they are verified, and a change in them is found at its place.

use crate::common::meniscus;
use serde_json::Value;
use std::path::{Path, PathBuf};

const SECTION: &str = "<section id=\"hand-in\">";

fn theory(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../simulations/theories").join(name);
    path.to_str().unwrap().to_owned()
}

/// A swinging column with noise, in a file of this name.
fn data(folder: &Path, name: &str, seed: u64) -> PathBuf {
    let mut state = seed;
    let mut noise = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let row = |index: u32| {
        let time = f64::from(index) / 30.0;
        let level = 0.04 * libm::exp(-0.42 * time) * libm::cos(10.4 * time) + 1e-3 * noise();
        format!("{time:.4},{level:.5},{:.5}\n", 3e-4 + 1e-4 * noise().abs())
    };
    let path = folder.join(name);
    let text: String = std::iter::once("t [s],y [m],e [m]\n".to_owned()).chain((0..120).map(row)).collect();
    std::fs::write(&path, text).unwrap();
    path
}

/// Exit code, and the result for the only file.
fn verified(path: &Path) -> (i32, Value) {
    let done = meniscus(&["verify", path.to_str().unwrap(), "--format", "json"]);
    let found: Value = serde_json::from_str(&done.stdout).unwrap();
    (done.code, found["hand_ins"][0].clone())
}

/// Reports of `fit` and `rank` with each kind of option.
fn reports(folder: &Path) -> Vec<(&'static str, PathBuf)> {
    let [one, two] = [("one.csv", 1), ("two.csv", 2)].map(|(name, seed)| data(folder, name, seed));
    let [one, two] = [&one, &two].map(|path| path.to_str().unwrap());
    let (linear, quadratic) = (theory("linear.md"), theory("quadratic.md"));
    let fits: [(&str, Vec<&str>); 8] = [
        ("plain", vec!["fit", &linear, one]),
        ("profile", vec!["fit", &linear, one, "--profile"]),
        ("error", vec!["fit", &linear, one, "--error", "y=0.3 [mm]", "--from", "0.5", "--until", "3"]),
        ("errors", vec!["fit", &linear, one, "--error", "y=e"]),
        ("bounds", vec!["fit", &linear, one, "--bounds", "gamma=0..0.3", "--start", "gamma=0.1"]),
        ("loss", vec!["fit", &linear, one, "--loss", "tukey", "--fix", "L=0.18 [m]", "--unit", "y=m"]),
        ("several", vec!["fit", &linear, one, two, "--share", "gamma"]),
        ("rank", vec!["rank", one, "--model", &linear, "--model", &quadratic, "--predict-from", "2"]),
    ];
    let made = fits.into_iter().map(|(name, words)| {
        let path = folder.join(format!("{name}.html"));
        let done = meniscus(&[&words[..], &["--observe", "y=2", "--output", path.to_str().unwrap()]].concat());
        assert_eq!(done.code, 0, "{name}: {}", done.stderr);
        (name, path)
    });
    made.collect()
}

#[test]
fn reports_of_fits_hold_and_a_change_is_found_in_its_section() {
    let folder = tempfile::tempdir().unwrap();
    for (name, path) in reports(folder.path()) {
        let page = std::fs::read_to_string(&path).unwrap();
        let begin = page.find(SECTION).unwrap();
        println!("{name}: {} bytes, {} of them for the data", page.len(), page.len() - without(&page).len());
        assert!(page[begin..].contains("meniscus verify") && page[begin..].contains("download"), "{name}");
        assert!(!page.contains("<script"), "{name}");
        let (code, found) = verified(&path);
        assert_eq!((code, &found["holds"]), (0, &true.into()), "{name}: {found:#}");
        assert!(found["equal"].as_u64().unwrap() > 40, "{name}");
        // A digit of the visible results.
        let results = page.find("<td class=\"n\">").unwrap();
        let after = page[results + 14..].find(|c: char| c.is_ascii_digit()).unwrap() + results + 14;
        let other = if &page[after..=after] == "7" { "3" } else { "7" };
        std::fs::write(&path, [&page[..after], other, &page[after + 1..]].concat()).unwrap();
        let (code, found) = verified(&path);
        assert_eq!((code, found["differences"].as_array().map(Vec::len)), (1, Some(1)), "{name}: {found:#}");
        assert_eq!(found["differences"][0]["part"], "report", "{name}: {found:#}");
        let cut = &page[..begin + SECTION.len() + 2000];
        std::fs::write(&path, cut).unwrap();
        assert_eq!(verified(&path).0, 1, "{name}, cut");
    }
}

/// A page without the section with its data.
fn without(page: &str) -> String {
    let begin = page.find(SECTION).unwrap();
    let end = begin + page[begin..].find("</section>\n").unwrap();
    [&page[..begin], &page[end..]].concat()
}

#[test]
fn a_page_without_data_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = data(folder.path(), "one.csv", 1);
    let page = folder.path().join("squared.html");
    let words =
        ["fit", &theory("linear.md"), path.to_str().unwrap(), "--observe", "2*y=2", "--output", page.to_str().unwrap()];
    let done = meniscus(&words);
    assert_eq!(done.code, 0, "{}", done.stderr);
    let text = std::fs::read_to_string(&page).unwrap();
    let why = "cannot be verified: the fit uses an expression or an option that a hand-in cannot state.";
    assert!(text.contains(why), "{}", text.rsplit("To verify this").next().unwrap_or_default());
    let (code, found) = verified(&page);
    assert_eq!((code, &found["unreadable"]), (1, &"is a page without the data of a hand-in".into()));
    // In a folder other pages are no hand-ins.
    let folder_name = folder.path().to_str().unwrap();
    let done = meniscus(&["verify", folder_name]);
    assert!(done.code == 2 && done.stderr.contains("has no hand-ins"), "{}", done.stderr);
}

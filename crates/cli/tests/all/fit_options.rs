//! Options of `meniscus fit` and `meniscus rank` that are refused, and the messages.

use crate::common::meniscus;
use crate::fit::{COSINE, LINEAR, record, word};

/// Options without effect, or with another effect than stated, are refused.
#[test]
fn options_without_effect_are_refused() {
    let directory = tempfile::tempdir().unwrap();
    let data = record(directory.path(), "run.txt", 0.4, 0.1);
    let cases: [(&[&str], &str); 3] = [
        (&["--share", "gamma"], "--share gamma: there is only one record"),
        (&["--start", "gamma=-3", "--bounds", "gamma=0..2"], "--start gamma=-3 lies outside the range"),
        (&["--start", "gamma=3", "--bounds", "gamma=0..2"], "--start gamma=3 lies outside the range"),
    ];
    for (words, expected) in cases {
        let done = meniscus(&[&["fit", COSINE, word(&data), "--observe", "y"], words].concat());
        assert!(done.code == 2 && done.stderr.contains(expected), "{}", done.stderr);
    }
    let words = ["rank", word(&data), "--model", COSINE, "--model", LINEAR, "--observe", "y", "--predict-from", "9"];
    let done = meniscus(&words);
    assert!(done.code == 2 && done.stderr.contains("no value is measured from there on"), "{}", done.stderr);
}

#[test]
fn profiles_say_what_they_suppose() {
    let directory = tempfile::tempdir().unwrap();
    let data = record(directory.path(), "run.txt", 0.4, 0.1);
    let out = meniscus(&["fit", COSINE, word(&data), "--observe", "y", "--profile"]).stdout;
    assert!(out.contains("from the profile of chi-square, for independent residuals"), "{out}");
}

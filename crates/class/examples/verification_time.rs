//! Time for the verification of a class: `cargo run --release -p class --example verification_time -- 120`. Makes that many hand-ins
//! and reports in turn, then opens, computes and compares them, and looks for shared data among all.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "an example prints, and stops at an error")]

#[path = "../tests/all/support.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod support;

use class::verify::{Curve, copies, verify};
use saved::hand_in::HandIn;
use std::time::Instant;
use support::{handed, measured, report, with_film};

fn main() {
    let count: u64 = std::env::args().nth(1).and_then(|count| count.parse().ok()).unwrap_or(120);
    let make = |case: u64| {
        let rows = measured(case);
        if case.is_multiple_of(2) { report(&rows) } else { with_film(handed(&rows, "group"), &rows).write() }
    };
    let files: Vec<String> = (0..count).map(make).collect();
    let begin = Instant::now();
    let opened: Vec<HandIn> = files.iter().map(|file| HandIn::open(file.as_bytes()).unwrap()).collect();
    let held = opened.iter().filter(|one| verify(one).unwrap().holds()).count();
    let verified = begin.elapsed();
    let curves: Vec<Curve> = opened.iter().enumerate().flat_map(|(index, one)| Curve::of(index, one)).collect();
    let found = copies(&curves).len();
    let all = begin.elapsed();
    println!(
        "{held} of {count} hold; {found} shared columns among {} pairs of columns",
        curves.len() * (curves.len().max(1) - 1) / 2
    );
    println!("{:.2} s to verify, {:.2} s with the search for shared data", verified.as_secs_f64(), all.as_secs_f64());
}

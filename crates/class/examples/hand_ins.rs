//! Makes the hand-ins of a class that measured the same column, for trying the dashboard and `meniscus class report`:
//! `cargo run -p class --example hand_ins -- FOLDER COUNT ROWS`. One in ten has taken half the times, so that its results are far
//! from the others. Without further arguments 10 hand-ins with 90 rows in 3 s are made.

#![allow(clippy::unwrap_used, clippy::print_stdout, reason = "an example prints, and stops at an error")]

#[path = "../tests/all/support.rs"]
#[allow(dead_code, reason = "the tests use more of it")]
mod support;

use class::verify::hand_in;
use saved::hand_in::Sender;
use std::path::Path;
use support::{answered, sampled};

const ANSWERS: [&[&str]; 5] = [&["0.42"], &["4.2", "0.42"], &["-0.42"], &["7", "8", "9"], &[]];

fn main() {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().unwrap_or_default();
    let count: u64 = arguments.next().and_then(|count| count.parse().ok()).unwrap_or(10);
    let rows: u32 = arguments.next().and_then(|rows| rows.parse().ok()).unwrap_or(90);
    std::fs::create_dir_all(&folder).unwrap();
    for seed in 1..=count {
        let factor = if seed.is_multiple_of(10) { 0.5 } else { 1.0 };
        let columns = sampled(seed, rows, f64::from(rows) / 3.0).into_iter();
        let columns: Vec<(f64, f64)> = columns.map(|(time, level)| (factor * time, level)).collect();
        let work = answered(&columns, ANSWERS[(seed % 5) as usize]);
        let sender = Sender { name: format!("group {seed}"), seat: Some(seed as u32), ..Sender::default() };
        let made = hand_in(work, sender, 1_763_812_900_000).unwrap();
        std::fs::write(Path::new(&folder).join(format!("group-{seed}.hand-in")), made.write()).unwrap();
    }
    println!("{count} hand-ins in {folder}");
}

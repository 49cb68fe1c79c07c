//! Prints how many times as fast fits of the linear equation of motion are with solutions side by side as one after the other, on one
//! thread: of eight records, `fit-records 2.3`, and the profiles of all numbers of one, `fit-profiles 3.4`.

#[path = "../tests/support/records.rs"]
mod records;

use analysis::fit::{Fit, Task, profiles};
use document::Document;
use records::task;
use runner::fitting::lanes;
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 5;
const RECORDS: usize = 8;
/// Frames of the first record, 30 in a second.
const FRAMES: usize = 207;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // One thread: the other processors may be busy.
    runner::use_threads(1);
    let opened = document::open(include_str!("../../../simulations/theories/linear.md"), &[]);
    let document = opened.document.ok_or("the document has errors")?;
    for (name, records) in [("fit-records", RECORDS), ("fit-profiles", 1)] {
        let task = task(&document, records, FRAMES)?;
        let mut times = [f64::INFINITY; 2];
        for _ in 0..ROUNDS {
            for (side_by_side, least) in [false, true].into_iter().zip(&mut times) {
                *least = least.min(seconds(&document, &task, side_by_side)?);
            }
        }
        let [alone, together] = times;
        println!("{name} {:.2}", alone / together);
    }
    Ok(())
}

/// Duration of a fit of several records, or of the profiles of a fitted record, s.
fn seconds(document: &Document, task: &Task, side_by_side: bool) -> Result<f64, String> {
    let begun = Instant::now();
    let mut fit = Fit::new(&document.program.model, task.clone()).map_err(|error| error.to_string())?;
    if side_by_side {
        fit.use_lanes(lanes);
    }
    fit.complete();
    let mut outcome = fit.outcome().ok_or("no end")?;
    if task.records.len() > 1 {
        return Ok(begun.elapsed().as_secs_f64());
    }
    let fitted = Instant::now();
    black_box(profiles(&mut fit, &mut outcome));
    Ok(fitted.elapsed().as_secs_f64())
}

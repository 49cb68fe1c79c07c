//! Fits whose equations of motion are solved side by side have the bits of fits that solve them one after the other.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[path = "support/records.rs"]
mod records;

use analysis::fit::{Fit, profiles};
use document::Document;
use records::task;
use runner::fitting::lanes;

/// Frames of the first record.
const FRAMES: usize = 40;

/// Theories of the level in a U-tube, and numbers of records of which fits are compared; none if solutions are not computed side by
/// side.
const THEORIES: [(&str, &[usize]); 3] = [
    (include_str!("../../../simulations/theories/linear.md"), &[1, 3]),
    (include_str!("../../../simulations/theories/linear-contact-line.md"), &[2]),
    (include_str!("../../../simulations/theories/dry-friction.md"), &[]),
];

/// Result and profiles of a fit.
fn fitted(document: &Document, records: usize, side_by_side: bool) -> String {
    let mut fit = Fit::new(&document.program.model, task(document, records, FRAMES).unwrap()).unwrap();
    if side_by_side {
        fit.use_lanes(lanes);
    }
    fit.complete();
    let mut outcome = fit.outcome().unwrap();
    let intervals = if records == 1 { profiles(&mut fit, &mut outcome) } else { Vec::new() };
    format!("{} trials, {outcome:?}, {intervals:?}", fit.trials())
}

#[test]
fn fits_have_the_bits_of_fits_one_after_the_other() {
    for (text, records) in THEORIES {
        let document = document::open(text, &[]).document.unwrap();
        let title = &document.program.title;
        let mut has = false;
        Fit::new(&document.program.model, task(&document, 1, FRAMES).unwrap()).unwrap().use_lanes(
            |model, setup, readings| {
                let made = lanes(model, setup, readings);
                has = made.is_some();
                made
            },
        );
        assert_eq!(has, !records.is_empty(), "{title}");
        for &records in records {
            assert_eq!(
                fitted(&document, records, true),
                fitted(&document, records, false),
                "{title}, {records} records"
            );
        }
    }
}

//! Fits whose equations of motion are solved side by side have the bits of fits that solve them one after the other.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use analysis::fit::{Fit, Observation, Record, Task, Varied, profiles};
use document::Document;
use runner::fitting::lanes;

/// Theories of the level in a U-tube, and numbers of records of which fits are compared; none if solutions are not computed side by
/// side.
const THEORIES: [(&str, &[usize]); 3] = [
    (include_str!("../../../simulations/theories/linear.md"), &[1, 3]),
    (include_str!("../../../simulations/theories/linear-contact-line.md"), &[2]),
    (include_str!("../../../simulations/theories/dry-friction.md"), &[]),
];

/// Records of damped oscillations with noise of 0.1 mm, of different lengths.
fn task(document: &Document, records: usize) -> Task {
    let model = &document.program.model;
    let observed = model.lookup("y", 0).unwrap();
    let record = |number: usize| {
        let times: Vec<f64> = (0..40 + 7 * number).map(|row| 0.4 * number as f64 + row as f64 / 30.0).collect();
        let level = |(row, time): (usize, &f64)| {
            let since = time - times[0];
            let noise = 1e-4 * libm::sin((37 * row * row + 11 * number) as f64);
            0.05 * libm::exp(-0.4 * since) * libm::cos((9.6 + 0.1 * number as f64) * since) + noise
        };
        let values = times.iter().enumerate().map(level).collect();
        let observation = Observation {
            name: "y".to_owned(),
            observed: observed.clone(),
            times: times.clone(),
            values,
            errors: None,
            derived_from: None,
        };
        Record { name: format!("record {number}"), observations: vec![observation], ..Record::default() }
    };
    let varied = document.program.vary.iter().enumerate();
    Task {
        parameters: model.parameters.iter().map(|parameter| parameter.value).collect(),
        records: (0..records).map(record).collect(),
        varied: varied.map(|(place, &index)| Varied { shared: place > 2, ..Varied::parameter(index) }).collect(),
        ..Task::default()
    }
}

/// Result and profiles of a fit.
fn fitted(document: &Document, records: usize, side_by_side: bool) -> String {
    let mut fit = Fit::new(&document.program.model, task(document, records)).unwrap();
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
        Fit::new(&document.program.model, task(&document, 1)).unwrap().use_lanes(|model, setup, readings| {
            let made = lanes(model, setup, readings);
            has = made.is_some();
            made
        });
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

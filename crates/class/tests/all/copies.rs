//! Shared data: copies through transformations without noise are found, independent measurements are not taken for copies.

use crate::support::{Noise, file, measured};
use class::verify::{Copied, Curve, Relation, copies};
use document::page::Source;
use saved::Item;
use saved::format::{Content, Record};
use saved::hand_in::HandIn;
use saved::project::Project;

pub type Rows = Vec<(f64, f64)>;

fn hand_in(rows: &[(f64, f64)], is_simulated: bool) -> HandIn {
    let truth = is_simulated.then(Vec::new);
    let record = Record { name: "tube.csv".to_owned(), text: file(rows), truth, ..Record::default() };
    let documents = vec![Source { name: "a.md".to_owned(), text: String::new() }];
    let items = vec![("r".to_owned(), Item(Content::Record(record)).write(0))];
    HandIn { work: Project { documents, items, ..Project::default() }, ..HandIn::default() }
}

fn found(one: &[(f64, f64)], other: &[(f64, f64)]) -> Vec<Copied> {
    let curves = [hand_in(one, false), hand_in(other, false)];
    copies(&curves.iter().enumerate().flat_map(|(index, one)| Curve::of(index, one)).collect::<Vec<_>>())
}

/// Name, relation, and the rows made from others.
pub type Transformation = (&'static str, Relation, fn(&Rows) -> Rows);

/// Transformations without noise, with the relation that they are to be found by.
pub fn transformations() -> Vec<Transformation> {
    vec![
        ("equal", Relation::Equal, |rows| rows.clone()),
        ("later", Relation::Equal, |rows| rows.iter().map(|(time, level)| (time + 3.0, *level)).collect()),
        ("shifted", Relation::Scaled, |rows| rows.iter().map(|(time, level)| (*time, level + 0.017)).collect()),
        ("in other units", Relation::Scaled, |rows| rows.iter().map(|(time, level)| (*time, level * 100.0)).collect()),
        ("upside down", Relation::Scaled, |rows| rows.iter().map(|(time, level)| (*time, 0.3 - 1.1 * level)).collect()),
        ("the beginning left out", Relation::Part, |rows| rows[20..].to_vec()),
        ("the end left out, scaled", Relation::Part, |rows| {
            rows[..60].iter().map(|(time, level)| (*time, level * 1.05)).collect()
        }),
        ("every third row", Relation::Part, |rows| rows.iter().skip(1).step_by(3).copied().collect()),
        ("with other times", Relation::Equal, |rows| rows.iter().map(|(time, level)| (time * 1.07, *level)).collect()),
        ("with other times, thinned and scaled", Relation::Part, |rows| {
            rows.iter().step_by(2).map(|(time, level)| (time * 0.9, level * 2.0)).collect()
        }),
        ("with other times, resampled", Relation::Resampled, |rows| resampled(rows, 0.05, 0.041, 1.07)),
        ("slower, upside down, resampled", Relation::Resampled, |rows| {
            let rows = resampled(rows, 0.3, 0.037, 1.9);
            rows.iter().map(|(time, level)| (time + 2.0, 0.1 - 3.0 * level)).collect()
        }),
        ("resampled", Relation::Resampled, |rows| resampled(rows, 0.05, 0.041, 1.0)),
    ]
}

/// Sixty rows from `begin` on, each `step` after the one before, by linear interpolation; the times multiplied by `scale`.
fn resampled(rows: &Rows, begin: f64, step: f64, scale: f64) -> Rows {
    let at = |index: usize| {
        let time = begin + index as f64 * step;
        let place = time * 30.0;
        let (before, part) = (place as usize, place.fract());
        (time * scale, rows[before].1 * (1.0 - part) + rows[before + 1].1 * part)
    };
    (0..60).map(at).collect()
}

#[test]
fn copies_are_found_with_their_relation() {
    for seed in 0..20 {
        let rows = measured(seed);
        for (name, relation, transform) in transformations() {
            let found = found(&rows, &transform(&rows));
            assert_eq!(found.iter().map(|one| one.relation).collect::<Vec<_>>(), [relation], "{name}, seed {seed}");
            assert!(!found[0].is_common_source);
        }
    }
}

/// Forty groups measure the same tube, started in the same way, with different noise.
#[test]
fn independent_measurements_are_no_copies() {
    for noise in [1e-4, 5e-4, 2e-3] {
        let group = |seed: u64| -> Rows {
            let mut own = Noise::new(1000 + seed);
            measured(0)
                .iter()
                .map(|(time, _)| {
                    let swing = 0.04 * libm::exp(-0.42 * time) * libm::cos(10.4 * time);
                    (*time, swing + noise * own.normal())
                })
                .collect()
        };
        let curves: Vec<Curve> =
            (0..40).flat_map(|index| Curve::of(index, &hand_in(&group(index as u64), false))).collect();
        let found = copies(&curves);
        assert!(found.is_empty(), "{noise}: {} of 780 pairs", found.len());
    }
}

#[test]
fn simulated_records_are_a_common_source() {
    let rows = measured(7);
    let curves: Vec<Curve> = [hand_in(&rows, true), hand_in(&rows, true), hand_in(&rows, false)]
        .iter()
        .enumerate()
        .flat_map(|(index, one)| Curve::of(index, one))
        .collect();
    let common: Vec<bool> = copies(&curves).iter().map(|one| one.is_common_source).collect();
    assert_eq!(common, [true, false, false]);
}

//! Files of measuring instruments in many variants: separators, decimal signs, numbers of channels, units and header lines.

use crate::support::instruments::{Variant, variants};
use analysis::import;
use units::{Language, Unit};

/// Difference from what a person reads; `None` without one.
fn difference(variant: &Variant, text: &str) -> Result<Option<String>, String> {
    let import = import::text(text.as_bytes()).map_err(|error| error.message(Language::English))?;
    let columns = &import.table.columns;
    if columns.len() != variant.columns.len() {
        let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
        return Ok(Some(format!("{} columns: {names:?}", columns.len())));
    }
    for (place, (column, (name, unit, values))) in columns.iter().zip(&variant.columns).enumerate() {
        if column.name != *name {
            return Ok(Some(format!("name {:?} for {name:?}", column.name)));
        }
        let wanted = Unit::parse(unit).ok().filter(|_| !unit.is_empty());
        let same = match (&column.unit, &wanted) {
            (Some(own), Some(wanted)) => own.dimension == wanted.dimension && own.factor == wanted.factor,
            (own, wanted) => own.is_none() && wanted.is_none(),
        };
        if !same {
            return Ok(Some(format!("unit {:?} of {name} for {unit}", column.unit.as_ref().map(|unit| &unit.text))));
        }
        if column.independent != 0 {
            return Ok(Some(format!("{name} is measured against column {}", column.independent)));
        }
        let span = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let close = |(own, wanted): (&f64, &f64)| (own - wanted).abs() <= 1e-9 * span;
        if column.values.len() != values.len() || !column.values.iter().zip(values).all(close) {
            return Ok(Some(format!("column {place}: {:?} for {:?}", &column.values[..4], &values[..4])));
        }
    }
    Ok(None)
}

#[test]
fn instruments_are_read_as_a_person_reads_them() {
    let all = variants();
    assert!(all.len() >= 100, "{}", all.len());
    let mut wrong = Vec::new();
    let mut refused = Vec::new();
    for variant in &all {
        // As written on Windows, and with the mark of UTF-8, each file is the same.
        for text in [variant.text.clone(), format!("\u{feff}{}", variant.text.replace('\n', "\r\n"))] {
            match difference(variant, &text) {
                Ok(None) => {}
                Ok(Some(difference)) => wrong.push(format!("{}: {difference}", variant.name)),
                Err(error) => refused.push(format!("{}: {error}", variant.name)),
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {} wrong:\n{}", wrong.len(), 2 * all.len(), wrong.join("\n"));
    assert!(refused.is_empty(), "{} of {} refused:\n{}", refused.len(), 2 * all.len(), refused.join("\n"));
}

#[test]
fn a_file_of_an_instrument_is_the_same_in_slices() {
    for variant in variants() {
        let whole = import::text(variant.text.as_bytes()).expect("a table");
        let mut importer = import::Importer::new(variant.text.as_str().into()).expect("a table");
        while !importer.advance(100) {}
        let (sliced, text) = importer.finish().expect("a table");
        // Cells without a number are NaN, which equals nothing.
        assert_eq!(format!("{sliced:?}"), format!("{whole:?}"), "{}", variant.name);
        assert_eq!(text, variant.text, "{}", variant.name);
    }
}

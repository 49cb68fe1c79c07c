//! Percentages in workbooks: the displayed value is used, whatever the heading.

use crate::support::old_workbook::{Cell, OldWorkbook};
use crate::support::packed::{ods, xlsx};
use analysis::import;
use analysis::reading::{self, Reading};

const MOST: usize = 1 << 20;
/// Headings of a column of percentages, and a factor for plain numbers below them.
const HEADINGS: [(&str, f64); 6] =
    [("eff (%)", 0.01), ("eff [%]", 0.01), ("eff / %", 0.01), ("eff in %", 0.01), ("eff_%", 0.01), ("eff", 1.0)];
/// Fractions of 1 in the cells, from a thousandth to a hundredfold.
const FRACTIONS: [f64; 5] = [0.05, 0.0525, 0.29, 1.0, 12.5];

/// File in each of the three formats: a column of times and one of fractions, each shown as a percentage or as a plain
/// number.
fn files(heading: &str, cells: &[(f64, bool)]) -> [Vec<u8>; 3] {
    let text = |reference: &str, text: &str| format!(r#"<c r="{reference}" t="inlineStr"><is><t>{text}</t></is></c>"#);
    let mut rows = format!(r#"<row r="1">{}{}</row>"#, text("A1", "t [s]"), text("B1", heading));
    let word = |text: &str| {
        format!(r#"<table:table-cell office:value-type="string"><text:p>{text}</text:p></table:table-cell>"#)
    };
    let mut lines = format!("<table:table-row>{}{}</table:table-row>", word("t [s]"), word(heading));
    let heading: &'static str = heading.to_owned().leak();
    let mut old = vec![(0, 0, Cell::Label("t [s]")), (0, 1, Cell::Label(heading))];
    for (index, (value, percent)) in cells.iter().enumerate() {
        let row = index + 2;
        // Style 3 of these workbooks is 0.00 %.
        let style = if *percent { r#" s="3""# } else { "" };
        rows += &format!(
            r#"<row r="{row}"><c r="A{row}"><v>{index}</v></c><c r="B{row}"{style}><v>{value:?}</v></c></row>"#
        );
        let kind = if *percent { "percentage" } else { "float" };
        lines += &format!(
            r#"<table:table-row><table:table-cell office:value-type="float" office:value="{index}"/><table:table-cell office:value-type="{kind}" office:value="{value:?}"/></table:table-row>"#
        );
        let row = index as u16 + 1;
        old.push((row, 0, Cell::Number(index as f64)));
        old.push((row, 1, Cell::Formatted(*value, if *percent { 1 } else { 0 })));
    }
    let old = OldWorkbook { sheets: vec![("Film", old)], ..OldWorkbook::default() };
    [xlsx(&[("Film", &rows)]), ods(&[("Film", &lines)]), old.bytes()]
}

/// Second column in SI, from the file and from its text read again.
fn values(form: usize, bytes: Vec<u8>) -> (Vec<f64>, Vec<f64>) {
    let contents =
        if form == 2 { Reading::new(bytes, MOST).and_then(Reading::complete) } else { reading::read(bytes, MOST) };
    let contents = contents.expect("a table");
    let again = import::text(contents.text.as_bytes()).expect("a table").table;
    (contents.import.table.columns[1].si(None), again.columns[1].si(None))
}

fn assert_close(found: &[f64], expected: &[f64], about: &str) {
    let close = |(found, expected): (&f64, &f64)| (found - expected).abs() <= 1e-15 * expected.abs();
    assert!(found.len() == expected.len() && found.iter().zip(expected).all(close), "{about}: {found:?} {expected:?}");
}

#[test]
fn cells_that_are_shown_as_percentages_count_once() {
    for (heading, _) in HEADINGS {
        for scale in FRACTIONS {
            let fractions: Vec<f64> = (1..=4).map(|row| scale * f64::from(row)).collect();
            let cells: Vec<(f64, bool)> = fractions.iter().map(|fraction| (*fraction, true)).collect();
            for (form, bytes) in files(heading, &cells).into_iter().enumerate() {
                let (found, again) = values(form, bytes);
                assert_close(&found, &fractions, heading);
                assert_close(&again, &fractions, heading);
            }
        }
    }
}

#[test]
fn plain_cells_have_the_unit_of_the_heading() {
    for (heading, factor) in HEADINGS {
        let cells = [(5.0, false), (7.5, false), (30.0, false)];
        for (form, bytes) in files(heading, &cells).into_iter().enumerate() {
            assert_close(&values(form, bytes).0, &cells.map(|(value, _)| factor * value), heading);
        }
    }
}

#[test]
fn cells_of_both_kinds_agree_under_a_heading_with_the_sign() {
    for (heading, factor) in HEADINGS.into_iter().filter(|(_, factor)| *factor < 1.0) {
        // Most of the cells with the sign, then most without.
        for signs in [[true, true, true, false], [true, false, true, false], [false, true, false, false]] {
            let expected = [0.05, 0.06, 0.07, 0.08];
            let cells: Vec<(f64, bool)> = expected
                .iter()
                .zip(signs)
                .map(|(fraction, percent)| (if percent { *fraction } else { (fraction / factor).round() }, percent))
                .collect();
            for (form, bytes) in files(heading, &cells).into_iter().enumerate() {
                assert_close(&values(form, bytes).0, &expected, heading);
            }
        }
    }
}

//! Import of arbitrary tables and arbitrary bytes.

use analysis::finding::Finding;
use analysis::import;
use analysis::inspection::inspect;
use proptest::prelude::*;
use units::Language;

/// Numbers as written by instruments: of moderate size, with few or with all digits.
fn value() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-1_000_000_i32..1_000_000).prop_map(|number| f64::from(number) / 1000.0),
        (-1000_i32..1000).prop_map(f64::from),
        -1.0..1.0_f64,
        (-1.0..1.0_f64, -30..30_i32).prop_map(|(digits, power)| format!("{digits}e{power}").parse().expect("a number")),
    ]
}

/// Rows of a table; the first column has no gaps, and some cell of the others is filled in every row.
fn table() -> impl Strategy<Value = Vec<Vec<Option<f64>>>> {
    (2..6_usize).prop_flat_map(|columns| {
        let row = (value(), value(), prop::collection::vec(prop::option::weighted(0.8, value()), columns - 2));
        let row = row.prop_map(|(time, first, others)| [Some(time), Some(first)].into_iter().chain(others).collect());
        prop::collection::vec(row, 3..40)
    })
}

#[derive(Clone, Copy, Debug)]
struct Writing {
    delimiter: &'static str,
    comma: bool,
    exponent: bool,
    line_end: &'static str,
    mark: bool,
    trailing: bool,
    headers: usize,
    units: bool,
}

fn writing() -> impl Strategy<Value = Writing> {
    let delimiter = prop::sample::select(vec!["\t", ";", "; ", " \t", "|", ","]);
    let ends = prop::sample::select(vec!["\n", "\r\n", "\r"]);
    (delimiter, any::<bool>(), any::<bool>(), ends, any::<bool>(), any::<bool>(), 0..3_usize, any::<bool>()).prop_map(
        |(delimiter, comma, exponent, line_end, mark, trailing, headers, units)| Writing {
            delimiter,
            // A comma cannot be both.
            comma: comma && delimiter != ",",
            exponent,
            line_end,
            mark,
            trailing,
            headers,
            units,
        },
    )
}

fn written(rows: &[Vec<Option<f64>>], how: Writing) -> String {
    let columns = rows[0].len();
    let mut lines: Vec<Vec<String>> = Vec::new();
    if how.headers > 1 {
        lines.push(vec!["mass_A".to_owned()]);
    }
    if how.headers > 0 {
        let unit = |column: usize| {
            if !how.units {
                ""
            } else if column == 0 {
                " [s]"
            } else {
                " (cm)"
            }
        };
        let name = |column: usize| ["t", "x", "y", "v_x", "v_y", "a"][column];
        lines.push((0..columns).map(|column| format!("{}{}", name(column), unit(column))).collect());
    }
    for row in rows {
        lines.push(
            row.iter()
                .map(|cell| match cell {
                    None => String::new(),
                    Some(value) => {
                        let text = if how.exponent { format!("{value:E}") } else { format!("{value:?}") };
                        if how.comma { text.replace('.', ",") } else { text }
                    }
                })
                .collect(),
        );
    }
    let mut text = if how.mark { "\u{feff}".to_owned() } else { String::new() };
    for line in lines {
        text.push_str(&line.join(how.delimiter));
        text.push_str(if how.trailing { how.delimiter } else { "" });
        text.push_str(how.line_end);
    }
    text
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_table_written_in_any_way_comes_back(rows in table(), how in writing()) {
        let text = written(&rows, how);
        let import = import::text(text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"));
        // Where the first column begins again after some rows, it is the clock of several runs.
        prop_assume!(!import.findings.iter().any(|finding| matches!(finding, Finding::Runs(_))));
        // A column without numbers and without a name is left out.
        let kept: Vec<usize> = (0..rows[0].len())
            .filter(|column| how.headers > 0 || rows.iter().any(|row| row[*column].is_some()))
            .collect();
        prop_assert_eq!(import.table.columns.len(), kept.len(), "{}", text);
        for (column, &source) in import.table.columns.iter().zip(&kept) {
            let expected: Vec<Option<f64>> = rows.iter().map(|row| row[source]).collect();
            let found: Vec<Option<f64>> = column.values.iter().map(|value| value.is_finite().then_some(*value)).collect();
            prop_assert_eq!(found, expected, "{}", text);
            prop_assert_eq!(column.unit.is_some(), how.units && how.headers > 0);
        }
        prop_assert_eq!(import.format.header_lines, how.headers);
    }

    #[test]
    fn arbitrary_bytes_are_a_table_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        if let Ok(import) = import::text(&bytes) {
            let length = import.table.rows();
            prop_assert!(import.table.columns.iter().all(|column| column.values.len() == length));
        }
    }

    /// Texts that resemble tables more often than arbitrary bytes do.
    #[test]
    fn arbitrary_cells_are_a_table_or_refused(text in "([0-9,.eE+\\-\u{2212} \t;\"#|]{0,30}\r?\n){0,12}") {
        if let Ok(import) = import::text(text.as_bytes()) {
            let found = inspect(&import.table);
            for finding in found.findings.iter().chain(&import.findings) {
                prop_assert!(!finding.text(Language::English).is_empty() && !finding.text(catalogues::with(Language::Spanish)).is_empty());
            }
            for column in 0..import.table.columns.len() {
                prop_assert!(import.table.columns[column].independent < import.table.columns.len());
                let _ = analysis::cycles::cycles(import.table.times_of(column), &import.table.columns[column].values);
            }
        }
    }
}

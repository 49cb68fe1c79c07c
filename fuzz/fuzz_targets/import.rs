//! Any bytes as measured data: a table or a refusal with words, never a panic, and nothing of it unbounded.

#![no_main]

use analysis::csv::{self, Dialect};
use analysis::inspection::inspect;
use analysis::smoothing::savitzky_golay;
use analysis::{cycles, import};
use libfuzzer_sys::fuzz_target;
use units::Language;

fuzz_target!(|bytes: &[u8]| {
    let import = match import::text(bytes) {
        Ok(import) => import,
        Err(error) => {
            assert!(!error.message(Language::Spanish).is_empty() && !error.hint(Language::Spanish).is_empty());
            return;
        }
    };
    let table = import.table;
    let rows = table.rows();
    for (index, column) in table.columns.iter().enumerate() {
        assert_eq!(column.values.len(), rows);
        assert_eq!(table.columns[column.independent].independent, column.independent);
        // A name that is another column's number leaves two readings.
        let found = table.column(&table.typed(index));
        assert_eq!(found.ok(), Some(index));
    }
    for finding in import.findings.iter().chain(&inspect(&table).findings) {
        assert!(!finding.text(Language::English).is_empty() && !finding.text(Language::Spanish).is_empty());
    }
    if let Some(column) = table.observed_columns().next() {
        let (times, values) = (table.times_of(column), &table.columns[column].values);
        let _ = cycles::cycles(times, values);
        assert_eq!(savitzky_golay(times, values, 5, 2, 1).len(), rows);
    }
    reads_what_it_writes(&table);
});

/// A table with names that cannot be mistaken comes back from our own CSV, in both dialects.
fn reads_what_it_writes(table: &analysis::table::Table) {
    let full: Vec<&[f64]> = table
        .columns
        .iter()
        .map(|column| column.values.as_slice())
        .filter(|values| values.iter().all(|value| value.is_finite()))
        .take(20)
        .collect();
    if full.len() < 2 || table.rows() < 2 {
        return;
    }
    let names: Vec<String> = (0..full.len()).map(|index| format!("column {index}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    for dialect in [Dialect::Commas, Dialect::Semicolons] {
        let text = csv::write(&names, &full, dialect);
        let again = match import::text(text.as_bytes()) {
            Ok(again) => again,
            // `1,295` beside `926` can be either, so that a person is asked.
            Err(error) if matches!(error.reason, import::Refusal::Separator { .. }) => continue,
            Err(error) => panic!("{error}\n{text}"),
        };
        let values: Vec<&[f64]> = again.table.columns.iter().map(|column| column.values.as_slice()).collect();
        assert_eq!(values, full, "{text}");
    }
}

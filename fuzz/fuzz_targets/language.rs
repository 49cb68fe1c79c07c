//! Any text as a model: nothing panics, every place lies in the text, and what compiles runs.

#![no_main]

use engine::csv::Dialect;
use engine::table::Table;
use engine::{Method, Run, Setup};
use libfuzzer_sys::fuzz_target;
use model::Diagnostic;
use program::Model;

fuzz_target!(|source: &str| {
    let whole = 0..source.len();
    places_lie_in(source, &model::parse_expression(source, whole.clone()).2);
    places_lie_in(source, &model::parse_assignments(source, whole.clone()).1);
    let (compiled, diagnostics) = model::compile(source, &[whole]);
    places_lie_in(source, &diagnostics);
    assert_eq!(compiled.is_none(), model::has_errors(&diagnostics), "a model exactly where there are no errors");
    if let Some(checked) = compiled {
        model::typeset(&checked.statements, &|text| text.to_owned());
        let model = checked.model;
        for method in Method::ALL {
            run(&model, method);
        }
    }
});

fn places_lie_in(source: &str, diagnostics: &[Diagnostic]) {
    for diagnostic in diagnostics {
        for label in &diagnostic.labels {
            assert!(source.get(label.span.range()).is_some(), "{diagnostic:?}");
        }
    }
}

/// Number of floating-point operations for which a run is continued at most in a row.
const WORK: u64 = 1_000_000;

/// A few steps, and their table; refusals and ends are values.
fn run(model: &Model, method: Method) {
    let Ok(mut run) = Run::start(model, Setup { method, ..Setup::defaults(model) }) else { return };
    for _ in 0..4 {
        if run.advance_within(WORK).is_err() {
            break;
        }
    }
    let mut table = Table::new(model);
    let mut text = String::new();
    for row in 0..run.history().len() {
        let _ = table.write_row(Dialect::Lines, run.history(), row, &mut text);
    }
}

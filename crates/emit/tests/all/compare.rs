//! Comparison of an emitted run with an interpreted one.

use crate::host::Instance;
use engine::{Method, Run, Setup};
use program::Model;
use std::rc::Rc;

/// Outcome of a comparison without differences.
#[derive(Debug, PartialEq)]
pub enum Compared {
    /// The number of equal rows.
    Rows(usize),
    /// The reason why there is no emitted code.
    Interpreted(String),
}

/// Work of an advance at most, so that a program with many steps in a row is compared in bounded time.
const WORK: u64 = 100_000;

const METHODS: [Method; 5] =
    [Method::Euler, Method::EulerRichardson, Method::VelocityVerlet, Method::RungeKutta4, Method::DormandPrince];

/// Compares the runs of a text of a model by all methods that can be emitted; returns the number of rows. Panics at the first
/// difference. A text with errors, as constants that are not finite, has no rows.
pub fn compare_text(text: &str) -> usize {
    let Some(checked) = model::compile(text, std::slice::from_ref(&(0..text.len()))).0 else { return 0 };
    let rows =
        METHODS.map(|method| match compare(&checked.model, Setup { method, ..Setup::defaults(&checked.model) }, 24) {
            Compared::Rows(rows) => rows,
            Compared::Interpreted(reason) => panic!("{reason}\n{text}"),
        });
    rows.iter().sum()
}

/// Compares `rows` advances, of a row each or less; a parameter changes in the middle, and later the runs go back. Panics at
/// the first difference.
pub fn compare(model: &Model, setup: Setup, rows: usize) -> Compared {
    let Ok(mut interpreted) = Run::start(model, setup) else { return Compared::Rows(0) };
    let mut emitted = interpreted.clone();
    let listing = match emitted.listing() {
        Ok(listing) => listing,
        Err(reason) => return Compared::Interpreted(format!("{reason:?}")),
    };
    let module = match emit::module(&listing) {
        Ok(module) => module,
        Err(reason) => return Compared::Interpreted(format!("{reason:?}")),
    };
    emitted.use_compiled(Rc::new(Instance::new(&module, &listing)));
    for row in 0..rows {
        let (one, other) = (interpreted.advance_within(WORK), emitted.advance_within(WORK));
        assert_eq!(format!("{one:?}"), format!("{other:?}"), "row {row}");
        assert_eq!(interpreted.work(), emitted.work(), "row {row}");
        if one.is_err() {
            break;
        }
        if row == rows / 3 {
            // A run takes over compiled code at any time.
            emitted.use_compiled(Rc::new(Instance::new(&module, &listing)));
        }
        if row == rows / 2 {
            // A changed parameter discards steps that are computed in advance.
            let mut parameters = interpreted.parameters().to_vec();
            parameters.iter_mut().take(1).for_each(|parameter| *parameter *= 1.01);
            interpreted.set_parameters(parameters.clone());
            emitted.set_parameters(parameters);
        }
        if row == 3 * rows / 4 && interpreted.work() < 10 * WORK {
            // So does going back, which repeats the steps of an adaptive method.
            interpreted.truncate(row / 2);
            emitted.truncate(row / 2);
        }
    }
    assert_eq!(interpreted.history().fingerprint(), emitted.history().fingerprint());
    Compared::Rows(interpreted.history().len())
}

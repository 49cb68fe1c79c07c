//! Comparison of an emitted run with an interpreted one.

use crate::host::Instance;
use emit::{Module, TooManyOperations};
use engine::{
    Compiled, LanesListing, Listing, Method, Progress, ROUNDING, Readings, Run, Setup, Stepper, side_by_side,
};
use program::{Model, NodeId};
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
    let compared = |emit, rows| {
        METHODS.map(|method| {
            let setup = Setup { method, ..Setup::defaults(&checked.model) };
            match compare(&checked.model, setup, emit, rows) {
                Compared::Rows(rows) => rows,
                Compared::Interpreted(reason) => panic!("{reason}\n{text}"),
            }
        })
    };
    let rows = compared(emit::module, 24);
    compared(emit::module_of_lists, 8);
    let side_by_side = METHODS.map(|method| {
        let setup = Setup { method, ..Setup::defaults(&checked.model) };
        compare_side_by_side(&checked.model, &setup, 24).unwrap_or_default()
    });
    rows.iter().chain(&side_by_side).sum()
}

/// Compares `rows` rows of each of three runs side by side with single ones. Returns the number of rows; `None` if the runs are made
/// one by one, or if there are no states. Panics at the first difference.
pub fn compare_side_by_side(model: &Model, setup: &Setup, rows: usize) -> Option<usize> {
    let nodes: Vec<NodeId> = model.states.iter().map(|state| state.derivative).collect();
    if nodes.is_empty() {
        return None;
    }
    let alone = |listing: Listing| {
        let module = emit::module(&listing).ok()?;
        Some(Rc::new(Instance::new(&module, &listing)) as Rc<dyn Compiled>)
    };
    let compile = |listing: &LanesListing| {
        let module = emit::side_by_side(listing).ok()?;
        Some(Rc::new(Instance::side_by_side(&module, listing)) as Rc<dyn Compiled>)
    };
    let mut lanes = side_by_side(model, setup, &nodes, compile, alone)?;
    let with_parameters = |run: usize| {
        let mut parameters = setup.parameters.clone();
        parameters.iter_mut().take(1).for_each(|parameter| *parameter *= 1.0 + 0.01 * run as f64);
        Setup { parameters, ..setup.clone() }
    };
    let setups: Vec<Setup> = (0..3).map(with_parameters).collect();
    let mut singles = Vec::new();
    for setup in &setups {
        singles.push(Stepper::new(model, setup).ok()?);
    }
    let begun =
        setups.iter().zip(&singles).map(|(setup, single)| [setup.parameters.clone(), single.initial().to_vec()]);
    let until = (rows as f64 + 0.5) * setup.step;
    let mut found = vec![Vec::new(); 3];
    let mut take = |run: usize, time: f64, values: &[f64]| found[run].push((time.to_bits(), bits(values)));
    lanes.begin(&begun.collect::<Vec<_>>(), until, &mut take);
    while !lanes.advance(&mut { 3_000_000 }, &mut take) {}
    let mut compared = 0;
    for (run, single) in singles.iter_mut().enumerate() {
        let Some((expected, ends)) = rows_until(single, until) else { continue };
        let initial = single.initial().to_vec();
        let mut readings = Readings::new(model, &nodes);
        let mut read =
            |(time, state): &Row| (time.to_bits(), bits(readings.at(&setups[run].parameters, &initial, *time, state)));
        let expected_values: Vec<_> = expected.iter().map(&mut read).collect();
        let last = lanes.end(run);
        // A run that fails is made again alone, whatever is taken of it.
        assert!(ends || last.is_none(), "run {run}");
        let Some((time, state)) = last else {
            if ends {
                return None;
            }
            continue;
        };
        for (row, (found, expected)) in found[run].iter().zip(&expected_values).enumerate() {
            assert_eq!(found, expected, "run {run}, row {row}");
        }
        assert_eq!(found[run].len(), expected_values.len(), "run {run}");
        let (last_time, last_state) = expected.last().expect("a first row");
        assert_eq!((time.to_bits(), bits(&state)), (last_time.to_bits(), bits(last_state)), "run {run}");
        compared += expected_values.len();
    }
    Some(compared)
}

/// Time and state, SI units.
type Row = (f64, Vec<f64>);

/// The rows of a run up to `until` (SI units), and whether it comes there or ends before. `None` if a row needs too much work.
fn rows_until(stepper: &mut Stepper, until: f64) -> Option<(Vec<Row>, bool)> {
    let last = until * (1.0 + ROUNDING);
    let mut rows = vec![(0.0, stepper.initial().to_vec())];
    let mut take = |time: f64, state: &[f64], _jumped: bool| {
        if time <= last {
            rows.push((time, state.to_vec()));
        }
    };
    let mut outcome = Ok(());
    while outcome.is_ok() && stepper.time() < until * (1.0 - ROUNDING) {
        match stepper.advance_within(10 * WORK, &mut take) {
            Ok(Progress::Partial) => return None,
            advanced => outcome = advanced.map(drop),
        }
    }
    if outcome.is_ok() {
        outcome = stepper.finish(until, &mut take);
    }
    Some((rows, outcome.is_ok() || outcome.is_err_and(|error| error.is_end())))
}

/// Bits of numbers; those of all NaN are equal.
fn bits(numbers: &[f64]) -> Vec<u64> {
    numbers.iter().map(|number| if number.is_nan() { f64::NAN } else { *number }.to_bits()).collect()
}

/// Emits a module.
pub type Emit = fn(&Listing) -> Result<Module, TooManyOperations>;

/// Compares `rows` advances, of a row each or less; a parameter changes in the middle, and later the runs go back. Panics at
/// the first difference.
pub fn compare(model: &Model, setup: Setup, emit: Emit, rows: usize) -> Compared {
    let Ok(mut interpreted) = Run::start(model, setup) else { return Compared::Rows(0) };
    let mut emitted = interpreted.clone();
    let listing = match emitted.listing() {
        Ok(listing) => listing,
        Err(reason) => return Compared::Interpreted(format!("{reason:?}")),
    };
    let module = match emit(&listing) {
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

//! Helpers for the tests of fits.
use analysis::fit::{Fit, Observation, Outcome, Record, Task, Varied};
use program::Model;

/// A damped cosine about a level.
pub const DAMPED_COSINE: &str = "
parameter A = 0.05 [m]
parameter gamma = 0.4 [1/s]
parameter omega = 9.6 [1/s]
parameter phi = 0.5
parameter c = 0.002 [m]
y = A*exp(-gamma*t)*cos(omega*t + phi) + c
";
/// Varied parameters of it.
pub const DAMPED_COSINE_NAMES: [&str; 5] = ["A", "gamma", "omega", "phi", "c"];

/// Model with this text.
pub fn model(text: &str) -> Model {
    let (model, diagnostics) = model::compile(text, std::slice::from_ref(&(0..text.len())));
    let model = model.map(|checked| checked.model);
    model.unwrap_or_else(|| panic!("{diagnostics:#?}"))
}

/// `values` at `times` as an observation of `name` (with `order` primes).
pub fn observation(model: &Model, name: &str, order: u32, times: &[f64], values: &[f64]) -> Observation {
    let model = model.clone();
    let observed = model.lookup(name, order).expect(name);
    Observation {
        name: format!("{name}{}", "'".repeat(order as usize)),
        observed,
        times: times.to_vec(),
        values: values.to_vec(),
        errors: None,
        derived_from: None,
    }
}

pub fn record(observations: Vec<Observation>) -> Record {
    Record { name: "record".to_owned(), observations, ..Record::default() }
}

/// Index of the parameter called `name`.
pub fn parameter(model: &Model, name: &str) -> usize {
    model.parameters.iter().position(|parameter| parameter.name == name).expect(name)
}

/// One record, the named parameters varied.
pub fn task(model: &Model, record: Record, names: &[&str]) -> Task {
    Task {
        parameters: model.parameters.iter().map(|parameter| parameter.value).collect(),
        records: vec![record],
        varied: names.iter().map(|name| Varied::parameter(parameter(model, name))).collect(),
        ..Task::default()
    }
}

/// The outcome of a fit that must reach its end.
pub fn fitted(model: &Model, task: Task) -> Outcome {
    let mut fit = Fit::new(model, task).unwrap_or_else(|error| panic!("{error}"));
    fit.complete();
    let outcome = fit.outcome().expect("a curve");
    assert!(outcome.converged);
    outcome
}

/// Results for all items in their order, computed on all processors.
pub fn on_all_processors<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let part = |items: &[T]| items.iter().map(&work).collect::<Vec<R>>();
    std::thread::scope(|scope| {
        let parts = items.chunks(items.len().div_ceil(threads).max(1));
        let parts: Vec<_> = parts.map(|items| scope.spawn(|| part(items))).collect();
        parts.into_iter().flat_map(|part| part.join().expect("a thread that ends")).collect()
    })
}

pub fn value(outcome: &Outcome, name: &str) -> f64 {
    outcome.estimate(name).expect(name).value
}

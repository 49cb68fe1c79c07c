//! Helpers shared by the tests of the engine.
use engine::{Method, Readings, Run, Setup};
use program::Model;

/// The model described by `text`.
pub fn model(text: &str) -> Model {
    let (model, diagnostics) = model::compile(text, std::slice::from_ref(&(0..text.len())));
    let model = model.map(|checked| checked.model);
    model.unwrap_or_else(|| panic!("{diagnostics:#?}"))
}

pub fn setup(model: &Model, method: Method, step: f64) -> Setup {
    Setup { method, step, ..Setup::defaults(model) }
}

/// A run of `rows` steps.
pub fn run(model: &Model, setup: Setup, rows: usize) -> Run {
    let mut run = Run::start(model, setup).expect("starts");
    for _ in 0..rows {
        run.advance().unwrap_or_else(|error| panic!("{error}"));
    }
    run
}

/// A quantity at the end of a run.
pub fn value(model: &Model, run: &Run, name: &str) -> f64 {
    let node = model.lookup(name, 0).expect("a quantity").node;
    let mut readings = Readings::new(model, &[node]);
    readings.at(run.parameters(), run.initial(), run.time(), run.state())[0]
}

/// Index of the parameter called `name`.
pub fn parameter(model: &Model, name: &str) -> usize {
    model.parameters.iter().position(|parameter| parameter.name == name).expect(name)
}

/// The times of the rows right after jumps.
pub fn jumps(run: &Run) -> Vec<f64> {
    let history = run.history();
    (1..history.len())
        .filter(|&row| history.segment(row) != history.segment(row - 1))
        .map(|row| history.time(row))
        .collect()
}

pub const U_TUBE: &str = "
parameter g   = 9.8  [m/s^2]  in 0..30
parameter rho = 1000 [kg/m^3] in 50..13600 step 50
parameter S   = 0.05 [m^2]    in 0.01..2 step 0.01
parameter b   = 50   [kg/s]   in 0..20000
parameter h_l = 3    [m]      in 2..9 step 0.5
parameter h_r = 2    [m]      in 2..9 step 0.5
parameter v_0 = 0    [m/s]    in -5..5

L = 2 [m] + h_l + h_r
m = rho*S*L
rho*S*L*y'' + b*y' + 2*rho*S*g*y = 0
y(0)  = (h_l - h_r)/2
y'(0) = v_0

T = m*y'^2/2 in [J]
V = m*g*y^2/L in [J]
E = T + V
";

//! Documents of Meniscus compared with an independent solver. Their equations, written a second time by hand as systems of
//! first order, are solved with the method DOP853 of another library. Both must give the same motion, row by row.

mod bodies;
mod circuits;
mod many;
mod rates;

use crate::simulations::{faultless, names};
use differential_equations::prelude::{ExplicitRungeKutta, IVP};
use document::Document;
use engine::{Run, Setup};
use program::{Node, NodeId, Program, Test};

/// A document and its equations written by hand.
struct Case {
    /// Name of the document.
    document: &'static str,
    /// Values set in addition to the defaults of the document (SI).
    settings: &'static [(&'static str, f64)],
    /// Duration of the comparison (SI): until the first event that changes a state; for a chaotic motion, as long as the
    /// errors of both are small.
    until: f64,
    /// Allowed difference, relative to the greatest magnitude of each state in the run.
    error: f64,
    /// Tolerance of an adaptive method, if not that of the document.
    tolerance: Option<f64>,
    /// Names of the compared states, in the order of the equations.
    states: fn(&Values) -> Vec<String>,
    /// The equations, from the values of the parameters.
    motion: fn(&Values) -> Motion,
}

/// A system of first order (SI).
struct Motion {
    start: Vec<f64>,
    rates: Rates,
}

/// Writes the derivatives of the states at a time.
type Rates = Box<dyn Fn(f64, &[f64], &mut [f64])>;

impl Motion {
    fn new(start: impl Into<Vec<f64>>, rates: impl Fn(f64, &[f64], &mut [f64]) + 'static) -> Self {
        Self { start: start.into(), rates: Box::new(rates) }
    }
}

/// Parameters and sizes of a document.
struct Values(Vec<(String, f64)>);

impl Values {
    fn new(program: &Program, settings: &[(&str, f64)]) -> Self {
        let parameters = program.model.parameters.iter().map(|parameter| (parameter.name.clone(), parameter.value));
        let sizes = program.model.sizes.iter().map(|size| (size.name.clone(), f64::from(size.value)));
        let mut values = Self(parameters.chain(sizes).collect());
        for &(name, value) in settings {
            let place = values.0.iter().position(|(own, _)| own == name).expect(name);
            values.0[place].1 = value;
        }
        values
    }

    /// Value of the parameter or size with this name (SI).
    fn of(&self, name: &str) -> f64 {
        self.0.iter().find(|(own, _)| own == name).expect(name).1
    }
}

fn cases() -> impl Iterator<Item = Case> {
    bodies::CASES.into_iter().chain(circuits::CASES).chain(many::CASES).chain(rates::CASES)
}

#[test]
fn documents_move_as_an_independent_solver_says() {
    let failures: Vec<String> = cases().filter_map(|case| difference(&case)).collect();
    assert_eq!(failures, [""; 0]);
}

/// First difference above the allowed one between a document and its equations written by hand.
fn difference(case: &Case) -> Option<String> {
    let document = faultless(case.document);
    let values = Values::new(&document.program, case.settings);
    let names = (case.states)(&values);
    let run = run(&document, case, &values);
    let history = run.history();
    let places: Vec<usize> = names.iter().map(|name| place(&document, name)).collect();
    let rows: Vec<usize> = (0..history.len())
        .filter(|&row| history.time(row) <= case.until && (row == 0 || history.time(row) > history.time(row - 1)))
        .collect();
    let scale: Vec<f64> = places
        .iter()
        .map(|&place| rows.iter().map(|&row| history.column(place)[row].abs()).fold(f64::MIN_POSITIVE, f64::max))
        .collect();
    let times: Vec<f64> = rows.iter().map(|&row| history.time(row)).collect();
    let expected = solve((case.motion)(&values), &times, &scale);
    assert!(rows.len() > 50 && expected.len() == rows.len(), "{}: {} rows", case.document, rows.len());
    let mut worst = (0.0, String::new());
    for (&row, expected) in rows.iter().zip(&expected) {
        for (state, (&place, scale)) in places.iter().zip(&scale).enumerate() {
            let found = history.column(place)[row];
            let error = (found - expected[state]).abs() / scale;
            if error > worst.0 || error.is_nan() {
                let time = history.time(row);
                worst = (error, format!("{} at {time}: {found} for {}, of {scale}", names[state], expected[state]));
            }
        }
    }
    (worst.0 > case.error || worst.0.is_nan()).then(|| format!("{}: {:e}, {}", case.document, worst.0, worst.1))
}

fn run(document: &Document, case: &Case, values: &Values) -> Run {
    let model = &document.program.model;
    let mut setup = Setup::of(&document.program);
    setup.parameters = model.parameters.iter().map(|parameter| values.of(&parameter.name)).collect();
    setup.tolerance = case.tolerance.unwrap_or(setup.tolerance);
    let mut run = Run::start(model, setup).expect(case.document);
    while run.time() < case.until {
        run.advance().unwrap_or_else(|error| panic!("{}: {error}", case.document));
    }
    run
}

/// Index of the state with this name.
fn place(document: &Document, name: &str) -> usize {
    let states = &document.program.model.states;
    states.iter().position(|state| state.name() == name).unwrap_or_else(|| panic!("no state {name}"))
}

/// States at these times and their magnitudes.
fn solve(motion: Motion, times: &[f64], scale: &[f64]) -> Vec<Vec<f64>> {
    const TOLERANCE: f64 = 1e-12;
    let absolute: Vec<f64> = scale.iter().map(|scale| TOLERANCE * scale).collect();
    let method = ExplicitRungeKutta::dop853().rtol(TOLERANCE).atol(absolute).max_steps(10_000_000);
    let rates = motion.rates;
    let end = times.last().copied().expect("rows");
    let solution =
        IVP::ode_from_fn(move |t, y: &Vec<f64>, out: &mut Vec<f64>| rates(t, y, out), 0.0, end, motion.start)
            .t_eval(times)
            .method(method)
            .solve();
    solution.unwrap_or_else(|_| panic!("the independent solver fails")).y
}

/// Every document is compared with an independent solver above, or with theory: it has a claim about a value that is
/// computed without states of the run.
#[test]
fn every_document_is_compared_with_what_meniscus_does_not_compute() {
    for name in names() {
        let known = cases().any(|case| case.document == name);
        assert!(known || has_closed_form(&faultless(&name).program), "{name}: neither solved again nor a closed form");
    }
}

fn has_closed_form(program: &Program) -> bool {
    let graph = &program.model.graph;
    let closed = |root: NodeId| {
        let nodes: Vec<Node> = graph.reachable(&[root]).into_iter().map(|id| graph.node(id)).collect();
        let has = |test: fn(&Node) -> bool| nodes.iter().any(test);
        // An initial value such as `E(0)` is not a closed form.
        let kept = has(|node| matches!(node, Node::Initial(_))) && !has(|node| matches!(node, Node::Independent));
        !kept && !has(|node| matches!(node, Node::State(_))) && graph.as_constant(root) != Some(0.0)
    };
    let mut claims = program.checks.iter().flat_map(|check| &check.claims);
    claims.any(|claim| matches!(&claim.test, Test::Near { expected, .. } if closed(expected.node)))
}

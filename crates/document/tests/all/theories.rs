//! The gallery of theories: each opens without diagnostics in its languages, and obeys its law.
use document::Document;
use engine::{Readings, Run, Setup};
use std::path::PathBuf;

/// Time between rows, s.
const STEP: f64 = 0.002;

const THEORIES: [&str; 9] = [
    "cosine",
    "linear",
    "quadratic",
    "linear-quadratic",
    "dry-friction",
    "linear-contact-line",
    "quadratic-contact-line",
    "power-law",
    "saturating-spring",
];

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../simulations/theories")
}

/// Opens a theory with its Spanish translation, without diagnostics.
fn theory(name: &str) -> Document {
    let read = |file: String| std::fs::read_to_string(folder().join(&file)).unwrap_or_else(|_| panic!("{file}"));
    let opened = document::open(&read(format!("{name}.md")), &[&read(format!("{name}.es.md"))]);
    let findings: Vec<String> = (opened.diagnostics.iter())
        .map(|(file, d)| format!("{file}: {} at {:?} {:?} {:?}", d.message.english(), d.span(), d.notes, d.hints))
        .collect();
    assert_eq!(findings, [""; 0], "{name}");
    opened.document.unwrap()
}

/// A finished run and its document.
struct Done {
    document: Document,
    run: Run,
}

/// Runs a theory over its whole time with some parameters set, with tolerance 1e-12 and a row at each step.
fn run(name: &str, values: &[(&str, f64)]) -> Done {
    let document = theory(name);
    let mut setup = Setup::defaults(&document.program.model);
    for (parameter, value) in values {
        let index = document.program.model.parameters.iter().position(|p| p.name == *parameter);
        setup.parameters[index.unwrap_or_else(|| panic!("{name}: {parameter}"))] = *value;
    }
    setup.method = document.program.method.unwrap();
    setup.step = STEP;
    setup.tolerance = 1e-12;
    let mut run = Run::start(&document.program.model, setup).unwrap();
    while run.time() < document.program.until.unwrap() {
        run.advance().unwrap_or_else(|error| panic!("{name}: {error:?}"));
    }
    Done { document, run }
}

impl Done {
    /// Values of an expression at the regular rows, without rows of events between.
    fn values(&self, expression: &str) -> Vec<f64> {
        let mut model = self.document.program.model.clone();
        let (tree, unit, found) = model::parse_expression(expression, 0..expression.len());
        assert!(found.is_empty(), "{expression}");
        let node = model::Compiler::new(&mut model)
            .compile(&tree, unit.as_ref())
            .unwrap_or_else(|found| panic!("{found:?}"))
            .node;
        let mut readings = Readings::new(&model, &[node]);
        let history = self.run.history();
        let mut state = vec![0.0; model.states.len()];
        let mut values: Vec<f64> = Vec::new();
        for row in 0..history.len() {
            history.state(row, &mut state);
            if history.time(row) != values.len() as f64 * STEP {
                continue;
            }
            let value = readings.at(history.parameters(row), history.initial(), history.time(row), &state)[0];
            values.push(value);
        }
        values
    }

    fn value(&self, expression: &str) -> f64 {
        self.values(expression)[0]
    }

    /// Displacement where the velocity is zero, including a start from rest.
    fn turning_points(&mut self) -> Vec<f64> {
        let (x, v) = (self.state("x", 0), self.state("x", 1));
        let mut state = vec![0.0; self.document.program.model.states.len()];
        let times: Vec<f64> = (0..self.run.history().len()).map(|row| self.run.history().time(row)).collect();
        let mut found = vec![self.run.initial()[x]];
        for pair in times.windows(2) {
            let mut at = |time: f64| {
                self.run.interpolate(time, &mut state);
                (state[x], state[v])
            };
            let (mut low, mut high) = (pair[0], pair[1]);
            let start = at(low).1;
            if low == 0.0 || start == 0.0 || start * at(high).1 > 0.0 || low == high {
                continue;
            }
            for _ in 0..60 {
                let middle = (low + high) / 2.0;
                if start * at(middle).1 > 0.0 {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            found.push(at(low).0);
        }
        found
    }

    fn state(&self, variable: &str, order: u32) -> usize {
        let mut states = self.document.program.model.states.iter();
        states.position(|state| state.variable == variable && state.order == order).unwrap()
    }
}

fn difference(one: &[f64], other: &[f64]) -> f64 {
    assert_eq!(one.len(), other.len());
    one.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn every_theory_can_be_fitted_to_a_measured_level_and_its_velocity() {
    let mut files: Vec<String> = std::fs::read_dir(folder())
        .unwrap()
        .filter_map(|entry| entry.unwrap().file_name().into_string().unwrap().strip_suffix(".es.md").map(str::to_owned))
        .collect();
    files.sort();
    let mut expected = THEORIES.map(str::to_owned).to_vec();
    expected.sort();
    assert_eq!(files, expected);
    for name in THEORIES {
        let done = run(name, &[("c", -0.003), ("drift", 0.001)]);
        let document = &done.document;
        assert_eq!(document.program.languages().collect::<Vec<_>>(), ["en", "es"], "{name}");
        assert!((4..=8).contains(&document.program.vary.len()), "{name}");
        assert!(
            document.program.vary.iter().all(|&index| document.program.model.parameters[index].name != "drift"),
            "{name}"
        );
        for parameter in &document.program.model.parameters {
            let (low, high) = parameter.range.unwrap();
            assert!((low..=high).contains(&parameter.value), "{name}: {}", parameter.name);
            let damping = ["gamma", "beta", "mu", "D"].contains(&parameter.name.as_str());
            assert!(!damping || low == 0.0, "{name}: {}", parameter.name);
        }
        // Every page carries it; the drawings of all theories are alike and compress to one.
        assert!(document.source.len() < 7500, "{name}: {} bytes", document.source.len());
        // The level is the measured quantity: it contains offset and drift; its velocity contains only the drift.
        let (level, velocity) = (done.values("y"), done.values("y'"));
        assert!((level[0] - 0.037).abs() < 1e-12, "{name}: {}", level[0]);
        let mean = velocity.iter().sum::<f64>() * STEP;
        let rise = level.last().unwrap() - level[0];
        assert!((mean - rise).abs() < 1e-3, "{name}: {mean} {rise}");
        assert!(velocity.iter().fold(0.0_f64, |most, v| most.max(v.abs())) > 0.25, "{name}");
    }
}

#[test]
fn the_closed_form_solves_the_linear_equation() {
    let drift = [("c", -0.0027), ("drift", 2e-4)];
    let cosine =
        run("cosine", &[&[("A", 0.056), ("gamma", 0.387), ("omega_d", 9.609), ("delta", -3.194)], &drift[..]].concat());
    let from = |name| cosine.value(name);
    let start = [("L", from("L")), ("y_0", from("y_0")), ("v_0", from("v_0")), ("gamma", 0.387)];
    let linear = run("linear", &[&start, &drift[..]].concat());
    assert!(difference(&cosine.values("y"), &linear.values("y")) < 1e-10);
    assert!(difference(&cosine.values("y'"), &linear.values("y'")) < 1e-9);
    assert!(difference(&cosine.values("v"), &cosine.values("y'")) == 0.0);
    assert!((linear.value("omega_d") - 9.609).abs() < 1e-12);
}

#[test]
fn the_theories_agree_where_they_are_the_same() {
    let gamma = ("gamma", 0.4);
    let beta = ("beta", 5.0);
    let same = |one: (&str, &[(&str, f64)]), other: (&str, &[(&str, f64)]), allowed: f64| {
        for observed in ["y", "y'/(10 [1/s])"] {
            let apart = difference(&run(one.0, one.1).values(observed), &run(other.0, other.1).values(observed));
            assert!(apart < allowed, "{one:?} {other:?} {observed}: {apart}");
        }
    };
    let linear = ("linear", &[gamma][..]);
    let quadratic = ("quadratic", &[beta][..]);
    same(linear, ("linear-quadratic", &[gamma, ("beta", 0.0)]), 1e-10);
    same(linear, ("dry-friction", &[gamma, ("mu", 0.0)]), 1e-10);
    same(linear, ("linear-contact-line", &[gamma, ("mu", 0.0)]), 1e-10);
    same(linear, ("power-law", &[("D", 2.0 * 0.4 * 0.1), ("n", 1.0)]), 1e-10);
    same(quadratic, ("linear-quadratic", &[beta, ("gamma", 0.0)]), 1e-10);
    same(quadratic, ("quadratic-contact-line", &[beta, ("mu", 0.0)]), 1e-10);
    same(quadratic, ("power-law", &[("D", 5.0 * 0.1 * 0.1), ("n", 2.0)]), 1e-8);
    // A contact line that yields at once is dry friction. The time that it takes at a turning point is proportional to the
    // square root of its yield length, and so is the remaining difference.
    let dry = run("dry-friction", &[gamma, ("mu", 0.1)]).values("y");
    let [coarse, fine] = [1e-5, 2.5e-6].map(|s| {
        let line = run("linear-contact-line", &[gamma, ("mu", 0.1), ("s", s)]).values("y");
        difference(&dry[..1000], &line[..1000])
    });
    assert!(coarse < 3e-4 && (0.45..0.55).contains(&(fine / coarse)), "{coarse} {fine}");
    // A spring that never saturates is a linear spring.
    same(("linear", &[("gamma", 0.0)]), ("saturating-spring", &[("x_s", 100.0)]), 1e-6);
}

/// Textbook result: each half swing loses 2 mu/omega_0^2, and the motion stops at the first turning point in the dead zone.
#[test]
fn dry_friction_takes_the_same_piece_from_each_swing_and_stops_for_good() {
    let mut done = run("dry-friction", &[("gamma", 0.0), ("mu", 0.2), ("drift", 1e-3)]);
    let (dead, omega) = (done.value("x_d"), done.value("omega_0"));
    let points = done.turning_points();
    let swings = (0..).find(|n| 0.04 - 2.0 * dead * f64::from(*n) <= dead).unwrap();
    assert_eq!(points.len(), 1 + swings as usize, "{points:?}");
    for (n, point) in points.iter().enumerate() {
        let expected = (0.04 - 2.0 * dead * n as f64) * [1.0, -1.0][n % 2];
        assert!((point - expected).abs() < 1e-9, "{n}: {point} {expected}");
    }
    let stop = f64::from(swings) * std::f64::consts::PI / omega;
    let moving = |t: f64| t < stop;
    assert!(stop < 7.0);
    let (x, v, drift) = (done.values("x"), done.values("x'"), done.values("y'"));
    for (row, time) in done.values("t").into_iter().enumerate().filter(|(_, t)| (t - stop).abs() > 1e-9) {
        assert_eq!(v[row] == 0.0, !moving(time) || time == 0.0, "{time}");
        if !moving(time) {
            assert_eq!((x[row], drift[row]), (*x.last().unwrap(), 1e-3), "{time}");
        }
    }
    // A start in the dead zone remains there.
    let still = run("dry-friction", &[("mu", 5.0), ("y_0", 0.01)]);
    assert!(still.values("x").iter().all(|x| *x == 0.01));
    // A push out of it does not.
    let pushed = run("dry-friction", &[("mu", 5.0), ("y_0", 0.01), ("v_0", -0.5)]);
    assert!(pushed.values("x").last().unwrap() < &0.005);
}

/// The first integral of x'' + beta x'^2 + omega^2 x = 0 between turning points.
#[test]
fn quadratic_damping_follows_its_first_integral() {
    let mut done = run("quadratic", &[("beta", 6.0)]);
    let points = done.turning_points();
    assert!(points.len() > 20, "{points:?}");
    for pair in points.windows(2) {
        let (before, after) = (2.0 * 6.0 * pair[0].abs(), 2.0 * 6.0 * pair[1].abs());
        let (left, right) = ((1.0 + before) * libm::exp(-before), (1.0 - after) * libm::exp(after));
        assert!((left - right).abs() < 1e-9, "{pair:?}");
        assert!(pair[0] * pair[1] < 0.0);
    }
}

#[test]
fn the_contact_line_pulls_no_more_than_it_can_and_never_gives_energy() {
    for (name, values) in [
        ("linear-contact-line", [("mu", 0.2), ("s", 0.004), ("gamma", 0.0)]),
        ("quadratic-contact-line", [("mu", 0.1), ("s", 0.001), ("beta", 3.0)]),
    ] {
        let done = run(name, &values);
        let (mu, s) = (values[0].1, values[1].1);
        let (pull, x, v) = (done.values("f"), done.values("x"), done.values("x'"));
        assert!(pull.iter().all(|f| f.abs() <= mu), "{name}");
        assert!(pull.iter().any(|f| f.abs() > 0.99 * mu), "{name}");
        // During the first descent the law can be integrated: f depends on the distance alone.
        let first = v.iter().skip(1).position(|v| *v >= 0.0).unwrap();
        for row in 0..first {
            let expected = -mu * (1.0 - libm::exp(-(0.04 - x[row]) / s));
            assert!((pull[row] - expected).abs() < 1e-9, "{name} {row}");
        }
        // Including the elastic energy of the line, f^2/(2k), the energy only falls. In a loop the elastic energy is
        // recovered, and the area of the loop is lost.
        let energy = done.values("x'^2/2 + omega_0^2*x^2/2 + f^2/(2*k)");
        assert!(energy.windows(2).all(|pair| pair[1] <= pair[0] + 1e-12), "{name}");
        assert!(*energy.last().unwrap() < 0.2 * energy[0], "{name}");
    }
}

#[test]
fn the_control_keeps_its_energy_and_its_large_swings_are_slow() {
    let mut done = run("saturating-spring", &[("x_s", 0.02), ("y_0", 0.05)]);
    let energy = done.values("E");
    assert!(energy.iter().all(|e| (e / energy[0] - 1.0).abs() < 1e-9));
    let points = done.turning_points();
    assert!(points.iter().all(|x| (x.abs() - 0.05).abs() < 1e-8));
    let small = run("saturating-spring", &[("x_s", 0.02), ("y_0", 0.0005)]).turning_points().len();
    assert!(small > points.len() + 4, "{small} {}", points.len());
}

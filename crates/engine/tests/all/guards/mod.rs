//! Guards: a branch that has a value on one side of a corner only ends no run.

mod models;

use crate::support::{model, setup};
use engine::{Method, NoticeKind, Run, Setup};
use models::{Guarded, others, tanks, vessels};

/// Orders of the methods with steps of the grid.
const ORDERS: [(Method, i32); 4] =
    [(Method::Euler, 1), (Method::EulerRichardson, 2), (Method::VelocityVerlet, 2), (Method::RungeKutta4, 4)];

/// States of a run at the rows nearest to these times.
fn states(text: &str, method: Method, step: f64, times: [f64; 2]) -> [Vec<f64>; 2] {
    let model = model(text);
    let tolerance = if step == 0.0 { 1e-12 } else { 1e-6 };
    let setup = Setup { tolerance, ..setup(&model, method, if step == 0.0 { 0.05 } else { step }) };
    let mut run = Run::start(&model, setup).expect("starts");
    times.map(|time| {
        while run.time() < time - 1e-9 {
            run.advance().unwrap_or_else(|error| panic!("{error} with {method}: {text}"));
        }
        let jumps = run.notices().into_iter().filter(|notice| notice.kind == NoticeKind::MayBeSkipped(None));
        assert_eq!(jumps.count(), 0, "{method}: {text}");
        run.state().to_vec()
    })
}

fn difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

/// Compares all methods with the states `exact` at a time before the corner and at one after it.
fn check(guarded: &Guarded, times: [f64; 2], exact: &[Vec<f64>; 2]) {
    let text = &guarded.text;
    let second_order = text.contains("''");
    let [before, after] = exact;
    for (method, order) in ORDERS.into_iter().filter(|(method, _)| second_order || *method != Method::VelocityVerlet) {
        let errors = [0.05, 0.025].map(|step| {
            let found = states(text, method, step, times);
            let end = difference(&found[1], after);
            // The errors of Euler's method grow over the whole run.
            assert!(order == 1 || end < 6.0 * libm::pow(step, 1.5), "{method}: {end} after it: {text}");
            difference(&found[0], before)
        });
        let expected = f64::from(1 << order);
        let [long, short] = errors;
        assert!(
            guarded.corner == 0.0 || long < 1e-9 || long / short > 0.5 * expected,
            "{method}: {long}, {short} before it: {text}"
        );
    }
    for method in [Method::DormandPrince, Method::Rosenbrock] {
        let found = states(text, method, 0.05, times);
        let errors = [0, 1].map(|place| difference(&found[place], &exact[place]));
        assert!(errors[0] < 1e-5 && errors[1] < 1e-3, "{method}: {errors:?}: {text}");
    }
}

#[test]
fn vessels_run_empty_by_every_method() {
    for (p, guarded) in vessels() {
        let times = [0.5 * guarded.corner, guarded.corner + 0.5].map(|time| (20.0 * time).round() / 20.0);
        let level = |time: f64| {
            let root = 1.0 - (1.0 - p) * time;
            if root > 0.0 { libm::pow(root, 1.0 / (1.0 - p)) } else { 0.0 }
        };
        // Every event fires once, whether it comes before the corner, at it or after it.
        check(&guarded, times, &[vec![level(times[0])], vec![0.0, 1.0]]);
    }
}

#[test]
fn other_corners_end_no_run() {
    for guarded in others() {
        let times = [0.4 * guarded.corner + 0.05, guarded.corner + 1.0].map(|time| (20.0 * time).round() / 20.0);
        let exact = states(&guarded.text, Method::DormandPrince, 0.0, times);
        check(&guarded, times, &exact);
    }
}

/// Levels of two tanks agree with those of Dormand-Prince at 1e-12, with no warning of a skipped jump, however the flow is written.
#[test]
fn tanks_level_by_every_method() {
    for Guarded { text, .. } in tanks() {
        let times = [8.0, 24.0];
        let exact = states(&text, Method::DormandPrince, 0.0, times);
        let methods = [
            (Method::Euler, 1e-2),
            (Method::EulerRichardson, 1e-3),
            (Method::RungeKutta4, 1e-4),
            (Method::DormandPrince, 1e-4),
            (Method::Rosenbrock, 1e-3),
        ];
        for (method, allowed) in methods {
            let found = states(&text, method, 0.1, times);
            let error = difference(&found[0], &exact[0]).max(difference(&found[1], &exact[1]));
            assert!(error < allowed, "{method}: {error}: {text}");
        }
    }
}

//! Fits with emitted code.

use crate::host::Instance;
use analysis::fit::{Fit, Observation, Outcome, Record, Task, Varied};
use engine::Compiled;
use program::Model;
use std::rc::Rc;

/// Fits a model to a damped oscillation of its observed quantity `y`, with the varied parameters of the document.
fn fitted(model: &Model, vary: &[usize], emits: bool) -> (Outcome, bool) {
    let times: Vec<f64> = (0..30).map(|frame| f64::from(frame) / 30.0).collect();
    let wave = |time: &f64| 0.04 * libm::exp(-0.4 * time) * libm::cos(9.6 * time) + 1e-4 * libm::sin(700.0 * time);
    let observation = Observation {
        name: "y".to_owned(),
        observed: model.lookup("y", 0).expect("a level"),
        values: times.iter().map(wave).collect(),
        times,
        errors: None,
        derived_from: None,
    };
    let task = Task {
        parameters: model.parameters.iter().map(|parameter| parameter.value).collect(),
        records: vec![Record { name: "record".to_owned(), observations: vec![observation], ..Record::default() }],
        varied: vary.iter().map(|&index| Varied::parameter(index)).collect(),
        ..Task::default()
    };
    let mut fit = Fit::new(model, task).expect("a task");
    let mut is_emitted = false;
    if emits {
        fit.compile(|listing| {
            let module = emit::module(&listing).ok()?;
            is_emitted = true;
            Some(Rc::new(Instance::new(&module, &listing)) as Rc<dyn Compiled>)
        });
    }
    fit.complete();
    (fit.outcome().expect("a curve"), is_emitted)
}

#[test]
fn a_fit_in_emitted_code_has_the_same_bits() {
    for source in [
        include_str!("../../../../simulations/theories/linear.md"),
        include_str!("../../../../simulations/theories/quadratic.md"),
    ] {
        let program = document::open(source, &[]).document.expect("a document").program;
        let (interpreted, _) = fitted(&program.model, &program.vary, false);
        let (emitted, is_emitted) = fitted(&program.model, &program.vary, true);
        assert!(is_emitted, "{}", program.title);
        assert_eq!(format!("{interpreted:?}"), format!("{emitted:?}"), "{}", program.title);
    }
}

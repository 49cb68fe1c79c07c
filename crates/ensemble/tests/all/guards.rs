//! Corners at which a branch loses its value.

use crate::compare::{lanes, single};
use crate::guarded::{Guarded, others, tanks, vessels};
use engine::{Method, Setup};
use ensemble::Features;

#[test]
fn lanes_over_guarded_corners_have_the_bits_of_single_runs() {
    let mut compared = 0;
    let all = vessels().into_iter().map(|(_, guarded)| guarded).chain(others());
    let all = all.chain(tanks().into_iter().step_by(3));
    for Guarded { text, corner } in all {
        let model = document::open(&format!("```model\n{text}\n```\n"), &[]).document.expect(&text).program.model;
        let setup = Setup { method: Method::DormandPrince, ..Setup::defaults(&model) };
        let nodes: Vec<_> = model.states.iter().map(|state| state.derivative).collect();
        let parameters: Vec<Vec<f64>> = (0..8).map(|run| vec![1.0 + 0.03 * f64::from(run)]).collect();
        let until = corner + 0.5;
        let Ok(found) = lanes(&model, (&setup, until), &nodes, &parameters, Features::Best) else { continue };
        for (parameters, found) in parameters.iter().zip(found) {
            let setup = Setup { parameters: parameters.clone(), ..setup.clone() };
            let expected = single(&model, &setup, until, &nodes);
            assert!(expected.1.is_ok(), "{:?}: {text}", expected.1);
            assert!(found == expected, "{parameters:?}: {text}");
        }
        compared += 1;
    }
    assert!(compared >= 30, "{compared}");
}

//! Corners at which a branch loses its value: emitted code leaves them to the engine.

use crate::compare::{Compared, compare, compare_side_by_side};
use crate::guarded::{Guarded, others, vessels};
use engine::{Method, Setup};

#[test]
fn runs_over_guarded_corners_have_the_bits_of_the_interpreter() {
    for Guarded { text, corner } in vessels().into_iter().map(|(_, guarded)| guarded).chain(others()) {
        let model = model::compile(&text, std::slice::from_ref(&(0..text.len()))).0.expect(&text).model;
        for method in [Method::VelocityVerlet, Method::RungeKutta4, Method::DormandPrince] {
            if method == Method::VelocityVerlet && !text.contains("''") {
                continue;
            }
            let setup = Setup { method, step: (corner + 0.2) / 16.0, ..Setup::defaults(&model) };
            assert_eq!(compare(&model, setup.clone(), emit::module, 24), Compared::Rows(24), "{method}: {text}");
            if let Some(rows) = compare_side_by_side(&model, &setup, 24) {
                assert!(rows >= 3 * 24, "{method}: {text}");
            }
        }
    }
}

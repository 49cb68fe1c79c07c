//! Corners at which a branch loses its value: emitted code leaves them to the engine.

use crate::compare::{Compared, compare, compare_side_by_side};
use crate::guarded::{Guarded, others, tanks, vessels};
use engine::{Method, Setup};

#[test]
fn runs_over_guarded_corners_have_the_bits_of_the_interpreter() {
    let all = vessels().into_iter().map(|(_, guarded)| guarded).chain(others());
    let all = all.chain(tanks().into_iter().step_by(5));
    for (number, Guarded { text, corner }) in all.enumerate() {
        let model = model::compile(&text, std::slice::from_ref(&(0..text.len()))).0.expect(&text).model;
        for method in [Method::VelocityVerlet, Method::RungeKutta4, Method::DormandPrince] {
            // Steps of the grid are made one by one.
            let rare = method != Method::DormandPrince && number % 6 != 0;
            if rare || (method == Method::VelocityVerlet && !text.contains("''")) {
                continue;
            }
            // The corner lies before the row from which the runs are made again.
            let setup = Setup { method, step: (corner + 0.2) / 10.0, ..Setup::defaults(&model) };
            let compared = compare(&model, setup.clone(), emit::module, 24);
            assert!(matches!(compared, Compared::Rows(rows) if rows > 10), "{method}, {compared:?}: {text}");
            let lanes = if number % 3 == 0 { compare_side_by_side(&model, &setup, 24) } else { None };
            if let Some(rows) = lanes {
                assert!(rows >= 3 * 24, "{method}: {text}");
            }
        }
    }
}

//! Arbitrary programs.

use crate::compare::{Compared, compare};
use crate::programs;
use engine::{Method, Setup};
use proptest::prelude::{ProptestConfig, any, prop_assert, proptest};
use std::sync::atomic::{AtomicUsize, Ordering};

const METHODS: [Method; 5] =
    [Method::Euler, Method::EulerRichardson, Method::VelocityVerlet, Method::RungeKutta4, Method::DormandPrince];

#[test]
fn arbitrary_programs_have_the_same_bits_in_emitted_code() {
    let compared = AtomicUsize::new(0);
    proptest!(ProptestConfig::with_cases(64), |(bytes in proptest::collection::vec(any::<u8>(), 0..200))| {
        let text = programs::text(&bytes);
        let (model, diagnostics) = model::compile(&text, std::slice::from_ref(&(0..text.len())));
        let Some(model) = model.map(|checked| checked.model) else {
            // Constants that are not finite, or a domain that is left everywhere.
            prop_assert!(model::has_errors(&diagnostics));
            return Ok(());
        };
        for method in METHODS {
            let setup = Setup { method, ..Setup::defaults(&model) };
            match compare(&model, setup, 20) {
                Compared::Rows(rows) => { compared.fetch_add(rows, Ordering::Relaxed); }
                Compared::Interpreted(reason) => prop_assert!(false, "{reason}\n{text}"),
            }
        }
    });
    assert!(compared.into_inner() > 500, "the programs make steps");
}

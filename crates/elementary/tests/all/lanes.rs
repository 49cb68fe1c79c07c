//! Lanes have the bits of the scalar functions.

use crate::table::FUNCTIONS;

/// Arguments from 1e-12 to 1e12 of both signs, from a generator (Numerical Recipes' LCG).
fn arguments(count: usize) -> Vec<[f64; 2]> {
    let mut state = 7_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let uniform = (state >> 11) as f64 / (1_u64 << 53) as f64;
        let magnitude = libm::exp10(6.0 * libm::pow(2.0 * uniform - 1.0, 3.0) + 0.5);
        if state & 2 == 0 { magnitude } else { -magnitude }
    };
    (0..count).map(|_| [next(), next()]).collect()
}

#[test]
fn lanes_have_the_bits_of_single_numbers() {
    for (name, function, table) in FUNCTIONS {
        let mut all: Vec<[f64; 2]> = function.lines(table).iter().map(|exact| exact.arguments).collect();
        all.extend(arguments(20_000));
        // Blocks with angles of less than pi/4 only, for which the scalar functions take a shorter way.
        all.extend((-160..160).map(|number| [f64::from(number) / 205.0, 1.5]));
        // A block of 16 with each special number at its own place.
        for (place, special) in [0.0, -0.0, f64::INFINITY, f64::NAN, 5e-324, 1e300].into_iter().enumerate() {
            let mut block = [[0.5, 0.7]; 16];
            block[2 * place][0] = special;
            block[2 * place + 1][1] = special;
            all.extend(block);
        }
        for skipped in [0, 5] {
            let some = &all[skipped..];
            for (lane, arguments) in function.values(some).into_iter().zip(some) {
                let scalar = function.value(*arguments);
                let same = lane.to_bits() == scalar.to_bits() || lane.is_nan() && scalar.is_nan();
                assert!(same, "{name} of {arguments:?}: {lane:?} in a lane, {scalar:?} alone");
            }
        }
    }
}

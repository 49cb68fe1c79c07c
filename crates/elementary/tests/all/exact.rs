//! Errors against exact values, and the behaviour where one polynomial follows on another.

use crate::table::{Exact, FUNCTIONS};
use elementary::{ULPS, atan, cos, cosh, exp, ln, sin, sinh, tan, tanh};

/// Function, sign of its slope, and places between two polynomials.
type Joined<'a> = (fn(f64) -> f64, f64, &'a [f64]);

/// Number of representable numbers from `b` to `a`, which have one sign.
fn steps(a: f64, b: f64) -> f64 {
    (a.to_bits() as i64).wrapping_sub(b.to_bits() as i64) as f64 * if a < 0.0 { -1.0 } else { 1.0 }
}

#[test]
fn errors_are_below_one_unit_in_the_last_place() {
    for (name, function, table) in FUNCTIONS {
        let lines = function.lines(table);
        assert_eq!(lines.len(), 400, "{name}");
        for exact in lines {
            let value = function.value(exact.arguments);
            let error = steps(value, exact.nearest) - exact.beyond;
            assert!(error.abs() < ULPS, "{name} of {:?}: {value:?} is wrong by {error}", exact.arguments);
        }
    }
}

#[test]
fn values_that_are_numbers_are_exact() {
    let cases: [(f64, f64, f64); 12] = [
        (2.0, 10.0, 1024.0),
        (10.0, 3.0, 1000.0),
        (10.0, 22.0, 1e22),
        (0.5, 1074.0, 5e-324),
        (2.0, -1030.0, f64::from_bits(1 << 44)),
        (9.0, 0.5, 3.0),
        (27.0, 4.0, 531_441.0),
        (1.5, 30.0, 205_891_132_094_649.0 / 1_073_741_824.0),
        (-3.0, 5.0, -243.0),
        (1.1, 1.0, 1.1),
        (4.0, -1.5, 0.125),
        (1.0, 1e17, 1.0),
    ];
    for (base, exponent, expected) in cases {
        assert_eq!(elementary::pow(base, exponent), expected, "{base}^{exponent}");
    }
    for base in [0.1, 1.3, 7.7e100, 3e-170, -0.7, 0.0, f64::INFINITY] {
        assert_eq!(elementary::pow(base, 2.0), base * base);
        assert_eq!(elementary::pow(base, 0.0), 1.0);
    }
    assert_eq!([exp(0.0), exp(-0.0), cos(0.0), cosh(0.0), ln(1.0)], [1.0, 1.0, 1.0, 1.0, 0.0]);
}

#[test]
fn values_do_not_fall_back_where_one_polynomial_follows_on_another() {
    let quarter = core::f64::consts::FRAC_PI_4;
    let fold = core::f64::consts::LN_2 / 2.0;
    let cases: [Joined; 9] = [
        (sin, 1.0, &[quarter]),
        (cos, -1.0, &[quarter, 3.0 * quarter]),
        (tan, 1.0, &[quarter, 3.0 * quarter]),
        (exp, 1.0, &[fold, -fold, 3.0 * fold, -21.0 * fold, 708.0, -708.0]),
        (ln, 1.0, &[0.5_f64.sqrt(), 2.0_f64.sqrt(), 8.0_f64.sqrt()]),
        (sinh, 1.0, &[fold, 3.0 * fold, 5.0 * fold]),
        (cosh, 1.0, &[fold, 3.0 * fold, 5.0 * fold]),
        (tanh, 1.0, &[fold / 2.0, 1.5 * fold, 2.5 * fold, 19.5]),
        (atan, 1.0, &[0.4375, 0.6875, 1.1875, 2.4375]),
    ];
    for (function, slope, places) in cases {
        for place in places {
            let near = |offset: i64| f64::from_bits(place.to_bits().wrapping_add_signed(offset));
            for offset in -2000..2000 {
                // The error can be a step, not more.
                let change = steps(function(near(offset + 1)), function(near(offset))) * slope * place.signum();
                assert!(change >= -1.0, "near {place}: {:?} {change}", near(offset));
            }
            let change = steps(function(near(2000)), function(near(-2000))) * slope * place.signum();
            assert!(change >= 0.0, "around {place}");
        }
    }
}

#[test]
fn the_angle_of_a_point_agrees_with_the_arctangent_in_all_quadrants() {
    let pi = core::f64::consts::PI;
    for (y, x) in [(1.0, 2.0), (3.0, 1.0), (1e-8, 1.0), (1e9, 0.5), (0.7, 0.7)] {
        let angle = atan(y / x);
        let found = [(y, x), (y, -x), (-y, -x), (-y, x)].map(|(y, x)| elementary::atan2(y, x));
        for (found, expected) in found.into_iter().zip([angle, pi - angle, angle - pi, -angle]) {
            assert!((found - expected).abs() < 1e-15, "{y} {x}: {found} {expected}");
        }
    }
}

#[test]
fn libm_is_at_most_two_steps_away() {
    for (name, function, table) in FUNCTIONS {
        let other: fn([f64; 2]) -> f64 = match name {
            "sin" => |[a, _]| libm::sin(a),
            "cos" => |[a, _]| libm::cos(a),
            "tan" => |[a, _]| libm::tan(a),
            "exp" => |[a, _]| libm::exp(a),
            "ln" => |[a, _]| libm::log(a),
            "sinh" => |[a, _]| libm::sinh(a),
            "cosh" => |[a, _]| libm::cosh(a),
            "tanh" => |[a, _]| libm::tanh(a),
            "atan" => |[a, _]| libm::atan(a),
            "atan2" => |[a, b]| libm::atan2(a, b),
            _ => |[a, b]| libm::pow(a, b),
        };
        for Exact { arguments, .. } in function.lines(table) {
            let steps = steps(function.value(arguments), other(arguments)).abs();
            assert!(steps <= 2.0, "{name} of {arguments:?}: {steps}");
        }
    }
}

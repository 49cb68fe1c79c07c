//! Zeros, infinities, NaN, subnormal numbers and symmetry.

use elementary::{atan, atan2, cos, cosh, exp, ln, pow, sin, sinh, tan, tanh};

const INFINITY: f64 = f64::INFINITY;
const NAN: f64 = f64::NAN;
const LEAST: f64 = 5e-324;

type Unary = fn(f64) -> f64;
/// Name, function, and arguments with the expected values.
type Case<'a> = (&'a str, Unary, &'a [(f64, f64)]);

fn assert_same(name: &str, found: f64, expected: f64) {
    let same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
    assert!(same, "{name}: {found:?} instead of {expected:?}");
}

#[test]
fn special_arguments_have_the_values_of_the_standard() {
    let cases: [Case; 9] = [
        ("sin", sin, &[(-0.0, -0.0), (0.0, 0.0), (INFINITY, NAN), (NAN, NAN), (LEAST, LEAST), (-1e-310, -1e-310)]),
        ("cos", cos, &[(-0.0, 1.0), (0.0, 1.0), (-INFINITY, NAN), (NAN, NAN), (LEAST, 1.0)]),
        ("tan", tan, &[(-0.0, -0.0), (0.0, 0.0), (INFINITY, NAN), (NAN, NAN), (LEAST, LEAST), (-1e-310, -1e-310)]),
        (
            "exp",
            exp,
            &[(INFINITY, INFINITY), (-INFINITY, 0.0), (NAN, NAN), (710.0, INFINITY), (-746.0, 0.0), (-745.1, LEAST)],
        ),
        ("ln", ln, &[(0.0, -INFINITY), (-0.0, -INFINITY), (-1.0, NAN), (INFINITY, INFINITY), (NAN, NAN)]),
        ("sinh", sinh, &[(-0.0, -0.0), (LEAST, LEAST), (INFINITY, INFINITY), (-711.0, -INFINITY), (NAN, NAN)]),
        ("cosh", cosh, &[(-0.0, 1.0), (-INFINITY, INFINITY), (711.0, INFINITY), (NAN, NAN)]),
        ("tanh", tanh, &[(-0.0, -0.0), (LEAST, LEAST), (INFINITY, 1.0), (-INFINITY, -1.0), (20.0, 1.0), (NAN, NAN)]),
        (
            "atan",
            atan,
            &[
                (-0.0, -0.0),
                (LEAST, LEAST),
                (INFINITY, core::f64::consts::FRAC_PI_2),
                (NAN, NAN),
                (-1.0, -core::f64::consts::FRAC_PI_4),
            ],
        ),
    ];
    for (name, function, values) in cases {
        for &(x, expected) in values {
            assert_same(&format!("{name}({x:?})"), function(x), expected);
        }
    }
}

#[test]
fn rare_arguments_have_the_values_of_libm() {
    let numbers =
        [0.0, -0.0, 1.0, -1.0, 2.0, -2.0, 3.0, 0.5, -0.5, LEAST, -1e-310, 1e300, -1e300, INFINITY, -INFINITY, NAN];
    for a in numbers {
        for b in numbers {
            if !(b == 2.0 || a > 0.0 && a.is_normal() && b.is_finite()) {
                assert_same(&format!("pow({a:?}, {b:?})"), pow(a, b), libm::pow(a, b));
            }
            if [a, b].iter().any(|x| !x.is_normal()) {
                assert_same(&format!("atan2({a:?}, {b:?})"), atan2(a, b), libm::atan2(a, b));
            }
        }
    }
    for x in [1.000_1e5, -3e7, 1e22, f64::MAX] {
        assert_same("sin", sin(x), libm::sin(x));
        assert_same("cos", cos(x), libm::cos(x));
        assert_same("tan", tan(x), libm::tan(x));
    }
    assert_same("ln", ln(1e-310), libm::log(1e-310));
}

#[test]
fn functions_are_odd_or_even_to_the_bit() {
    let cases: [(&str, Unary, f64); 7] = [
        ("sin", sin, -1.0),
        ("cos", cos, 1.0),
        ("tan", tan, -1.0),
        ("sinh", sinh, -1.0),
        ("cosh", cosh, 1.0),
        ("tanh", tanh, -1.0),
        ("atan", atan, -1.0),
    ];
    for (name, function, sign) in cases {
        for number in 1..4000 {
            let x = f64::from(number) * 0.017_3;
            assert_same(name, function(-x), sign * function(x));
        }
    }
}

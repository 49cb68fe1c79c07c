//! Time of each function in ns, alone and in lanes, beside that of `libm`, and how many times as fast it is:
//! `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo run --release --package elementary --example pace`, with `x86-64` (SSE2),
//! `x86-64-v3` (AVX2) or `x86-64-v4 -C target-feature=-prefer-256-bit` (AVX-512).

use elementary as own;
use std::hint::black_box;
use std::time::Instant;

/// Number of arguments; they fit into the cache.
const COUNT: usize = 4096;

/// Repetitions of one measurement, of which the shortest counts.
const MEASUREMENTS: usize = 15;
const REPETITIONS: usize = 20;

/// A function alone, in lanes, and that of `libm`.
type Compared = (fn(f64) -> f64, fn(&mut [f64]), fn(f64) -> f64);

fn main() {
    let rows: [(&str, Compared, [f64; 2]); 13] = [
        ("sin", (own::sin, own::sin_all, libm::sin), [-0.5, 0.5]),
        ("sin", (own::sin, own::sin_all, libm::sin), [-10.0, 10.0]),
        ("sin", (own::sin, own::sin_all, libm::sin), [-1000.0, 1000.0]),
        ("cos", (own::cos, own::cos_all, libm::cos), [-10.0, 10.0]),
        ("tan", (own::tan, own::tan_all, libm::tan), [-10.0, 10.0]),
        ("exp", (own::exp, own::exp_all, libm::exp), [-10.0, 10.0]),
        ("ln", (own::ln, own::ln_all, libm::log), [0.01, 10.0]),
        ("sinh", (own::sinh, own::sinh_all, libm::sinh), [-5.0, 5.0]),
        ("cosh", (own::cosh, own::cosh_all, libm::cosh), [-5.0, 5.0]),
        ("tanh", (own::tanh, own::tanh_all, libm::tanh), [-5.0, 5.0]),
        ("atan", (own::atan, own::atan_all, libm::atan), [-5.0, 5.0]),
        ("atan2", (|y| own::atan2(y, black_box(1.7)), angles, |y| libm::atan2(y, black_box(1.7))), [-5.0, 5.0]),
        ("pow", (|x| own::pow(x, black_box(1.7)), powers, |x| libm::pow(x, black_box(1.7))), [0.1, 10.0]),
    ];
    println!(
        "{:5} {:>13}  {:>7} {:>7} {:>7}  {:>5} {:>5}",
        "", "arguments", "libm", "alone", "lanes", "alone", "lanes"
    );
    for (name, (alone, lanes, libm), [low, high]) in rows {
        let arguments = spread(low, high);
        let mut values = arguments.clone();
        let in_lanes = nanoseconds(|| {
            values.copy_from_slice(&arguments);
            lanes(black_box(&mut values));
        });
        let mut each = |function: fn(f64) -> f64| {
            nanoseconds(|| {
                values.iter_mut().zip(&arguments).for_each(|(value, x)| *value = black_box(function(black_box(*x))));
            })
        };
        let (libm, alone) = (each(libm), each(alone));
        let range = format!("{low} to {high}");
        println!(
            "{name:5} {range:>13}  {libm:7.2} {alone:7.2} {in_lanes:7.2}  {:5.2} {:5.1}",
            libm / alone,
            libm / in_lanes
        );
    }
}

fn powers(values: &mut [f64]) {
    own::pow_all(values, &[1.7; COUNT]);
}

fn angles(values: &mut [f64]) {
    own::atan2_all(values, &[1.7; COUNT]);
}

/// Arguments without order, so that no branch is foreseen.
fn spread(low: f64, high: f64) -> Vec<f64> {
    let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
    (0..COUNT).map(|number| low + (high - low) * (number as f64 * golden).fract()).collect()
}

/// Time for each of [`COUNT`] values, ns.
fn nanoseconds(mut run: impl FnMut()) -> f64 {
    let mut shortest = f64::INFINITY;
    for _ in 0..MEASUREMENTS {
        let start = Instant::now();
        (0..REPETITIONS).for_each(|_| run());
        shortest = shortest.min(start.elapsed().as_secs_f64());
    }
    shortest * 1e9 / (REPETITIONS * COUNT) as f64
}

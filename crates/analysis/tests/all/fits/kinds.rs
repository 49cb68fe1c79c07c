//! Kinds of records on which a search from the values of a document can miss the minimum.

use crate::support::Noise;
use core::f64::consts::{PI, TAU};

/// Kind of a record: its model, and a record with its true values.
pub struct Kind {
    pub name: &'static str,
    pub text: &'static str,
    pub varied: &'static [&'static str],
    pub make: fn(&mut Noise) -> Made,
}

/// True values in the order of the varied numbers, times and clean values, standard deviation of the noise.
pub struct Made {
    pub truth: Vec<f64>,
    pub times: Vec<f64>,
    pub values: Vec<f64>,
    pub noise: f64,
}

impl Made {
    fn new(truth: Vec<f64>, times: Vec<f64>, noise: f64, curve: impl Fn(f64) -> f64) -> Self {
        let values = times.iter().map(|time| curve(*time)).collect();
        Self { truth, times, values, noise }
    }
}

pub fn grid(count: u32, end: f64) -> Vec<f64> {
    (0..count).map(|row| end * f64::from(row) / f64::from(count - 1)).collect()
}

/// Between two numbers.
fn between(random: &mut Noise, low: f64, high: f64) -> f64 {
    low + (high - low) * random.uniform()
}

/// Solution of y'' = f(t, y, y') at ascending times from 0, by small steps of the classical Runge-Kutta method.
fn solution(times: &[f64], start: [f64; 2], acceleration: impl Fn(f64, f64, f64) -> f64) -> Vec<f64> {
    let ([mut y, mut v], mut t) = (start, 0.0);
    let mut values = Vec::new();
    for time in times {
        let h = (time - t) / 20.0;
        for _ in 0..20 {
            let (a1, b1) = (v, acceleration(t, y, v));
            let (a2, b2) = (v + h / 2.0 * b1, acceleration(t + h / 2.0, y + h / 2.0 * a1, v + h / 2.0 * b1));
            let (a3, b3) = (v + h / 2.0 * b2, acceleration(t + h / 2.0, y + h / 2.0 * a2, v + h / 2.0 * b2));
            let (a4, b4) = (v + h * b3, acceleration(t + h, y + h * a3, v + h * b3));
            y += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
            v += h / 6.0 * (b1 + 2.0 * b2 + 2.0 * b3 + b4);
            t += h;
        }
        t = *time;
        values.push(y);
    }
    values
}

pub const TWO_EXPONENTIALS: &str = "
parameter A = 1 [V] in 0..100
parameter a = 1 [s] in 0.001..100
parameter B = 1 [V] in 0..100
parameter b = 1 [s] in 0.001..100
y = A*exp(-t/a) + B*exp(-t/b)";
const TWO_ROOMS: &str = "
parameter k1 = 1 [1/s] in 0.001..100
parameter k2 = 1 [1/s] in 0.001..100
u' = -k1*u
v' = -k2*v
u(0) = 3
v(0) = 3
y = u + v";
const TWO_TONES: &str = "
parameter A = 0.02 [m] in 0..1
parameter w = 6.5 [rad/s] in 0.1..50
parameter B = 0.02 [m] in 0..1
parameter v = 6.5 [rad/s] in 0.1..50
y = A*cos(w*t) + B*cos(v*t)";
const TWO_SPRINGS: &str = "
parameter k1 = 40 [1/s^2] in 1..200
parameter k2 = 40 [1/s^2] in 1..200
parameter a = 0.03 [m] in -1..1
parameter b = 0.03 [m] in -1..1
u'' = -k1*u
v'' = -k2*v
u(0) = a
u'(0) = 0 [m/s]
v(0) = b
v'(0) = 0 [m/s]
y = u + v";
const DRIVEN: &str = "
parameter k = 10 [1/s^2] in 0.1..200
parameter g = 0.3 [1/s] in 0..10
parameter F = 1 [m/s^2] in 0..50
parameter w = 3 [rad/s] in 0.1..30
parameter x0 = 0 [m] in -2..2
parameter v0 = 0 [m/s] in -10..10
y'' + 2*g*y' + k*y = F*cos(w*t)
y(0) = x0
y'(0) = v0";
const BEAT: &str = "
parameter A = 0.02 [m] in 0..1
parameter w = 8 [rad/s] in 0.1..50
parameter d = 0 [rad] in -10..10
parameter B = 0.02 [m] in 0..1
parameter v = 10 [rad/s] in 0.1..50
parameter e = 0 [rad] in -10..10
y = A*cos(w*t + d) + B*cos(v*t + e)";
const PARAMETRIC: &str = "
parameter k = 20 [1/s^2] in 0.1..200
parameter g = 0.1 [1/s] in 0..10
parameter h = 0.2 in 0..1
parameter w = 5 [rad/s] in 0.1..50
parameter x0 = 0.05 [m] in -2..2
parameter v0 = 0 [m/s] in -10..10
y'' + 2*g*y' + k*(1 + h*cos(w*t))*y = 0
y(0) = x0
y'(0) = v0";
const CHIRP: &str = "
parameter A = 0.02 [m] in 0..1
parameter w = 5 [rad/s] in 0.1..50
parameter s = 0 [rad/s^2] in -10..10
parameter d = 0 [rad] in -10..10
y = A*cos(w*t + s*t^2/2 + d)";
const SINE_OF_X: &str = "
independent x
parameter A = 1 in 0..10
parameter f = 1 in 0..100
parameter phi = 0.5 in 0..6.2832
y = A*sin(f*x + phi)";
const SINE_OF_TIME: &str = "
parameter A = 1 [V] in 0..10
parameter f = 1 [Hz] in 0..100
parameter phi = 0.5 in 0..6.2832
y = A*sin(2*pi*f*t + phi)";
pub const COSINE: &str = "
parameter A = 0.04 [m] in -1..1
parameter gamma = 0.4 [1/s] in 0..20
parameter omega = 10 [rad/s] in 0.1..100
parameter delta = 0 [rad] in -7..7
parameter c = 0 [m] in -1..1
y = A*exp(-gamma*t)*cos(omega*t + delta) + c";

fn two_exponentials(random: &mut Noise) -> Made {
    let (p, q) = (between(random, 1.0, 4.0), between(random, 1.0, 4.0));
    let a = between(random, 0.3, 1.0);
    let b = a * between(random, 2.5, 6.0);
    Made::new(vec![p, a, q, b], grid(101, 10.0), 0.02, move |t| p * libm::exp(-t / a) + q * libm::exp(-t / b))
}

fn two_rooms(random: &mut Noise) -> Made {
    let p = between(random, 0.2, 1.5);
    let q = p * between(random, 2.0, 8.0);
    Made::new(vec![p, q], grid(101, 5.0), 0.03, move |t| 3.0 * (libm::exp(-p * t) + libm::exp(-q * t)))
}

fn tones(random: &mut Noise) -> [f64; 4] {
    let w = between(random, 4.0, 9.0);
    let apart = between(random, 0.8, 4.0);
    [between(random, 0.015, 0.05), w, between(random, 0.015, 0.05), w + apart]
}

fn two_tones(random: &mut Noise) -> Made {
    let [p, w, q, v] = tones(random);
    Made::new(vec![p, w, q, v], grid(301, 9.0), 2e-3, move |t| p * libm::cos(w * t) + q * libm::cos(v * t))
}

fn two_springs(random: &mut Noise) -> Made {
    let [p, w, q, v] = tones(random);
    Made::new(vec![w * w, v * v, p, q], grid(301, 9.0), 2e-3, move |t| p * libm::cos(w * t) + q * libm::cos(v * t))
}

fn driven(random: &mut Noise) -> Made {
    let (k, g) = (between(random, 8.0, 60.0), between(random, 0.05, 0.4));
    let (force, w) = (between(random, 0.5, 4.0), between(random, 1.5, 9.0));
    let (x, v) = (between(random, -0.3, 0.3), between(random, -1.0, 1.0));
    let times = grid(251, 20.0);
    let values = solution(&times, [x, v], |t, y, v| force * libm::cos(w * t) - 2.0 * g * v - k * y);
    let size = values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    Made { truth: vec![k, g, force, w, x, v], times, values, noise: 0.03 * size }
}

fn beat(random: &mut Noise) -> Made {
    let [p, w, q, v] = tones(random);
    let (d, e) = (between(random, -PI, PI), between(random, -PI, PI));
    let truth = vec![p, w, d, q, v, e];
    Made::new(truth, grid(401, 12.0), 2e-3, move |t| p * libm::cos(w * t + d) + q * libm::cos(v * t + e))
}

fn parametric(random: &mut Noise) -> Made {
    let (k, g) = (between(random, 10.0, 40.0), between(random, 0.05, 0.15));
    let (h, w) = (between(random, 0.1, 0.3), k.sqrt() * between(random, 0.7, 2.2));
    let x = between(random, 0.03, 0.1);
    let times = grid(301, 15.0);
    let values = solution(&times, [x, 0.0], |t, y, v| -2.0 * g * v - k * (1.0 + h * libm::cos(w * t)) * y);
    let size = values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    Made { truth: vec![k, g, h, w, x, 0.0], times, values, noise: 0.01 * size }
}

fn chirp(random: &mut Noise) -> Made {
    let (a, w, d) = (between(random, 0.01, 0.05), between(random, 3.0, 8.0), between(random, -PI, PI));
    let s = between(random, 0.2, 2.0);
    let curve = move |t: f64| a * libm::cos(w * t + s * t * t / 2.0 + d);
    Made::new(vec![a, w, s, d], grid(401, 10.0), 0.05 * a, curve)
}

fn phase_of_x(random: &mut Noise) -> Made {
    let (a, f, phi) = (between(random, 0.5, 3.0), between(random, 1.0, 6.0), between(random, 0.0, TAU));
    Made::new(vec![a, f, phi], grid(201, 6.2), 0.05, move |x| a * libm::sin(f * x + phi))
}

fn phase_of_time(random: &mut Noise) -> Made {
    let (a, f, phi) = (between(random, 0.5, 3.0), between(random, 0.5, 4.0), between(random, 0.0, TAU));
    Made::new(vec![a, f, phi], grid(201, 6.2), 0.05, move |t| a * libm::sin(TAU * f * t + phi))
}

/// Damped cosine whose clock begins anywhere between 0 and 1e9 s. Its true values count from the first row.
fn clock(random: &mut Noise) -> Made {
    let begins = match random.uniform() {
        few if few < 0.2 => 0.0,
        _ => libm::pow(10.0, between(random, 0.0, 9.0)).round(),
    };
    let (a, g, w) = (between(random, 0.03, 0.08), between(random, 0.1, 0.5), between(random, 6.0, 12.0));
    let (d, c) = (between(random, -3.0, 3.0), between(random, -0.01, 0.01));
    let mut made =
        Made::new(vec![a, g, w, d, c], grid(241, 8.0), 5e-4, move |t| a * libm::exp(-g * t) * libm::cos(w * t + d) + c);
    made.times.iter_mut().for_each(|time| *time += begins);
    made
}

pub const KINDS: [Kind; 11] = [
    Kind { name: "two exponentials", text: TWO_EXPONENTIALS, varied: &["A", "a", "B", "b"], make: two_exponentials },
    Kind { name: "two rooms", text: TWO_ROOMS, varied: &["k1", "k2"], make: two_rooms },
    Kind { name: "two tones", text: TWO_TONES, varied: &["A", "w", "B", "v"], make: two_tones },
    Kind { name: "two springs", text: TWO_SPRINGS, varied: &["k1", "k2", "a", "b"], make: two_springs },
    Kind { name: "driven", text: DRIVEN, varied: &["k", "g", "F", "w", "x0", "v0"], make: driven },
    Kind { name: "beat", text: BEAT, varied: &["A", "w", "d", "B", "v", "e"], make: beat },
    Kind { name: "parametric", text: PARAMETRIC, varied: &["k", "g", "h", "w", "x0", "v0"], make: parametric },
    Kind { name: "chirp", text: CHIRP, varied: &["A", "w", "s", "d"], make: chirp },
    Kind { name: "phase of x", text: SINE_OF_X, varied: &["A", "f", "phi"], make: phase_of_x },
    Kind { name: "phase of time", text: SINE_OF_TIME, varied: &["A", "f", "phi"], make: phase_of_time },
    Kind { name: "clock", text: COSINE, varied: &["A", "gamma", "omega", "delta", "c"], make: clock },
];

//! Motions of bodies: the place at each sixteenth of a frame.

use super::{Dice, FINE};

/// A pendulum whose greatest speed is so many radii a frame.
pub fn swing(dice: &mut Dice, [wide, high]: [f64; 2], radius: f64, speed: f64, count: usize) -> Vec<[f64; 2]> {
    let (length, most) = (dice.between(0.5, 0.75) * high, dice.between(0.3, 0.8));
    // Radians a frame.
    let omega = speed * radius / (length * most);
    let (decay, phase) = (dice.between(0.0, 0.004), dice.between(0.0, std::f64::consts::TAU));
    let place = |k: usize| {
        let t = k as f64 / FINE as f64;
        let angle = most * libm::exp(-decay * t) * libm::cos(omega * t + phase);
        [wide / 2.0 + length * libm::sin(angle), 0.1 * high + length * libm::cos(angle)]
    };
    (0..count).map(place).collect()
}

/// Two bodies that swing against one another about one middle.
pub fn twins(dice: &mut Dice, [wide, high]: [f64; 2], radius: f64, speed: f64, count: usize) -> Vec<Vec<[f64; 2]>> {
    let apart = dice.between(0.0, 0.6) * radius;
    let mut path = |sign: f64| -> Vec<[f64; 2]> {
        let far = dice.between(0.2, 0.4) * wide;
        let omega = speed * radius / far * dice.between(0.8, 1.0);
        let (phase, bend) = (dice.between(-0.4, 0.4), dice.between(0.0, 0.15) * high);
        let place = |k: usize| {
            let swing = libm::cos(omega * k as f64 / FINE as f64 + phase);
            [wide / 2.0 + sign * far * swing, 0.6 * high + sign * apart / 2.0 - bend * swing * swing]
        };
        (0..count).map(place).collect()
    };
    vec![path(1.0), path(-1.0)]
}

/// Up a slope and back.
pub fn slope(dice: &mut Dice, [wide, high]: [f64; 2], radius: f64, speed: f64, count: usize) -> Vec<[f64; 2]> {
    let start = dice.between(0.1, 0.3) * wide;
    let way = dice.between(0.4, 0.6) * wide;
    let (velocity, tilt) = (speed * radius, dice.between(0.0, 0.3));
    let brake = velocity * velocity / (2.0 * way);
    let period = 2.0 * velocity / brake;
    let place = |k: usize| {
        let t = (k as f64 / FINE as f64) % period;
        let far = velocity * t - brake * t * t / 2.0;
        [start + far, 0.8 * high - tilt * far]
    };
    (0..count).map(place).collect()
}

/// Two equal bobs on rods of equal length, whose greatest speed is so many pixels a frame.
/// They start from rest, at angles to the vertical of which the first is `least` to `most` radians and the second at most `most`.
pub fn double_pendulum(
    dice: &mut Dice,
    pivot: [f64; 2],
    length: f64,
    [least, most]: [f64; 2],
    speed: f64,
    count: usize,
) -> Vec<Vec<[f64; 2]>> {
    let mut state = [dice.between(least, most) * dice.sign(), dice.between(-most, most), 0.0, 0.0];
    // M. Levien, S. M. Tan, Am. J. Phys. 61 (1993) 1038: equal masses and lengths, in units of sqrt(l / g).
    let rates = |[a, b, p, q]: [f64; 4]| {
        let (sine, cosine) = libm::sincos(a - b);
        let below = 2.0 - cosine * cosine;
        let first = (-2.0 * libm::sin(a) - sine * (q * q + p * p * cosine) + libm::sin(b) * cosine) / below;
        let second = (2.0 * sine * (p * p + libm::cos(a)) + q * q * sine * cosine) / below;
        [p, q, first, second]
    };
    let plus = |state: [f64; 4], rate: [f64; 4], step: f64| [0, 1, 2, 3].map(|k| state[k] + step * rate[k]);
    let ends = |state: [f64; 4]| {
        let first = [pivot[0] + length * libm::sin(state[0]), pivot[1] + length * libm::cos(state[0])];
        [first, [first[0] + length * libm::sin(state[1]), first[1] + length * libm::cos(state[1])]]
    };
    // The fastest that the second bob becomes from rest at these angles is about 3 l/sqrt(l/g).
    let step = speed / (3.0 * length) / FINE as f64;
    let mut places = vec![Vec::new(), Vec::new()];
    for _ in 0..count {
        places.iter_mut().zip(ends(state)).for_each(|(places, end)| places.push(end));
        let one = rates(state);
        let two = rates(plus(state, one, step / 2.0));
        let three = rates(plus(state, two, step / 2.0));
        let four = rates(plus(state, three, step));
        let mean = [0, 1, 2, 3].map(|k| (one[k] + 2.0 * two[k] + 2.0 * three[k] + four[k]) / 6.0);
        state = plus(state, mean, step);
    }
    places
}

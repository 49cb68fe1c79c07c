//! Films in colour with known truth, drawn for the virtual camera: bodies that are hard to follow, varied by a seed.

use film::camera::{Exposure, Noise, instants};
use film::{Colour, Plane};
use units::split_mix::SplitMix64;

/// Something hard to follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Both bobs of a double pendulum.
    DoublePendulum,
    /// Two equal bodies that cross.
    Twins,
    /// A grey bob that swings before leaves.
    Leaves,
    /// A ball with spots that rolls up a slope and back.
    Ball,
    /// A bob that swings before a wall, a part of which has the grey value of the bob.
    Wall,
    /// A bob that swings before an even wall.
    Plain,
}

/// A disc with spots that turn with it.
#[derive(Clone)]
struct Paint {
    shade: [f64; 3],
    /// Distance and direction from the middle, radius, all in parts of the body's radius; and grey value.
    spots: Vec<[f64; 4]>,
    /// Radians for each pixel to the right.
    roll: f64,
}

/// A film that is drawn frame by frame.
pub struct Stage {
    pub width: usize,
    pub height: usize,
    /// Of each body, in pixels.
    pub radius: f64,
    /// Greatest speed in radii a frame.
    pub speed: f64,
    coloured: bool,
    /// Part of the time between frames.
    exposure: f64,
    /// The wall's grey values, and its colours for a block of two times two pixels.
    wall: [Vec<u8>; 3],
    paints: Vec<Paint>,
    /// Points joined by rods, besides the bodies.
    pivot: Option<[f64; 2]>,
    /// The place of each body at each sixteenth of a frame.
    places: Vec<Vec<[f64; 2]>>,
    noise: Noise,
}

/// Places between two frames.
const FINE: usize = 16;

pub struct Dice(SplitMix64);

impl Dice {
    pub fn new(seed: u64) -> Dice {
        Dice(SplitMix64::new(seed))
    }

    pub fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * (self.0.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn sign(&mut self) -> f64 {
        if self.0.bits() >> 63 == 0 { 1.0 } else { -1.0 }
    }
}

impl Stage {
    /// A film of so many rows and frames.
    pub fn new(kind: Kind, seed: u64, height: usize, frames: usize, coloured: bool) -> Stage {
        let mut dice = Dice::new(seed.wrapping_mul(7919) ^ kind as u64);
        let width = height * 4 / 3;
        let (wide, high) = (width as f64, height as f64);
        let radius = dice.between(5.0, (0.06 * high).clamp(6.0, 40.0));
        let speed = dice.between(0.3, 2.0);
        let count = frames * FINE + 2 * FINE;
        let places = match kind {
            Kind::DoublePendulum => {
                double_pendulum(&mut dice, [wide / 2.0, 0.45 * high], 0.2 * high, radius * speed, count)
            }
            Kind::Twins => twins(&mut dice, [wide, high], radius, speed, count),
            Kind::Ball => vec![slope(&mut dice, [wide, high], radius, speed, count)],
            Kind::Leaves | Kind::Wall | Kind::Plain => vec![swing(&mut dice, [wide, high], radius, speed, count)],
        };
        let base = [dice.between(70.0, 180.0), 128.0, 128.0];
        let hue = |dice: &mut Dice, grey: f64, far: f64| {
            let angle = dice.between(0.0, std::f64::consts::TAU);
            [grey, 128.0 + far * libm::cos(angle), 128.0 + far * libm::sin(angle)]
        };
        let far = dice.between(50.0, 90.0) * dice.sign();
        let grey = if base[0] + far > 30.0 && base[0] + far < 225.0 { base[0] + far } else { base[0] - far };
        let mut wall = wall(&mut dice, [width, height], base);
        let mut shades = vec![hue(&mut dice, grey, 35.0), hue(&mut dice, grey, 35.0)];
        match kind {
            Kind::Leaves => {
                shades = vec![[grey, 128.0, 128.0]];
                leaves(&mut dice, &mut wall, [width, height]);
            }
            Kind::Wall => {
                shades.truncate(1);
                blocks(&mut dice, &mut wall, width, grey);
            }
            Kind::DoublePendulum => {
                // Before a wall of nearly the same grey, if the colours differ.
                if coloured && dice.sign() > 0.0 {
                    shades.iter_mut().for_each(|shade| shade[0] = base[0] + dice.between(-12.0, 12.0));
                } else if dice.sign() > 0.0 {
                    shades[1] = shades[0];
                }
            }
            Kind::Twins => shades[1] = shades[0],
            Kind::Ball | Kind::Plain => shades.truncate(1),
        }
        let paint = |shade: [f64; 3]| {
            let spots = (0..if kind == Kind::Ball { 6 } else { 0 })
                .map(|k| [dice.between(0.2, 0.7), f64::from(k) * 1.05, dice.between(0.15, 0.3), 255.0 - shade[0]])
                .collect();
            Paint { shade, spots, roll: if kind == Kind::Ball { 1.0 / radius } else { 0.0 } }
        };
        let paints = shades.into_iter().map(paint).collect();
        let pivot = (kind == Kind::DoublePendulum).then_some([wide / 2.0, 0.45 * high]);
        let exposure = dice.between(0.05, 0.5);
        let noise = Noise::new(dice.between(1.0, 4.0), seed);
        let level = |k: usize| move |shade: &[f64; 3]| level(shade[k]);
        let halved = |k: usize| -> Vec<u8> {
            wall.chunks(width).step_by(2).flat_map(|row| row.iter().step_by(2)).map(level(k)).collect()
        };
        let wall = [wall.iter().map(level(0)).collect(), halved(1), halved(2)];
        Stage { width, height, radius, speed, coloured, exposure, wall, paints, pivot, places, noise }
    }

    /// How many bodies there are.
    pub fn bodies(&self) -> usize {
        self.places.len()
    }

    /// Where the middle of a body is at a time in frames.
    pub fn place(&self, body: usize, time: f64) -> [f64; 2] {
        let at = ((time + 1.0) * FINE as f64).max(0.0);
        let places = &self.places[body];
        let (whole, part) = ((at as usize).min(places.len() - 2), at - at.floor());
        let (one, next) = (places[whole], places[whole + 1]);
        [0, 1].map(|k| one[k] + part * (next[k] - one[k]))
    }

    /// A click within so much of a body's radius, which depends on a seed.
    pub fn click(&self, body: usize, frame: usize, seed: u64, part: f64) -> [f64; 2] {
        let mut dice = Dice::new(seed ^ 0x5eed);
        let (far, angle) = (part * dice.between(0.0, 1.0).sqrt(), dice.between(0.0, std::f64::consts::TAU));
        let [x, y] = self.place(body, frame as f64);
        [x + far * self.radius * libm::cos(angle), y + far * self.radius * libm::sin(angle)]
    }

    /// A frame.
    pub fn frame(&self, frame: usize) -> Plane {
        let drawn = |time: f64| self.drawn(time);
        let mut pictures = instants(frame as f64, self.exposure, 4).map(drawn);
        let mut exposure = Exposure::new(&pictures.next().expect("a picture"));
        pictures.for_each(|picture| assert!(exposure.add(&picture)));
        exposure.develop(&self.noise, frame as u64).expect("a picture")
    }

    fn drawn(&self, time: f64) -> Plane {
        let mut picture = self.wall.clone();
        let mut ends: Vec<[f64; 2]> = self.pivot.into_iter().collect();
        ends.extend((0..self.bodies()).map(|body| self.place(body, time)).filter(|_| self.pivot.is_some()));
        for pair in ends.windows(2) {
            let length = libm::hypot(pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]);
            for k in 0..(2.0 * length) as usize {
                let [x, y] =
                    [0, 1].map(|axis| pair[0][axis] + k as f64 / (2.0 * length) * (pair[1][axis] - pair[0][axis]));
                self.disc(&mut picture, [x, y], 1.0, |_, _| [40.0, 128.0, 128.0]);
            }
        }
        for (body, paint) in self.paints.iter().enumerate() {
            let middle = self.place(body, time);
            let (sine, cosine) = libm::sincos(-paint.roll * middle[0]);
            self.disc(&mut picture, middle, self.radius, |u, v| {
                let (u, v) = (u / self.radius, v / self.radius);
                let gleam = 40.0 * libm::exp(-((u + 0.4) * (u + 0.4) + (v + 0.4) * (v + 0.4)) / 0.05);
                let (p, q) = (cosine * u - sine * v, sine * u + cosine * v);
                let spotted = paint.spots.iter().find(|[far, angle, size, _]| {
                    libm::hypot(p - far * libm::cos(*angle), q - far * libm::sin(*angle)) < *size
                });
                let grey = spotted.map_or(paint.shade[0], |spot| spot[3]);
                [grey - 10.0 * (u + v) + gleam, paint.shade[1], paint.shade[2]]
            });
        }
        let [grey, blue, red] = picture;
        let plane = Plane::new(self.width, self.height, grey).expect("a plane");
        if self.coloured { plane.coloured(Colour { blue, red }).expect("colours") } else { plane }
    }

    /// Draws a disc with a soft edge; `shade` of the place from its middle.
    fn disc(&self, picture: &mut [Vec<u8>; 3], [x, y]: [f64; 2], radius: f64, shade: impl Fn(f64, f64) -> [f64; 3]) {
        let range = |at: f64, size: usize| {
            ((at - radius - 1.0).max(0.0) as usize)..((at + radius + 2.0).clamp(0.0, size as f64) as usize)
        };
        for row in range(y, self.height) {
            for column in range(x, self.width) {
                let (u, v) = (column as f64 + 0.5 - x, row as f64 + 0.5 - y);
                let cover = (radius + 0.5 - libm::hypot(u, v)).clamp(0.0, 1.0);
                if cover > 0.0 {
                    let shade = shade(u, v);
                    let mut blend = |k: usize, place: usize| {
                        let value = f64::from(picture[k][place]);
                        picture[k][place] = level(value + cover * (shade[k] - value));
                    };
                    blend(0, row * self.width + column);
                    if row % 2 == 0 && column % 2 == 0 {
                        let place = row / 2 * self.width.div_ceil(2) + column / 2;
                        (1..3).for_each(|k| blend(k, place));
                    }
                }
            }
        }
    }
}

fn level(value: f64) -> u8 {
    value.round().clamp(0.0, 255.0) as u8
}

/// Uneven light and a fine texture.
fn wall(dice: &mut Dice, [width, height]: [usize; 2], base: [f64; 3]) -> Vec<[f64; 3]> {
    let texture = dice.between(0.0, 5.0);
    let (p, q) = (dice.between(0.1, 0.6), dice.between(0.1, 0.6));
    let (slope, across) = (dice.between(-20.0, 20.0), dice.between(-20.0, 20.0));
    let pixel = |at: usize| {
        let (x, y) = ((at % width) as f64, (at / width) as f64);
        let grey = base[0] + slope * (y / height as f64 - 0.5) + across * (x / width as f64 - 0.5);
        [grey + texture * libm::sin(p * x + 0.3 * q * y) * libm::sin(q * y), base[1], base[2]]
    };
    (0..width * height).map(pixel).collect()
}

/// Many ellipses of many greys and greens.
fn leaves(dice: &mut Dice, wall: &mut [[f64; 3]], [width, height]: [usize; 2]) {
    for _ in 0..400 {
        let (x, y) = (dice.between(0.0, width as f64), dice.between(0.0, height as f64));
        let (long, short) = (dice.between(0.02, 0.06) * height as f64, dice.between(0.01, 0.025) * height as f64);
        let (sine, cosine) = libm::sincos(dice.between(0.0, std::f64::consts::PI));
        let shade = [dice.between(40.0, 210.0), dice.between(100.0, 128.0), dice.between(95.0, 128.0)];
        for row in ((y - long).max(0.0) as usize)..((y + long).min(height as f64) as usize) {
            for column in ((x - long).max(0.0) as usize)..((x + long).min(width as f64) as usize) {
                let (u, v) = (column as f64 - x, row as f64 - y);
                let (p, q) = ((cosine * u + sine * v) / long, (cosine * v - sine * u) / short);
                if p * p + q * q < 1.0 {
                    wall[row * width + column] = shade;
                }
            }
        }
    }
}

/// Upright boards with the grey value of the body, some with another colour.
fn blocks(dice: &mut Dice, wall: &mut [[f64; 3]], width: usize, grey: f64) {
    for board in 0..3 {
        let left = (0.15 + 0.3 * f64::from(board)) * width as f64;
        let right = left + dice.between(0.04, 0.12) * width as f64;
        let shade = [grey + dice.between(-6.0, 6.0), dice.between(110.0, 146.0), dice.between(110.0, 146.0)];
        for row in wall.chunks_mut(width) {
            row[left as usize..(right as usize).min(width)].fill([shade[0], shade[1], shade[2]]);
        }
    }
}

/// A pendulum whose greatest speed is so many radii a frame.
fn swing(dice: &mut Dice, [wide, high]: [f64; 2], radius: f64, speed: f64, count: usize) -> Vec<[f64; 2]> {
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
fn twins(dice: &mut Dice, [wide, high]: [f64; 2], radius: f64, speed: f64, count: usize) -> Vec<Vec<[f64; 2]>> {
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
fn slope(dice: &mut Dice, [wide, high]: [f64; 2], radius: f64, speed: f64, count: usize) -> Vec<[f64; 2]> {
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
fn double_pendulum(dice: &mut Dice, pivot: [f64; 2], length: f64, speed: f64, count: usize) -> Vec<Vec<[f64; 2]>> {
    let mut state = [dice.between(0.8, 1.8) * dice.sign(), dice.between(-1.8, 1.8), 0.0, 0.0];
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

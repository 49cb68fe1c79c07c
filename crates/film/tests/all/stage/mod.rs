//! Films in colour with known truth, drawn for the virtual camera: bodies that are hard to follow, varied by a seed.

mod motions;
mod walls;

use film::camera::{Exposure, Noise, instants};
use film::{Colour, Plane};
use motions::{double_pendulum, slope, swing, twins};
use units::split_mix::SplitMix64;
use walls::{blocks, boards, leaves};

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
    /// A grey bob that swings before a fence, whose boards have the grey values of the bob.
    Boards,
    /// Both bobs of a fast double pendulum before a wall of their own grey.
    Chaos,
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
    /// Radius of each body, px.
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
        let speed = dice.between(if kind == Kind::Chaos { 1.2 } else { 0.3 }, 2.0);
        let count = frames * FINE + 2 * FINE;
        let places = match kind {
            Kind::DoublePendulum | Kind::Chaos => {
                let angles = if kind == Kind::Chaos { [1.8, 2.8] } else { [0.8, 1.8] };
                double_pendulum(&mut dice, [wide / 2.0, 0.45 * high], 0.2 * high, angles, radius * speed, count)
            }
            Kind::Twins => twins(&mut dice, [wide, high], radius, speed, count),
            Kind::Ball => vec![slope(&mut dice, [wide, high], radius, speed, count)],
            Kind::Leaves | Kind::Wall | Kind::Plain | Kind::Boards => {
                vec![swing(&mut dice, [wide, high], radius, speed, count)]
            }
        };
        let base = [dice.between(70.0, 180.0), 128.0, 128.0];
        let hue = |dice: &mut Dice, grey: f64, far: f64| {
            let angle = dice.between(0.0, std::f64::consts::TAU);
            [grey, 128.0 + far * libm::cos(angle), 128.0 + far * libm::sin(angle)]
        };
        let far = dice.between(50.0, 90.0) * dice.sign();
        let grey = if base[0] + far > 30.0 && base[0] + far < 225.0 { base[0] + far } else { base[0] - far };
        let mut wall = walls::wall(&mut dice, [width, height], base);
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
            Kind::Boards => {
                shades = vec![[grey, 128.0, 128.0]];
                boards(&mut dice, &mut wall, width, grey);
            }
            Kind::Chaos => shades.iter_mut().for_each(|shade| shade[0] = base[0] + dice.between(-12.0, 12.0)),
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
        let pivot = matches!(kind, Kind::DoublePendulum | Kind::Chaos).then_some([wide / 2.0, 0.45 * high]);
        let exposure = dice.between(0.05, 0.5);
        let noise = Noise::new(dice.between(1.0, 4.0), seed);
        let level = |k: usize| move |shade: &[f64; 3]| level(shade[k]);
        let halved = |k: usize| -> Vec<u8> {
            wall.chunks(width).step_by(2).flat_map(|row| row.iter().step_by(2)).map(level(k)).collect()
        };
        let wall = [wall.iter().map(level(0)).collect(), halved(1), halved(2)];
        Stage { width, height, radius, speed, coloured, exposure, wall, paints, pivot, places, noise }
    }

    /// Number of bodies.
    pub fn bodies(&self) -> usize {
        self.places.len()
    }

    /// Centre of a body, px. `time` in frames.
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

//! Virtual camera: films of drawings with known positions, for tests and teaching of tracking.
//!
//! An exposure is the mean of several drawings at instants while the shutter is open. Sensor noise is added; its
//! variance is proportional to the light.

use crate::plane::{Colour, Plane};
use libm::{cos, log, sqrt};
use units::split_mix::SplitMix64;

/// Number of precomputed normal deviates. Each row of a picture starts at another one.
const DEVIATES: usize = 1 << 16;
/// Grey value at which the standard deviation of the noise is given.
const REFERENCE: f64 = 128.0;
/// Grey value below which the noise is constant: readout noise of a pixel.
const DARKEST: f64 = 4.0;

/// Instants in s of an exposure of `duration` s, evenly spaced about its middle `time` (s). All equal `time` if
/// `duration` is 0.
pub fn instants(time: f64, duration: f64, count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |at| time + duration * ((at as f64 + 0.5) / count as f64 - 0.5))
}

/// Sensor noise.
#[derive(Clone, Debug)]
pub struct Noise {
    deviates: Vec<f32>,
    /// Standard deviation at each grey value.
    sigma: [f32; 256],
    seed: u64,
}

impl Noise {
    /// Noise with the standard deviation `sigma` at grey value 128, proportional to the square root of the grey value.
    /// `sigma` is limited to 0 to 128 grey values. Equal seeds give equal noise.
    pub fn new(sigma: f64, seed: u64) -> Noise {
        let sigma = if sigma.is_finite() { sigma.clamp(0.0, 128.0) } else { 0.0 };
        let uniform = |at: u64| (mixed(seed ^ mixed(at)) >> 11) as f64 / (1_u64 << 53) as f64;
        // Box and Muller, Ann. Math. Stat. 29 (1958) 610.
        let deviate = |at: u64| {
            let (radius, angle) = (1.0 - uniform(2 * at), uniform(2 * at + 1));
            (sqrt(-2.0 * log(radius)) * cos(std::f64::consts::TAU * angle)) as f32
        };
        let mut levels = [0.0; 256];
        for (level, grey) in levels.iter_mut().zip(0_u16..) {
            *level = (sigma * sqrt(f64::from(grey).max(DARKEST) / REFERENCE)) as f32;
        }
        Noise { deviates: (0..DEVIATES as u64).map(deviate).collect(), sigma: levels, seed }
    }
}

/// Sum of the drawings of one frame.
#[derive(Clone, Debug)]
pub struct Exposure {
    width: usize,
    height: usize,
    light: Vec<u32>,
    /// Sums of both colour differences, for coloured drawings.
    colour: Option<[Vec<u32>; 2]>,
    drawings: u32,
}

impl Exposure {
    /// Starts with the first drawing.
    pub fn new(first: &Plane) -> Exposure {
        let light = |values: &[u8]| values.iter().map(|value| u32::from(*value)).collect();
        let colour = first.colour().map(|colour| [&colour.blue, &colour.red].map(|values| light(values)));
        Exposure { width: first.width(), height: first.height(), light: light(first.grey()), colour, drawings: 1 }
    }

    /// Adds a drawing of another instant. Returns false and changes nothing if its size differs from that of the first
    /// drawing, if it lacks colours that the first one has, or after 65536 drawings.
    pub fn add(&mut self, drawing: &Plane) -> bool {
        let fits = (drawing.width(), drawing.height()) == (self.width, self.height) && self.drawings < 1 << 16;
        let fits = fits && (self.colour.is_none() || drawing.colour().is_some());
        if fits {
            let add = |light: &mut [u32], values: &[u8]| {
                light.iter_mut().zip(values).for_each(|(light, value)| *light += u32::from(*value));
            };
            add(&mut self.light, drawing.grey());
            if let Some(([blue, red], colour)) = self.colour.as_mut().zip(drawing.colour()) {
                add(blue, &colour.blue);
                add(red, &colour.red);
            }
            self.drawings += 1;
        }
        fits
    }

    /// Mean of the drawings, with the noise of frame number `frame`.
    pub fn develop(&self, noise: &Noise, frame: u64) -> Option<Plane> {
        let plane = Plane::new(self.width, self.height, self.developed(&self.light, noise, frame))?;
        let Some(colour) = &self.colour else { return Some(plane) };
        // The colour planes use the noise of other frame numbers, so that it is independent of the grey noise.
        let [blue, red] = [(&colour[0], 1), (&colour[1], 2)]
            .map(|(light, at)| self.developed(light, noise, frame.wrapping_add(at << 32)));
        plane.coloured(Colour { blue, red })
    }

    /// Mean of one plane with noise, row by row.
    fn developed(&self, light: &[u32], noise: &Noise, frame: u64) -> Vec<u8> {
        let drawings = self.drawings as f32;
        let mut values = Vec::with_capacity(light.len());
        for (row, line) in light.chunks(self.width).enumerate() {
            let start = mixed(noise.seed ^ mixed(frame) ^ (row as u64).rotate_left(32)) as usize;
            for (column, light) in line.iter().enumerate() {
                let mean = *light as f32 / drawings;
                let deviate = noise.deviates.get((start.wrapping_add(column)) % DEVIATES).copied().unwrap_or(0.0);
                let sigma = noise.sigma.get(mean as usize).copied().unwrap_or(0.0);
                values.push((mean + sigma * deviate).round() as u8);
            }
        }
        values
    }
}

/// Hash of a number.
fn mixed(number: u64) -> u64 {
    SplitMix64::new(number).bits()
}

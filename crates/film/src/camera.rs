//! A camera for drawings: films of which the truth is known, so that tracking can be learned and tested without a laboratory.
//!
//! A real exposure collects light as long as the shutter is open. Here it is the mean of several drawings made for instants
//! within that time, and noise is added as a sensor has it: its variance grows with the light.

use crate::plane::{Colour, Plane};
use libm::{cos, log, sqrt};
use units::split_mix::SplitMix64;

/// Normal deviates that are computed once; each row of a picture reads them from another place on.
const DEVIATES: usize = 1 << 16;
/// The grey value at which the standard deviation of the noise is stated.
const REFERENCE: f64 = 128.0;
/// Below this grey value the noise does not decrease further: reading a pixel has noise of its own.
const DARKEST: f64 = 4.0;

/// The instants of an exposure of `duration` seconds whose middle is at `time`, evenly distributed; without duration all are
/// equal to `time`.
pub fn instants(time: f64, duration: f64, count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |at| time + duration * ((at as f64 + 0.5) / count as f64 - 0.5))
}

/// The noise of a sensor.
#[derive(Clone, Debug)]
pub struct Noise {
    deviates: Vec<f32>,
    /// The standard deviation for each grey value.
    sigma: [f32; 256],
    seed: u64,
}

impl Noise {
    /// Noise whose standard deviation is `sigma` grey values at a grey of 128, and goes with the square root of the light. Pictures
    /// of equal `seed` have the same noise.
    pub fn new(sigma: f64, seed: u64) -> Noise {
        let sigma = if sigma.is_finite() { sigma.clamp(0.0, 128.0) } else { 0.0 };
        let uniform = |at: u64| (mixed(seed ^ mixed(at)) >> 11) as f64 / (1_u64 << 53) as f64;
        // G. E. P. Box, M. E. Muller, Ann. Math. Stat. 29 (1958) 610.
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

/// The drawings of one frame.
#[derive(Clone, Debug)]
pub struct Exposure {
    width: usize,
    height: usize,
    light: Vec<u32>,
    /// Sums of both colour differences, of coloured drawings.
    colour: Option<[Vec<u32>; 2]>,
    drawings: u32,
}

impl Exposure {
    /// Begins with the first drawing.
    pub fn new(first: &Plane) -> Exposure {
        let light = |values: &[u8]| values.iter().map(|value| u32::from(*value)).collect();
        let colour = first.colour().map(|colour| [&colour.blue, &colour.red].map(|values| light(values)));
        Exposure { width: first.width(), height: first.height(), light: light(first.grey()), colour, drawings: 1 }
    }

    /// Adds the drawing of another instant. Whether it has the size of the first one, and colours if that has some; otherwise
    /// nothing changes.
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

    /// The picture: the mean of the drawings with the noise of the frame of this number.
    pub fn develop(&self, noise: &Noise, frame: u64) -> Option<Plane> {
        let plane = Plane::new(self.width, self.height, self.developed(&self.light, noise, frame))?;
        let Some(colour) = &self.colour else { return Some(plane) };
        // Of another frame, whose noise is as independent as that of a colour is.
        let [blue, red] = [(&colour[0], 1), (&colour[1], 2)]
            .map(|(light, at)| self.developed(light, noise, frame.wrapping_add(at << 32)));
        plane.coloured(Colour { blue, red })
    }

    /// The mean of a plane's drawings, with noise.
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

/// A number of which each bit depends on all bits of another.
fn mixed(number: u64) -> u64 {
    SplitMix64::new(number).bits()
}

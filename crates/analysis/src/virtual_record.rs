//! Virtual measurements: readings of a simulated run by a camera, with random and systematic errors.
//!
//! The true values behind such a record are known, so that the result of a fit can be compared with them.

use units::split_mix::SplitMix64;

/// Camera, with the errors of its readings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Frame rate, per SI unit of the independent variable (Hz for a time).
    pub rate: f64,
    /// Duration of the film, SI.
    pub duration: f64,
    /// Readings are rounded to multiples of this, SI; 0 for no rounding.
    pub pixel: f64,
    /// Standard deviation of a reading, SI.
    pub noise: f64,
    /// Standard deviation of the instant of a frame, SI. The recorded instant is the nominal one.
    pub jitter: f64,
    /// Relative error of the scale: 0.02 makes every reading 2 % too large.
    pub scale: f64,
    /// Seed of the random errors.
    pub seed: u64,
}

/// Upper bound of the number of frames.
pub const MOST_FRAMES: usize = 20_000;

impl Camera {
    /// Recorded instants, SI: evenly spaced from 0.
    pub fn times(&self) -> Vec<f64> {
        let frames = (self.duration * self.rate + 1e-9).clamp(0.0, MOST_FRAMES as f64 - 1.0) as usize + 1;
        (0..frames).map(|frame| frame as f64 / self.rate).collect()
    }

    /// One reading, SI, for each of [`Self::times`]; `truth` is the value at any instant from 0 to the last frame.
    pub fn read(&self, mut truth: impl FnMut(f64) -> f64) -> Vec<f64> {
        let mut chance = Chance::new(self.seed);
        let times = self.times();
        let last = times.last().copied().unwrap_or_default();
        let mut reading = |time: &f64| {
            // Both deviates are always drawn, so that changing one error does not change the other.
            let (early, off) = chance.normals();
            let value = truth((time + self.jitter * early).clamp(0.0, last)) * (1.0 + self.scale) + self.noise * off;
            if self.pixel > 0.0 { (value / self.pixel).round() * self.pixel } else { value }
        };
        times.iter().map(&mut reading).collect()
    }
}

/// Random numbers that are the same for the same seed on every machine.
#[derive(Clone, Debug)]
pub struct Chance(SplitMix64);

impl Chance {
    /// Generator with this seed.
    pub fn new(seed: u64) -> Self {
        Self(SplitMix64::new(seed))
    }

    /// Uniformly distributed number, above 0 and at most 1.
    pub fn uniform(&mut self) -> f64 {
        ((self.0.bits() >> 11) + 1) as f64 / (1_u64 << 53) as f64
    }

    /// Two independent normal deviates of mean 0 and variance 1 (Box and Muller 1958).
    pub fn normals(&mut self) -> (f64, f64) {
        let radius = libm::sqrt(-2.0 * libm::log(self.uniform()));
        let (sine, cosine) = libm::sincos(core::f64::consts::TAU * self.uniform());
        (radius * cosine, radius * sine)
    }
}

/// Velocities as computed by tracking programs, one per value, in its unit per unit of the times: central difference of the neighbours, NaN at the ends.
pub fn tracked_velocities(times: &[f64], values: &[f64]) -> Vec<f64> {
    let inner = times.windows(3).zip(values.windows(3));
    let inner = inner.map(|(time, value)| (value[2] - value[0]) / (time[2] - time[0]));
    let mut velocities: Vec<f64> = std::iter::once(f64::NAN).chain(inner).collect();
    velocities.resize(values.len(), f64::NAN);
    velocities
}

#[cfg(test)]
mod tests {
    use super::*;

    const STILL: Camera =
        Camera { rate: 100.0, duration: 199.99, pixel: 0.0, noise: 0.0, jitter: 0.0, scale: 0.0, seed: 1 };

    fn moments(values: &[f64]) -> (f64, f64) {
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        (mean, values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / count)
    }

    #[test]
    fn deviates_are_normal() {
        let mut chance = Chance::new(7);
        let pairs: Vec<(f64, f64)> = (0..50_000).map(|_| chance.normals()).collect();
        let (one, two): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
        for values in [&one, &two] {
            let (mean, variance) = moments(values);
            assert!(mean.abs() < 0.02 && (variance - 1.0).abs() < 0.03, "{mean} {variance}");
            let fourth = values.iter().map(|value| value * value * value * value).sum::<f64>() / 50_000.0;
            assert!((fourth - 3.0).abs() < 0.15, "{fourth}");
            let within = values.iter().filter(|value| value.abs() < 1.0).count() as f64 / 50_000.0;
            assert!((within - 0.6827).abs() < 0.01, "{within}");
        }
        let together = pairs.iter().map(|(one, two)| one * two).sum::<f64>() / 50_000.0;
        assert!(together.abs() < 0.02, "{together}");
    }

    #[test]
    fn each_error_is_as_large_as_asked() {
        let noisy = Camera { noise: 0.003, ..STILL };
        let (mean, variance) = moments(&noisy.read(|_| 0.25));
        assert!((mean - 0.25).abs() < 1e-4 && (variance / 9e-6 - 1.0).abs() < 0.05);
        // On a ramp, an error of the instant is an error of the position.
        let shaky = Camera { jitter: 0.002, ..STILL };
        let off: Vec<f64> = shaky.read(|time| 5.0 * time).iter().zip(shaky.times()).map(|(y, t)| y - 5.0 * t).collect();
        assert!((moments(&off).1 / 1e-4 - 1.0).abs() < 0.05);
        let stretched = Camera { scale: 0.02, ..STILL };
        assert!(stretched.read(|time| time).iter().zip(stretched.times()).all(|(y, t)| (y - 1.02 * t).abs() < 1e-12));
        // Rounding to pixels is a uniform error of variance p^2/12.
        let coarse = Camera { pixel: 0.01, ..STILL };
        let rounded: Vec<f64> =
            coarse.read(libm::sin).iter().zip(coarse.times()).map(|(y, t)| y - libm::sin(t)).collect();
        assert!(rounded.iter().all(|off| off.abs() <= 0.005 + 1e-12));
        assert!((moments(&rounded).1 * 12.0 / 1e-4 - 1.0).abs() < 0.05);
    }

    #[test]
    fn the_same_seed_gives_the_same_bits() {
        let camera =
            Camera { rate: 30.0, duration: 8.0, pixel: 4e-4, noise: 5e-4, jitter: 1e-3, scale: 0.01, seed: 42 };
        let bits = |camera: Camera| camera.read(libm::cos).iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        assert_eq!(camera.times().len(), 241);
        assert_eq!(bits(camera), bits(camera));
        assert_ne!(bits(camera), bits(Camera { seed: 43, ..camera }));
        // Changing another error leaves the noise unchanged.
        let alone = Camera { pixel: 0.0, jitter: 0.0, scale: 0.0, ..camera };
        let shaken = Camera { jitter: 1e-3, ..alone };
        assert!(alone.read(|_| 0.0).iter().zip(shaken.read(|_| 0.0)).all(|(one, other)| *one == other));
    }

    #[test]
    fn what_is_asked_for_is_bounded() {
        assert_eq!(Camera { rate: 1e9, ..STILL }.times().len(), MOST_FRAMES);
        assert_eq!(Camera { duration: f64::NAN, ..STILL }.times().len(), 1);
        assert_eq!(Camera { duration: -1.0, ..STILL }.times(), [0.0]);
    }

    #[test]
    fn velocities_are_those_of_a_tracking_program() {
        let velocities = tracked_velocities(&[0.0, 0.5, 1.0], &[1.0, 2.0, 4.0]);
        assert!(velocities[0].is_nan() && velocities[1] == 3.0 && velocities[2].is_nan());
        assert_eq!(tracked_velocities(&[], &[]).len(), 0);
    }
}

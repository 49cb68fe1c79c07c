//! Films with known truth: a tube with a liquid that swings, and a pendulum.

use film::Plane;
use film::tracking::Similarity;
use units::split_mix::{GOLDEN, scramble};

pub const WIDTH: usize = 180;
pub const HEIGHT: usize = 240;

/// Settings of a film. Rate in frames per second.
#[derive(Clone)]
pub struct Camera {
    pub rate: f64,
    pub frames: usize,
    /// Exposure time, s.
    pub exposure: f64,
    /// Readout time from the first row to the last, s.
    pub readout: f64,
    /// Standard deviation of the noise, grey values.
    pub noise: f64,
    /// Fraction of the light that flickers at 100 Hz.
    pub flicker: f64,
    /// Amplitude of the camera shake, px.
    pub shake: f64,
    pub seed: u64,
}

impl Default for Camera {
    fn default() -> Self {
        Camera { rate: 30.0, frames: 120, exposure: 0.004, readout: 0.0, noise: 2.0, flicker: 0.0, shake: 0.0, seed: 1 }
    }
}

/// Filmed scene. Coordinates in px, times in s.
pub trait Scene {
    /// Position of the object at a time.
    fn place(&self, t: f64) -> [f64; 2];
    /// Grey value of a point at a time.
    fn grey(&self, x: f64, y: f64, t: f64) -> f64;
    /// True if a point shows something that moves now.
    fn moving(&self, x: f64, y: f64, t: f64) -> bool;
    /// True if a point shows something that moves at any time.
    fn changed(&self, x: f64, y: f64) -> bool;
}

/// 0 to 1 around zero, as a lens shows an edge.
fn step(z: f64, width: f64) -> f64 {
    0.5 * (1.0 + libm::erf(z / (width * std::f64::consts::SQRT_2)))
}

/// A wall with uneven light and four dark discs.
fn wall(x: f64, y: f64) -> f64 {
    let light = 200.0 - 25.0 * ((x - 110.0) / 180.0) * ((x - 110.0) / 180.0) - 15.0 * y / 240.0
        + 2.0 * libm::sin(0.21 * x + 0.13 * y) * libm::sin(0.9 * x);
    MARKS.iter().fold(light, |light, [u, v]| light + step(7.0 - libm::hypot(x - u, y - v), 0.6) * (30.0 - light))
}

/// The discs.
pub const MARKS: [[f64; 2]; 4] = [[20.0, 25.0], [160.0, 30.0], [25.0, 215.0], [155.0, 210.0]];

/// A liquid in an upright tube.
#[derive(Clone)]
pub struct Tube {
    pub axis: f64,
    pub rest: f64,
    /// Pixels.
    pub amplitude: f64,
    /// Seconds.
    pub period: f64,
    pub decay: f64,
    /// Grey values between air and liquid, relative to usual ones.
    pub contrast: f64,
    pub drops: bool,
    /// From this time on, further surfaces at these distances in place of the first one.
    pub jump: Option<(f64, [f64; 2])>,
    /// Between these times the surface cannot be seen.
    pub hidden: (f64, f64),
}

impl Default for Tube {
    fn default() -> Self {
        let hidden = (f64::INFINITY, f64::INFINITY);
        Tube {
            axis: 91.0,
            rest: 123.0,
            amplitude: 45.0,
            period: 0.71,
            decay: 4.1,
            contrast: 1.0,
            drops: false,
            jump: None,
            hidden,
        }
    }
}

const INNER: f64 = 10.0;

impl Tube {
    fn level(&self, t: f64) -> f64 {
        let phase = std::f64::consts::TAU / self.period * t + 0.4;
        self.rest - self.amplitude * libm::exp(-t / self.decay) * libm::cos(phase)
    }
}

impl Scene for Tube {
    fn place(&self, t: f64) -> [f64; 2] {
        let shift = self.jump.filter(|jump| t >= jump.0).map_or(0.0, |jump| jump.1[0]);
        [self.axis, self.level(t) + shift]
    }

    fn grey(&self, x: f64, y: f64, t: f64) -> f64 {
        let base = wall(x, y);
        let u = (x - self.axis) / INNER;
        let inside = step(INNER - (x - self.axis).abs(), 0.6);
        let round = (u * u).min(1.0);
        let mut column = base - 5.0 * round;
        let levels = match self.jump.filter(|jump| t >= jump.0) {
            Some((_, shifts)) => shifts.map(|shift| self.level(t) + shift).to_vec(),
            None => vec![self.level(t)],
        };
        for level in levels.into_iter().filter(|_| t < self.hidden.0 || t > self.hidden.1) {
            let depth = y - level + 2.5 * round;
            let bell = |at: f64, width: f64| libm::exp(-0.5 * ((depth - at) / width) * ((depth - at) / width));
            let surface = -45.0 * step(depth, 0.8) - 70.0 * bell(3.0, 1.8) + 20.0 * bell(-2.5, 1.3);
            column += self.contrast * surface;
        }
        if self.drops {
            for (dx, dy) in [(-4.0, -40.0), (5.0, -16.0), (-2.0, 15.0), (5.0, 36.0)] {
                column -= 40.0 * step(2.5 - libm::hypot(x - self.axis - dx, y - self.rest - dy), 0.6);
            }
        }
        let glass = -55.0 * libm::exp(-((u.abs() - 1.12) / 0.12) * ((u.abs() - 1.12) / 0.12));
        base + inside * (column - base) + glass * (1.0 - inside)
    }

    fn moving(&self, x: f64, y: f64, t: f64) -> bool {
        let (far, around) =
            ((y - self.level(t)).abs(), self.jump.map_or(28.0, |jump| 28.0 + jump.1[0].abs() + jump.1[1].abs()));
        (x - self.axis).abs() < INNER + 1.5 && far < around
    }

    fn changed(&self, x: f64, _: f64) -> bool {
        (x - self.axis).abs() < INNER + 1.5
    }
}

/// A ball that swings, and is hidden behind a wall between two times.
#[derive(Clone)]
pub struct Pendulum {
    pub radius: f64,
    pub hidden: (f64, f64),
}

impl Default for Pendulum {
    fn default() -> Self {
        Pendulum { radius: 11.0, hidden: (f64::INFINITY, f64::INFINITY) }
    }
}

impl Scene for Pendulum {
    fn place(&self, t: f64) -> [f64; 2] {
        let angle = 0.35 * libm::exp(-t / 20.0) * libm::cos(std::f64::consts::TAU / 1.1 * t + 0.3);
        [90.0 + 160.0 * libm::sin(angle), 10.0 + 160.0 * libm::cos(angle)]
    }

    fn grey(&self, x: f64, y: f64, t: f64) -> f64 {
        let base = wall(x, y);
        if t > self.hidden.0 && t < self.hidden.1 {
            return base;
        }
        let [u, v] = self.place(t);
        let (dx, dy) = (x - u, y - v);
        let gleam = 60.0 * libm::exp(-((dx + 4.0) * (dx + 4.0) + (dy + 4.0) * (dy + 4.0)) / 12.0);
        base + step(self.radius - libm::hypot(dx, dy), 0.6) * (60.0 + gleam - base)
    }

    fn moving(&self, x: f64, y: f64, t: f64) -> bool {
        let [u, v] = self.place(t);
        (x - u).abs().max((y - v).abs()) < self.radius + 12.0
    }

    fn changed(&self, x: f64, y: f64) -> bool {
        (libm::hypot(x - 90.0, y - 10.0) - 160.0).abs() < self.radius + 20.0
    }
}

/// A frame, and what is true of it.
pub struct Frame {
    pub time: f64,
    pub plane: Plane,
    /// Position of the object in the picture when its row is read (px), and that time (s, `instant`).
    pub seen: [f64; 2],
    pub instant: f64,
}

/// A random number with a standard normal distribution for a counter: four uniform ones from its hash.
fn normal(counter: u64) -> f64 {
    let z = scramble(counter.wrapping_mul(GOLDEN));
    let parts = (0..4).map(|k| ((z >> (16 * k)) & 0xffff) as f64 / 65_535.0 - 0.5);
    parts.sum::<f64>() * 3.0_f64.sqrt()
}

/// Motion of the camera in a frame.
pub fn held(camera: &Camera, n: usize) -> Similarity {
    let t = n as f64 / camera.rate;
    let wander =
        |p: f64| libm::sin(2.5 * t + p) + 0.7 * libm::sin(9.0 * t + 2.0 * p) + 0.3 * libm::sin(21.0 * t + 3.0 * p);
    let (sine, cosine) = libm::sincos(camera.shake * 0.002 * wander(5.0));
    Similarity { a: cosine, b: sine, c: camera.shake * wander(1.0), d: camera.shake * wander(3.0) }
}

/// Films a scene.
pub fn film(scene: &impl Scene, camera: &Camera) -> Vec<Frame> {
    // On a tripod the stationary points are equal in all frames.
    let still: Vec<f64> = pixels().map(|[x, y]| scene.grey(x, y, 0.0)).collect();
    (0..camera.frames).map(|n| frame(scene, camera, n, &still)).collect()
}

/// The middles of all pixels.
fn pixels() -> impl Iterator<Item = [f64; 2]> {
    (0..HEIGHT).flat_map(|row| (0..WIDTH).map(move |column| [column as f64 + 0.5, row as f64 + 0.5]))
}

fn frame(scene: &impl Scene, camera: &Camera, n: usize, still: &[f64]) -> Frame {
    let t = n as f64 / camera.rate;
    let held = held(camera, n);
    let light = 1.0 + camera.flicker * libm::sin(std::f64::consts::TAU * 100.0 * t);
    let instants = if camera.exposure > 0.01 { 7_u32 } else { 3 };
    let mut grey = Vec::with_capacity(WIDTH * HEIGHT);
    for (at, pixel) in pixels().enumerate() {
        let late = camera.readout * (pixel[1] / HEIGHT as f64 - 0.5);
        let [x, y] = held.undo(pixel);
        let instant = |k: u32| t + late + ((f64::from(k) + 0.5) / f64::from(instants) - 0.5) * camera.exposure;
        let value = if scene.moving(x, y, t) {
            (0..instants).map(|k| scene.grey(x, y, instant(k))).sum::<f64>() / f64::from(instants)
        } else if camera.shake > 0.0 || scene.changed(x, y) {
            scene.grey(x, y, t)
        } else {
            still[at]
        };
        let counter = camera.seed << 40 | (n * WIDTH * HEIGHT + at) as u64;
        let noise = if camera.noise > 0.0 { camera.noise * normal(counter) } else { 0.0 };
        grey.push((light * value + noise).round().clamp(0.0, 255.0) as u8);
    }
    let mut instant = t;
    let mut seen = [0.0; 2];
    for _ in 0..8 {
        seen = held.apply(scene.place(instant));
        instant = t + camera.readout * (seen[1] / HEIGHT as f64 - 0.5);
    }
    Frame { time: t, plane: Plane::new(WIDTH, HEIGHT, grey).expect("a plane"), seen, instant }
}

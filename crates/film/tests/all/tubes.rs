//! Films of a liquid in a tube with all that disturbs: marks inside the bore, textured walls, reflections, steps of the exposure,
//! hands, leaves behind clear water, interlaced rows, a bumped camera, coarse compression. Geometry is free, and the truth is known.

use film::Plane;
use units::split_mix::SplitMix64;

/// Filmed tube and settings of the film. Lengths in px, times in frames, brightness in grey values.
#[derive(Clone, Debug)]
pub struct Filmed {
    pub size: [usize; 2],
    pub frames: usize,
    /// Half the width of the bore.
    pub inner: f64,
    /// The angle between tube and picture's columns.
    pub tilt: f64,
    /// The surface swings about this row of the axis.
    pub rest: f64,
    pub swing: f64,
    pub period: f64,
    pub decay: f64,
    /// The part of a frame that the shutter is open.
    pub shutter: f64,
    /// Brightness of the wall.
    pub light: f64,
    /// Liquid less air, and the line along the surface.
    pub liquid: f64,
    pub line: f64,
    pub noise: f64,
    /// Distance and brightness of the marks inside the bore.
    pub marks: Option<(f64, f64)>,
    /// Strength of the texture of the wall, which is seen through the bore.
    pub texture: f64,
    /// Amplitude of the motion of the texture, as of leaves; the liquid shows it mirrored and fainter.
    pub leaves: Option<f64>,
    /// Brightness, size and swing of a reflection that moves along the bore.
    pub reflection: Option<[f64; 3]>,
    /// Factors of the brightness from some frames on.
    pub exposures: Vec<(usize, f64)>,
    pub flicker: f64,
    /// A hand is before the tube from the first to before the last of these frames.
    pub hand: Option<(usize, usize)>,
    /// Odd rows are taken half a frame later.
    pub comb: bool,
    /// From this frame on the camera points elsewhere.
    pub bump: Option<(usize, [f64; 2])>,
    /// Pixels by which the picture moves in each frame.
    pub drift: [f64; 2],
    /// The step in which a coarse compression rounds changes of blocks.
    pub blocks: f64,
    pub seed: u64,
}

impl Default for Filmed {
    fn default() -> Self {
        Filmed {
            size: [120, 240],
            frames: 120,
            inner: 9.0,
            tilt: 0.0,
            rest: 125.0,
            swing: 40.0,
            period: 21.0,
            decay: 120.0,
            shutter: 0.15,
            light: 190.0,
            liquid: -45.0,
            line: -60.0,
            noise: 2.0,
            marks: None,
            texture: 0.0,
            leaves: None,
            reflection: None,
            exposures: Vec::new(),
            flicker: 0.0,
            hand: None,
            comb: false,
            bump: None,
            drift: [0.0; 2],
            blocks: 0.0,
            seed: 1,
        }
    }
}

/// A film with its truth.
pub struct Taken {
    pub planes: Vec<Plane>,
    /// Intersection of surface and axis in each frame, px of the first picture.
    pub truth: Vec<[f64; 2]>,
    /// Intersection of surface and axis in each frame, px of its own picture.
    pub seen: Vec<[f64; 2]>,
    pub hidden: Vec<bool>,
    /// Two points of the axis.
    pub axis: [[f64; 2]; 2],
}

/// Uniform numbers from 0 to 1.
pub struct Draw(SplitMix64);

impl Draw {
    pub fn new(seed: u64) -> Draw {
        Draw(SplitMix64::new(seed))
    }

    pub fn next(&mut self) -> f64 {
        self.0.bits() as f64 / u64::MAX as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// 0 to 1 around zero, over about two pixels.
fn step(z: f64) -> f64 {
    let z = (z / 2.4 + 0.5).clamp(0.0, 1.0);
    z * z * (3.0 - 2.0 * z)
}

fn bell(z: f64) -> f64 {
    libm::exp(-0.5 * z * z)
}

/// Uneven light: sums of waves in several directions, each with its change of phase along and across, and its phase.
struct Waves([[f64; 3]; 6]);

impl Waves {
    fn new(seed: u64) -> Waves {
        let mut draw = Draw::new(seed ^ 0x5eed);
        Waves(std::array::from_fn(|_| {
            let (angle, length, phase) = (draw.between(0.0, 3.0), draw.between(5.0, 26.0), draw.between(0.0, 6.0));
            let (sine, cosine) = libm::sincos(angle);
            let number = std::f64::consts::TAU / length;
            [number * cosine, number * sine, phase]
        }))
    }

    /// From -2 to 2.
    fn at(&self, x: f64, y: f64) -> f64 {
        self.0.iter().map(|[across, along, phase]| libm::sin(x * across + y * along + phase)).sum::<f64>() / 3.0
    }
}

impl Filmed {
    fn level(&self, t: f64) -> f64 {
        self.rest - self.swing * libm::exp(-t / self.decay) * libm::cos(std::f64::consts::TAU * t / self.period + 0.4)
    }

    fn center(&self) -> [f64; 2] {
        [self.size[0] as f64 / 2.0 + 0.3, self.size[1] as f64 / 2.0]
    }

    /// Across and along the tube.
    fn place(&self, x: f64, y: f64) -> [f64; 2] {
        let (sine, cosine) = libm::sincos(self.tilt);
        let [cx, cy] = self.center();
        [(x - cx) * cosine + (y - cy) * sine, (y - cy) * cosine - (x - cx) * sine + cy]
    }

    /// The point of the axis at a row.
    fn point(&self, along: f64) -> [f64; 2] {
        let (sine, cosine) = libm::sincos(self.tilt);
        let [cx, cy] = self.center();
        [cx - (along - cy) * sine, cy + (along - cy) * cosine]
    }

    fn wall(&self, waves: &Waves, [x, y]: [f64; 2], t: f64, mirrored: bool) -> f64 {
        let [cx, _] = self.center();
        let mut value = self.light * (1.0 - 0.0006 * (x - cx).abs() - 0.0003 * y);
        if self.texture > 0.0 {
            let moved =
                self.leaves.map_or(0.0, |far| far * libm::sin(0.23 * t) + 0.6 * far * libm::sin(0.11 * t + 1.0));
            let (x, strength) = if mirrored { (2.0 * cx - x, 0.75) } else { (x, 1.0) };
            value += strength * self.texture * waves.at(x + moved, y + 0.4 * moved);
        }
        value
    }

    fn grey(&self, waves: &Waves, [x, y]: [f64; 2], t: f64) -> f64 {
        let [across, along] = self.place(x, y);
        let u = across / self.inner;
        let inside = step(self.inner - across.abs());
        let thick = 0.3 * self.inner + 1.5;
        let glass = step(self.inner + thick - across.abs()) - inside;
        let mut value = self.wall(waves, [x, y], t, false) - 40.0 * glass * self.light / 190.0;
        if inside > 0.0 {
            let depth = along - self.level(t) + 0.12 * self.inner * (u * u).min(1.0);
            let wet = step(depth);
            let air = value - 6.0 * u * u;
            let liquid = if self.leaves.is_some() { self.wall(waves, [x, y], t, true) } else { air } + self.liquid;
            let mut column = air + (liquid - air) * wet + self.line * bell((depth - 2.5) / 1.7);
            if let Some((distance, dark)) = self.marks {
                let far = (along - 3.0) - distance * ((along - 3.0) / distance).round();
                column += dark * step(0.9 - far.abs()) * step(0.45 * self.inner - across);
            }
            if let Some([bright, size, far]) = self.reflection {
                let at = self.rest + 0.3 * self.swing + far * libm::sin(0.19 * t + 1.3);
                column += bright * bell((along - at) / size) * bell((u - 0.3) / 0.5);
            }
            value += inside * (column - value);
        }
        value
    }

    fn hides(&self, x: f64, y: f64, n: usize) -> bool {
        let Some((first, end)) = self.hand.filter(|(first, end)| (*first..*end).contains(&n)) else { return false };
        // It comes from the left and leaves to the left.
        let edge = 0.5 * self.size[0] as f64 + 2.5 * self.inner + 8.0;
        let part = (n - first + 1).min(end - n).min(3) as f64 / 3.0;
        (0.15..0.85).contains(&(y / self.size[1] as f64)) && x < edge * part
    }

    fn moves(&self, x: f64, y: f64) -> bool {
        self.leaves.is_some() || self.place(x, y)[0].abs() < self.inner + 1.5
    }

    pub fn film(&self) -> Taken {
        let (waves, skin) = (Waves::new(self.seed), Waves::new(77));
        let [wide, high] = self.size;
        let pixels = || (0..wide * high).map(move |at| ((at % wide) as f64 + 0.5, (at / wide) as f64 + 0.5));
        let still: Vec<f64> = pixels().map(|(x, y)| self.grey(&waves, [x, y], 0.0)).collect();
        let bumped: Vec<f64> = match self.bump {
            Some((_, [dx, dy])) => pixels().map(|(x, y)| self.grey(&waves, [x - dx, y - dy], 0.0)).collect(),
            None => Vec::new(),
        };
        let mut draw = Draw::new(self.seed);
        let mut taken = Taken {
            planes: Vec::new(),
            truth: Vec::new(),
            seen: Vec::new(),
            hidden: Vec::new(),
            axis: [self.point(4.0), self.point(high as f64 - 4.0)],
        };
        let mut kept: Vec<f64> = Vec::new();
        for n in 0..self.frames {
            let shift = self.bump.filter(|bump| n >= bump.0).map_or([0.0; 2], |bump| bump.1);
            let still = if shift == [0.0; 2] { &still } else { &bumped };
            let t = n as f64;
            let shift = [0, 1].map(|k| shift[k] + self.drift[k] * t);
            let drifts = self.drift != [0.0; 2];
            let exposed = self.exposures.iter().rev().find(|one| n >= one.0).map_or(1.0, |one| one.1);
            let light = exposed * (1.0 + self.flicker * libm::sin(2.1 * t));
            let mut grey: Vec<f64> = Vec::with_capacity(wide * high);
            for (at, (x, y)) in pixels().enumerate() {
                let late = if self.comb && (at / wide) % 2 == 1 { 0.5 } else { 0.0 };
                let (px, py) = (x - shift[0], y - shift[1]);
                let value = if self.hides(x, y, n) {
                    0.55 * self.light + 8.0 * skin.at(x - 3.0 * t, y)
                } else if drifts || self.moves(px, py) {
                    let grey = |k: f64| self.grey(&waves, [px, py], t + late + k * self.shutter);
                    (grey(-0.33) + grey(0.0) + grey(0.33)) / 3.0
                } else {
                    still[at]
                };
                let noise = (0..3).map(|_| draw.next() - 0.5).sum::<f64>() * 2.0;
                grey.push(
                    (light * value + self.noise * noise * (value.max(4.0) / 128.0).sqrt()).round().clamp(0.0, 255.0),
                );
            }
            if self.blocks > 0.0 {
                compress(&mut grey, &mut kept, wide, self.blocks, n % 60 == 0);
            }
            taken.planes.push(Plane::new(wide, high, grey.iter().map(|value| *value as u8).collect()).unwrap());
            let level = if self.comb { 0.5 * (self.level(t) + self.level(t + 0.5)) } else { self.level(t) };
            let [x, y] = self.point(level);
            taken.truth.push([x, y]);
            taken.seen.push([x + shift[0], y + shift[1]]);
            let hidden = (-2..3).all(|k| self.hides(x, y + 4.0 * f64::from(k), n));
            taken.hidden.push(hidden);
        }
        taken
    }
}

/// Rounds the changes of blocks of 8 times 8 pixels since the picture before, after a Walsh-Hadamard transform; small ones vanish.
fn compress(grey: &mut [f64], kept: &mut Vec<f64>, wide: usize, size: f64, whole: bool) {
    if kept.is_empty() {
        *kept = vec![128.0; grey.len()];
    }
    let size = if whole { 0.5 * size } else { size };
    let high = grey.len() / wide;
    for top in (0..high).step_by(8) {
        for left in (0..wide).step_by(8) {
            let at = |k: usize| {
                let (row, column) = ((top + k / 8).min(high - 1), (left + k % 8).min(wide - 1));
                row * wide + column
            };
            let mut block: [f64; 64] = std::array::from_fn(|k| grey[at(k)] - kept[at(k)]);
            hadamard(&mut block);
            block.iter_mut().for_each(|value| *value = size * (value.abs() / size + 0.33).floor() * value.signum());
            hadamard(&mut block);
            for (k, change) in block.iter().enumerate() {
                if top + k / 8 < high && left + k % 8 < wide {
                    let value = (kept[at(k)] + change / 64.0).round().clamp(0.0, 255.0);
                    grey[at(k)] = value;
                }
            }
        }
    }
    kept.copy_from_slice(grey);
}

fn hadamard(block: &mut [f64; 64]) {
    let mut wide = 1;
    while wide < 64 {
        for first in (0..64).step_by(2 * wide) {
            for k in first..first + wide {
                let (a, b) = (block[k], block[k + wide]);
                (block[k], block[k + wide]) = (a + b, a - b);
            }
        }
        wide *= 2;
    }
}

/// A film of one of some kinds, each with a geometry of its own for every seed; `least` has few frames and rows, for tests.
pub fn kind(name: &str, seed: u64, least: bool) -> Filmed {
    let mut draw = Draw::new(name.bytes().fold(seed, |seed, byte| seed.wrapping_mul(977) ^ u64::from(byte)));
    let high = if least { draw.between(200.0, 260.0) } else { draw.between(240.0, 640.0) }.round();
    let inner = draw.between(5.0, (high / 16.0 - 3.0).min(25.0));
    let swing = draw.between(0.05, 0.3) * high;
    let sign = if draw.next() < 0.5 { -1.0 } else { 1.0 };
    let frames = if least { 72 } else { draw.between(100.0, 260.0) as usize };
    let mut film = Filmed {
        size: [(high / 8.0 + 50.0) as usize, high as usize],
        frames,
        inner,
        tilt: if draw.next() < 0.4 { draw.between(-0.2, 0.2) } else { 0.0 },
        rest: draw.between(0.45, 0.6) * high,
        swing,
        period: draw.between(9.0, 50.0),
        decay: draw.between(80.0, 400.0),
        light: if sign < 0.0 { draw.between(150.0, 210.0) } else { draw.between(90.0, 130.0) },
        liquid: sign * draw.between(15.0, 50.0),
        line: sign * draw.between(20.0, 60.0),
        noise: draw.between(1.0, 4.0),
        marks: Some((draw.between(8.0, 25.0), -draw.between(25.0, 70.0))),
        seed,
        ..Filmed::default()
    };
    match name {
        "comb" => film.comb = true,
        "dark" => {
            film.light = 26.0;
            film.liquid = -draw.between(7.0, 11.0);
            film.line = -8.0;
            film.marks = film.marks.map(|(far, _)| (far, -12.0));
            film.noise = 5.0;
        }
        "steps" => {
            film.light = 130.0;
            film.exposures = (1..6).map(|k| (k * film.frames / 6, draw.between(0.6, 1.4))).collect();
            film.flicker = 0.04;
        }
        "reflection" => {
            film.reflection = Some([draw.between(40.0, 90.0), draw.between(3.0, 9.0), draw.between(0.1, 0.25) * high])
        }
        "leaves" | "plain leaves" => {
            film.texture = draw.between(18.0, 35.0);
            film.leaves = Some(draw.between(0.5, 2.5));
            film.liquid = -draw.between(3.0, 8.0);
            film.line = -draw.between(20.0, 40.0);
            film.light = 150.0;
            if name == "plain leaves" {
                film.marks = None;
            }
        }
        "hand" => film.hand = Some((frames / 2, frames / 2 + 10)),
        "bump" => {
            film.texture = 10.0;
            film.bump = Some((frames * 2 / 5, [draw.between(-4.0, 4.0), sign * draw.between(4.0, 8.0)]));
        }
        "low" => film.blocks = draw.between(150.0, 400.0),
        "small" => {
            film.swing = draw.between(2.0, 4.0);
            film.blocks = draw.between(60.0, 160.0);
            film.period = draw.between(20.0, 50.0);
        }
        "textured" => film.texture = draw.between(15.0, 40.0),
        _ => {}
    }
    film
}

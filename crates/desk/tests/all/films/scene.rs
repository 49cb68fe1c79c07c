//! A film with known truth: an oscillating liquid in an upright tube, generated as luma planes.

use desk::film::Plane;
use desk::film::containers::{Codec, Coding, Container, Film, Orientation, Sample};
use desk::{Desk, FilmIdentity};

pub const WIDTH: usize = 160;
pub const HEIGHT: usize = 240;
/// Frames a second.
pub const RATE: f64 = 30.0;
/// Size of a pixel in metres.
pub const PIXEL: f64 = 1e-3;
/// Axis of the tube and level at rest, in pixels.
pub const AXIS: f64 = 80.0;
pub const REST: f64 = 120.0;
/// Amplitude (px), angular frequency (rad/s) and decay rate (1/s) of the swing.
pub const AMPLITUDE: f64 = 40.0;
pub const OMEGA: f64 = 8.0;
pub const DECAY: f64 = 0.25;
const TIMESCALE: u32 = 600;

/// Level above rest in pixels at `time` in s, counted from the first frame.
pub fn level(time: f64) -> f64 {
    AMPLITUDE * libm::exp(-DECAY * time) * libm::cos(OMEGA * time)
}

/// Container data of a film with this number of frames at the usual rate.
pub fn container(frames: usize) -> Film {
    let sample = |frame: usize| Sample {
        offset: 1000 + 10 * frame as u64,
        size: 10,
        ticks: (frame as f64 * f64::from(TIMESCALE) / RATE) as i64,
        key: frame == 0,
        shown: true,
    };
    Film {
        container: Container::Mp4,
        codec: Codec { coding: Coding::H264, name: "avc1.64001f".to_owned(), description: Vec::new() },
        size: [WIDTH as u32, HEIGHT as u32],
        pixel_aspect: [1, 1],
        orientation: Orientation::default(),
        timescale: TIMESCALE,
        samples: (0..frames).map(sample).collect(),
        capture_rate: None,
        stated_rate: None,
        duration: None,
        created: None,
        notices: Vec::new(),
    }
}

/// A film by its name.
pub fn identity(name: &str) -> FilmIdentity {
    FilmIdentity::new(name, 1 << 20, name.as_bytes())
}

fn edge(z: f64) -> f64 {
    0.5 * (1.0 + libm::erf(z / 1.1))
}

/// The picture at a time in seconds: bright wall, darker liquid with a dark line at its surface, a ruler with a mark every 10
/// pixels, and noise.
pub fn picture(time: f64, seed: u64) -> Plane {
    let surface = REST - level(time);
    let mut state = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    let mut noise = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        3.0 * ((state >> 40) as f64 / f64::from(1_u32 << 24) - 0.5)
    };
    let mut grey = Vec::with_capacity(WIDTH * HEIGHT);
    for row in 0..HEIGHT {
        for column in 0..WIDTH {
            let (x, y) = (column as f64 + 0.5, row as f64 + 0.5);
            let inside = edge(9.0 - (x - AXIS).abs());
            let depth = y - surface;
            let line = 50.0 * libm::exp(-0.5 * ((depth - 3.0) / 1.8) * ((depth - 3.0) / 1.8));
            let liquid = 50.0 * edge(depth) + line;
            let mark = if (20.0..35.0).contains(&x) { 40.0 * libm::cos(std::f64::consts::TAU * y / 10.0) } else { 0.0 };
            grey.push((190.0 - 0.05 * y + mark - inside * liquid + noise()).round().clamp(0.0, 255.0) as u8);
        }
    }
    Plane::new(WIDTH, HEIGHT, grey).unwrap()
}

/// Opens a film and tracks the surface until the record exists. Returns the number of frames that were requested.
pub fn track(desk: &mut Desk, picture: &dyn Fn(usize) -> Plane) -> usize {
    desk.change_films(|films, play| films.begin_tracking(play)).unwrap();
    let mut asked = 0;
    loop {
        while let Some(frame) = desk.films().wanted_frame() {
            asked += 1;
            desk.change_films(|films, play| films.give_frame(play, frame, picture(frame))).unwrap();
        }
        if desk.advance_tracking(10).unwrap() {
            return asked;
        }
    }
}

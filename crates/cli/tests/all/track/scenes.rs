//! Films that are formulas.

pub const WIDTH: usize = 160;
pub const HEIGHT: usize = 120;
pub const FRAMES: u32 = 90;
pub const PERIOD: f64 = 0.8;
pub const DECAY: f64 = 3.0;

/// The height of the liquid in the left arm above its rest, in pixels; the right arm has the opposite one.
pub fn height(t: f64) -> f64 {
    20.0 * libm::exp(-t / DECAY) * libm::cos(std::f64::consts::TAU / PERIOD * t + 0.4)
}

/// A grey value with some noise that is a function of the place.
pub fn noisy(grey: f64, x: usize, y: usize, frame: u32) -> u8 {
    let seed =
        (x as u32).wrapping_mul(73_856_093) ^ (y as u32).wrapping_mul(19_349_663) ^ frame.wrapping_mul(83_492_791);
    let seed = (seed ^ (seed >> 13)).wrapping_mul(1_274_126_177);
    (grey + f64::from((seed >> 16) % 7) - 3.0).round() as u8
}

/// Two upright tubes around x = 50 and x = 110 with a liquid that rests at y = 60, at the point (x, y).
pub fn scene(x: f64, y: f64, frame: u32) -> f64 {
    let t = f64::from(frame) / 30.0;
    let level = if x < 80.0 { 60.0 - height(t) } else { 60.0 + height(t) };
    let inside = (x - 50.0).abs() < 5.0 || (x - 110.0).abs() < 5.0;
    // The part of the pixel below the surface, blurred a little as by a lens.
    let wet = 1.0 / (1.0 + libm::exp(-(y - level) / 0.5));
    if inside { 190.0 - 90.0 * wet } else { 190.0 }
}

pub fn tubes(x: usize, y: usize, frame: u32) -> u8 {
    noisy(scene(x as f64 + 0.5, y as f64 + 0.5, frame), x, y, frame)
}

/// Where a ball is.
pub fn place(frame: u32) -> [f64; 2] {
    let t = f64::from(frame) / 30.0;
    [30.0 + 30.0 * t, 100.0 - 45.0 * t + 15.0 * t * t]
}

/// A dark ball of radius 6, which is gone from frame 60 on.
pub fn ball(x: usize, y: usize, frame: u32) -> u8 {
    let [u, v] = place(frame);
    let far = libm::hypot(x as f64 + 0.5 - u, y as f64 + 0.5 - v);
    let dark = if frame < 60 { 1.0 / (1.0 + libm::exp((far - 6.0) / 0.5)) } else { 0.0 };
    noisy(190.0 - 110.0 * dark, x, y, frame)
}

pub fn y4m(size: [usize; 2], frames: u32, grey: impl Fn(usize, usize, u32) -> u8) -> Vec<u8> {
    let [width, height] = size;
    let mut film = format!("YUV4MPEG2 W{width} H{height} F30:1 Ip A1:1 Cmono\n").into_bytes();
    for frame in 0..frames {
        film.extend(b"FRAME\n");
        film.extend((0..width * height).map(|at| grey(at % width, at / width, frame)));
    }
    film
}

/// A tube in the middle of a picture of 64 times 96 pixels that is seen upright, with a level that rises by a pixel and a half in
/// each frame; at the point (x, y) of it.
pub fn narrow(x: f64, y: f64, frame: u32) -> f64 {
    let wet = 1.0 / (1.0 + libm::exp(-(y - level(frame)) / 0.5));
    if (x - 32.0).abs() < 4.0 { 190.0 - 90.0 * wet } else { 190.0 }
}

pub fn level(frame: u32) -> f64 {
    60.0 - 1.5 * f64::from(frame)
}

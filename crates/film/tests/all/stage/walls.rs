//! Walls behind bodies.

use super::Dice;

/// Uneven light and a fine texture.
pub fn wall(dice: &mut Dice, [width, height]: [usize; 2], base: [f64; 3]) -> Vec<[f64; 3]> {
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
pub fn leaves(dice: &mut Dice, wall: &mut [[f64; 3]], [width, height]: [usize; 2]) {
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
pub fn blocks(dice: &mut Dice, wall: &mut [[f64; 3]], width: usize, grey: f64) {
    for board in 0..3 {
        let left = (0.15 + 0.3 * f64::from(board)) * width as f64;
        let right = left + dice.between(0.04, 0.12) * width as f64;
        let shade = [grey + dice.between(-6.0, 6.0), dice.between(110.0, 146.0), dice.between(110.0, 146.0)];
        for row in wall.chunks_mut(width) {
            row[left as usize..(right as usize).min(width)].fill([shade[0], shade[1], shade[2]]);
        }
    }
}

/// A fence of upright boards with the grey value of the body, with grain and dark joints.
pub fn boards(dice: &mut Dice, wall: &mut [[f64; 3]], width: usize, grey: f64) {
    let high = (wall.len() / width) as f64;
    let mut left = 0;
    while left < width {
        let right = (left + (dice.between(0.05, 0.16) * high) as usize).min(width);
        let (shade, grain) = (grey + dice.between(-10.0, 10.0), dice.between(2.0, 10.0));
        let (fine, bent, phase) = (dice.between(0.3, 1.5), dice.between(1.0, 5.0), dice.between(0.0, 6.0));
        for (row, pixels) in wall.chunks_mut(width).enumerate() {
            let bend = bent * libm::sin(0.03 * row as f64 + phase);
            for (column, pixel) in pixels.iter_mut().enumerate().take(right).skip(left) {
                let value = shade + grain * libm::sin(fine * (column as f64 + bend) + phase);
                *pixel = [if column < left + 2 { 0.6 * shade } else { value }, 128.0, 128.0];
            }
        }
        left = right;
    }
}

//! Colours of a figure, for light and dark pages.

use std::fmt;

use crate::items::Ink;

/// Number of different colours of series.
pub const SERIES_COLOURS: usize = 6;

/// Number of different colours of kept runs.
pub const RUN_COLOURS: usize = 5;

/// An sRGB colour: red, green, blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour(pub u8, pub u8, pub u8);

impl fmt::Display for Colour {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

impl Colour {
    /// Relative luminance (WCAG 2.2), from 0 for black to 1 for white.
    pub fn luminance(self) -> f64 {
        let linear = |channel: u8| {
            let value = f64::from(channel) / 255.0;
            if value <= 0.04045 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
        };
        0.2126 * linear(self.0) + 0.7152 * linear(self.1) + 0.0722 * linear(self.2)
    }

    /// Contrast ratio of two colours (WCAG 2.2), from 1 to 21.
    pub fn contrast(self, other: Colour) -> f64 {
        let (one, two) = (self.luminance(), other.luminance());
        (one.max(two) + 0.05) / (one.min(two) + 0.05)
    }

    /// Mixture of `share`/255 of this colour and the rest of the other, linear in sRGB values.
    pub fn mixed(self, other: Colour, share: u8) -> Colour {
        let mix = |one: u8, two: u8| {
            let sum = u32::from(one) * u32::from(share) + u32::from(two) * (255 - u32::from(share));
            ((sum + 127) / 255) as u8
        };
        Colour(mix(self.0, other.0), mix(self.1, other.1), mix(self.2, other.2))
    }
}

/// Colours of a figure.
///
/// Contrast with the background (WCAG 2.2, checked by a test): text at least 7, axes and marker at least 3, series at least
/// 4.5, so that their colours are also suitable for text. Grid and ghosts are intentionally faint. The colours of series
/// were found by search so that any two differ for protanopes, deuteranopes and tritanopes too (at least 18 in CIELAB,
/// simulated as by Machado and others, 2009). The colours of runs were found in the same way and differ by as much from
/// each other and from the first three series; dash patterns distinguish runs as well.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette {
    /// Background.
    pub ground: Colour,
    /// Text.
    pub text: Colour,
    /// Grid lines.
    pub grid: Colour,
    /// Line at zero.
    pub zero: Colour,
    /// Axes and ticks.
    pub axis: Colour,
    /// Line at the present moment.
    pub marker: Colour,
    /// Series, by index.
    pub series: [Colour; SERIES_COLOURS],
    /// Kept runs, by index.
    pub runs: [Colour; RUN_COLOURS],
}

impl Palette {
    /// Palette of a light page.
    pub const LIGHT: Palette = Palette {
        ground: Colour(0xff, 0xff, 0xff),
        text: Colour(0x24, 0x2c, 0x36),
        grid: Colour(0xe6, 0xe9, 0xee),
        zero: Colour(0xa9, 0xb3, 0xc0),
        axis: Colour(0x6f, 0x7a, 0x88),
        marker: Colour(0x6f, 0x7a, 0x88),
        series: [
            Colour(0x1c, 0x76, 0xda),
            Colour(0xd1, 0x46, 0x00),
            Colour(0x00, 0x68, 0x5c),
            Colour(0xa3, 0x31, 0x91),
            Colour(0x5c, 0x42, 0x12),
            Colour(0x59, 0x38, 0xd6),
        ],
        runs: [
            Colour(0x74, 0x01, 0xf5),
            Colour(0x78, 0x24, 0x13),
            Colour(0x90, 0x66, 0xa5),
            Colour(0x08, 0x10, 0x3e),
            Colour(0x5a, 0x1d, 0x83),
        ],
    };

    /// Palette of a dark page.
    pub const DARK: Palette = Palette {
        ground: Colour(0x12, 0x18, 0x20),
        text: Colour(0xe4, 0xe9, 0xf0),
        grid: Colour(0x26, 0x2f, 0x3a),
        zero: Colour(0x56, 0x63, 0x73),
        axis: Colour(0x8a, 0x97, 0xa7),
        marker: Colour(0x9a, 0xa6, 0xb4),
        series: [
            Colour(0x38, 0x96, 0xff),
            Colour(0xff, 0x97, 0x35),
            Colour(0x25, 0xe2, 0xa2),
            Colour(0xf1, 0x58, 0xa6),
            Colour(0xe4, 0xdf, 0x7c),
            Colour(0xc4, 0xce, 0xed),
        ],
        runs: [
            Colour(0xe0, 0x3f, 0xaf),
            Colour(0xfb, 0xff, 0x40),
            Colour(0xad, 0xde, 0xe7),
            Colour(0xad, 0x77, 0x6d),
            Colour(0xac, 0xa1, 0x5c),
        ],
    };

    /// Colour of an ink.
    pub fn colour(&self, ink: Ink) -> Colour {
        let series = |number: u8| self.series[usize::from(number) % SERIES_COLOURS];
        match ink {
            Ink::Ground => self.ground,
            Ink::Text => self.text,
            Ink::Grid => self.grid,
            Ink::Zero => self.zero,
            Ink::Axis => self.axis,
            Ink::Marker => self.marker,
            Ink::Series(number) => series(number),
            Ink::Run(number) => self.runs[usize::from(number) % RUN_COLOURS],
            Ink::Faded(number) => series(number).mixed(self.ground, 150),
            Ink::Ghost(number) => series(number).mixed(self.ground, 96),
            Ink::Band(number) => series(number).mixed(self.ground, 40),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOTH: [Palette; 2] = [Palette::LIGHT, Palette::DARK];

    #[test]
    fn contrast_is_that_of_wcag() {
        let (black, white) = (Colour(0, 0, 0), Colour(255, 255, 255));
        assert!((black.contrast(white) - 21.0).abs() < 1e-12);
        assert!((white.contrast(black) - 21.0).abs() < 1e-12);
        assert_eq!(white.contrast(white), 1.0);
        // A common example: the lightest grey that is legible on white.
        assert!((Colour(0x76, 0x76, 0x76).contrast(white) - 4.54).abs() < 0.005);
    }

    #[test]
    fn everything_that_matters_stands_out_from_the_ground() {
        for palette in BOTH {
            let ground = palette.ground;
            assert!(palette.text.contrast(ground) >= 7.0);
            assert!(palette.axis.contrast(ground) >= 3.0);
            assert!(palette.marker.contrast(ground) >= 3.0);
            for colour in palette.series.into_iter().chain(palette.runs) {
                assert!(colour.contrast(ground) >= 4.5, "{colour} on {ground}: {}", colour.contrast(ground));
            }
        }
    }

    #[test]
    fn series_differ_for_every_kind_of_eye() {
        const EYES: [(&str, [[f64; 3]; 3]); 4] = [
            ("trichromat", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
            (
                "protanope",
                [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
            ),
            (
                "deuteranope",
                [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
            ),
            (
                "tritanope",
                [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
            ),
        ];
        for palette in BOTH {
            for (eye, matrix) in EYES {
                let seen = palette.series.map(|colour| lab(colour, matrix));
                let distance = |one: [f64; 3], other: [f64; 3]| {
                    (0..3).map(|axis| one[axis] - other[axis]).map(|d| d * d).sum::<f64>().sqrt()
                };
                for one in 0..SERIES_COLOURS {
                    for other in 0..one {
                        let (a, b) = (palette.series[one], palette.series[other]);
                        let apart = distance(seen[one], seen[other]);
                        assert!(apart >= 18.0, "{a} and {b} look alike to a {eye}: {apart}");
                    }
                }
                let runs = palette.runs.map(|colour| lab(colour, matrix));
                for one in 0..RUN_COLOURS {
                    for (other, also) in
                        runs[..one].iter().zip(palette.runs).chain(seen[..3].iter().zip(palette.series))
                    {
                        let (run, apart) = (palette.runs[one], distance(runs[one], *other));
                        assert!(apart >= 18.0, "{run} and {also} look alike to a {eye}: {apart}");
                    }
                }
            }
        }
    }

    /// CIELAB coordinates of a colour as seen by this type of eye.
    fn lab(colour: Colour, eye: [[f64; 3]; 3]) -> [f64; 3] {
        let linear = [colour.0, colour.1, colour.2].map(|channel| {
            let value = f64::from(channel) / 255.0;
            if value <= 0.04045 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
        });
        let times = |matrix: [[f64; 3]; 3], vector: [f64; 3]| {
            matrix.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
        };
        let seen = times(eye, linear).map(|channel| channel.clamp(0.0, 1.0));
        let xyz = times([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]], seen);
        let f = |t: f64| {
            if t > 0.008856 { libm::cbrt(t) } else { 7.787 * t + 16.0 / 116.0 }
        };
        let (x, y, z) = (f(xyz[0] / 0.9505), f(xyz[1]), f(xyz[2] / 1.089));
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }
}

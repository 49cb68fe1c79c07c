//! Colours of a figure, light and dark.

use std::fmt;

use crate::figure::Ink;

/// How many series have colours of their own.
pub const SERIES_COLOURS: usize = 6;

/// A colour in sRGB.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour(pub u8, pub u8, pub u8);

impl fmt::Display for Colour {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

impl Colour {
    /// The relative luminance of WCAG 2.2, from 0 for black to 1 for white.
    pub fn luminance(self) -> f64 {
        let linear = |channel: u8| {
            let value = f64::from(channel) / 255.0;
            if value <= 0.04045 {
                value / 12.92
            } else {
                libm::pow((value + 0.055) / 1.055, 2.4)
            }
        };
        0.2126 * linear(self.0) + 0.7152 * linear(self.1) + 0.0722 * linear(self.2)
    }

    /// The contrast ratio of WCAG 2.2 between two colours, from 1 to 21.
    pub fn contrast(self, other: Colour) -> f64 {
        let (one, two) = (self.luminance(), other.luminance());
        (one.max(two) + 0.05) / (one.min(two) + 0.05)
    }

    /// The colour that has `share` of 255 parts of this one and the rest of the other.
    pub fn mixed(self, other: Colour, share: u8) -> Colour {
        let mix = |one: u8, two: u8| {
            let sum = u32::from(one) * u32::from(share) + u32::from(two) * (255 - u32::from(share));
            ((sum + 127) / 255) as u8
        };
        Colour(
            mix(self.0, other.0),
            mix(self.1, other.1),
            mix(self.2, other.2),
        )
    }
}

/// The colours of a figure.
///
/// Contrast with the ground (WCAG 2.2, checked by a test): text at least 7, axes and the marker at least 3, every series at
/// least 4.5. Grid and ghosts are meant to be faint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette {
    /// Behind everything.
    pub ground: Colour,
    /// Texts.
    pub text: Colour,
    /// The grid.
    pub grid: Colour,
    /// The line of zero.
    pub zero: Colour,
    /// Axes and ticks.
    pub axis: Colour,
    /// The present.
    pub marker: Colour,
    /// The series.
    pub series: [Colour; SERIES_COLOURS],
}

impl Palette {
    /// For a light page.
    pub const LIGHT: Palette = Palette {
        ground: Colour(0xff, 0xff, 0xff),
        text: Colour(0x24, 0x2c, 0x36),
        grid: Colour(0xe6, 0xe9, 0xee),
        zero: Colour(0xa9, 0xb3, 0xc0),
        axis: Colour(0x6f, 0x7a, 0x88),
        marker: Colour(0x6f, 0x7a, 0x88),
        series: [
            Colour(0x00, 0x5f, 0xb8),
            Colour(0xb8, 0x43, 0x00),
            Colour(0x00, 0x78, 0x5a),
            Colour(0xa0, 0x2c, 0x86),
            Colour(0x7a, 0x65, 0x00),
            Colour(0x4a, 0x3a, 0xa8),
        ],
    };

    /// For a dark page.
    pub const DARK: Palette = Palette {
        ground: Colour(0x12, 0x18, 0x20),
        text: Colour(0xe4, 0xe9, 0xf0),
        grid: Colour(0x26, 0x2f, 0x3a),
        zero: Colour(0x56, 0x63, 0x73),
        axis: Colour(0x8a, 0x97, 0xa7),
        marker: Colour(0x9a, 0xa6, 0xb4),
        series: [
            Colour(0x5c, 0xb3, 0xff),
            Colour(0xff, 0x9a, 0x52),
            Colour(0x3d, 0xd1, 0xa5),
            Colour(0xf2, 0x8c, 0xd8),
            Colour(0xe3, 0xc9, 0x3c),
            Colour(0xa9, 0x9c, 0xff),
        ],
    };

    /// The colour of an ink.
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
            Ink::Ghost(number) => series(number).mixed(self.ground, 96),
        }
    }
}

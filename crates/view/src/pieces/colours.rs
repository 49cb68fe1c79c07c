//! Colours for painting on canvases.

use figure::{Ink, Palette, RUN_COLOURS, SERIES_COLOURS};

/// A palette in the form required by the canvas: colours as texts, created once instead of in every frame.
pub struct Colours {
    plain: [String; 6],
    series: [String; SERIES_COLOURS],
    runs: [String; RUN_COLOURS],
    faded: [String; SERIES_COLOURS],
    ghosts: [String; SERIES_COLOURS],
    bands: [String; SERIES_COLOURS],
}

impl Colours {
    /// Colours of a palette.
    pub fn new(palette: &Palette) -> Self {
        let text = |ink| palette.colour(ink).to_string();
        Self {
            plain: [Ink::Ground, Ink::Text, Ink::Grid, Ink::Zero, Ink::Axis, Ink::Marker].map(text),
            series: std::array::from_fn(|number| text(Ink::Series(number as u8))),
            runs: std::array::from_fn(|number| text(Ink::Run(number as u8))),
            faded: std::array::from_fn(|number| text(Ink::Faded(number as u8))),
            ghosts: std::array::from_fn(|number| text(Ink::Ghost(number as u8))),
            bands: std::array::from_fn(|number| text(Ink::Band(number as u8))),
        }
    }

    /// The colour of an ink, such as `#005fb8`.
    pub fn of(&self, ink: Ink) -> &str {
        match ink {
            Ink::Ground => &self.plain[0],
            Ink::Text => &self.plain[1],
            Ink::Grid => &self.plain[2],
            Ink::Zero => &self.plain[3],
            Ink::Axis => &self.plain[4],
            Ink::Marker => &self.plain[5],
            Ink::Series(number) => &self.series[usize::from(number) % SERIES_COLOURS],
            Ink::Run(number) => &self.runs[usize::from(number) % RUN_COLOURS],
            Ink::Faded(number) => &self.faded[usize::from(number) % SERIES_COLOURS],
            Ink::Ghost(number) => &self.ghosts[usize::from(number) % SERIES_COLOURS],
            Ink::Band(number) => &self.bands[usize::from(number) % SERIES_COLOURS],
        }
    }
}

impl Default for Colours {
    fn default() -> Self {
        Self::new(&Palette::LIGHT)
    }
}

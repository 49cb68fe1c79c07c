//! Word clouds: words whose size grows with their weight, on a spiral around the centre, none over another.

use crate::palette::{Palette, SERIES_COLOURS};
use crate::svg::{Short, write_head};
use crate::text::width;
use std::fmt::Write;
use units::markup::Escaped;

/// Largest and smallest font size, pixels.
const LARGEST: f64 = 64.0;
const SMALLEST: f64 = 11.0;
/// Height of the rectangle of a word, em: from the top of its capitals to the bottom of its descenders, with a gap.
const HEIGHT: f64 = 1.12;
/// Distance from the top of the rectangle to the baseline, em.
const BASELINE: f64 = 0.87;
/// Distance between the windings of the spiral and between the places tried on it, pixels.
const STEP: f64 = 4.0;
/// Part of the area that the rectangles of the words fill at most in the first attempt.
const FILLED: f64 = 0.7;
/// Factor of all sizes from one attempt to the next.
const SHRINKING: f64 = 0.93;
/// Number of attempts.
const ATTEMPTS: usize = 12;

/// A word with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedWord {
    /// The text.
    pub text: String,
    /// Left end of the baseline, pixels.
    pub x: f64,
    /// The baseline, pixels from the upper edge.
    pub y: f64,
    /// Font size, pixels.
    pub size: f64,
}

/// A word cloud.
#[derive(Clone, Debug, PartialEq)]
pub struct WordCloud {
    width: f64,
    height: f64,
    placed: Vec<PlacedWord>,
}

#[derive(Clone, Copy)]
struct Area {
    left: f64,
    top: f64,
    right: f64,
    bottom: f64,
}

impl Area {
    fn meets(self, other: Self) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }
}

/// Places words with their weights, the heaviest first, in a rectangle of this size in pixels. Words that find no room are
/// left out; the same words always have the same places.
pub fn word_cloud(words: &[(&str, usize)], width: f64, height: f64) -> WordCloud {
    let mut best = WordCloud { width, height, placed: Vec::new() };
    let mut scale = first_scale(words, width * height * FILLED);
    for _ in 0..ATTEMPTS {
        let placed = placed(words, scale, (width, height));
        if placed.len() > best.placed.len() {
            best.placed = placed;
        }
        if best.placed.len() == words.len() {
            break;
        }
        scale *= SHRINKING;
    }
    best
}

/// Size of a word of weight `weight`, if the heaviest has `most`.
fn size(weight: usize, most: usize, scale: f64) -> f64 {
    (LARGEST * scale * libm::sqrt(weight as f64 / most.max(1) as f64)).max(SMALLEST)
}

fn heaviest(words: &[(&str, usize)]) -> usize {
    words.iter().map(|(_, weight)| *weight).max().unwrap_or(0)
}

/// Largest scale up to 1 at which the rectangles of all words together fill at most this area.
fn first_scale(words: &[(&str, usize)], most_area: f64) -> f64 {
    let most = heaviest(words);
    let mut scale = 1.0;
    for _ in 0..40 {
        let area = |&(text, weight): &(&str, usize)| {
            let size = size(weight, most, scale);
            width(text, size) * size * HEIGHT
        };
        if words.iter().map(area).sum::<f64>() <= most_area {
            break;
        }
        scale *= SHRINKING;
    }
    scale
}

fn placed(words: &[(&str, usize)], scale: f64, (across, down): (f64, f64)) -> Vec<PlacedWord> {
    let most = heaviest(words);
    let mut taken: Vec<Area> = Vec::new();
    let mut placed = Vec::new();
    for &(text, weight) in words {
        let size = size(weight, most, scale);
        let (long, high) = (width(text, size), size * HEIGHT);
        if let Some(area) = place((long, high), &taken, (across, down)) {
            taken.push(area);
            placed.push(PlacedWord { text: text.to_owned(), x: area.left, y: area.top + size * BASELINE, size });
        }
    }
    placed
}

/// First free place of a rectangle on the spiral, which is as much wider than high as the whole.
fn place((long, high): (f64, f64), taken: &[Area], (across, down): (f64, f64)) -> Option<Area> {
    if !(long <= across && high <= down && across.is_finite() && down.is_finite()) {
        return None;
    }
    let wide = across / down;
    let (mut radius, mut angle) = (0.0, 0.0);
    // Beyond this radius every place is outside.
    while radius <= down {
        let centre = (across / 2.0 + radius * wide * libm::cos(angle), down / 2.0 + radius * libm::sin(angle));
        let left = centre.0 - long / 2.0;
        let top = centre.1 - high / 2.0;
        let area = Area { left, top, right: left + long, bottom: top + high };
        let inside = area.left >= 0.0 && area.top >= 0.0 && area.right <= across && area.bottom <= down;
        if inside && !taken.iter().any(|other| area.meets(*other)) {
            return Some(area);
        }
        let turn = STEP / (radius * wide).max(STEP);
        angle += turn;
        radius += STEP * turn / core::f64::consts::TAU;
    }
    None
}

impl WordCloud {
    /// The words that have found a place, the heaviest first.
    pub fn placed(&self) -> &[PlacedWord] {
        &self.placed
    }

    /// The cloud as a standalone SVG document with this name and description.
    pub fn svg(&self, name: &str, description: &str, palette: &Palette) -> String {
        let mut out = String::new();
        // Writing to a string cannot fail.
        let _ = write_head(&mut out, (self.width as f32, self.height as f32), name, description);
        for (index, word) in self.placed.iter().enumerate() {
            let colour = palette.series[index % SERIES_COLOURS];
            let [x, y, size] = [word.x, word.y, word.size].map(|number| Short(number as f32));
            let text = Escaped(&word.text);
            let _ = write!(out, "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{colour}\">{text}</text>");
        }
        out.push_str("</svg>\n");
        out
    }
}

//! The ruler beside the scene in a filmed picture.

use play::Play;
use units::number::plain;

/// The ruler has at most so many pixels, and more than two fifths of them.
const LONGEST: f64 = 260.0;
/// Where it stands in the picture, in pixels.
const PLACE: [f64; 2] = [566.0, 310.0];

/// A ruler of round length.
pub struct Ruler {
    /// Its length in pixels.
    pub pixels: f64,
    /// The same for people.
    pub length: String,
    /// Metres in a pixel.
    pub pixel: f64,
}

impl Ruler {
    /// For a scene of which a unit is drawn in so many pixels; `None` where the scene has no scale.
    pub fn of(play: &mut Play, pixels: f64) -> Option<Self> {
        let (metres, unit) = play.grips().scale()?;
        let pixel = metres / pixels;
        let most = unit.from_si(LONGEST * pixel);
        if !(most > 0.0 && most.is_finite() && pixels > 0.0) {
            return None;
        }
        let mut ten = 1.0;
        while 10.0 * ten <= most {
            ten *= 10.0;
        }
        while ten > most {
            ten /= 10.0;
        }
        let factor = [5.0, 2.0].into_iter().find(|factor| factor * ten <= most).unwrap_or(1.0);
        let value = factor * ten;
        let length = format!("{} {}", plain(value, 3, play.style()), units::number::unit_text(&unit.text));
        Some(Self { pixels: unit.to_si(value) / pixel, length, pixel })
    }

    /// As SVG.
    pub fn drawn(&self) -> String {
        let [x, bottom] = PLACE;
        let top = bottom - self.pixels;
        let marks: String = (0..=10)
            .map(|mark| {
                let y = bottom - self.pixels * f64::from(mark) / 10.0;
                let far = if mark % 5 == 0 { 18.0 } else { 10.0 };
                format!("M{x} {y:.3}H{}", x + far)
            })
            .collect();
        format!(
            "<path d=\"M{x} {bottom}V{top:.3}{marks}\" fill=\"none\" stroke=\"#111\" stroke-width=\"1.5\"/>\
             <text x=\"{right}\" y=\"{middle:.1}\" font-size=\"15\">{length}</text>",
            right = x + 24.0,
            middle = (bottom + top) / 2.0 + 5.0,
            length = self.length.replace('&', "&amp;").replace('<', "&lt;"),
        )
    }
}

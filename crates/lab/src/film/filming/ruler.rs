//! Ruler beside the scene in a filmed picture.

use play::Play;
use units::number::plain;

/// Maximum length of the ruler, px. It is longer than two fifths of that.
const LONGEST: f64 = 260.0;
/// Position of its lower end in the picture, px.
const PLACE: [f64; 2] = [566.0, 310.0];

/// Ruler of a round length.
pub struct Ruler {
    /// Length, px.
    pub pixels: f64,
    /// Length as text with its unit.
    pub length: String,
    /// Size of a pixel, m.
    pub pixel: f64,
}

impl Ruler {
    /// Ruler for a scene drawn with `pixels` px per unit; `None` if the scene has no scale.
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
        let length = format!("{} {}", plain(value, 3, play.basis().style()), units::number::unit_text(&unit.text));
        Some(Self { pixels: unit.to_si(value) / pixel, length, pixel })
    }

    /// SVG of the ruler.
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

//! How the camera moves, by marks that rest.

use crate::plane::Plane;
use crate::tracking::body::{Disc, MARGIN, Part, Template};
use crate::tracking::refusal::Refusal;
use crate::tracking::similarity::Similarity;

/// Marks that are followed at most.
const MOST: usize = 4;
/// The radius of a mark as a part of the picture's height.
const RADIUS: f64 = 1.0 / 24.0;
/// Pixels around the last position that are searched, as a part of the picture's height.
const REACH: f64 = 1.0 / 40.0;
/// Below this correlation a mark is lost.
const SCORE: f64 = 0.6;

/// The marks of a film.
pub struct Marks {
    clicks: Vec<[f64; 2]>,
    templates: Vec<Template>,
    /// Where each mark was seen last.
    last: Vec<[f64; 2]>,
}

impl Marks {
    /// Marks that were clicked at these points, in pixels: one shows shifts alone, two to four rotation and scale as well.
    ///
    /// # Errors
    ///
    /// With more marks than can be followed.
    pub fn new(clicks: Vec<[f64; 2]>) -> Result<Marks, Refusal> {
        if clicks.len() > MOST {
            return Err(Refusal::Many { greatest: MOST });
        }
        Ok(Marks { last: clicks.clone(), clicks, templates: Vec::new() })
    }

    /// How the camera has moved since the first frame that was taken: from the pixels of that frame to those of this one.
    ///
    /// # Errors
    ///
    /// Where a mark lies outside the picture, on a uniform place, or is lost.
    pub fn take(&mut self, frame: usize, plane: &Plane) -> Result<Similarity, Refusal> {
        let high = plane.height() as f64;
        let radius = (RADIUS * high).clamp(4.0, 60.0);
        let disc = Disc { shift: [0.0; 2], radius, outline: radius };
        let part = |place| Part::around(plane, place, disc.radius + MARGIN, None);
        if self.templates.is_empty() {
            for (number, [x, y]) in (1..).zip(&self.clicks) {
                if !(0.0..=plane.width() as f64).contains(x) || !(0.0..=high).contains(y) {
                    return Err(Refusal::Click { x: *x, y: *y });
                }
                let template = part([*x, *y]).map(|part| Template::new(&part, [*x, *y], disc));
                let template = template.filter(|template| !template.plain()).ok_or(Refusal::PlainMark { number })?;
                self.templates.push(template);
            }
            return Ok(Similarity::IDENTITY);
        }
        let mut pairs = Vec::with_capacity(self.clicks.len());
        let found = self.templates.iter().zip(&self.clicks).zip(&mut self.last);
        for (number, ((template, click), last)) in (1..).zip(found) {
            let (place, _) = template.search(plane, *last, (REACH * high).max(4.0));
            let found = part(place).map(|part| template.align(&part, place, 2.0));
            let Some(found) = found.filter(|found| found.score >= SCORE) else {
                return Err(Refusal::Mark { number, frame });
            };
            *last = found.position;
            pairs.push((*click, found.position));
        }
        Ok(Similarity::between(&pairs).unwrap_or(Similarity::IDENTITY))
    }
}

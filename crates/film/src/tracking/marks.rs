//! Camera motion from fixed marks.

use crate::plane::Plane;
use crate::tracking::body::{Disc, MARGIN, Part, Shape, Template};
use crate::tracking::refusal::Refusal;
use crate::tracking::similarity::Similarity;

/// Maximum number of marks.
const MOST: usize = 4;
/// Radius of a mark relative to the height of the picture.
const RADIUS: f64 = 1.0 / 24.0;
/// Radius of the search around the last position, relative to the height of the picture.
const REACH: f64 = 1.0 / 40.0;
/// Minimum correlation of a mark.
const SCORE: f64 = 0.6;

/// Tracker of the marks of a film.
pub struct Marks {
    clicks: Vec<[f64; 2]>,
    templates: Vec<Template>,
    /// Last position of each mark, px.
    last: Vec<[f64; 2]>,
}

impl Marks {
    /// Marks clicked at these points, px. One mark gives shifts only, two to four also rotation and scale.
    ///
    /// # Errors
    ///
    /// [`Refusal::Many`] for too many marks.
    pub fn new(clicks: Vec<[f64; 2]>) -> Result<Marks, Refusal> {
        if clicks.len() > MOST {
            return Err(Refusal::Many { greatest: MOST });
        }
        Ok(Marks { last: clicks.clone(), clicks, templates: Vec::new() })
    }

    /// Motion of the camera since the first frame taken: map from px of that frame to px of this one.
    ///
    /// # Errors
    ///
    /// A [`Refusal`] if a mark lies outside the picture or on a uniform area, or is lost.
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
                let template = part([*x, *y]).map(|part| Template::new(&part, [*x, *y], disc, &Shape::disc(radius)));
                let template = template.filter(|template| !template.plain()).ok_or(Refusal::PlainMark { number })?;
                self.templates.push(template);
            }
            return Ok(Similarity::IDENTITY);
        }
        let mut pairs = Vec::with_capacity(self.clicks.len());
        let found = self.templates.iter().zip(&self.clicks).zip(&mut self.last);
        for (number, ((template, click), last)) in (1..).zip(found) {
            let (place, _) = template.search(plane, *last, (REACH * high).max(4.0));
            let found = part(place).map(|part| template.align(&part, place, 2.0, None));
            let Some(found) = found.filter(|found| found.score >= SCORE) else {
                return Err(Refusal::Mark { number, frame });
            };
            *last = found.position;
            pairs.push((*click, found.position));
        }
        Ok(Similarity::between(&pairs).unwrap_or(Similarity::IDENTITY))
    }
}

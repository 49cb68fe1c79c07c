//! Refinement of positions with the mean appearance of a body over all frames.
//!
//! A template from one frame contains its noise and the background behind the body. The mean over the frames after a
//! key frame averages both. The scatter of each pixel about the mean determines its weight.

use crate::tracking::body::appearance::Sighting;
use crate::tracking::body::frame::Frame;
use crate::tracking::body::part::Part;
use crate::tracking::body::template::{Found, Sample, Template};
use crate::tracking::crossing::Place;
use crate::tracking::median::median;
use crate::tracking::similarity::Similarity;

/// Number of iterations of template and positions.
const ROUNDS: usize = 3;
/// Maximum distance of a position from that of the first template along a coordinate, px.
const REACH: f64 = 1.5;
/// Correlation with the mean below which the position of an outline is more accurate.
const UNLIKE: f64 = 0.6;
/// Addition to the relative variance of a pixel in its weight, so that a few pixels do not dominate.
const ADDITION: f64 = 0.5;

/// Frame in which the body was found. Time in s.
#[derive(Clone, Debug)]
pub(crate) struct Seen {
    pub frame: usize,
    pub time: f64,
    /// Index of the template.
    pub key: usize,
    /// Motion of the camera since the first frame.
    pub camera: Similarity,
    pub part: Part,
    /// Result with the template of the key frame.
    pub first: Found,
    pub now: Found,
    /// Agreement with the body rather than the background, relative to the best possible one.
    pub agreement: f64,
    /// True if the body was away from its predicted position, hidden before, or outside the picture.
    pub aside: bool,
    /// True if the first position is that of the template that is updated in each frame.
    pub updated: bool,
    /// True if the first position is that of the outline, whatever the look.
    pub outlined: bool,
    /// True if no other moving object touches the body, so that its position can be used for predictions.
    pub free: bool,
    /// True if the pixels of the body's disc move with its position.
    pub moves: bool,
    /// False since it met a body of the same look, unless the motion told afterwards which of them it is.
    pub alone: bool,
    /// Vector to a body of the same look that may cover a part of this one, px.
    pub beside: Option<[f64; 2]>,
    /// Fraction of the ring around the body that does not show the background.
    pub outside: f32,
}

impl Seen {
    /// Body found in a frame. `key`: index of the template.
    pub(super) fn new(frame: Frame<'_>, key: usize, part: Part, one: &Sighting) -> Seen {
        let Sighting { found, agreement, updated, outlined, free, beside, outside, .. } = *one;
        let [x, y] = found.position;
        let is_inside =
            (0.0..frame.plane.width() as f64).contains(&x) && (0.0..frame.plane.height() as f64).contains(&y);
        let aside = one.aside || !is_inside;
        Seen {
            frame: frame.number,
            time: frame.time,
            key,
            camera: frame.camera,
            part,
            first: found,
            now: found,
            agreement,
            aside,
            updated,
            outlined,
            free,
            moves: true,
            alone: true,
            beside,
            outside,
        }
    }

    /// Time and position with the first template.
    pub(super) fn place(&self) -> Place {
        (self.time, self.first.position)
    }

    /// Size of the kept pixels.
    pub(super) fn bytes(&self) -> usize {
        self.part.plane.grey().len()
    }
}

enum Stage {
    Averaging(usize),
    Aligning(usize),
}

/// Sums over the frames for a sample of a template.
#[derive(Clone, Copy, Default)]
struct Sum {
    count: f64,
    value: f64,
    gradient: [f64; 2],
    /// Squared deviations from the previous template.
    squares: f64,
}

/// State of the refinement.
pub(crate) struct Refining {
    templates: Vec<Template>,
    /// One per template and sample.
    sums: Vec<Vec<Sum>>,
    stage: Stage,
    round: usize,
}

impl Refining {
    pub(crate) fn new(templates: Vec<Template>) -> Refining {
        let sums = templates.iter().map(|template| vec![Sum::default(); template.samples.len()]).collect();
        Refining { templates, sums, stage: Stage::Averaging(0), round: 0 }
    }

    /// Does the work of one frame. Returns true at the end.
    pub(crate) fn step(&mut self, seen: &mut [Seen]) -> bool {
        match self.stage {
            Stage::Averaging(at) if at < seen.len() => {
                self.add(&seen[at]);
                self.stage = Stage::Averaging(at + 1);
            }
            Stage::Averaging(_) => {
                self.average();
                self.stage = Stage::Aligning(0);
            }
            Stage::Aligning(at) if at < seen.len() => {
                let one = &mut seen[at];
                if let Some(template) = self.templates.get(one.key) {
                    one.now = template.align(&one.part, one.first.position, REACH, one.beside);
                    // A look that turns has no mean.
                    if one.outlined && one.now.score < UNLIKE {
                        one.now = Found { score: one.now.score, ..one.first };
                    }
                }
                self.stage = Stage::Aligning(at + 1);
            }
            Stage::Aligning(_) => {
                self.centre(seen);
                self.round += 1;
                self.stage = Stage::Averaging(0);
            }
        }
        self.round == ROUNDS
    }

    /// Adds the pixels of a frame, with gain and offset of the template.
    fn add(&mut self, one: &Seen) {
        let Some((template, sums)) = self.templates.get(one.key).zip(self.sums.get_mut(one.key)) else { return };
        let [gain, offset] = one.now.light;
        if !one.now.settled || gain < 0.3 || one.beside.is_some() {
            return;
        }
        let jets = one.part.jets(one.now.position, template.reach());
        for (sample, sum) in template.samples.iter().zip(sums) {
            let (value, gradient) = jets[sample.place];
            let value = (value - offset) / gain;
            sum.count += 1.0;
            sum.value += value;
            sum.gradient = [0, 1].map(|k| sum.gradient[k] + gradient[k] / gain);
            sum.squares += (value - sample.value) * (value - sample.value);
        }
    }

    fn average(&mut self) {
        for (template, sums) in self.templates.iter_mut().zip(&mut self.sums) {
            let frames = sums.first().map_or(0.0, |sum| sum.count);
            // With few frames the first template is as good as the mean.
            if frames >= 8.0 {
                let mut variances = Vec::with_capacity(sums.len());
                for (sample, sum) in template.samples.iter_mut().zip(sums.iter()) {
                    let value = sum.value / frames;
                    let shift = value - sample.value;
                    variances.push((sum.squares / frames - shift * shift).max(0.0));
                    *sample = Sample { value, gradient: sum.gradient.map(|part| part / frames), ..*sample };
                }
                let usual = median(variances.clone()).max(1e-6);
                for (sample, variance) in template.samples.iter_mut().zip(variances) {
                    sample.weight = (1.0 + ADDITION) / (variance / usual + ADDITION);
                }
            }
            sums.fill(Sum::default());
        }
    }

    /// Subtracts the mean shift over the frames of each template, so that the click defines the tracked point.
    fn centre(&self, seen: &mut [Seen]) {
        for key in 0..self.templates.len() {
            let mut shift = [0.0; 2];
            let mut count = 0.0;
            for one in seen.iter().filter(|one| one.key == key) {
                for (k, shift) in shift.iter_mut().enumerate() {
                    *shift += one.now.position[k] - one.first.position[k];
                }
                count += 1.0;
            }
            for one in seen.iter_mut().filter(|one| one.key == key) {
                one.now.position = [0, 1].map(|k| one.now.position[k] - shift[k] / count);
            }
        }
    }
}

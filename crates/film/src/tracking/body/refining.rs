//! Positions by the mean of what a body looks like in all frames.
//!
//! A template from one frame contains the noise of that frame and the background behind the body. The mean over the frames
//! that follow a key frame contains neither, and the scatter of each pixel about the mean says how much it counts.

use crate::tracking::body::part::Part;
use crate::tracking::body::template::{Found, Sample, Template};

/// Rounds of template and positions.
const ROUNDS: usize = 3;
/// Pixels that a position may be away from where the first template found it.
const REACH: f64 = 1.5;
/// The variance of a pixel that scatters as usual counts with this addition, so that no few pixels decide.
const ADDITION: f64 = 0.5;

/// A frame in which the body was seen.
#[derive(Clone, Debug)]
pub(crate) struct Seen {
    pub frame: usize,
    pub time: f64,
    /// Which key frame the template is from.
    pub key: usize,
    pub part: Part,
    /// By the template of the key frame.
    pub first: Found,
    pub now: Found,
    /// How well the place agrees with the body rather than with what stands still behind it, as a part of the best agreement there.
    pub agreement: f64,
    /// True if the body was not where its motion leads, or was hidden before.
    pub aside: bool,
    /// True if nothing else that moves touches the body: its position then tells where it goes.
    pub free: bool,
}

enum Stage {
    Averaging(usize),
    Aligning(usize),
}

/// Sums over the frames of what a sample of a template shows.
#[derive(Clone, Copy, Default)]
struct Sum {
    count: f64,
    value: f64,
    gradient: [f64; 2],
    /// Of the deviation from the template before.
    squares: f64,
}

/// The state between two portions of work.
pub(crate) struct Refining {
    templates: Vec<Template>,
    /// For each template and sample.
    sums: Vec<Vec<Sum>>,
    stage: Stage,
    round: usize,
}

impl Refining {
    pub(crate) fn new(templates: Vec<Template>) -> Refining {
        let sums = templates.iter().map(|template| vec![Sum::default(); template.samples.len()]).collect();
        Refining { templates, sums, stage: Stage::Averaging(0), round: 0 }
    }

    /// Does the work of one frame; true once all is done.
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
                    one.now = template.align(&one.part, one.first.position, REACH);
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

    /// Adds the pixels of a frame in the light of the template.
    fn add(&mut self, one: &Seen) {
        let Some((template, sums)) = self.templates.get(one.key).zip(self.sums.get_mut(one.key)) else { return };
        let [gain, offset] = one.now.light;
        if !one.now.settled || gain < 0.3 {
            return;
        }
        let [x, y] = one.now.position;
        for (sample, sum) in template.samples.iter().zip(sums) {
            let (value, gradient) = one.part.jet(x + sample.offset[0], y + sample.offset[1]);
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
            // Few frames: one template is as good as their mean.
            if frames >= 8.0 {
                let mut variances = Vec::with_capacity(sums.len());
                for (sample, sum) in template.samples.iter_mut().zip(sums.iter()) {
                    let value = sum.value / frames;
                    let shift = value - sample.value;
                    variances.push((sum.squares / frames - shift * shift).max(0.0));
                    *sample = Sample { value, gradient: sum.gradient.map(|part| part / frames), ..*sample };
                }
                let mut sorted = variances.clone();
                sorted.sort_by(f64::total_cmp);
                let usual = sorted.get(sorted.len() / 2).copied().unwrap_or(0.0).max(1e-6);
                for (sample, variance) in template.samples.iter_mut().zip(variances) {
                    sample.weight = (1.0 + ADDITION) / (variance / usual + ADDITION);
                }
            }
            sums.fill(Sum::default());
        }
    }

    /// Takes away the mean shift of each template's frames: the click decides which point of the body is followed.
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

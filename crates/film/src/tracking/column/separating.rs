//! Path of the surface if something else moves along the bore. The residuals show that motion. It is subtracted, and
//! the search is repeated.

use crate::tracking::column::outcome::Outcome;
use crate::tracking::column::path::Template;
use crate::tracking::column::reflection::{Finding, Reflection};
use crate::tracking::column::seeking::{BETTER, Seeking, Sought};
use crate::tracking::column::strip::with_differences;
use units::order::sort_numbers;

/// Ratio of mean to median absolute residual that indicates another motion; 1.18 for pure noise.
const UNEXPLAINED: f64 = 1.5;
/// Maximum ratio of the residuals with and without a reflection.
const LEFT: f64 = 0.9;
/// Maximum fraction of frames in which a reflection keeps its distance from the surface to within `FIRM` rows. Smear
/// and a second surface move along with the surface.
const ALONG: f64 = 0.35;
const FIRM: f64 = 6.0;
/// Maximum fraction of the frames in doubt, besides those of the path within the maximum motion, of a faster path.
const DOUBTS: f64 = 0.05;

enum Stage {
    Seeking(Box<Seeking>, Option<Reflection>),
    Finding(Box<Finding>),
    Cleaning(Reflection),
    Finished,
}

/// State of the search, in steps of about one frame.
pub(crate) struct Separating {
    sought: Sought,
    strongest: Vec<f64>,
    stage: Stage,
    /// Profiles and signals without the reflection.
    profiles: Vec<Vec<f32>>,
    signals: Vec<Vec<f32>>,
    /// Result without a reflection, and the best one with it.
    plain: Option<Outcome>,
    best: Option<(Outcome, Reflection)>,
    tried: usize,
}

impl Separating {
    /// State before the search. `strongest`: largest strength of the profile in each frame.
    pub(crate) fn new(sought: Sought, template: Template, strongest: Vec<f64>) -> Separating {
        Separating {
            stage: Stage::Seeking(Box::new(Seeking::new(sought.clone(), template)), None),
            sought,
            strongest,
            profiles: Vec::new(),
            signals: Vec::new(),
            plain: None,
            best: None,
            tried: 0,
        }
    }

    /// Does the work of one frame. Returns the result at the end, with the reflection if there is one. `profiles`:
    /// means over the bore, one value per row; `signals`: values in channels.
    pub(crate) fn step(
        &mut self,
        profiles: &[Vec<f32>],
        signals: &[Vec<f32>],
    ) -> Option<(Outcome, Option<Reflection>)> {
        self.stage = match std::mem::replace(&mut self.stage, Stage::Finished) {
            Stage::Seeking(mut seeking, None) => {
                if seeking.step(profiles, signals) {
                    self.take(seeking.outcome(), profiles)
                } else {
                    Stage::Seeking(seeking, None)
                }
            }
            Stage::Seeking(mut seeking, Some(reflection)) => {
                if seeking.step(&self.profiles, &self.signals) {
                    self.compare(seeking.outcome(), reflection);
                    self.next()
                } else {
                    Stage::Seeking(seeking, Some(reflection))
                }
            }
            Stage::Finding(mut finding) => match finding.step(signals) {
                // If nothing else moves, the path is not that of a reflection.
                Some(reflection) if self.tried == 1 && reflection.is_faint() => Stage::Finished,
                Some(reflection) => {
                    (self.profiles, self.signals) = Default::default();
                    Stage::Cleaning(reflection)
                }
                None => Stage::Finding(finding),
            },
            Stage::Cleaning(reflection) => self.clean(reflection, profiles, signals),
            Stage::Finished => Stage::Finished,
        };
        if !matches!(self.stage, Stage::Finished) {
            return None;
        }
        match self.best.take() {
            Some((outcome, reflection)) => Some((outcome, Some(reflection))),
            None => Some((self.plain.take()?, None)),
        }
    }

    /// Takes the path without a reflection. If it reaches the maximum motion, the search is repeated with twice that motion. Such a path
    /// replaces it if it leaves less, is smooth where it is faster, and has few more frames in doubt: things beside the surface invite jumps.
    fn take(&mut self, outcome: Option<Outcome>, profiles: &[Vec<f32>]) -> Stage {
        let is_better = |one: &Outcome| {
            let is_better = |plain: &Outcome| {
                let most = plain.doubts() as f64 + DOUBTS * plain.path.len() as f64;
                one.left < BETTER * plain.left && one.doubts() as f64 <= most && one.is_smooth_beyond(&plain.limits)
            };
            self.plain.as_ref().is_none_or(is_better)
        };
        let Some(outcome) = outcome.filter(is_better) else { return self.next() };
        self.sought.limits.clone_from(&outcome.limits);
        let is_bound = outcome.is_bound();
        self.plain = Some(outcome);
        match self.template(profiles).filter(|_| is_bound) {
            Some(template) => {
                let limits = self.sought.limits.iter().map(|(reach, fixed)| (2 * reach, *fixed)).collect();
                Stage::Seeking(Box::new(Seeking::new(Sought { limits, ..self.sought.clone() }, template)), None)
            }
            None => self.next(),
        }
    }

    /// Template of the clicked frame.
    fn template(&self, profiles: &[Vec<f32>]) -> Option<Template> {
        let (clicked, row) = self.sought.clicked;
        Template::new(profiles.get(clicked)?, row, self.sought.half, &self.strongest)
    }

    fn next(&mut self) -> Stage {
        let Some(plain) = self.plain.as_ref().filter(|plain| plain.unexplained > UNEXPLAINED) else {
            return Stage::Finished;
        };
        let (from, is_swapped) = match (self.tried, &self.best) {
            (0, _) => (plain, false),
            (1, _) => (plain, true),
            (2, Some((best, _))) => (best, false),
            _ => return Stage::Finished,
        };
        self.tried += 1;
        let reach = self.sought.limits.iter().map(|limit| limit.0).collect();
        Stage::Finding(Box::new(Finding::new(from.regions.clone(), from.path.clone(), reach, is_swapped)))
    }

    fn compare(&mut self, outcome: Option<Outcome>, reflection: Reflection) {
        let Some((outcome, plain)) = outcome.zip(self.plain.as_ref()) else { return };
        let least = self.best.as_ref().map_or(LEFT * plain.left, |best| best.0.left);
        if outcome.left < least && !goes_along(&outcome.path, &reflection) {
            self.best = Some((outcome, reflection));
        }
    }

    fn clean(&mut self, reflection: Reflection, profiles: &[Vec<f32>], signals: &[Vec<f32>]) -> Stage {
        let rows = self.sought.shape.rows;
        let at = self.signals.len();
        if let Some((profile, values)) = profiles.get(at).zip(signals.get(at)) {
            let mut profile = profile.clone();
            let mut values = values.get(..values.len() / 2).unwrap_or_default().to_vec();
            reflection.take_from(at, &mut values, rows);
            reflection.take_mean_from(at, &mut profile);
            self.profiles.push(profile);
            self.signals.push(with_differences(values, rows));
            return Stage::Cleaning(reflection);
        }
        match self.template(&self.profiles) {
            Some(template) => Stage::Seeking(Box::new(Seeking::new(self.sought.clone(), template)), Some(reflection)),
            None => self.next(),
        }
    }
}

/// True if a reflection keeps its distance from the surface.
fn goes_along(path: &[usize], reflection: &Reflection) -> bool {
    let mut distances: Vec<f64> = path.iter().zip(reflection.rows()).map(|(own, other)| other - *own as f64).collect();
    sort_numbers(&mut distances);
    let within = |first: &f64| distances.partition_point(|one| *one <= first + 2.0 * FIRM);
    let most = distances.iter().enumerate().map(|(at, first)| within(first) - at).max().unwrap_or(0);
    most as f64 > ALONG * distances.len() as f64
}

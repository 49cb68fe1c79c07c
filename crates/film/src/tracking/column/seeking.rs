//! Path of the surface from the click. Several candidates are improved by the two regions that all frames then show.
//! The candidate with the least residual is chosen.

use crate::tracking::column::certainty::Certainty;
use crate::tracking::column::outcome::{Limit, Outcome};
use crate::tracking::column::path::{Search, Template, strengths};
use crate::tracking::column::regions::{Regions, Shape, Sums};
use crate::tracking::median::median;
use units::order::sort;

/// Cost of a step by one row, for the correlation of profiles and for each channel of the regions.
const TEMPLATE_STEP: f32 = 0.004;
const REGION_STEP: f32 = 0.01;
/// Number of iterations of regions and path.
const ROUNDS: usize = 4;
/// Lower bound of the noise in each iteration, relative to the mean residual around the surface.
const NEAR: [f64; ROUNDS + 1] = [1.5, 1.0, 0.7, 0.5, 0.5];
/// Ratio of residuals below which a later candidate replaces the best one; of equal ones the simpler is kept.
pub(crate) const BETTER: f64 = 0.995;
/// Minimum distance of an alternative row from the surface.
pub(crate) const ELSEWHERE: usize = 6;

/// Input of the search.
#[derive(Clone, Debug)]
pub(crate) struct Sought {
    pub shape: Shape,
    /// Frame and row of the click.
    pub clicked: (usize, f64),
    /// Number of rows on each side of the surface that are compared with the click.
    pub half: usize,
    pub limits: Vec<Limit>,
}

enum Stage {
    /// Comparing the profiles with the clicked one.
    Template(Template, Search, bool),
    /// Determining the temporal median of each row, a few rows per step.
    Medians(Vec<f32>),
    Regions(Box<Trial>),
    Moving(Box<Trial>),
    Costs(Box<Trial>, Search),
    /// Searching backwards from the last frame.
    Back(Search),
    Finished,
}

struct Trial {
    path: Vec<usize>,
    regions: Regions,
    sums: Sums,
    round: usize,
    costs: Vec<Vec<f32>>,
    /// Least total cost up to each row of each frame.
    forward: Vec<Vec<f32>>,
    left: f64,
}

/// State of the search, in steps of about one frame.
pub(crate) struct Seeking {
    sought: Sought,
    stage: Stage,
    at: usize,
    /// Profiles minus their temporal median.
    residues: Vec<Vec<f32>>,
    starts: Vec<Vec<usize>>,
    best: Option<Box<Trial>>,
    /// Rows that the surface passes.
    passed: std::ops::Range<usize>,
    certainties: Vec<Certainty>,
    /// Row of least cost in the clicked frame.
    favourite: usize,
}

impl Seeking {
    pub(crate) fn new(sought: Sought, template: Template) -> Seeking {
        let search = Search::new(sought.shape.rows, TEMPLATE_STEP);
        Seeking {
            sought,
            stage: Stage::Template(template, search, false),
            at: 0,
            residues: Vec::new(),
            starts: Vec::new(),
            best: None,
            passed: 0..0,
            certainties: Vec::new(),
            favourite: 0,
        }
    }

    /// Result, once the path is found.
    pub(crate) fn outcome(&mut self) -> Option<Outcome> {
        let best = self.best.take()?;
        let unexplained = best.sums.spread();
        Some(Outcome {
            path: best.path,
            regions: best.regions,
            certainties: std::mem::take(&mut self.certainties),
            limits: std::mem::take(&mut self.sought.limits),
            favourite: self.favourite,
            left: best.left,
            unexplained,
        })
    }

    /// Does the work of one frame. Returns true once the path is found. `profiles`: means over the bore, one value per
    /// row; `signals`: values in channels.
    pub(crate) fn step(&mut self, profiles: &[Vec<f32>], signals: &[Vec<f32>]) -> bool {
        let at = self.at;
        self.at += 1;
        self.stage = match std::mem::replace(&mut self.stage, Stage::Finished) {
            Stage::Template(template, mut search, moving) => {
                let profile = if moving { self.residues.get(at) } else { profiles.get(at) };
                match profile.zip(self.sought.limits.get(at)) {
                    Some((profile, (reach, fixed))) => {
                        search.take(&template.costs(profile), *reach, *fixed);
                        Stage::Template(template, search, moving)
                    }
                    None => {
                        self.starts.push(search.path());
                        self.at = 0;
                        if moving { self.next() } else { Stage::Medians(vec![0.0; self.sought.shape.rows]) }
                    }
                }
            }
            Stage::Medians(mut medians) => {
                let rows = medians.len().div_ceil(profiles.len().max(1));
                for (row, usual) in medians.iter_mut().enumerate().skip(at * rows).take(rows) {
                    let values = profiles.iter().filter_map(|profile| profile.get(row).map(|value| f64::from(*value)));
                    *usual = median(values.collect()) as f32;
                }
                if (at + 1) * rows < medians.len() {
                    Stage::Medians(medians)
                } else {
                    self.subtract(&medians, profiles)
                }
            }
            Stage::Regions(mut trial) => match signals.get(at).zip(trial.path.get(at)) {
                Some((values, row)) => {
                    trial.regions.take_regions(&mut trial.sums, values, *row);
                    Stage::Regions(trial)
                }
                None => {
                    trial.regions.set_regions(&trial.sums);
                    self.at = 0;
                    Stage::Moving(trial)
                }
            },
            Stage::Moving(mut trial) => match signals.get(at).zip(trial.path.get(at)) {
                Some((values, row)) => {
                    trial.regions.take_moving(&mut trial.sums, values, *row);
                    Stage::Moving(trial)
                }
                None => {
                    trial.left = trial.sums.total;
                    trial.regions.set_moving(&trial.sums, NEAR[trial.round.min(ROUNDS)]);
                    self.at = 0;
                    if trial.round < ROUNDS {
                        trial.costs.clear();
                        trial.forward.clear();
                        Stage::Costs(trial, self.search())
                    } else {
                        self.compare(trial)
                    }
                }
            },
            Stage::Costs(mut trial, mut search) => match signals.get(at).zip(self.sought.limits.get(at)) {
                Some((values, (reach, fixed))) => {
                    let costs = trial.regions.costs(values);
                    search.take(&costs, *reach, *fixed);
                    trial.costs.push(costs);
                    trial.forward.push(search.sums().to_vec());
                    Stage::Costs(trial, search)
                }
                None => {
                    trial.path = search.path();
                    trial.round += 1;
                    trial.sums = trial.regions.sums();
                    self.at = 0;
                    // Further rounds of a candidate that has come to the best path would repeat it.
                    if self.is_best(&trial.path) { self.next() } else { Stage::Regions(trial) }
                }
            },
            Stage::Back(search) => self.back(search, signals),
            Stage::Finished => Stage::Finished,
        };
        matches!(self.stage, Stage::Finished)
    }

    fn search(&self) -> Search {
        Search::new(self.sought.shape.rows, REGION_STEP * self.sought.shape.channels as f32)
    }

    fn subtract(&mut self, medians: &[f32], profiles: &[Vec<f32>]) -> Stage {
        self.at = 0;
        let residue = |profile: &Vec<f32>| profile.iter().zip(medians).map(|(value, usual)| value - usual).collect();
        self.residues = profiles.iter().map(residue).collect();
        let half = self.sought.half;
        let strongest: Vec<f64> =
            self.residues.iter().map(|profile| strengths(profile, half).into_iter().fold(0.0, f64::max)).collect();
        let (clicked, row) = self.sought.clicked;
        let template = self.residues.get(clicked).and_then(|profile| Template::new(profile, row, half, &strongest));
        match template {
            Some(template) => Stage::Template(template, Search::new(self.sought.shape.rows, TEMPLATE_STEP), true),
            None => self.next(),
        }
    }

    /// True if a path does not differ from the best one.
    fn is_best(&self, path: &[usize]) -> bool {
        let is_same = |(own, other): (&usize, &usize)| own.abs_diff(*other) <= ELSEWHERE;
        self.best.as_ref().is_some_and(|best| best.path.iter().zip(path).all(is_same))
    }

    /// Starts with the next candidate that differs from the best one, or searches backwards with the best one.
    fn next(&mut self) -> Stage {
        self.at = 0;
        while let Some(path) = self.starts.pop() {
            if self.is_best(&path) {
                continue;
            }
            let regions = Regions::new(self.sought.shape);
            let sums = regions.sums();
            let (costs, forward, left) = (Vec::new(), Vec::new(), f64::INFINITY);
            return Stage::Regions(Box::new(Trial { path, sums, regions, round: 0, costs, forward, left }));
        }
        self.residues.clear();
        Stage::Back(self.search())
    }

    fn compare(&mut self, trial: Box<Trial>) -> Stage {
        if self.best.as_ref().is_none_or(|best| trial.left < BETTER * best.left) {
            self.best = Some(trial);
        }
        self.next()
    }

    /// Searches backwards: together with the forward search this gives the least cost of a path through each row of each
    /// frame.
    fn back(&mut self, mut search: Search, signals: &[Vec<f32>]) -> Stage {
        let Some(best) = &self.best else { return Stage::Finished };
        let frames = best.costs.len();
        let limit = |frame: usize| self.sought.limits.get(frame).copied().unwrap_or((0, None));
        if self.certainties.is_empty() {
            self.passed = passed(&best.path);
        }
        let Some(at) = frames.checked_sub(self.certainties.len() + 1) else {
            self.certainties.reverse();
            let costs = best.costs.get(self.sought.clicked.0);
            let least = costs.and_then(|costs| costs.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1)));
            self.favourite = least.map_or(0, |least| least.0);
            return Stage::Finished;
        };
        let own = &best.costs[at];
        // The bound of a step holds in both directions.
        let reach = limit(at + 1).0;
        search.take(own, reach, limit(at).1);
        let row = best.path[at];
        let through = |row: usize| best.forward[at][row] + search.sums()[row] - own[row];
        let rows = self.sought.shape.rows;
        let elsewhere = (0..row.saturating_sub(ELSEWHERE)).chain((row + ELSEWHERE + 1).min(rows)..rows);
        let other = elsewhere.map(|row| (row, through(row))).min_by(|a, b| a.1.total_cmp(&b.1));
        let certainty = match other {
            Some((other, cost)) => {
                let contrast = best.regions.contrast(row, other);
                let lead = (cost - through(row)) / contrast.max(1e-3);
                let misfit = signals.get(at).map_or(1.0, |values| best.regions.misfit(values, row));
                let passed = self.passed.clone();
                let covered = signals.get(at).map_or(0.0, |values| best.regions.covered(values, passed));
                Certainty { lead, contrast, misfit, covered }
            }
            None => Certainty::default(),
        };
        self.certainties.push(certainty);
        Stage::Back(search)
    }
}

/// Range of rows that the surface passes, without the outer 5 % on each side.
fn passed(path: &[usize]) -> std::ops::Range<usize> {
    let mut rows = path.to_vec();
    sort(&mut rows);
    let at = |place: usize| rows.get(place.min(rows.len().saturating_sub(1))).copied().unwrap_or(0);
    at(rows.len() / 20)..at(rows.len() - rows.len() / 20) + 1
}

//! Light that moves along the bore besides the surface, such as the reflection of a person. Its path and shape are
//! found so that it can be subtracted from the strips before the surface is sought.

use crate::tracking::column::path::Search;
use crate::tracking::column::regions::{Regions, Shape};
use crate::tracking::median::median;

/// Number of modelled rows on each side of the middle of a reflection.
const HALF: usize = 28;
/// Number of rows on each side over which light is added up for the first path.
const BROAD: usize = 4;
/// Cost of a step by one row, relative to the gain at the correct row.
const STEP: f32 = 0.005;
/// Minimum root mean square, over rows and channels, of a reflection that can be mistaken for the surface, in grey
/// values. Compression artefacts without a reflection have 0.4 to 1.5.
const FAINT: f32 = 2.0;
/// Number of iterations of path and shape.
const ROUNDS: usize = 3;

/// Shape of a reflection, and the row of its middle in each frame.
#[derive(Clone, Debug)]
pub(crate) struct Reflection {
    rows: Vec<f64>,
    /// Added grey values around the middle, for each channel.
    added: Vec<Vec<f32>>,
}

enum Stage {
    /// Subtracting the two regions from the frames; also searching the first path, if none is given.
    Residuals(Option<Search>),
    /// Determining the shape, one row per step.
    Added,
    Path(Search, Vec<Vec<f32>>),
}

/// Search for a reflection, in steps of about one frame.
pub(crate) struct Finding {
    shape: Shape,
    regions: Regions,
    surface: Vec<usize>,
    /// Maximum motion since the previous frame, rows, for each frame.
    reach: Vec<usize>,
    /// True if the given path is that of the reflection instead of the surface.
    is_swapped: bool,
    residuals: Vec<Vec<f32>>,
    path: Vec<usize>,
    added: Vec<Vec<f32>>,
    stage: Stage,
    at: usize,
    round: usize,
}

impl Finding {
    /// Starts a search for light beside the `surface`. `is_swapped`: the given path is that of the light.
    pub(crate) fn new(regions: Regions, surface: Vec<usize>, reach: Vec<usize>, is_swapped: bool) -> Finding {
        // The second half of the channels are differences.
        let shape = Shape { channels: (regions.shape.channels / 2).max(1), ..regions.shape };
        let search = (!is_swapped).then(|| Search::new(shape.rows, STEP));
        Finding {
            path: surface.clone(),
            shape,
            regions,
            surface,
            reach,
            is_swapped,
            residuals: Vec::new(),
            added: vec![vec![0.0; 2 * HALF + 1]; shape.channels],
            stage: Stage::Residuals(search),
            at: 0,
            round: 0,
        }
    }

    /// Does the work of one frame. Returns the reflection at the end.
    pub(crate) fn step(&mut self, signals: &[Vec<f32>]) -> Option<Reflection> {
        let at = self.at;
        self.at += 1;
        self.stage = match std::mem::replace(&mut self.stage, Stage::Added) {
            Stage::Residuals(mut search) => match signals.get(at).zip(self.surface.get(at)) {
                Some((values, surface)) => {
                    let rest = self.regions.rest(values, *surface, self.shape.channels, !self.is_swapped);
                    if let Some(search) = &mut search {
                        search.take(&self.broad(&rest), self.reach[at], None);
                    }
                    self.residuals.push(rest);
                    Stage::Residuals(search)
                }
                None => {
                    if let Some(search) = search {
                        self.path = search.path();
                    }
                    self.at = 0;
                    Stage::Added
                }
            },
            Stage::Added => {
                for channel in 0..self.shape.channels {
                    let first = channel * self.shape.rows;
                    let value = |(values, middle): (&Vec<f32>, &usize)| {
                        let row = (middle + at).checked_sub(HALF).filter(|row| *row < self.shape.rows)?;
                        Some(f64::from(*values.get(first + row)?))
                    };
                    let values = self.residuals.iter().zip(&self.path).filter_map(value).collect();
                    self.added[channel][at] = median(values) as f32;
                }
                if at < 2 * HALF {
                    Stage::Added
                } else {
                    self.at = 0;
                    // The ends of the window are background.
                    for added in &mut self.added {
                        let ends = 0.5 * (added[0] + added[2 * HALF]);
                        added.iter_mut().for_each(|value| *value -= ends);
                    }
                    Stage::Path(Search::new(self.shape.rows, STEP), Vec::new())
                }
            }
            Stage::Path(mut search, mut all) => match self.residuals.get(at) {
                Some(rest) => {
                    let costs = self.costs(rest);
                    search.take(&costs, self.reach[at], None);
                    all.push(costs);
                    Stage::Path(search, all)
                }
                None => {
                    self.path = search.path();
                    self.round += 1;
                    self.at = 0;
                    if self.round == ROUNDS {
                        let rows = self.path.iter().zip(&all).map(|(row, costs)| vertex(costs, *row)).collect();
                        return Some(Reflection { rows, added: std::mem::take(&mut self.added) });
                    }
                    Stage::Added
                }
            },
        };
        None
    }

    /// Cost of each row while the shape is unknown, decreasing with the light around it.
    fn broad(&self, rest: &[f32]) -> Vec<f32> {
        let rows = self.shape.rows;
        let mut light = vec![0.0_f32; rows];
        for values in rest.chunks(rows) {
            for (row, sum) in light.iter_mut().enumerate() {
                let around = row.saturating_sub(BROAD)..(row + BROAD + 1).min(rows);
                *sum += values.get(around).unwrap_or_default().iter().sum::<f32>().abs();
            }
        }
        let most = light.iter().copied().fold(1e-3, f32::max);
        light.into_iter().map(|light| 1.0 - light / most).collect()
    }

    /// Cost of each row: change of the squared residuals by subtraction of the light there, plus 1, relative to the
    /// squared light.
    fn costs(&self, rest: &[f32]) -> Vec<f32> {
        let rows = self.shape.rows;
        let own: f32 = self.added.iter().flatten().map(|value| value * value).sum::<f32>().max(1e-3);
        let mut costs = vec![1.0; rows];
        let mut products = vec![0.0_f32; rows];
        for (values, added) in rest.chunks(rows).zip(&self.added) {
            products.fill(0.0);
            for (along, added) in added.iter().enumerate() {
                // Row of the strip: `row + along - HALF`.
                let (skip, start) = (HALF.saturating_sub(along), along.saturating_sub(HALF));
                let sums = products.get_mut(skip..).unwrap_or_default();
                sums.iter_mut()
                    .zip(values.get(start..).unwrap_or_default())
                    .for_each(|(sum, value)| *sum += added * value);
            }
            costs.iter_mut().zip(&products).for_each(|(cost, product)| *cost -= 2.0 * product / own);
        }
        costs
    }
}

impl Reflection {
    /// Subtracts the light from a frame whose channels have `rows` values each.
    pub(crate) fn take_from(&self, at: usize, values: &mut [f32], rows: usize) {
        for (values, added) in values.chunks_mut(rows).zip(&self.added) {
            for (row, value) in values.iter_mut().enumerate() {
                *value -= self.light(added, at, row);
            }
        }
    }

    /// Subtracts the mean light of the channels from a profile.
    pub(crate) fn take_mean_from(&self, at: usize, profile: &mut [f32]) {
        let part = 1.0 / self.added.len() as f32;
        for (row, value) in profile.iter_mut().enumerate() {
            *value -= part * self.added.iter().map(|added| self.light(added, at, row)).sum::<f32>();
        }
    }

    /// True if the light is too faint to be mistaken for the surface.
    pub(crate) fn is_faint(&self) -> bool {
        let (squares, count) =
            self.added.iter().flatten().fold((0.0, 0.0), |(sum, count), value| (sum + value * value, count + 1.0));
        squares < FAINT * FAINT * count
    }

    /// Row of the middle in each frame.
    pub(crate) fn rows(&self) -> &[f64] {
        &self.rows
    }

    /// Rows with light.
    pub(crate) fn around(&self, at: usize, rows: usize) -> std::ops::Range<usize> {
        let middle = self.rows.get(at).copied().unwrap_or(0.0) as usize;
        middle.saturating_sub(HALF).min(rows)..(middle + HALF + 2).min(rows)
    }

    /// Light in a row of a frame, in the channel of bin `bin` of `bins`.
    pub(crate) fn at(&self, at: usize, row: usize, (bin, bins): (usize, usize)) -> f64 {
        let channels = self.added.len();
        let channel = (0..channels).rev().find(|channel| bins * channel / channels <= bin).unwrap_or(0);
        self.added.get(channel).map_or(0.0, |added| f64::from(self.light(added, at, row)))
    }

    fn light(&self, added: &[f32], at: usize, row: usize) -> f32 {
        let place = row as f64 - self.rows.get(at).copied().unwrap_or(0.0) + HALF as f64;
        if place < 0.0 {
            return 0.0;
        }
        let (first, part) = (place as usize, place.fract() as f32);
        let value = |k: usize| added.get(k).copied().unwrap_or(0.0);
        (1.0 - part) * value(first) + part * value(first + 1)
    }
}

/// Minimum of the parabola through the costs around a row.
fn vertex(costs: &[f32], row: usize) -> f64 {
    let around = row.checked_sub(1).and_then(|first| costs.get(first..first + 3));
    let Some(&[before, own, after]) = around else { return row as f64 };
    let curvature = before - 2.0 * own + after;
    if curvature <= 0.0 {
        return row as f64;
    }
    row as f64 + f64::from((0.5 * (before - after) / curvature).clamp(-0.5, 0.5))
}

//! Surface as the boundary of two regions: each row of the strip has one value while it lies above the surface and
//! another below, and a pattern moves with the surface. Stationary details, such as the marks of a graduated tube, are
//! in both regions and do not bias the surface.

use crate::tracking::median::{magnitude, median};

/// Residual in standard deviations of the noise with half of the maximum cost.
const LARGE: f32 = 3.0;
/// Weight of the mean difference between the regions relative to one frame, for rows seen in one region only.
const PRIOR: f32 = 1.0;
/// Minimum cost of a residual that belongs to neither region, relative to the maximum cost.
const FOREIGN: f32 = 0.45;
/// Minimum noise, grey values.
const LEAST_NOISE: f64 = 0.25;

/// Layout of the grey values of the bore, in channels side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shape {
    pub rows: usize,
    pub channels: usize,
    /// Number of rows on each side of the surface with the moving pattern.
    pub half: usize,
}

impl Shape {
    fn window(&self) -> usize {
        2 * self.half + 1
    }

    /// Index of the first value of each channel.
    fn starts(&self) -> impl Iterator<Item = usize> + use<> {
        let rows = self.rows;
        (0..self.channels).map(move |channel| channel * rows)
    }

    /// Rows of the window around the surface.
    fn around(&self, surface: usize) -> std::ops::Range<usize> {
        surface.saturating_sub(self.half)..(surface + self.half + 1).min(self.rows)
    }
}

/// Model of the strip for any row of the surface.
#[derive(Clone, Debug)]
pub(crate) struct Regions {
    pub shape: Shape,
    above: Vec<f32>,
    below: Vec<f32>,
    moving: Vec<f32>,
    /// Standard deviation of the residuals of each channel, grey values.
    noise: Vec<f32>,
}

/// Sums over the frames for the regions, or for the moving pattern.
pub(crate) struct Sums {
    /// Weights and weighted values of each row while it is above the surface, then while it is below.
    regions: [Vec<f32>; 4],
    moving: Vec<[f32; 2]>,
    /// Median absolute residual of each frame, for each channel.
    residuals: Vec<Vec<f64>>,
    /// Mean and median absolute residual of each frame, summed over the channels.
    spreads: Vec<(f64, f64)>,
    /// Number and sum of the absolute residuals around the surface, for each channel.
    near: Vec<[f64; 2]>,
    /// Sum of the absolute residuals.
    pub total: f64,
}

impl Sums {
    /// Ratio of the mean to the median absolute residual, in the median frame.
    pub(crate) fn spread(&self) -> f64 {
        let least = LEAST_NOISE * self.near.len() as f64;
        median(self.spreads.iter().map(|(mean, median)| mean / median.max(least)).collect())
    }
}

impl Regions {
    pub(crate) fn new(shape: Shape) -> Regions {
        let values = vec![0.0; shape.rows * shape.channels];
        let moving = vec![0.0; shape.window() * shape.channels];
        Regions { shape, above: values.clone(), below: values, moving, noise: vec![f32::INFINITY; shape.channels] }
    }

    /// Factor from squared residuals to relative costs.
    fn scale(&self, channel: usize) -> f32 {
        let noise = self.noise.get(channel).copied().unwrap_or(f32::INFINITY);
        1.0 / (LARGE * LARGE * noise * noise)
    }

    pub(crate) fn sums(&self) -> Sums {
        Sums {
            regions: std::array::from_fn(|_| vec![0.0; self.above.len()]),
            moving: vec![[0.0; 2]; self.moving.len()],
            residuals: vec![Vec::new(); self.shape.channels],
            spreads: Vec::new(),
            near: vec![[0.0; 2]; self.shape.channels],
            total: 0.0,
        }
    }

    /// Model of a frame in the rows of a channel.
    fn modelled(&self, channel: usize, surface: usize) -> Vec<f32> {
        let shape = self.shape;
        let (first, window) = (channel * shape.rows, channel * shape.window());
        let split = first + surface.min(shape.rows);
        let mut model = [&self.above[first..split], &self.below[split..first + shape.rows]].concat();
        let around = shape.around(surface);
        let start = window + around.start + shape.half - surface;
        let moving = &self.moving[start..start + around.len()];
        model[around].iter_mut().zip(moving).for_each(|(model, moving)| *model += moving);
        model
    }

    /// Rows above and below the surface, and the region that they show.
    fn sides(&self, surface: usize) -> [(std::ops::Range<usize>, &[f32]); 2] {
        let surface = surface.min(self.shape.rows);
        [(0..surface, &self.above), (surface..self.shape.rows, &self.below)]
    }

    /// Residuals of the first channels relative to the two regions, with the moving pattern subtracted if `moves`.
    pub(crate) fn rest(&self, values: &[f32], surface: usize, channels: usize, moves: bool) -> Vec<f32> {
        let rows = self.shape.rows;
        let mut rest = values[..channels * rows].to_vec();
        for (channel, rest) in rest.chunks_mut(rows.max(1)).enumerate() {
            let mut subtract = |range: std::ops::Range<usize>, model: &[f32]| {
                rest[range].iter_mut().zip(model).for_each(|(value, model)| *value -= model);
            };
            if moves {
                subtract(0..rows, &self.modelled(channel, surface));
            } else {
                for (range, side) in self.sides(surface) {
                    subtract(range.clone(), &side[channel * rows + range.start..]);
                }
            }
        }
        rest
    }

    /// Adds a frame to the sums of the regions.
    pub(crate) fn take_regions(&self, sums: &mut Sums, values: &[f32], surface: usize) {
        let [up, high, down, low] = &mut sums.regions;
        for (channel, first) in self.shape.starts().enumerate() {
            let scale = self.scale(channel);
            let model = self.modelled(channel, surface);
            for ((range, side), (weights, weighted)) in
                self.sides(surface).into_iter().zip([(&mut *up, &mut *high), (&mut *down, &mut *low)])
            {
                let part = first + range.start..first + range.end;
                let sums = weights[part.clone()].iter_mut().zip(&mut weighted[part.clone()]);
                let seen = values[part.clone()].iter().zip(&model[range]).zip(&side[part]);
                for ((sum, product), ((value, model), side)) in sums.zip(seen) {
                    let far = 1.0 + (value - model) * (value - model) * scale;
                    let weight = 1.0 / (far * far);
                    *sum += weight;
                    *product += weight * (value - (model - side));
                }
            }
        }
    }

    /// Computes the regions from the sums.
    pub(crate) fn set_regions(&mut self, sums: &Sums) {
        for first in self.shape.starts() {
            let part = first..first + self.shape.rows;
            let (mut product, mut weight) = (0.0, 1e-6);
            let at = |at: usize| sums.regions.each_ref().map(|sum| sum[at]);
            for [up, high, down, low] in part.clone().map(at) {
                let common = up * down / (up + down).max(1e-6);
                if common > 0.0 {
                    product += common * (low / down - high / up);
                    weight += common;
                }
            }
            let step = product / weight;
            for row in part {
                let [up, high, down, low] = at(row);
                let mean = |sum: f32, weight: f32, other: f32, others: f32, step: f32| {
                    if others > 0.0 {
                        (sum + PRIOR * (other / others + step)) / (weight + PRIOR)
                    } else {
                        sum / weight.max(1e-6)
                    }
                };
                self.above[row] = mean(high, up, low, down, -step);
                self.below[row] = mean(low, down, high, up, step);
            }
        }
    }

    /// Adds a frame to the sums of the moving pattern and of the residuals.
    pub(crate) fn take_moving(&self, sums: &mut Sums, values: &[f32], surface: usize) {
        let shape = self.shape;
        let mut spread = (0.0, 0.0);
        for (channel, first) in shape.starts().enumerate() {
            let models = self.modelled(channel, surface).into_iter().zip(&values[first..]);
            let residuals: Vec<f32> = models.map(|(model, value)| (value - model).abs()).collect();
            let near = shape.around(surface);
            sums.near[channel][0] += near.len() as f64;
            sums.near[channel][1] += sum(residuals.get(near).unwrap_or_default());
            let (total, count) = (sum(&residuals), residuals.len());
            let usual = magnitude(&residuals);
            sums.total += total;
            spread = (spread.0 + total / count.max(1) as f64, spread.1 + usual);
            sums.residuals[channel].push(usual);
            for row in shape.around(surface) {
                let side = if row < surface { &self.above } else { &self.below };
                let along = row + shape.half - surface;
                let sum = &mut sums.moving[channel * shape.window() + along];
                sum[0] += 1.0;
                sum[1] += values[first + row] - side[first + row];
            }
        }
        sums.spreads.push(spread);
    }

    /// Computes the moving pattern and the noise from the sums. The noise is at least `part` of the mean residual
    /// around the surface, so that a coarse path can be improved over a distance.
    pub(crate) fn set_moving(&mut self, sums: &Sums, part: f64) {
        for (moving, [count, sum]) in self.moving.iter_mut().zip(&sums.moving) {
            *moving = if *count > 0.0 { sum / count } else { 0.0 };
        }
        for (noise, (residuals, [count, sum])) in self.noise.iter_mut().zip(sums.residuals.iter().zip(&sums.near)) {
            *noise = (1.5 * median(residuals.clone())).max(part * sum / count.max(1.0)).max(LEAST_NOISE) as f32;
        }
    }

    /// Cost of each row as the row of the surface. Each value adds its squared residual relative to the noise,
    /// saturating at 1.
    pub(crate) fn costs(&self, values: &[f32]) -> Vec<f32> {
        let shape = self.shape;
        let mut costs = vec![0.0; shape.rows];
        for (channel, first) in shape.starts().enumerate() {
            let scale = self.scale(channel);
            let cost = |residual: f32| {
                let far = residual * residual * scale;
                far / (1.0 + far)
            };
            let part = first..first + shape.rows;
            let rest = |side: &[f32]| -> Vec<f32> {
                side[part.clone()].iter().zip(&values[part.clone()]).map(|(side, value)| value - side).collect()
            };
            let (above, below) = (rest(&self.above), rest(&self.below));
            let pairs: Vec<[f32; 2]> =
                above.iter().zip(&below).map(|(above, below)| [cost(*above), cost(*below)]).collect();
            let sums = running(pairs);
            let all = sums.last().map_or(0.0, |last| last[1]);
            for (row, sum) in costs.iter_mut().enumerate() {
                let around = shape.around(row);
                *sum += sums[around.start][0] + all - sums[around.end][1];
            }
            for along in 0..shape.window() {
                let moving = self.moving[channel * shape.window() + along];
                let side = if along < shape.half { &above } else { &below };
                // Row of the strip: `surface + along - half`.
                let (skip, start) = (shape.half.saturating_sub(along), along.saturating_sub(shape.half));
                let (sums, rests) = (costs.get_mut(skip..).unwrap_or_default(), side.get(start..).unwrap_or_default());
                sums.iter_mut().zip(rests).for_each(|(sum, rest)| *sum += cost(rest - moving));
            }
        }
        costs
    }

    /// Mean cost of the values around the surface, 0 to 1.
    pub(crate) fn misfit(&self, values: &[f32], surface: usize) -> f32 {
        let around = self.shape.around(surface);
        let (mut sum, mut count) = (0.0, 0.0);
        for (channel, first) in self.shape.starts().enumerate() {
            let models = self.modelled(channel, surface).into_iter().zip(&values[first..]);
            let scale = self.scale(channel);
            for (model, value) in models.skip(around.start).take(around.len()) {
                let far = (value - model) * (value - model) * scale;
                sum += far / (1.0 + far);
                count += 1.0;
            }
        }
        sum / f32::max(count, 1.0)
    }

    /// Fraction of some rows that shows neither region in a channel of grey values. The second half of the channels are
    /// differences.
    pub(crate) fn covered(&self, values: &[f32], rows: std::ops::Range<usize>) -> f32 {
        let shape = self.shape;
        let count = rows.len().max(1) as f32;
        let is_covered = |row: &usize| {
            (0..shape.channels.div_ceil(2)).any(|channel| {
                let at = channel * shape.rows + row;
                let far = |side: &[f32]| (values[at] - side[at]) * (values[at] - side[at]) * self.scale(channel);
                far(&self.above).min(far(&self.below)) > FOREIGN
            })
        };
        rows.filter(is_covered).count() as f32 / count
    }

    /// Expected increase of the cost of row `other` if the surface is at row `surface`.
    pub(crate) fn contrast(&self, surface: usize, other: usize) -> f32 {
        let mut sum = 0.0;
        for channel in 0..self.shape.channels {
            let scale = self.scale(channel);
            let models = self.modelled(channel, surface).into_iter().zip(self.modelled(channel, other));
            sum += models
                .map(|(one, other)| (one - other) * (one - other) * scale)
                .map(|far| far / (1.0 + far))
                .sum::<f32>();
        }
        sum
    }
}

/// Cumulative sums of pairs, starting with 0.
fn running(values: Vec<[f32; 2]>) -> Vec<[f32; 2]> {
    let mut sum = [0.0; 2];
    std::iter::once(sum)
        .chain(values.into_iter().map(|[one, other]| {
            sum = [sum[0] + one, sum[1] + other];
            sum
        }))
        .collect()
}

/// Sum in double precision, in four parts that do not wait for one another.
fn sum(values: &[f32]) -> f64 {
    let mut sums = [0.0; 4];
    let (parts, rest) = values.as_chunks::<4>();
    for part in parts {
        sums.iter_mut().zip(part).for_each(|(sum, value)| *sum += f64::from(*value));
    }
    sums.iter().sum::<f64>() + rest.iter().copied().map(f64::from).sum::<f64>()
}

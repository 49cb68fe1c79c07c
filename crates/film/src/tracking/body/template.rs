//! Template of a body and its alignment with a frame.

use crate::plane::Plane;
use crate::tracking::body::disc::Disc;
use crate::tracking::body::part::Part;
use crate::tracking::body::shape::Shape;
use crate::tracking::linear::solve;

/// Maximum number of steps of an alignment.
const STEPS: usize = 25;
/// Length of a step in px that ends an alignment.
const CLOSE: f64 = 1e-3;

/// Minimum fraction of the samples for an alignment.
const VISIBLE: f64 = 0.4;

/// Number of samples for a coarse search.
const FEW: usize = 120;

/// Sample of a template.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    /// Offset from the tracked point, px.
    pub offset: [f64; 2],
    /// Index of the offset among all of at most [`Template::reach`] px, row by row.
    pub place: usize,
    pub value: f64,
    /// Derivatives to the right and downwards, per px.
    pub gradient: [f64; 2],
    /// Weight: 1 for a usual pixel, less for one that varies between frames.
    pub weight: f64,
}

/// Pixels in a disc, relative to the tracked point.
#[derive(Clone, Debug)]
pub(crate) struct Template {
    pub samples: Vec<Sample>,
    pub disc: Disc,
}

/// Result of an alignment. Position in px.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Found {
    pub position: [f64; 2],
    /// Correlation of the pixels with the template.
    pub score: f64,
    /// Variances of both coordinates from the residuals, px².
    pub variance: [f64; 2],
    /// Contrast relative to the template, and difference of brightness in grey values.
    pub light: [f64; 2],
    pub settled: bool,
}

/// Maximum offset of a sample along a coordinate, px.
fn reach(disc: Disc) -> i64 {
    disc.reach().floor() as i64
}

impl Template {
    /// Template from the disc near a point, px.
    pub(crate) fn new(part: &Part, point: [f64; 2], disc: Disc, shape: &Shape) -> Template {
        let margin = disc.radius - shape.extent;
        let reach = reach(disc);
        let offsets = (-reach..=reach).flat_map(|row| (-reach..=reach).map(move |column| [column as f64, row as f64]));
        let jets = offsets.zip(part.jets(point, reach)).enumerate();
        let samples = jets
            .filter(|(_, (offset, _))| shape.beyond([0, 1].map(|k| offset[k] - disc.shift[k])) <= margin)
            .map(|(place, (offset, (value, gradient)))| Sample { offset, place, value, gradient, weight: 1.0 })
            .collect();
        Template { samples, disc }
    }

    /// Maximum offset of a sample along a coordinate, px.
    pub(crate) fn reach(&self) -> i64 {
        reach(self.disc)
    }

    /// Updates the template by the fraction `pace` of its deviation from a frame.
    pub(crate) fn follow(&mut self, part: &Part, found: &Found, pace: f64) {
        let [gain, offset] = found.light;
        let jets = part.jets(found.position, self.reach());
        for sample in &mut self.samples {
            let (value, gradient) = jets[sample.place];
            sample.value += pace * ((value - offset) / gain - sample.value);
            sample.gradient = [0, 1].map(|k| sample.gradient[k] + pace * (gradient[k] / gain - sample.gradient[k]));
        }
    }

    /// True if a sample lies within another body.
    fn is_taken(&self, sample: &Sample, beside: Option<[f64; 2]>) -> bool {
        beside.is_some_and(|beside| {
            let [u, v] = [0, 1].map(|k| sample.offset[k] - self.disc.shift[k] - beside[k]);
            libm::hypot(u, v) <= self.disc.blurred()
        })
    }

    /// True if the disc is uniform: its standard deviation is below 1 grey value.
    pub(crate) fn plain(&self) -> bool {
        let count = self.samples.len() as f64;
        let mean = self.samples.iter().map(|sample| sample.value).sum::<f64>() / count;
        let squares: f64 = self.samples.iter().map(|sample| (sample.value - mean) * (sample.value - mean)).sum();
        squares.is_nan() || squares < count
    }

    /// Correlation with the pixels around the centre of a pixel, from every `stride`-th sample.
    fn correlation(&self, plane: &Plane, column: i64, row: i64, stride: usize) -> f64 {
        let (mut n, mut t, mut p, mut tt, mut pp, mut tp) = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
        for sample in self.samples.iter().step_by(stride) {
            let pixel = plane.pixel(column + sample.offset[0] as i64, row + sample.offset[1] as i64);
            let (pixel, value) = (f64::from(pixel), sample.value);
            n += 1.0;
            t += value;
            p += pixel;
            tt += value * value;
            pp += pixel * pixel;
            tp += value * pixel;
        }
        let (tt, pp, tp) = (tt - t * t / n, pp - p * p / n, tp - t * p / n);
        // A uniform area, with a standard deviation below half a grey value, has no correlation.
        if tt > 0.0 && pp > 0.25 * n { tp / (tt * pp).sqrt() } else { 0.0 }
    }

    /// Position of the best correlation within `reach` px of a point, and that correlation. A coarse search with fewer
    /// samples comes first.
    pub(crate) fn search(&self, plane: &Plane, around: [f64; 2], reach: f64) -> ([f64; 2], f64) {
        // A disc of several pixels is still similar at a distance of a fifth of its radius.
        let step = ((self.disc.radius / 5.0) as usize).clamp(1, 4);
        let stride = (self.samples.len() / FEW).max(1);
        let (place, _) = self.scan(plane, around, reach.ceil().clamp(1.0, 1e4) as i64, (step, stride));
        self.scan(plane, place, step as i64 + 1, (1, 1))
    }

    /// Best position on a grid, by every `stride`-th sample.
    fn scan(&self, plane: &Plane, around: [f64; 2], reach: i64, (step, stride): (usize, usize)) -> ([f64; 2], f64) {
        let middle = around.map(|at| at.floor().clamp(-1e6, 1e6) as i64);
        let mut best = (around, -1.0);
        for row in (middle[1] - reach..=middle[1] + reach).step_by(step) {
            for column in (middle[0] - reach..=middle[0] + reach).step_by(step) {
                let inside = |at: i64, size: usize| usize::try_from(at).is_ok_and(|at| at < size);
                if !inside(column, plane.width()) || !inside(row, plane.height()) {
                    continue;
                }
                let score = self.correlation(plane, column, row, stride);
                if score > best.1 {
                    best = ([column as f64 + 0.5, row as f64 + 0.5], score);
                }
            }
        }
        best
    }

    /// Position of the least weighted residual, at most `reach` px from the start along each coordinate, with free
    /// contrast and brightness. `beside`: vector to another body of the same disc (px), whose pixels do not count. The
    /// score is 0 where too few are left.
    ///
    /// Baker and Matthews, *Int. J. Comput. Vis.* 56 (2004) 221, inverse compositional form.
    pub(crate) fn align(&self, part: &Part, start: [f64; 2], reach: f64, beside: Option<[f64; 2]>) -> Found {
        let mut found = Found { position: start, score: 0.0, variance: [0.0; 2], light: [1.0, 0.0], settled: false };
        let visible: Vec<&Sample> = self.samples.iter().filter(|sample| !self.is_taken(sample, beside)).collect();
        if (visible.len() as f64) < VISIBLE * self.samples.len() as f64 {
            return found;
        }
        let mean = visible.iter().map(|sample| sample.value).sum::<f64>() / visible.len() as f64;
        let terms = |sample: &Sample| [sample.gradient[0], sample.gradient[1], sample.value - mean, 1.0];
        let mut matrix = [[0.0; 4]; 4];
        for sample in visible.iter().copied() {
            let terms = terms(sample);
            for (line, term) in matrix.iter_mut().zip(terms) {
                line.iter_mut().zip(terms).for_each(|(sum, other)| *sum += sample.weight * term * other);
            }
        }
        for _ in 0..STEPS {
            let mut side = [0.0; 4];
            let mut squares = 0.0;
            let values = part.values(found.position, self.reach());
            for sample in visible.iter().copied() {
                let grey = values[sample.place] - mean;
                side.iter_mut().zip(terms(sample)).for_each(|(sum, term)| *sum += sample.weight * term * grey);
                squares += sample.weight * grey * grey;
            }
            let Some((solution, inverse)) = solve(matrix, side) else { return found };
            let [across, down, gain, offset] = solution;
            let explained: f64 = solution.iter().zip(side).map(|(a, b)| a * b).sum();
            let rest = (squares - explained).max(0.0);
            let total = (squares - side[3] * side[3] / matrix[3][3]).max(f64::MIN_POSITIVE);
            if gain <= 0.0 {
                return Found { score: 0.0, ..found };
            }
            let residual = rest / (visible.len() as f64 - 4.0).max(1.0) / (gain * gain);
            let step = [across, down].map(|part| (-part / gain).clamp(-1.0, 1.0));
            let moved = [0, 1].map(|k| (found.position[k] + step[k]).min(start[k] + reach).max(start[k] - reach));
            let length = (moved[0] - found.position[0]).abs() + (moved[1] - found.position[1]).abs();
            found = Found {
                position: moved,
                score: (1.0 - rest / total).max(0.0).sqrt(),
                variance: [residual * inverse[0][0], residual * inverse[1][1]],
                light: [gain, offset + mean - gain * mean],
                settled: step[0].abs() + step[1].abs() < 2.0 * CLOSE,
            };
            if length < CLOSE {
                break;
            }
        }
        found
    }
}

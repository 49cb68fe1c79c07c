//! Derivatives by finite differences, and recognition of columns that were computed so.

use crate::sampling::{self, Sampling};
use units::order::median;
use units::order::sort;

/// Formula of finite differences on even steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stencil {
    /// First derivative, `(x[i+1] - x[i-1])/(2 dt)`: Tracker's velocity.
    Central,
    /// First derivative, `(x[i+1] - x[i])/dt`.
    Forward,
    /// First derivative, `(x[i] - x[i-1])/dt`.
    Backward,
    /// Second derivative, `(2x[i+2] - x[i+1] - 2x[i] - x[i-1] + 2x[i-2])/(7 dt^2)`: Tracker's acceleration.
    FivePoint,
    /// Second derivative, `(x[i+1] - 2x[i] + x[i-1])/dt^2`.
    Second,
}

impl Stencil {
    /// All stencils.
    pub const ALL: [Self; 5] = [Self::Central, Self::Forward, Self::Backward, Self::FivePoint, Self::Second];

    /// Neighbours as (distance in frames, weight). The weighted sum is divided by the step to the power of the order.
    pub fn weights(self) -> &'static [(i64, f64)] {
        match self {
            Self::Central => &[(-1, -0.5), (1, 0.5)],
            Self::Forward => &[(0, -1.0), (1, 1.0)],
            Self::Backward => &[(-1, -1.0), (0, 1.0)],
            Self::FivePoint => &[(-2, 2.0 / 7.0), (-1, -1.0 / 7.0), (0, -2.0 / 7.0), (1, -1.0 / 7.0), (2, 2.0 / 7.0)],
            Self::Second => &[(-1, 1.0), (0, -2.0), (1, 1.0)],
        }
    }

    /// Order of the derivative: 1 or 2.
    pub fn order(self) -> u8 {
        match self {
            Self::Central | Self::Forward | Self::Backward => 1,
            Self::FivePoint | Self::Second => 2,
        }
    }

    /// Ratio of the result to the exact derivative of a sinusoid with `theta = omega dt`, rad; below 1 the result is too
    /// small. The one-sided stencils also shift it by half a step.
    pub fn attenuation(self, theta: f64) -> f64 {
        if theta == 0.0 {
            return 1.0;
        }
        match self {
            Self::Central => libm::sin(theta) / theta,
            Self::Forward | Self::Backward => libm::sin(theta / 2.0) / (theta / 2.0),
            Self::FivePoint => (2.0 + 2.0 * libm::cos(theta) - 4.0 * libm::cos(2.0 * theta)) / (7.0 * theta * theta),
            Self::Second => {
                let half = libm::sin(theta / 2.0) / (theta / 2.0);
                half * half
            }
        }
    }

    /// Text of the formula for a quantity of this name.
    pub fn formula(self, x: &str) -> String {
        match self {
            Self::Central => format!("({x}[i+1] − {x}[i−1])/(2 Δt)"),
            Self::Forward => format!("({x}[i+1] − {x}[i])/Δt"),
            Self::Backward => format!("({x}[i] − {x}[i−1])/Δt"),
            Self::FivePoint => {
                format!("(2 {x}[i+2] − {x}[i+1] − 2 {x}[i] − {x}[i−1] + 2 {x}[i−2])/(7 Δt²)")
            }
            Self::Second => format!("({x}[i+1] − 2 {x}[i] + {x}[i−1])/Δt²"),
        }
    }
}

/// Recognition of a column computed from another one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recognised {
    /// Stencil.
    pub stencil: Stencil,
    /// Order of the derivative: 1 or 2.
    pub order: u8,
    /// Part of the rows with all neighbours that agree: 0 to 1.
    pub share: f64,
    /// Number of rows with all neighbours.
    pub rows: usize,
    /// Unit of the difference quotient in units of the column, a power of ten: 1 if both are coherent.
    pub scale: f64,
}

/// Derivative of `position` by a stencil, in the units of values and times; NaN where a neighbour is missing, and
/// everywhere if the times are not evenly spaced. Neighbours are found by frame: rows on both sides of a missing frame are
/// not neighbours.
pub fn differentiate(times: &[f64], position: &[f64], stencil: Stencil) -> Vec<f64> {
    difference(&sampling::examine(times), position, stencil)
}

fn difference(sampling: &Sampling, position: &[f64], stencil: Stencil) -> Vec<f64> {
    let mut derivative = vec![f64::NAN; position.len()];
    let steps = if stencil.order() == 1 { sampling.interval } else { sampling.interval * sampling.interval };
    neighbours(sampling, position, stencil, |row, weighted| {
        if let Some(cell) = derivative.get_mut(row) {
            *cell = weighted.iter().map(|(weight, value)| weight * value).sum::<f64>() / steps;
        }
    });
    derivative
}

/// Calls `each` for each row that has all neighbours, with these as (weight, value).
fn neighbours(sampling: &Sampling, position: &[f64], stencil: Stencil, mut each: impl FnMut(usize, &[(f64, f64)])) {
    let mut places: Vec<(i64, usize)> =
        sampling.frames.iter().enumerate().filter_map(|(row, frame)| Some(((*frame)?, row))).collect();
    if !places.is_sorted_by(|one, other| one.0 <= other.0) {
        sort(&mut places);
    }
    // The first row of doubled frames is used.
    places.dedup_by_key(|place| place.0);
    let mut weighted = Vec::with_capacity(5);
    for (index, (frame, row)) in places.iter().enumerate() {
        weighted.clear();
        for (distance, weight) in stencil.weights() {
            // Frames ascend without repeats, so a neighbour is at most as many entries away as frames.
            let range =
                if *distance < 0 { index.saturating_sub(2)..index + 1 } else { index..(index + 3).min(places.len()) };
            let found = places[range].iter().find(|place| place.0 == frame + distance);
            let value = found.and_then(|(_, row)| position.get(*row)).filter(|value| value.is_finite());
            let Some(value) = value else { break };
            weighted.push((*weight, *value));
        }
        if weighted.len() == stencil.weights().len() {
            each(*row, &weighted);
        }
    }
}

/// Recognises whether `candidate` was computed from `position` by one of the stencils, within the rounding of the file.
/// With a velocity as `position` it recognises an acceleration. `None` if less than 80 % of the rows agree.
pub fn recognise(times: &[f64], position: &[f64], candidate: &[f64]) -> Option<Recognised> {
    let sampling = sampling::examine(times);
    recognise_on(&sampling, position, candidate)
}

/// [`recognise`] with a known sampling.
pub fn recognise_on(sampling: &Sampling, position: &[f64], candidate: &[f64]) -> Option<Recognised> {
    let (of, its) = (Rounding::of(position), Rounding::of(candidate));
    let found =
        Stencil::ALL.into_iter().filter_map(|stencil| agreement(sampling, position, candidate, stencil, of, its));
    found.max_by(|one, other| one.share.total_cmp(&other.share)).filter(|best| best.share >= 0.8)
}

fn agreement(
    sampling: &Sampling,
    position: &[f64],
    candidate: &[f64],
    stencil: Stencil,
    of: Rounding,
    its: Rounding,
) -> Option<Recognised> {
    let steps = if stencil.order() == 1 { sampling.interval } else { sampling.interval * sampling.interval };
    // (difference quotient, value of the column, tolerance from rounding).
    let mut rows: Vec<(f64, f64, f64)> = Vec::new();
    neighbours(sampling, position, stencil, |row, weighted| {
        let Some(value) = candidate.get(row).copied().filter(|value| value.is_finite()) else { return };
        let quotient = weighted.iter().map(|(weight, value)| weight * value).sum::<f64>() / steps;
        let size =
            weighted.iter().map(|(weight, value)| weight.abs() * (of.error(*value) + 1e-10 * value.abs())).sum::<f64>()
                / steps;
        rows.push((quotient, value, size));
    });
    const FEWEST: usize = 8;
    if rows.len() < FEWEST {
        return None;
    }
    let root_mean_square = |each: &dyn Fn(&(f64, f64, f64)) -> f64| {
        (rows.iter().map(each).map(|value| value * value).sum::<f64>() / rows.len() as f64).sqrt()
    };
    let size = root_mean_square(&|row| row.0);
    let ratio = median(rows.iter().filter(|row| row.0.abs() > 0.5 * size).map(|row| row.1 / row.0).collect());
    let scale = power_of_ten(ratio)?;
    // The step in the file may be rounded, while the column was computed with the exact one.
    let exact = |rate: f64| {
        let step = sampling.interval * rate;
        if stencil.order() == 1 { step } else { step * step }
    };
    // Tolerance of the ratio: jitter of the times, reduced by the number of rows.
    let slack = 3e-5 + 4.0 * sampling.jitter / libm::pow(rows.len() as f64, 1.5);
    let allowed = [1.0, sampling.rate.map_or(1.0, exact)];
    if allowed.iter().all(|factor| (ratio / scale / factor - 1.0).abs() > slack) {
        return None;
    }
    // If the rounding is as large as the values, nothing can be recognised.
    if root_mean_square(&|row| row.2) > 0.1 * size {
        return None;
    }
    let agree = |row: &&(f64, f64, f64)| {
        (row.1 - ratio * row.0).abs() <= 1.05 * (ratio.abs() * row.2 + its.error(row.1)) + 1e-10 * row.1.abs()
    };
    let agreeing = rows.iter().filter(agree).count();
    Some(Recognised {
        stencil,
        order: stencil.order(),
        share: agreeing as f64 / rows.len() as f64,
        rows: rows.len(),
        scale,
    })
}

/// Power of ten within 2 % of a number, for units that differ by a prefix.
fn power_of_ten(ratio: f64) -> Option<f64> {
    const POWERS: [f64; 13] = [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6];
    POWERS.into_iter().find(|power| (ratio / power - 1.0).abs() < 0.02)
}

/// Rounding of the numbers of a column.
#[derive(Clone, Copy, Debug)]
struct Rounding {
    /// Last decimal of the finest number.
    decimal: f64,
    /// Last digit of a number in units of its first one.
    significant: f64,
}

impl Rounding {
    fn of(values: &[f64]) -> Self {
        let stride = values.len().div_ceil(200).max(1);
        let (mut decimals, mut significant) = (i32::MIN, 1);
        for value in values.iter().step_by(stride).filter(|value| value.is_finite() && **value != 0.0) {
            // 15 digits, so that rounding errors of a unit conversion do not count as digits of the file.
            let text = format!("{value:.14e}");
            let Some((mantissa, exponent)) = text.split_once('e') else { continue };
            let digits = mantissa.trim_end_matches('0').bytes().filter(u8::is_ascii_digit).count();
            let exponent: i32 = exponent.parse().unwrap_or(0);
            significant = significant.max(digits);
            decimals = decimals.max(digits as i32 - 1 - exponent);
        }
        Self {
            decimal: libm::pow(10.0, -f64::from(decimals.max(-300))),
            significant: libm::pow(10.0, 1.0 - significant as f64),
        }
    }

    /// Greatest rounding error of a value.
    fn error(self, value: f64) -> f64 {
        let leading = if value == 0.0 { 0.0 } else { libm::pow(10.0, libm::floor(libm::log10(value.abs()))) };
        0.5 * self.decimal.max(self.significant * leading)
    }
}

//! Values that are assigned, at equal distances.

use super::seat::BLOCK;
use serde::{Deserialize, Serialize};

/// Greatest integer up to which all integers are exact as `f64`.
const GREATEST: i64 = 1 << 53;
/// Greatest power of ten that is exact as `f64`.
const DECIMALS: u8 = 22;

/// Values at equal distances, as decimal numbers: value `k` is (`first` + `k` `step`) / 10^`decimals`, one correctly rounded
/// division of two exact numbers, and so the same number as its decimal digits in a document.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Grid {
    first: i64,
    step: i64,
    count: u32,
    pub(super) decimals: u8,
}

/// Reason why there is no grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GridFault {
    /// The range has no positive length, or the step is not positive.
    Empty,
    /// The range is no multiple of the step.
    Uneven,
    /// There are fewer values than [`Grid::LEAST`].
    TooFew,
    /// There are more values than [`Grid::MOST`].
    TooMany,
    /// The numbers have too many digits.
    TooExact,
}

impl Grid {
    /// Minimum number of values: one for each eighth of the range.
    pub const LEAST: u32 = BLOCK;
    /// Maximum number of values.
    pub const MOST: u32 = 1_000_000;

    /// The values from `low` to `high` at distances of `step`. The numbers are taken as the shortest decimal ones that stand for
    /// them.
    ///
    /// # Errors
    /// Any [`GridFault`].
    pub fn new(low: f64, high: f64, step: f64) -> Result<Self, GridFault> {
        let numbers = [low, high, step].map(decimal);
        let [Some((_, a)), Some((_, b)), Some((_, c))] = numbers else { return Err(GridFault::TooExact) };
        let decimals = a.min(b).min(c).min(0).unsigned_abs();
        if decimals > u32::from(DECIMALS) {
            return Err(GridFault::TooExact);
        }
        let whole = |number: Option<(i64, i32)>| {
            let (digits, tens) = number?;
            let shift = tens.checked_add(decimals as i32)?.unsigned_abs();
            let whole = digits.checked_mul(10_i64.checked_pow(shift)?)?;
            (whole.abs() <= GREATEST).then_some(whole)
        };
        let [Some(first), Some(last), Some(step)] = numbers.map(whole) else { return Err(GridFault::TooExact) };
        if step <= 0 || last <= first {
            return Err(GridFault::Empty);
        }
        if (last - first) % step != 0 {
            return Err(GridFault::Uneven);
        }
        let count = (last - first) / step + 1;
        if count > i64::from(Self::MOST) {
            return Err(GridFault::TooMany);
        }
        if count < i64::from(Self::LEAST) {
            return Err(GridFault::TooFew);
        }
        Ok(Self { first, step, count: count as u32, decimals: decimals as u8 })
    }

    /// Number of values.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// Value with this index, in the unit of the grid.
    pub fn value(&self, index: u32) -> f64 {
        let whole = self.first.saturating_add(self.step.saturating_mul(i64::from(index)));
        let power = (0..self.decimals).fold(1.0, |power, _| power * 10.0);
        whole as f64 / power
    }

    /// True if the grid is one that [`Self::new`] could return.
    pub(crate) fn is_sound(&self) -> bool {
        let steps = i64::from(self.count.saturating_sub(1));
        let last = self.step.checked_mul(steps).and_then(|length| self.first.checked_add(length));
        (Self::LEAST..=Self::MOST).contains(&self.count)
            && self.decimals <= DECIMALS
            && self.step > 0
            && self.first.checked_abs().is_some_and(|first| first <= GREATEST)
            && last.is_some_and(|last| last.abs() <= GREATEST)
    }

    /// Indices of the values in the eighth with this number, from 0. An eighth has its lower end; the last one has both.
    pub(super) fn eighth(&self, number: u32) -> std::ops::Range<u32> {
        let end = |number: u32| (u64::from(number) * u64::from(self.count - 1)).div_ceil(u64::from(BLOCK)) as u32;
        end(number)..if number + 1 == BLOCK { self.count } else { end(number + 1) }
    }
}

/// Digits of the shortest decimal number that stands for `number`, and the power of ten; `None` if it is not finite.
fn decimal(number: f64) -> Option<(i64, i32)> {
    let text = format!("{number:e}");
    let (digits, tens) = text.split_once('e')?;
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    let tens: i32 = tens.parse().ok()?;
    Some((format!("{whole}{part}").parse().ok()?, tens.checked_sub(part.len() as i32)?))
}

/// The values that are assigned instead of a stated one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Assigned {
    /// Values in the unit of the parameter.
    pub grid: Grid,
    /// Value without a seat, SI units.
    pub stated: f64,
}

//! Phases in ranges: the curve is periodic in them, so that the ends of a range that holds a whole turn stop no search.

use super::problem::Problem;
use super::tones::Phase;
use crate::fit::task::Target;

impl Problem {
    /// Least part of a period in the range of a phase that turns freely.
    const WHOLE: f64 = 0.98;

    /// Bounds of searches: those of a phase whose range holds a whole turn do not stop it.
    pub fn open_bounds(&self) -> Vec<(f64, f64)> {
        let open = |number| self.turning(number).map(|_| (f64::NEG_INFINITY, f64::INFINITY));
        self.bounds.iter().enumerate().map(|(number, bounds)| open(number).unwrap_or(*bounds)).collect()
    }

    /// Moves all phases of `x` into their ranges. Returns false if the curve has changed: a range misses a part of a turn.
    pub fn turn_phases_inside(&self, x: &mut [f64]) -> bool {
        let mut same = true;
        for (number, value) in x.iter_mut().enumerate() {
            if let Some(phase) = self.turning(number) {
                let inside = phase.inside(*value, self.bounds[number]);
                let turns = (*value - inside) / phase.period;
                same &= (turns - turns.round()).abs() < 1e-9;
                *value = inside;
            }
        }
        same
    }

    /// Phase that a number is, if the curve is periodic in it and its range holds nearly a whole period or more.
    pub fn turning(&self, number: usize) -> Option<Phase> {
        let (low, high) = self.bounds[number];
        let of_number = |phase: &&Phase| self.columns[number].target() == Some(Target::Parameter(phase.parameter));
        let phase = self.tones.periodic.iter().find(of_number)?;
        let bounded = low.is_finite() || high.is_finite();
        (bounded && high - low >= Self::WHOLE * phase.period).then_some(*phase)
    }
}

//! `random seed = 1 in 1..9999 "Seed"`: the integer seed of all random draws of a run.

use super::Salvaged;
use crate::parser::cursor::Cursor;
use crate::{Diagnostic, ParameterForm, StatementKind};
use units::words;

/// 2^53: all integers up to it are exact as `f64`.
const GREATEST: f64 = 9_007_199_254_740_992.0;

impl Cursor<'_> {
    /// `random seed = 1 in 1..9999`
    pub(in crate::parser) fn random(&mut self) -> Salvaged {
        let (mut kind, mut read) = self.parameter();
        if let StatementKind::Parameter(seed) = &mut kind {
            seed.form = ParameterForm::Seed;
            seed.step = seed.step.or(Some(1.0));
            let bounds = seed.range.iter().flat_map(|range| [range.low, range.high]);
            let whole = |number: f64| number.floor() == number && (0.0..=GREATEST).contains(&number);
            let fits = bounds.chain([seed.value]).chain(seed.step).all(whole) && seed.unit.is_none();
            if read.is_ok() && !fits {
                let wrong = words!("the seed `{}` is a whole number without a unit", seed.name.text);
                let hint = words!("such as: random {} = 1 in 1..9999", seed.name.text);
                read = self.fail(Diagnostic::error("seed", wrong, seed.value_span).with_hint(hint));
            }
        }
        (kind, read)
    }
}

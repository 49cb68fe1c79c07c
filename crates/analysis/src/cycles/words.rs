//! Sentences about the cycles of a record, in English and Spanish.

use super::constancy::Constancy;
use super::cycle::Measured;
use super::quantity::Quantity;
use super::record::{Cycles, NoCycles};
use units::{Language, say};

/// Number formats for the sentences.
pub struct Writing<'a> {
    /// Formats a value of a quantity with its error and unit.
    pub measured: &'a dyn Fn(Quantity, Measured) -> String,
    /// Formats a value of the record with its unit.
    pub value: &'a dyn Fn(f64) -> String,
    /// Formats a time with its unit.
    pub time: &'a dyn Fn(f64) -> String,
    /// Formats a number with this many decimals.
    pub fixed: &'a dyn Fn(f64, usize) -> String,
}

/// Least correlation of the noise of neighbouring rows that is reported.
const CORRELATED: f64 = 0.3;

impl Cycles {
    /// Sentences about the record: constancy of frequency and damping, shape, drift, noise, and the end of the table.
    pub fn sentences(&self, language: Language, writing: &Writing) -> Vec<String> {
        let one_decimal = |value: f64| (writing.fixed)(value, 1);
        let mut sentences: Vec<String> = [Quantity::AngularFrequency, Quantity::Damping]
            .into_iter()
            .filter_map(|quantity| {
                let written = |measured: Measured| (writing.measured)(quantity, measured);
                Some(Constancy::of(&self.cycles, quantity)?.text(quantity, language, &written, &one_decimal))
            })
            .collect();
        sentences.extend((!self.sinusoidal).then(|| another_shape(language).to_owned()));
        if let Some(drift) = &self.drift {
            let [from, to] = [drift.from, drift.to].map(writing.value);
            sentences.push(say!(
                language,
                "The level drifts, from {from} to {to}; the drift was subtracted before the cycles were measured."
            ));
        }
        if self.correlation >= CORRELATED {
            let rho = (writing.fixed)(self.correlation, 2);
            sentences.push(say!(
                language,
                "The noise of neighbouring rows is correlated ({rho}); the errors account for it."
            ));
        }
        if let Some(cut_off) = &self.cut_off {
            let ends: Vec<String> = cut_off.low.iter().chain(&cut_off.high).map(|end| (writing.value)(*end)).collect();
            let ends = ends.join(language.say(" and "));
            let rows = cut_off.rows;
            sentences.push(say!(language, "The record is cut off at {ends}, the end of the range of the instrument: {rows} rows were left out, and \
                     the cycles were measured from the others."));
        }
        sentences.extend(self.lost.map(|time| self.lost_text(&(writing.time)(time), language)));
        sentences
    }

    /// Reason why the cycles end at `time`, a text with its unit.
    fn lost_text(&self, time: &str, language: Language) -> String {
        let why = match self.sinusoidal {
            true => language.say("the noise hides the oscillation"),
            false => language.say(
                "the oscillation does not cross its middle level clearly: by more than the noise and a hundredth of its range",
            ),
        };
        say!(language, "From {time} on {why}.")
    }
}

/// Meaning of period and amplitude if the shape is not a sinusoid.
fn another_shape(language: Language) -> &'static str {
    language.say(
        "The shape is not a damped sinusoid: the period is the time between crossings of the middle level in the same \
         direction, and the amplitude is half the height between turning points.",
    )
}

impl NoCycles {
    /// Reason as a sentence; `fixed` formats a number with one decimal.
    pub fn text(self, language: Language, fixed: &dyn Fn(f64) -> String) -> String {
        match self {
            Self::Unclear => language.say(
                "This column does not oscillate clearly above the noise: a cycle needs three turning points, clear of the noise.",
            )
            .to_owned(),
            Self::Sparse(density) => {
                let density = fixed(density);
                say!(language, "The rows are too sparse: a period has {density} of them, and a cycle is measured from at least 5.3. \
                         Record more rows per second, or fit a model, which uses all cycles together.")
            }
        }
    }
}

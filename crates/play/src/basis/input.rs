//! Parsing of typed input: a number with an optional unit, or an expression.

use super::Basis;
use super::calculator::calculate;
use super::typed::{Candidate, candidates, stated_units};
use crate::{Course, Refusal, number};
use engine::Readings;
use units::Unit;
use units::number::Style;
use units::number::typed::NotRead;

/// Significant digits of a value at rest.
pub const DIGITS: usize = 6;

impl Basis {
    /// Parses a value and returns it in SI: a number in `unit`, or with its own unit of the same dimension, with or without
    /// brackets. 1 Hz is read as 2 pi rad/s where `unit` counts angles, and the reverse.
    pub fn read_value(&self, typed: &str, unit: &Unit) -> Result<f64, Refusal> {
        self.read_value_as(typed, unit, self.style())
    }

    /// [`Basis::read_value`] of a text in another number format.
    pub(crate) fn read_value_as(&self, typed: &str, unit: &Unit, style: Style) -> Result<f64, Refusal> {
        Ok(number::typed::quantity(typed, unit, style)?)
    }

    /// Refuses an expression with the value `value` in the unit `own`, if `unit` counts turns differently: whether it is
    /// converted already, as `6.28*0.27 Hz` is, remains open.
    fn refuse_other_frequency(&self, value: f64, own: &Unit, unit: &Unit) -> Result<(), Refusal> {
        if own.turning(unit) == 1.0 {
            return Ok(());
        }
        let meant = unit.from_si(own.to_si_of(value, unit));
        Err(Refusal::OtherFrequency {
            typed: number::with_unit(&number::plain(value, DIGITS, self.style()), own),
            meant: number::with_unit(&number::plain(meant, 3, self.style()), unit),
            angular: own.counts_cycles(),
        })
    }

    /// Parses the text of a field that shows `shown`. `None` if the text is unchanged, because the shown text may be
    /// rounded. Otherwise a value (SI) as in [`Basis::read_value`], or the present value of an expression in the
    /// parameters `at` the moment shown.
    pub fn read_field(&self, at: &Course, typed: &str, shown: &str, unit: &Unit) -> Result<Option<f64>, Refusal> {
        if typed.trim() == shown {
            return Ok(None);
        }
        match self.read_value(typed, unit) {
            Ok(value) => Ok(Some(value)),
            Err(refusal) => self.read_expression(at, typed, unit).map(Some).map_err(|why| why.unwrap_or(refusal)),
        }
    }

    /// Value (SI) of an expression as in presets (`2*m*omega_0`, `y(0)/2`), or of typed arithmetic with units
    /// (`15/4 s`). A pure number is taken to be in `unit`.
    ///
    /// # Errors
    ///
    /// The specific refusal, or `None` if the text is simply not a number.
    pub(crate) fn read_expression(&self, at: &Course, typed: &str, unit: &Unit) -> Result<f64, Option<Refusal>> {
        self.evaluate_any(typed, unit, self.style(), (at.parameters(), at.initial()))
    }

    /// Value (SI) of typed arithmetic without names of the model, in a number format; errors as of
    /// [`Basis::read_expression`].
    pub(crate) fn read_constant(&self, typed: &str, unit: &Unit, style: Style) -> Result<f64, Option<Refusal>> {
        let start = vec![0.0; self.model().states.len()];
        self.evaluate_any(typed, unit, style, (&self.defaults().parameters, &start))
    }

    fn evaluate_any(
        &self,
        typed: &str,
        unit: &Unit,
        style: Style,
        known: (&[f64], &[f64]),
    ) -> Result<f64, Option<Refusal>> {
        let mut why = None;
        for candidate in candidates(typed, style) {
            match self.evaluate(known, &candidate, unit) {
                Ok(value) => return Ok(value),
                Err(refusal) => why = why.or(refusal),
            }
        }
        Err(why)
    }

    /// Value (SI) of a candidate with these parameters and this initial state.
    fn evaluate(
        &self,
        (parameters, initial): (&[f64], &[f64]),
        candidate: &Candidate,
        unit: &Unit,
    ) -> Result<f64, Option<Refusal>> {
        let text = &candidate.expression;
        // A copy, so that the typed expression does not stay in the graph.
        let mut model = self.model().clone();
        let calculation = calculate(&mut model, text).ok_or(None)?;
        if model.depends(calculation.node).varies() {
            return Err(None);
        }
        let mut readings = Readings::new(&model, &[calculation.node]);
        let value = readings.at(parameters, initial, 0.0, initial).first().copied().unwrap_or(f64::NAN);
        let (pure, fits) = (calculation.dimension.is_none(), calculation.dimension == unit.dimension);
        let names = &calculation.names;
        let si = match &candidate.unit {
            Some(own) if pure && own.dimension == unit.dimension => {
                self.refuse_other_frequency(value, own, unit)?;
                own.to_si(value)
            }
            Some(own) if pure => {
                let (typed, expected) = (number::unit_text(&own.text), number::unit_text(&unit.text));
                return Err(Some(NotRead::WrongUnit { typed, expected }.into()));
            }
            Some(_) => return Err(None),
            // `60/2` is 30 degrees if degrees are expected, but `pi/6` and `theta_0/2` are angles themselves.
            None if pure && (!fits || (names.is_empty() && !text.contains('['))) => unit.to_si(value),
            None if fits => {
                // `2*pi*(0.27 Hz)` is an angular frequency, `0.54/2 Hz` is not.
                let unconverted = stated_units(text).filter(|_| names.is_empty());
                for own in unconverted {
                    self.refuse_other_frequency(own.from_si(value), &own, unit)?;
                }
                // Another quantity is converted, an expression in quantities is not.
                match names.as_slice() {
                    [name] if !text.contains(|sign: char| sign == ' ' || "+-*/^([".contains(sign)) => {
                        let own = model.lookup(name, 0).map(|named| named.unit);
                        own.map_or(value, |own| value * own.turning(unit))
                    }
                    _ => value,
                }
            }
            None => return Err(None),
        };
        if si.is_finite() { Ok(si) } else { Err(None) }
    }

    /// Text of an SI value in `unit`, with the unit: `0,05 m²`.
    pub fn quantity_text(&self, value: f64, unit: &Unit) -> String {
        number::with_unit(&number::plain(unit.from_si(value), DIGITS, self.style()), unit)
    }
}

//! Unit of the numbers of a record that states none, decided once for all theories that are to describe them.

use engine::{Advance, Method, Readings, Run, Setup};
use program::{Compiled, Model};
use units::Unit;
use units::order::nth;

/// Ratio of the swings of a record and of a theory's own run from which on a unit is out of proportion. Neighbouring units
/// differ by 100 or 1000.
const OUT_OF_PROPORTION: f64 = 30.0;
/// Number of instants at which the theory's own run is read.
const INSTANTS: usize = 256;
/// Maximum work of the theory's own run, in floating-point operations: some milliseconds.
const MOST_WORK: u64 = 4_000_000;

/// Unit that a theory declares for a measured quantity, and the size of the numbers compared with its own run.
#[derive(Clone, Debug, PartialEq)]
pub struct Expectation {
    /// Declared unit.
    pub declared: Unit,
    /// Swing of the numbers, without a unit, over the swing of the theory's own run, SI; `None` if one of them is unknown or
    /// 0.
    pub ratio: Option<f64>,
}

/// Decision about the unit of numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum AssumedUnit {
    /// The numbers are read in this unit.
    Unit(Unit),
    /// The theories declare these different units, and the numbers do not decide between them.
    Open(Vec<Unit>),
}

impl Expectation {
    /// Compares numbers at `times` (readings of the clock, SI) with the run of `model` that has its own parameters and takes as
    /// long as the record.
    pub fn new(model: &Model, observed: &Compiled, times: &[f64], numbers: &[f64]) -> Self {
        let own = own_values(model, observed, times).map_or(0.0, |values| swing(&values));
        let ratio = swing(numbers) / own;
        Self { declared: observed.unit.clone(), ratio: Some(ratio).filter(|ratio| *ratio > 0.0 && ratio.is_finite()) }
    }

    /// Natural logarithm of the ratio of both swings if the numbers are in `unit`.
    fn off(&self, unit: &Unit) -> Option<f64> {
        self.ratio.map(|ratio| libm::log(unit.to_si(ratio)).abs())
    }
}

/// Decides the unit of numbers for all theories together. `present`: unit in which they have been read so far.
///
/// The unit that all theories declare is taken, unless it makes the numbers out of proportion to the theories' own runs and
/// the SI unit does not. Of different units the only one is taken that is not out of proportion. `None` without theories.
pub fn assumed_unit(present: Option<&Unit>, theories: &[Expectation]) -> Option<AssumedUnit> {
    let mut declared: Vec<&Unit> = Vec::new();
    for unit in present.into_iter().chain(theories.iter().map(|theory| &theory.declared)) {
        if !declared.iter().any(|known| is_same(known, unit)) {
            declared.push(unit);
        }
    }
    let first = *declared.first()?;
    let mut candidates: Vec<Unit> = declared.iter().map(|unit| (*unit).clone()).collect();
    if !first.is_coherent() && candidates.iter().all(|unit| !unit.is_coherent()) {
        candidates.push(Unit::si(first.dimension));
    }
    let proportionate = |unit: &&Unit| {
        let off: Vec<f64> = theories.iter().filter_map(|theory| theory.off(unit)).collect();
        off.iter().sum::<f64>() <= off.len() as f64 * libm::log(OUT_OF_PROPORTION)
    };
    let mut fitting = candidates.iter().filter(proportionate);
    Some(match (fitting.next(), fitting.next()) {
        _ if declared.len() == 1 && proportionate(&first) => AssumedUnit::Unit(first.clone()),
        (Some(only), None) => AssumedUnit::Unit(only.clone()),
        _ if declared.len() == 1 => AssumedUnit::Unit(first.clone()),
        _ => AssumedUnit::Open(declared.into_iter().cloned().collect()),
    })
}

/// True if numbers mean the same in both units, which is not so of Hz and rad/s.
pub fn is_same(one: &Unit, other: &Unit) -> bool {
    one.dimension == other.dimension && one.to_si_of(1.0, other) == other.to_si(1.0)
}

/// Distance from the lowest to the highest value, without 2 % of the values at either end; 0 without finite values.
fn swing(values: &[f64]) -> f64 {
    let values: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
    let left_out = values.len() / 50;
    let ends = values.len().checked_sub(1 + left_out).map(|last| nth(&values, last) - nth(&values, left_out));
    ends.unwrap_or(0.0)
}

/// Values of a quantity in the theory's own run, SI: of a formula at the `times` themselves, of equations of motion from
/// their beginning on. `None` if the run fails or needs too much work.
fn own_values(model: &Model, observed: &Compiled, times: &[f64]) -> Option<Vec<f64>> {
    let finite = || times.iter().copied().filter(|time| time.is_finite());
    let (first, last) = (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
    let duration = Some(last - first).filter(|duration| *duration > 0.0 && duration.is_finite())?;
    let step = duration / (INSTANTS - 1) as f64;
    let instants = (0..INSTANTS).map(|place| place as f64 * step);
    let mut readings = Readings::new(model, &[observed.node]);
    let mut value = |parameters: &[f64], initial: &[f64], time: f64, state: &[f64]| {
        readings.at(parameters, initial, time, state).first().copied().unwrap_or(f64::NAN)
    };
    let setup = Setup { method: Method::DormandPrince, tolerance: 1e-4, step, ..Setup::defaults(model) };
    let parameters = setup.parameters.clone();
    if model.states.is_empty() {
        return Some(instants.map(|instant| value(&parameters, &[], first + instant, &[])).collect());
    }
    let mut run = Run::start(model, setup).ok()?;
    while run.time() < duration {
        let left = MOST_WORK.checked_sub(run.work())?;
        if !matches!(run.advance_within(left), Ok(Advance::Step | Advance::Event)) {
            return None;
        }
    }
    // An event that ends the run there does not affect the rows before.
    let _ = run.finish(duration);
    let mut state = vec![0.0; model.states.len()];
    let at = |instant: f64| {
        run.interpolate(instant, &mut state);
        value(&parameters, run.initial(), instant, &state)
    };
    Some(instants.map(at).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(text: &str) -> Unit {
        Unit::parse(text).unwrap()
    }

    /// Unit in which numbers have been read, theories as for [`read`], swing of the numbers, and expected unit.
    type Case<'a> = (Option<&'a str>, &'a [(&'a str, f64)], f64, &'a str);

    /// Theories that declare these units, with swings of their own runs in metres; numbers that swing by `numbers`.
    fn read(present: Option<&str>, theories: &[(&str, f64)], numbers: f64) -> String {
        let theories: Vec<Expectation> = theories
            .iter()
            .map(|(declared, own)| Expectation { declared: unit(declared), ratio: Some(numbers / own) })
            .collect();
        match assumed_unit(present.map(unit).as_ref(), &theories) {
            Some(AssumedUnit::Unit(unit)) => unit.text,
            Some(AssumedUnit::Open(units)) => {
                units.iter().map(|unit| unit.text.as_str()).collect::<Vec<_>>().join(" or ")
            }
            None => String::new(),
        }
    }

    #[test]
    fn one_unit_holds_for_all_theories() {
        let cases: [Case; 15] = [
            (None, &[("cm", 0.06)], 5.0, "cm"),
            // A small swing is no reason to doubt the theory's unit, one that is far too small is.
            (None, &[("cm", 0.06)], 0.5, "cm"),
            (None, &[("cm", 0.06)], 0.041, "m"),
            (None, &[("m", 1.0)], 0.041, "m"),
            (None, &[("m", 0.08)], 400.0, "m"),
            // Neither suits.
            (None, &[("cm", 0.06)], 1e6, "cm"),
            (None, &[("cm", 0.06), ("m", 0.08)], 0.041, "m"),
            (None, &[("m", 0.08), ("cm", 0.06)], 0.041, "m"),
            (None, &[("m", 1.0), ("cm", 0.06)], 0.041, "m"),
            (None, &[("cm", 0.06), ("m", 0.08)], 4.1, "cm"),
            (None, &[("cm", 0.06), ("m", 0.08)], 0.5, "cm or m"),
            (Some("cm"), &[("m", 0.08)], 4.1, "cm"),
            (Some("cm"), &[("m", 0.08)], 0.5, "cm or m"),
            // One counts cycles, the other angles.
            (None, &[("Hz", 1.0), ("rad/s", 1.0)], 1.0, "Hz or rad/s"),
            (None, &[], 1.0, ""),
        ];
        for (present, theories, numbers, expected) in cases {
            assert_eq!(read(present, theories, numbers), expected, "{present:?} {theories:?} {numbers}");
        }
        // Without a run to compare with, one declared unit holds, and of two none.
        let unknown = |declared| Expectation { declared: unit(declared), ratio: None };
        assert_eq!(assumed_unit(None, &[unknown("cm")]), Some(AssumedUnit::Unit(unit("cm"))));
        let two = [unknown("cm"), unknown("m")];
        assert_eq!(assumed_unit(None, &two), Some(AssumedUnit::Open(vec![unit("cm"), unit("m")])));
    }

    #[test]
    fn single_values_do_not_decide_a_swing() {
        let mut values: Vec<f64> = (0..200).map(|row| f64::from(row % 10)).collect();
        values[17] = 1e6;
        values[18] = f64::NAN;
        assert_eq!(swing(&values), 9.0);
        assert_eq!((swing(&[]), swing(&[3.0])), (0.0, 0.0));
    }
}

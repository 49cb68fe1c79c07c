//! Start of the run after a drag: finds the parameters that give a dragged initial value.

use engine::Readings;
use program::{Choices, Model, Variable};

/// Initial value of one state as a function of the parameters that determine it.
#[derive(Clone, Debug)]
pub(crate) struct Start {
    /// The value, then its partial derivatives with respect to `parameters`.
    readings: Readings,
    parameters: Vec<Decides>,
    /// Number of states of the model.
    states: usize,
}

/// A parameter on which the initial value depends.
#[derive(Clone, Copy, Debug)]
struct Decides {
    /// Index into [`Model::parameters`].
    index: usize,
    /// Least and greatest value, SI.
    range: (f64, f64),
    /// Scale of its changes, SI: the width of its range. Without a range, the magnitude of its default value, or one
    /// unit if that is 0.
    scale: f64,
}

/// Maximum number of Newton iterations.
const MOST_TRIALS: usize = 20;

/// Tolerance of the value found, relative to the change wanted.
const NEAR: f64 = 1e-9;

impl Start {
    /// Returns `None` if no parameter determines the initial value of this state.
    pub fn of(model: &Model, state: usize) -> Option<Self> {
        let initial = model.states.get(state)?.initial;
        let decides = |index: u32| {
            let parameter =
                model.parameters.get(index as usize).filter(|own| own.choices == Choices::Numbers && own.is_shown())?;
            let range = parameter.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            let width = range.1 - range.0;
            let size = if parameter.value == 0.0 { parameter.unit.to_si(1.0) } else { parameter.value };
            let scale = if width.is_finite() { width } else { size.abs() };
            Some(Decides { index: index as usize, range, scale })
        };
        let parameters: Vec<Decides> = model.depends(initial).parameters.into_iter().filter_map(decides).collect();
        if parameters.is_empty() {
            return None;
        }
        let mut extended = model.clone();
        let mut nodes = vec![initial];
        for parameter in &parameters {
            let variable = Variable::Parameter(parameter.index as u32);
            nodes.push(program::differentiate(&mut extended.graph, initial, variable));
        }
        Some(Self { readings: Readings::new(&extended, &nodes), parameters, states: model.states.len() })
    }

    /// Parameters (SI) that give the initial value `wanted` (SI) with the least change from `from`: the sum of squares
    /// of the changes, each divided by its scale, is minimal. For `y(0) = (h_l - h_r)/2` and equal ranges, one height
    /// rises by as much as the other falls. `None` if a parameter would leave its range or no solution is found.
    ///
    /// Newton's method along the gradient. If the initial value is linear in the parameters, the first step is exact.
    pub fn solve(&mut self, from: &[f64], wanted: f64) -> Option<Vec<f64>> {
        let nothing = vec![0.0; self.states];
        let mut found = from.to_vec();
        let mut way = None;
        for _ in 0..MOST_TRIALS {
            let (&value, slopes) = self.readings.at(&found, &nothing, 0.0, &nothing).split_first()?;
            let missing = wanted - value;
            if !missing.is_finite() {
                return None;
            }
            let rounding = 4.0 * f64::EPSILON * wanted.abs().max(value.abs());
            let near = (NEAR * *way.get_or_insert(missing.abs())).max(rounding);
            let gradient: Vec<f64> =
                self.parameters.iter().zip(slopes).map(|(parameter, slope)| slope * parameter.scale).collect();
            let squared: f64 = gradient.iter().map(|part| part * part).sum();
            if missing.abs() <= near || !squared.is_finite() || squared == 0.0 {
                let inside = |parameter: &Decides| {
                    let slack = NEAR * parameter.scale;
                    found
                        .get(parameter.index)
                        .is_some_and(|value| *value >= parameter.range.0 - slack && *value <= parameter.range.1 + slack)
                };
                let reached = missing.abs() <= near && self.parameters.iter().all(inside);
                return reached.then(|| self.within(found));
            }
            for (parameter, part) in self.parameters.iter().zip(gradient) {
                if let Some(value) = found.get_mut(parameter.index) {
                    *value += missing * part / squared * parameter.scale;
                }
            }
        }
        None
    }

    /// Clamps parameters to their ranges to remove rounding errors.
    fn within(&self, mut parameters: Vec<f64>) -> Vec<f64> {
        for parameter in &self.parameters {
            if let Some(value) = parameters.get_mut(parameter.index) {
                *value = value.max(parameter.range.0).min(parameter.range.1);
            }
        }
        parameters
    }
}

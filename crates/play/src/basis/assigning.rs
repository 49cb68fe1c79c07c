//! Parameters after assignments.

use engine::Readings;
use program::Assignment;

/// Parameters (SI) after `assignments`, whose values are the readings from index `first` on. Each is evaluated with the
/// parameters left by the previous ones, and with the initial state that `initial` gives for them.
pub(crate) fn assign(
    readings: &mut Readings,
    first: usize,
    assignments: &[Assignment],
    parameters: &[f64],
    initial: &mut dyn FnMut(&[f64]) -> Vec<f64>,
) -> Vec<f64> {
    let mut parameters = parameters.to_vec();
    for (offset, assignment) in assignments.iter().enumerate() {
        let start = initial(&parameters);
        let values = readings.at(&parameters, &start, 0.0, &start);
        let value = values.get(first + offset).copied().unwrap_or(f64::NAN);
        if let Some(parameter) = parameters.get_mut(assignment.parameter) {
            *parameter = value;
        }
    }
    parameters
}

//! Derived quantities of fitted theories against the parameters that a fit held fixed.

use crate::fits::ShownFits;
use crate::fits::fit::Fitted;
use analysis::fit::Target;
use engine::Readings;
use program::NodeId;
use serde::{Deserialize, Serialize};
use units::order::sort_by;

/// Number of points of a curve.
const POINTS: u32 = 80;
/// A curve reaches from the value of the fit divided by this factor to that value times it.
const REACH: f64 = 10.0;

/// A derived quantity of a theory against a parameter, with the values of a fit for all other parameters. SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TheoryCurve {
    /// Title of the theory.
    pub theory: String,
    /// Name of the derived quantity.
    pub quantity: String,
    /// Name of the parameter.
    pub parameter: String,
    /// Ascending values of the parameter, inside its range.
    pub x: Vec<f64>,
    /// Value of the quantity at each of them.
    pub y: Vec<f64>,
}

impl ShownFits<'_> {
    /// Derived quantities of the finished fits against each parameter that the fit held fixed, from a tenth to ten times its value.
    /// A parameter of value 0 has no curve. `is_wanted`: true for the title of a theory whose curves are to be computed.
    pub fn theory_curves(self, is_wanted: impl Fn(&str) -> bool) -> Vec<TheoryCurve> {
        let wanted = self.fits.finished.iter().filter(|fit| is_wanted(&fit.document.program.title));
        wanted.flat_map(curves).collect()
    }
}

fn curves(fit: &Fitted) -> Vec<TheoryCurve> {
    let model = &fit.document.program.model;
    let Some(settings) = fit.outcome.settings.first() else { return Vec::new() };
    let derived: Vec<_> = model
        .quantities
        .iter()
        .filter(|quantity| fit.outcome.derived.iter().any(|estimate| estimate.name == quantity.name))
        .collect();
    let nodes: Vec<NodeId> = derived.iter().map(|quantity| quantity.value.node).collect();
    let initial: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
    let (mut readings, mut initial) = (Readings::new(model, &nodes), Readings::new(model, &initial));
    let nothing = vec![0.0; model.states.len()];
    let mut curves = Vec::new();
    for (index, parameter) in model.shown_parameters() {
        let is_varied = fit.task.varied.iter().any(|varied| varied.target == Target::Parameter(index));
        let Some(&own) = settings.get(index).filter(|own| !is_varied && **own != 0.0 && own.is_finite()) else {
            continue;
        };
        let (low, high) = parameter.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        let mut points: Vec<(f64, Vec<f64>)> = Vec::new();
        let mut parameters = settings.clone();
        for step in 0..=POINTS {
            let x = own * libm::pow(REACH, 2.0 * f64::from(step) / f64::from(POINTS) - 1.0);
            if (low..=high).contains(&x) {
                parameters[index] = x;
                let state = initial.at(&parameters, &nothing, 0.0, &nothing).to_vec();
                points.push((x, readings.at(&parameters, &state, 0.0, &state).to_vec()));
            }
        }
        sort_by(&mut points, |one, other| one.0.total_cmp(&other.0));
        for (place, quantity) in derived.iter().enumerate() {
            let depends = points.windows(2).any(|pair| pair[0].1.get(place) != pair[1].1.get(place));
            let known = points.iter().filter_map(|(x, values)| Some((*x, *values.get(place)?)));
            let (x, y) = known.filter(|(_, y)| depends && y.is_finite()).unzip();
            curves.push(TheoryCurve {
                theory: fit.document.program.title.clone(),
                quantity: quantity.name.clone(),
                parameter: parameter.name.clone(),
                x,
                y,
            });
        }
    }
    curves.retain(|curve| curve.x.len() > 1);
    curves
}

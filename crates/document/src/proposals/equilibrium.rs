//! Equilibria of single motions, and the linearised equations about them.

use super::study::{Motion, Point, Study};
use super::terms::Class;
use program::NodeId;

/// Maximum number of Newton steps to an equilibrium.
const STEPS: usize = 50;

/// Equilibrium of a motion that is coupled with nothing once its drive is switched off; SI units.
pub struct Equilibrium {
    pub motion: Motion,
    /// Position.
    pub position: f64,
    /// Square of the angular frequency of small oscillations without friction; negative if it is unstable.
    pub stiffness: f64,
    /// [`Self::stiffness`] with other values than those of the document; NaN if there is no equilibrium.
    pub stiffness_moved: f64,
    /// Twice the damping rate.
    pub damping: f64,
    /// True if the acceleration is linear in the position.
    pub linear: bool,
    /// Parameters that switch the drive off.
    pub drive: Vec<usize>,
    /// Parameters that switch friction off; `None` if it cannot be.
    pub friction: Option<Vec<usize>>,
    /// Indices of the parameters on which the acceleration depends.
    pub parameters: Vec<u32>,
}

/// Equilibria of all single motions, with the values of the document; damping rates with nonzero friction.
pub fn equilibria(study: &mut Study) -> Vec<Equilibrium> {
    let motions = study.motions.clone();
    motions.into_iter().filter_map(|motion| equilibrium(study, motion)).collect()
}

fn equilibrium(study: &mut Study, motion: Motion) -> Option<Equilibrium> {
    let terms = study.terms(&[motion]);
    let of = |driven: bool| -> Vec<NodeId> {
        terms.iter().filter(|(term, _)| (term.class == Class::Driven) == driven).map(|(term, _)| term.node).collect()
    };
    let drive = study.vanishing(&of(true))?;
    let alone = |node: &NodeId| {
        let states = study.model.depends(*node).states;
        states.iter().all(|&state| state == motion.position || state == motion.velocity || study.is_discrete(state))
    };
    if !of(false).iter().all(alone) {
        return None;
    }
    let frictions: Vec<NodeId> = terms
        .iter()
        .filter(|(term, _)| matches!(term.class, Class::Odd | Class::Other))
        .map(|(term, _)| term.node)
        .collect();
    let friction = study.vanishing(&frictions);
    let slopes = [motion.position, motion.velocity].map(|state| study.slope(motion.acceleration, state));
    let [parameters, generic, moved] = [&study.stated, &study.generic, &study.moved].map(|values| {
        let mut values = values.clone();
        drive.iter().for_each(|&index| values[index] = 0.0);
        values
    });
    let at = |position: f64| {
        let mut point = study.run[0].clone();
        point.states[motion.position as usize] = position;
        point.states[motion.velocity as usize] = 0.0;
        point
    };
    let position = zero(study, motion, slopes[0], &parameters, at)?;
    let elsewhere = zero(study, motion, slopes[0], &moved, at);
    let stiffness_moved =
        elsewhere.map_or(f64::NAN, |position| -study.values_at(&slopes[..1], &moved, &[at(position)])[0][0]);
    let stiffness = -study.values_at(&slopes[..1], &parameters, &[at(position)])[0][0];
    let damping = -study.values_at(&slopes[1..], &generic, &[at(position)])[0][0];
    let along: Vec<Point> = study.run.iter().map(|point| at(point.states[motion.position as usize])).collect();
    let slopes = &study.values_at(&slopes[..1], &parameters, &along)[0];
    let linear = slopes.iter().all(|slope| (slope + stiffness).abs() <= 1e-9 * stiffness.abs());
    let parameters = study.model.depends(motion.acceleration).parameters;
    Some(Equilibrium { motion, position, stiffness, stiffness_moved, damping, linear, drive, friction, parameters })
}

/// Position at which the acceleration is 0, by Newton's method from the mean position of the run.
fn zero(study: &Study, motion: Motion, slope: NodeId, parameters: &[f64], at: impl Fn(f64) -> Point) -> Option<f64> {
    let positions = || study.run.iter().map(|point| point.states[motion.position as usize]);
    let mut position = positions().sum::<f64>() / study.run.len() as f64;
    let scale = positions().map(f64::abs).fold(0.0, f64::max);
    for _ in 0..STEPS {
        let values = study.values_at(&[motion.acceleration, slope], parameters, &[at(position)]);
        let step = values[0][0] / values[1][0];
        if values[0][0] == 0.0 && values[1][0] != 0.0 {
            return Some(position);
        }
        if !step.is_finite() {
            return None;
        }
        position -= step;
        if step.abs() <= 1e-14 * (scale + position.abs()) {
            // Rounding leaves a small number of 0.
            return Some(if position.abs() <= 1e-12 * scale { 0.0 } else { position });
        }
    }
    None
}

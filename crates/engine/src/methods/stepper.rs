//! Integration of a model along the grid, without recorded history.

mod advance;
mod ahead;
mod compiled;
mod corner;
mod count;
mod finish;
mod moment;
mod outside;
mod presses;

pub use advance::Progress;
pub use finish::{ROUNDING, rows_until};
pub(crate) use moment::{Moment, grid_index};
pub use outside::Reached;
use presses::Presses;

use super::adaptive::{Adaptive, Pair};
use super::dormand_prince::DormandPrince;
use super::equations::Equations;
use super::fixed::Fixed;
use super::rosenbrock::Rosenbrock;
use super::stability::Stability;
use crate::events::surfaces::Surfaces;
use crate::start;
use crate::{Cause, Method, Notice, Routine, RunError, Setup};
use program::{Model, NodeId};

/// A model with its current state, which moves along the grid t_n = n h.
#[derive(Clone, Debug)]
pub struct Stepper {
    equations: Equations,
    solver: Solver,
    surfaces: Surfaces,
    method: Method,
    step: f64,
    /// Index of the last grid point at or before `time`.
    index: u64,
    /// True if `time` is that grid point.
    on_grid: bool,
    time: f64,
    state: Vec<f64>,
    next: Vec<f64>,
    /// The parameters in force, SI units. A stepper has no history; fits use it without one.
    parameters: Vec<f64>,
    initial: Vec<f64>,
    /// Progress since the last grid point.
    row: RowWork,
    /// True if events that end the run take effect.
    heeds_ends: bool,
    /// True if the independent variable counts (discrete time).
    counts: bool,
    presses: Presses,
    /// Error that stopped the stepper, until parameters or state change.
    stopped: Option<RunError>,
}

/// Steps and events since the last grid point.
#[derive(Clone, Copy, Debug, Default)]
struct RowWork {
    steps: usize,
    events: usize,
    event_burst: Burst,
    /// Switches of the equations.
    switches: usize,
    /// Steps that were shortened because the equations have no value.
    shortened: usize,
}

/// Number of events or switches within a short time.
#[derive(Clone, Copy, Debug, Default)]
struct Burst {
    since: f64,
    count: usize,
}

impl Burst {
    /// Adds `count`; returns the number within about the last `span`.
    fn add(&mut self, count: usize, time: f64, span: f64) -> usize {
        if time - self.since > span {
            *self = Self { since: time, count: 0 };
        }
        self.count += count;
        self.count
    }
}

#[derive(Clone, Debug)]
enum Solver {
    Fixed(Fixed),
    Adaptive(Box<Adaptive>),
}

impl Stepper {
    /// Checks the setup and computes the initial state.
    ///
    /// # Errors
    /// A step or tolerance out of range, an initial state that is not finite, or a method that cannot integrate the model.
    pub fn new(model: &Model, setup: &Setup) -> Result<Self, RunError> {
        let setup = &setup.clone().fitting(model);
        start::check(setup, model)?;
        let initial = match &setup.start {
            Some(start) => start.clone(),
            None => initial_state(model, &setup.parameters),
        };
        start::check_initial(&initial)?;
        let states = model.states.len();
        // The error control of an adaptive method shortens its steps at a bend. Locating the bend would take as many steps.
        let held = model.held(!setup.method.adaptive());
        let moving = held.as_ref().map_or(model, |held| &held.model);
        let adaptive = |pair| Solver::Adaptive(Box::new(Adaptive::new(pair, model, setup)));
        let equations = match setup.method {
            Method::Rosenbrock => Equations::with_slopes(moving).ok_or(RunError::at_start(Cause::ModelTooLarge))?,
            _ => Equations::new(moving),
        };
        let solver = match setup.method {
            method @ (Method::Euler | Method::EulerRichardson | Method::VelocityVerlet | Method::RungeKutta4) => {
                Solver::Fixed(Fixed::new(method, model, &equations))
            }
            Method::DormandPrince => adaptive(Pair::DormandPrince(DormandPrince::new(states))),
            Method::Rosenbrock => {
                let pattern = equations.pattern();
                if !Rosenbrock::can_solve(states, pattern) {
                    return Err(RunError::at_start(Cause::ModelTooLarge));
                }
                adaptive(Pair::Rosenbrock(Rosenbrock::new(states, pattern)))
            }
        };
        let mut stepper = Self {
            equations,
            solver,
            surfaces: Surfaces::new(model, held.as_ref()),
            method: setup.method,
            step: setup.step,
            index: 0,
            on_grid: true,
            time: 0.0,
            next: initial.clone(),
            state: initial.clone(),
            parameters: setup.parameters.clone(),
            initial,
            row: RowWork::default(),
            heeds_ends: true,
            counts: model.independent.counts,
            presses: Presses::new(model, &setup.presses),
            stopped: None,
        };
        stepper.prepare();
        stepper.restart();
        stepper.surfaces.events.arm(stepper.time, &stepper.state);
        Ok(stepper)
    }

    /// Current value of the independent variable, SI units.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The current state, one value per state, SI units.
    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// The state at the start, one value per state, SI units.
    pub fn initial(&self) -> &[f64] {
        &self.initial
    }

    /// Number of evaluations of the right-hand side.
    pub fn evaluations(&self) -> u64 {
        self.equations.evaluations
    }

    /// Number of evaluations of its derivatives (stiff method only).
    pub fn jacobians(&self) -> u64 {
        self.equations.jacobians
    }

    /// Approximate number of floating-point operations so far: equations, conditions of events and, for the stiff method,
    /// linear systems.
    pub fn work(&self) -> u64 {
        let systems = match &self.solver {
            Solver::Adaptive(adaptive) => adaptive.work_of_systems(self.equations.evaluations),
            Solver::Fixed(_) => 0,
        };
        self.equations.work() + self.surfaces.work() + systems
    }

    /// The limits of accuracy met so far.
    pub fn notices(&self) -> Vec<Notice> {
        self.surfaces.notices()
    }

    /// Runs the stability check at the current state.
    pub(crate) fn look(&mut self, stability: &mut Stability) {
        stability.look(&mut self.equations, self.time, self.step, &self.state);
    }

    /// The parameters in force, one value per parameter, SI units.
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// Changes the parameters from here on (one value per parameter, SI units); the state is kept.
    pub fn set_parameters(&mut self, parameters: Vec<f64>) {
        self.catch_up();
        self.parameters = parameters;
        self.stopped = None;
        self.row = RowWork::default();
        self.prepare();
        self.restart();
    }

    /// Sets the tolerance per step of an adaptive method, relative to the greatest magnitude of each state so far instead
    /// of its current one. An oscillation then takes a third of the steps and is as accurate where it matters for fits:
    /// measured values do not become more accurate near zero either.
    pub fn allow_of_peak(&mut self, tolerance: f64) {
        self.catch_up();
        self.forget_steps();
        if let Solver::Adaptive(adaptive) = &mut self.solver {
            adaptive.allow_of_peak(tolerance.max(Setup::LEAST_TOLERANCE));
        }
    }

    fn prepare(&mut self) {
        self.surfaces.prepare(&self.parameters, &self.initial);
        self.surfaces.switches.differ(self.time, &self.state);
        self.surfaces.switches.hold();
        self.prepare_equations();
    }

    fn prepare_equations(&mut self) {
        self.equations.prepare(&self.parameters, self.surfaces.switches.held(), &self.initial);
        self.surfaces.prepare_looks(&self.parameters, &self.initial);
        self.load_checks();
    }

    /// Holds the switches of the equations at their current values. Returns the first that changes and makes the rates
    /// jump, if any.
    fn hold(&mut self) -> Option<usize> {
        if !self.surfaces.switches.differ(self.time, &self.state) {
            return None;
        }
        let jumped = self.surfaces.switches.hold();
        self.prepare_equations();
        jumped
    }

    fn restart(&mut self) {
        self.forget_steps();
        if let Solver::Adaptive(adaptive) = &mut self.solver {
            adaptive.restart(self.time, &self.state);
        }
    }
}

/// Initial state of the model for `parameters`, one value per state, SI units.
pub(crate) fn initial_state(model: &Model, parameters: &[f64]) -> Vec<f64> {
    let nodes: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
    let zeros = vec![0.0; nodes.len()];
    let mut initial = zeros.clone();
    let mut routine = Routine::compile(model, &nodes);
    routine.prepare(parameters, &zeros);
    routine.evaluate(0.0, &zeros, &mut initial);
    initial
}

//! A model in motion, without memory of where it has been.

mod advance;
mod count;
mod finish;
mod moment;
mod presses;

pub use advance::Progress;
pub use finish::ROUNDING;
pub(crate) use moment::{Moment, grid_index};
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

/// A model in motion: goes from one point of the grid t_n = n h to the next.
#[derive(Clone, Debug)]
pub struct Stepper {
    equations: Equations,
    solver: Solver,
    surfaces: Surfaces,
    method: Method,
    step: f64,
    /// The number of the last grid point at or before `time`.
    index: u64,
    /// Whether `time` is that grid point.
    on_grid: bool,
    time: f64,
    state: Vec<f64>,
    next: Vec<f64>,
    /// Those in force. A stepper has no history, and a fit runs it without any.
    parameters: Vec<f64>,
    initial: Vec<f64>,
    /// What has been done since the last point of the grid.
    row: RowWork,
    /// Whether an event that ends the run does so.
    heeds_ends: bool,
    /// Whether the independent variable counts.
    counts: bool,
    presses: Presses,
    /// Why it cannot go on, until something is changed.
    stopped: Option<RunError>,
}

/// What it took to come from one point of the grid towards the next.
#[derive(Clone, Copy, Debug, Default)]
struct RowWork {
    steps: usize,
    events: usize,
    event_burst: Burst,
    /// Switches of the equations.
    switches: usize,
}

/// How many happenings there have been within a short time.
#[derive(Clone, Copy, Debug, Default)]
struct Burst {
    since: f64,
    count: usize,
}

impl Burst {
    /// Counts so many more, those of the last `span` together.
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
    /// A step or tolerance that is not positive, an initial state that is not finite, a method that cannot treat the model.
    pub fn new(model: &Model, setup: &Setup) -> Result<Self, RunError> {
        let setup = &setup.clone().fitting(model);
        start::check(setup, model)?;
        let initial = match &setup.start {
            Some(start) => start.clone(),
            None => initial_state(model, &setup.parameters),
        };
        start::check_initial(&initial)?;
        let states = model.states.len();
        // The error control of an adaptive method meets a bend with shorter steps; to find it would take as many.
        let held = model.held(!setup.method.adaptive());
        let moving = held.as_ref().map_or(model, |held| &held.model);
        let adaptive = |pair| Solver::Adaptive(Box::new(Adaptive::new(pair, model, setup)));
        let (solver, equations) = match setup.method {
            method @ (Method::Euler | Method::EulerRichardson | Method::VelocityVerlet | Method::RungeKutta4) => {
                let equations = Equations::new(moving);
                (Solver::Fixed(Fixed::new(method, model, &equations)), equations)
            }
            Method::DormandPrince => {
                (adaptive(Pair::DormandPrince(DormandPrince::new(states))), Equations::new(moving))
            }
            Method::Rosenbrock => {
                let equations = Equations::with_slopes(moving).ok_or(RunError::at_start(Cause::ModelTooLarge))?;
                let pattern = equations.pattern();
                if !Rosenbrock::can_solve(states, pattern) {
                    return Err(RunError::at_start(Cause::ModelTooLarge));
                }
                (adaptive(Pair::Rosenbrock(Rosenbrock::new(states, pattern))), equations)
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

    /// The independent variable.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The present state.
    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// The state at the start.
    pub fn initial(&self) -> &[f64] {
        &self.initial
    }

    /// How often the right side of the equations was evaluated.
    pub fn evaluations(&self) -> u64 {
        self.equations.evaluations
    }

    /// How often its derivatives were evaluated (by the stiff method).
    pub fn jacobians(&self) -> u64 {
        self.equations.jacobians
    }

    /// About how many floating-point operations were made so far: evaluations of the equations and of the conditions of
    /// events and, for the stiff method, the solution of its linear systems.
    pub fn work(&self) -> u64 {
        let systems = match &self.solver {
            Solver::Adaptive(adaptive) => adaptive.work_of_systems(self.equations.evaluations),
            Solver::Fixed(_) => 0,
        };
        self.equations.work() + self.surfaces.work() + systems
    }

    /// What cannot be promised of what was done so far.
    pub fn notices(&self) -> Vec<Notice> {
        self.surfaces.notices()
    }

    /// Has the equations looked at where it stands.
    pub(crate) fn look(&mut self, stability: &mut Stability) {
        stability.look(&mut self.equations, self.time, self.step, &self.state);
    }

    /// The parameters in force.
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// Changes the parameters from here on; the state stays.
    pub fn set_parameters(&mut self, parameters: Vec<f64>) {
        self.parameters = parameters;
        self.stopped = None;
        self.row = RowWork::default();
        self.prepare();
        self.restart();
    }

    /// From here on an adaptive method may make this error in each step, relative to the greatest magnitude that each state
    /// has had, and no longer to its present one. What swings through zero then takes a third of the steps, and is as exact
    /// where that counts: beside measured values, whose errors do not vanish at zero either.
    pub fn allow_of_peak(&mut self, tolerance: f64) {
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
    }

    /// Holds the switches of the equations at their values here; the first that changes and with which the rates
    /// jump, if there is one.
    fn hold(&mut self) -> Option<usize> {
        if !self.surfaces.switches.differ(self.time, &self.state) {
            return None;
        }
        let jumped = self.surfaces.switches.hold();
        self.prepare_equations();
        jumped
    }

    fn restart(&mut self) {
        if let Solver::Adaptive(adaptive) = &mut self.solver {
            adaptive.restart(self.time, &self.state);
        }
    }
}

/// The model's initial state for `parameters`.
pub(crate) fn initial_state(model: &Model, parameters: &[f64]) -> Vec<f64> {
    let nodes: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
    let zeros = vec![0.0; nodes.len()];
    let mut initial = zeros.clone();
    let mut routine = Routine::compile(model, &nodes);
    routine.prepare(parameters, &zeros);
    routine.evaluate(0.0, &zeros, &mut initial);
    initial
}

//! A model in motion, without memory of where it has been.

use crate::adaptive::{Adaptive, Pair};
use crate::dormand_prince::DormandPrince;
use crate::equations::Equations;
use crate::events::Events;
use crate::fixed::Fixed;
use crate::places::Places;
use crate::rosenbrock::Rosenbrock;
use crate::setup;
use crate::{Method, Routine, RunError, Setup};
use model::{Model, NodeId};
use units::words;

/// A model in motion: goes from one point of the grid t_n = n h to the next.
#[derive(Clone, Debug)]
pub struct Stepper {
    equations: Equations,
    solver: Solver,
    events: Events,
    places: Places,
    step: f64,
    /// The number of the last grid point at or before `time`.
    index: u64,
    /// Whether `time` is that grid point.
    on_grid: bool,
    time: f64,
    state: Vec<f64>,
    next: Vec<f64>,
    parameters: Vec<f64>,
    initial: Vec<f64>,
    /// Why it cannot go on, until something is changed.
    stopped: Option<RunError>,
}

#[derive(Clone, Debug)]
enum Solver {
    Fixed(Fixed),
    Adaptive(Box<Adaptive>),
}

impl Stepper {
    /// So many events in one step stop the run.
    pub const EVENT_LIMIT: usize = 1000;
    /// So many steps of an adaptive method between two grid points stop the run.
    pub const STEP_LIMIT: usize = 100_000;

    /// Checks the setup and computes the initial state.
    ///
    /// # Errors
    /// A step or tolerance that is not positive, an initial state that is not finite, a method that cannot treat the model.
    pub fn new(model: &Model, setup: &Setup) -> Result<Self, RunError> {
        setup.check(model)?;
        let initial = match &setup.start {
            Some(start) => start.clone(),
            None => initial_state(model, &setup.parameters),
        };
        setup::check_initial(model, &initial)?;
        let states = model.states.len();
        let adaptive = |pair| Solver::Adaptive(Box::new(Adaptive::new(pair, model, setup)));
        let (solver, equations) = match setup.method {
            method @ (Method::Euler | Method::EulerRichardson | Method::VelocityVerlet | Method::RungeKutta4) => {
                (Solver::Fixed(Fixed::new(method, states)), Equations::new(model))
            }
            Method::DormandPrince => (adaptive(Pair::DormandPrince(DormandPrince::new(states))), Equations::new(model)),
            Method::Rosenbrock => (
                adaptive(Pair::Rosenbrock(Rosenbrock::new(states))),
                Equations::with_slopes(model).ok_or_else(|| slopes_too_many(model))?,
            ),
        };
        let mut stepper = Self {
            equations,
            solver,
            events: Events::new(model),
            places: Places::new(model, setup.method),
            step: setup.step,
            index: 0,
            on_grid: true,
            time: 0.0,
            next: initial.clone(),
            state: initial.clone(),
            parameters: setup.parameters.clone(),
            initial,
            stopped: None,
        };
        stepper.prepare();
        stepper.restart();
        stepper.events.arm(stepper.time, &stepper.state);
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

    /// The parameters in force.
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// Changes the parameters from here on; the state stays.
    pub fn set_parameters(&mut self, parameters: Vec<f64>) {
        self.parameters = parameters;
        self.stopped = None;
        self.prepare();
        self.restart();
    }

    /// Goes to the next point of the grid; `record` receives every row on the way: time, state, and whether the state
    /// jumped there from the row before. The result is the number of events.
    ///
    /// # Errors
    /// A state that is no longer finite, too many events, a step that has become too small or too many of them. The state
    /// is then the last finite one, and every further try gives the same error until parameters change.
    pub fn advance(&mut self, mut record: impl FnMut(f64, &[f64], bool)) -> Result<usize, RunError> {
        if let Some(error) = &self.stopped {
            return Err(error.clone());
        }
        let result = self.advance_to_grid(&mut record);
        if let Err(error) = &result {
            self.stopped = Some(error.clone());
        }
        result
    }

    /// Goes to any later time, which need not be on the grid, without a record; the result is the number of events.
    ///
    /// # Errors
    /// As [`Stepper::advance`].
    pub fn advance_to(&mut self, time: f64) -> Result<usize, RunError> {
        if let Some(error) = &self.stopped {
            return Err(error.clone());
        }
        self.on_grid = false;
        let result = self.advance_until(time, &mut |_, _, _| {});
        if let Err(error) = &result {
            self.stopped = Some(error.clone());
        }
        self.find_grid();
        result
    }

    fn advance_to_grid(&mut self, record: &mut impl FnMut(f64, &[f64], bool)) -> Result<usize, RunError> {
        let target = (self.index + 1) as f64 * self.step;
        let fired = self.advance_until(target, record)?;
        self.index += 1;
        self.on_grid = self.time == target;
        Ok(fired)
    }

    fn advance_until(&mut self, target: f64, record: &mut impl FnMut(f64, &[f64], bool)) -> Result<usize, RunError> {
        let mut fired = 0;
        let mut steps = 0;
        while self.time < target {
            let jumped = match self.solver {
                Solver::Fixed(_) => self.fixed(target)?,
                Solver::Adaptive(_) => {
                    steps += 1;
                    if steps > Self::STEP_LIMIT {
                        return Err(self.places.too_many_steps(Self::STEP_LIMIT, self.time));
                    }
                    self.adaptive(target)?
                }
            };
            match jumped {
                Some(resolution) => fired += self.jump(resolution, fired, record)?,
                None if self.time == target => record(self.time, &self.state, false),
                None => {}
            }
        }
        Ok(fired)
    }

    /// From here on an adaptive method may make this error in each step, relative to the greatest magnitude that each state
    /// has had, and no longer to its present one. What swings through zero then takes a third of the steps, and is as exact
    /// where that counts: beside measured values, whose errors do not vanish at zero either.
    pub fn allow_of_peak(&mut self, tolerance: f64) {
        if let Solver::Adaptive(adaptive) = &mut self.solver {
            adaptive.allow_of_peak(tolerance.max(Setup::LEAST_TOLERANCE));
        }
    }

    /// Begins a new run at 0 with other parameters and another initial state, as if it were a new stepper.
    pub fn begin(&mut self, parameters: Vec<f64>, initial: &[f64]) {
        self.initial.copy_from_slice(initial);
        if let Solver::Adaptive(adaptive) = &mut self.solver {
            adaptive.renew(self.step);
        }
        self.resume(0.0, initial, parameters, false);
    }

    /// Goes on from another moment; `after_jump` where the state has just jumped.
    pub(crate) fn resume(&mut self, time: f64, state: &[f64], parameters: Vec<f64>, after_jump: bool) {
        self.time = time;
        self.state.copy_from_slice(state);
        self.parameters = parameters;
        self.stopped = None;
        self.find_grid();
        self.prepare();
        self.restart();
        if after_jump {
            self.events.arm_after_jump(&mut self.equations, time, &self.state, 1e-9 * self.step);
        } else {
            self.events.arm(time, &self.state);
        }
    }

    /// Finds the last grid point at or before the present time.
    fn find_grid(&mut self) {
        self.index = (self.time / self.step) as u64;
        while self.index > 0 && self.index as f64 * self.step > self.time {
            self.index -= 1;
        }
        while (self.index + 1) as f64 * self.step <= self.time {
            self.index += 1;
        }
        self.on_grid = self.index as f64 * self.step == self.time;
    }

    fn prepare(&mut self) {
        self.equations.prepare(&self.parameters, &self.initial);
        self.events.prepare(&self.parameters, &self.initial);
    }

    fn restart(&mut self) {
        if let Solver::Adaptive(adaptive) = &mut self.solver {
            adaptive.restart(self.time, &self.state);
        }
    }

    /// One step to `target`, or, if an event lies before it, to the event, whose resolution in time is returned.
    // Not inlined: `advance` is compiled with its caller, which in the page is optimised for size.
    fn fixed(&mut self, target: f64) -> Result<Option<f64>, RunError> {
        let Solver::Fixed(method) = &mut self.solver else {
            return Ok(None);
        };
        let equations = &mut self.equations;
        let size = if self.on_grid { self.step } else { target - self.time };
        method.step(equations, self.time, size, &self.state, &mut self.next);
        if !self.next.iter().all(|value| value.is_finite()) {
            return Err(self.places.not_finite(self.time, &self.next, equations.singular()));
        }
        if !self.events.is_empty() {
            if self.events.due(target, &self.next) {
                let (time, state) = (self.time, &self.state);
                let crossing = self.events.locate(time, 0.0, size, |since, out| {
                    method.step(equations, time, since, state, out);
                });
                self.time += crossing.low;
                return Ok(Some(crossing.high - crossing.low));
            }
            self.events.pass();
        }
        std::mem::swap(&mut self.state, &mut self.next);
        self.time = target;
        Ok(None)
    }

    /// Goes on to `target` or to the end of the method's own step, whichever is first; or, if an event lies before that, to
    /// the event, whose resolution in time is returned.
    fn adaptive(&mut self, target: f64) -> Result<Option<f64>, RunError> {
        let Solver::Adaptive(method) = &mut self.solver else {
            return Ok(None);
        };
        let equations = &mut self.equations;
        if method.end() <= self.time
            && let Err(stuck) = method.extend(equations, target)
        {
            return Err(self.places.stuck(stuck, self.time, method.attempt(), equations.singular()));
        }
        let until = target.min(method.end());
        if until == method.end() {
            self.next.copy_from_slice(method.end_state());
        } else {
            method.dense(until - method.start(), &mut self.next);
        }
        if !self.events.is_empty() {
            if self.events.due(until, &self.next) {
                let start = method.start();
                let crossing = method.locate(equations, &mut self.events, self.time - start, until - start);
                self.time = start + crossing.low;
                return Ok(Some(crossing.high - crossing.low));
            }
            self.events.pass();
        }
        std::mem::swap(&mut self.state, &mut self.next);
        self.time = until;
        Ok(None)
    }

    /// Lets the located events act; how many there were.
    fn jump(
        &mut self,
        resolution: f64,
        fired: usize,
        record: &mut impl FnMut(f64, &[f64], bool),
    ) -> Result<usize, RunError> {
        self.on_grid = false;
        self.state.copy_from_slice(self.events.before());
        record(self.time, &self.state, false);
        let mut count = self.events.fire(self.time);
        loop {
            let after = self.events.after();
            if !after.iter().all(|value| value.is_finite()) {
                return Err(self.places.not_finite(self.time, after, false));
            }
            self.state.copy_from_slice(after);
            record(self.time, &self.state, true);
            if fired + count > Self::EVENT_LIMIT {
                let event = self.events.first_due();
                return Err(self.places.too_many_events(Self::EVENT_LIMIT, event, self.time));
            }
            match self.events.cascade(self.time) {
                0 => break,
                more => count += more,
            }
        }
        self.events.settle(&mut self.equations, self.time, resolution, self.step);
        self.restart();
        Ok(count)
    }
}

/// The stiff method's derivatives would fill the memory.
fn slopes_too_many(model: &Model) -> RunError {
    let message =
        words("the model is too large for the stiff method", "el modelo es demasiado grande para el método rígido");
    RunError::at_start("model-too-large", message)
        .with_hint(words("choose another method", "elige otro método"))
        .with_span(model.states.first().map(|state| state.span))
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

//! Curve of the model at measured times, with its derivatives with respect to the varied numbers.

use super::motion::Motion;
use crate::fit::lanes::{Lanes, Solution, Sought};
use crate::fit::task::Target;
use engine::{Compiled, Listing, Method, Routine, Setup};
use program::{Kind, Model, Node, NodeId};
use std::cell::RefCell;
use std::rc::Rc;
use units::{Words, words};

/// Error tolerances of a step of equations of motion, relative to the greatest value of each state: far from the answer,
/// near it, and at the end. The last one keeps the error of all steps together below 1e-9.
pub(crate) const TOLERANCES: [f64; 3] = [1e-6, 1e-8, 1e-10];

/// Copy of a model without tables, buttons, texts and sizes.
pub(crate) fn bare(model: &Model) -> Model {
    Model {
        independent: model.independent.clone(),
        parameters: model.parameters.clone(),
        states: model.states.clone(),
        quantities: model.quantities.clone(),
        tables: Vec::new(),
        events: model.events.clone(),
        // No buttons are pressed in a fit.
        buttons: Vec::new(),
        graph: model.graph.clone(),
        texts: Vec::new(),
        sizes: Vec::new(),
        sensitive: None,
    }
}

/// Values of the observed expressions, with derivatives, at any ascending times.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    /// Number of states without sensitivities.
    states: usize,
    /// Indices of the varied parameters, in the order of the targets.
    varied: Vec<usize>,
    observed: usize,
    /// One per varied parameter: true if all observed expressions are linear in all marked parameters together.
    linear: Vec<bool>,
    /// For each observed expression: its value, its derivatives with respect to each of `varied`, and to the independent
    /// variable.
    routine: Routine,
    /// Solver of the equations of motion; `None` for a formula.
    motion: Option<Motion>,
    values: Vec<f64>,
    /// Model, setup and readings from which a solver of several solutions is made; `None` for a formula.
    extended: Option<Rc<Extended>>,
    lanes: Option<Rc<RefCell<dyn Lanes>>>,
    /// Error tolerance of integrations.
    tolerance: f64,
    /// Solutions that were computed side by side, with this tolerance.
    solved: Vec<(Sought, Solution)>,
}

/// The model with sensitivities, the setup of its runs, and what is read.
#[derive(Debug)]
struct Extended {
    model: Model,
    setup: Setup,
    readings: Vec<NodeId>,
}

impl Curve {
    /// Compiles the `observed` expressions of `model` with derivatives with respect to the parameters among `targets`.
    /// `duration` is the approximate length of a run, SI. A method for stiff equations is kept; all others are replaced by
    /// that of Dormand and Prince, which reaches all [`TOLERANCES`].
    pub fn new(
        model: &Model,
        observed: &[NodeId],
        targets: &[Target],
        parameters: &[f64],
        (method, duration): (Method, f64),
    ) -> Result<Self, Words> {
        let mut varied: Vec<usize> = targets
            .iter()
            .filter_map(|target| match target {
                Target::Parameter(index) => Some(*index),
                _ => None,
            })
            .collect();
        varied.dedup();
        let states = model.states.len();
        let mut extended = bare(model)
            .with_sensitivities(&varied)
            .ok_or_else(|| words("the model is too large to be differentiated by what is varied"))?;
        let by_parameter: Vec<Vec<NodeId>> = varied
            .iter()
            .enumerate()
            .map(|(place, &parameter)| extended.sensitivities(observed, parameter, place, states))
            .collect();
        // Each parameter is added to the marked ones if no derivative with respect to one of them depends on any of them.
        let mut linear = vec![false; varied.len()];
        for place in 0..varied.len() {
            linear[place] = states == 0;
            let joined: Vec<usize> = (0..=place).filter(|&one| linear[one]).collect();
            linear[place] &= joined.iter().flat_map(|&one| &by_parameter[one]).all(|node| {
                let depends = extended.depends(*node).parameters;
                joined.iter().all(|&one| !depends.contains(&(varied[one] as u32)))
            });
        }
        let rates = match targets.contains(&Target::Origin) {
            true => extended.rates_of(observed),
            // The rates are not needed.
            false => vec![extended.graph.constant(0.0); observed.len()],
        };
        let mut roots = Vec::new();
        for (number, &node) in observed.iter().enumerate() {
            roots.push(node);
            roots.extend(by_parameter.iter().map(|nodes| nodes[number]));
            roots.push(rates[number]);
        }
        let setup = Setup {
            parameters: parameters.to_vec(),
            method: if method == Method::Rosenbrock { method } else { Method::DormandPrince },
            step: if duration > 0.0 { duration / 100.0 } else { Setup::STEP },
            tolerance: TOLERANCES[0],
            start: Some(vec![0.0; extended.states.len()]),
            drawings: Vec::new(),
            presses: Vec::new(),
        };
        let motion = match states {
            0 => None,
            _ => Some(Motion::new(&extended, &setup).map_err(|error| error.message(&extended))?),
        };
        let mut curve = Self {
            routine: Routine::compile(&extended, &roots),
            extended: motion.is_some().then(|| Rc::new(Extended { model: extended, setup, readings: roots })),
            lanes: None,
            tolerance: TOLERANCES[0],
            solved: Vec::new(),
            states,
            varied,
            linear,
            observed: observed.len(),
            motion,
            values: Vec::new(),
        };
        curve.set_tolerance(TOLERANCES[0]);
        Ok(curve)
    }

    /// Makes the steps in compiled code from now on, if `compile` makes it from their listing. The bits stay the same.
    pub fn compile(&mut self, compile: impl FnOnce(Listing) -> Option<Rc<dyn Compiled>>) {
        if let Some(motion) = &mut self.motion {
            motion.compile(compile);
        }
    }

    /// Computes solutions side by side from now on, if `make` makes a solver for the model, the setup of its runs and what is read.
    /// The bits stay the same.
    pub fn use_lanes(&mut self, make: impl FnOnce(&Model, &Setup, &[NodeId]) -> Option<Rc<RefCell<dyn Lanes>>>) {
        self.lanes = self.extended.as_ref().and_then(|known| make(&known.model, &known.setup, &known.readings));
    }

    /// True if several solutions are computed side by side.
    pub fn has_lanes(&self) -> bool {
        self.lanes.is_some()
    }

    /// Number of values that a solution has at each time.
    pub fn readings(&self) -> usize {
        self.routine.len()
    }

    /// Computes solutions side by side, which [`Curve::follow`] then finds. Those of the last call are discarded.
    pub fn solve_together(&mut self, sought: Vec<Sought>) {
        self.solved.clear();
        if let Some(lanes) = &self.lanes {
            let solutions = lanes.borrow_mut().solve(self.tolerance, &sought);
            self.solved
                .extend(sought.into_iter().zip(solutions).filter_map(|(sought, solved)| Some((sought, solved?))));
        }
    }

    /// Index of the solution with these parameters at these times among those computed side by side.
    fn solved(&self, parameters: &[f64], times: &[f64]) -> Option<usize> {
        let same = |one: &[f64], other: &[f64]| {
            one.len() == other.len() && one.iter().zip(other).all(|(one, other)| one.to_bits() == other.to_bits())
        };
        self.solved.iter().position(|(sought, _)| same(&sought.parameters, parameters) && same(&sought.times, times))
    }

    /// True if the solution with these parameters at these times has been computed side by side with others.
    pub fn is_solved(&self, parameters: &[f64], times: &[f64]) -> bool {
        self.solved(parameters, times).is_some()
    }

    /// Sets the error tolerance of later integrations, relative to the greatest value of each state.
    pub fn set_tolerance(&mut self, tolerance: f64) {
        self.tolerance = tolerance;
        self.solved.clear();
        if let Some(motion) = &mut self.motion {
            motion.set_tolerance(tolerance);
        }
    }

    /// Number of columns of [`Curve::values`] per observed expression: its value, its derivatives with respect to each
    /// varied parameter in the order of the targets, and that with respect to the independent variable.
    pub fn stride(&self) -> usize {
        self.varied.len() + 2
    }

    /// Column, within one observed expression, of the derivative with respect to a varied parameter of the model.
    pub fn place(&self, parameter: usize) -> usize {
        1 + self.varied.iter().position(|varied| *varied == parameter).unwrap_or(0)
    }

    /// True if all observed expressions are linear in this parameter of the model, together with all others for which this
    /// is true; false for equations of motion.
    pub fn is_linear_in(&self, parameter: usize) -> bool {
        self.varied.iter().zip(&self.linear).any(|(&varied, &linear)| varied == parameter && linear)
    }

    /// True for equations of motion, false for a formula.
    pub fn has_states(&self) -> bool {
        self.states > 0
    }

    /// Begins a trial: its solutions together are bounded.
    pub fn begin_trial(&mut self) {
        if let Some(motion) = &mut self.motion {
            motion.begin_trial();
        }
    }

    /// True if a solution took more computation than is allowed, and was given up.
    pub fn gave_up(&self) -> bool {
        self.motion.as_ref().is_some_and(Motion::gave_up)
    }

    /// Computes the observed expressions, [`Curve::stride`] columns for each, into [`Curve::values`]. `times` are those of
    /// the model, SI, ascending and not before 0 for equations of motion. Returns the number of rows that the solution
    /// reaches.
    pub fn follow(&mut self, parameters: &[f64], times: &[f64]) -> usize {
        let rows = times.len();
        let place = if self.solved.is_empty() { None } else { self.solved(parameters, times) };
        self.values.resize(self.observed * self.stride() * rows, 0.0);
        let Some(motion) = &mut self.motion else {
            self.routine.prepare(parameters, &[]);
            self.routine.evaluate_rows(times, &[], &mut self.values);
            return rows;
        };
        if let Some(place) = place {
            let (_, solution) = self.solved.swap_remove(place);
            // Near the upper bound the engine finds the row at which it is reached.
            if motion.may_spend(solution.work) {
                self.values = solution.values;
                return rows;
            }
        }
        motion.solve(parameters, times, &mut self.routine, &mut self.values)
    }

    /// Shape of the curve: values of the roots of `routine` at `times`, as [`Curve::follow`] takes them, those of the first root at
    /// all times, then those of the second, and so on; NaN where the solution does not reach. The routine is compiled for the
    /// model without sensitivities. Equations of motion are solved with the coarsest of the [`TOLERANCES`].
    pub fn shape(&mut self, routine: &mut Routine, parameters: &[f64], times: &[f64]) -> Vec<f64> {
        let mut values = vec![f64::NAN; routine.len() * times.len()];
        match &mut self.motion {
            Some(motion) => {
                motion.set_tolerance(TOLERANCES[0]);
                motion.solve(parameters, times, routine, &mut values);
                motion.set_tolerance(self.tolerance);
            }
            None => {
                routine.prepare(parameters, &[]);
                routine.evaluate_rows(times, &[], &mut values);
            }
        }
        values
    }

    /// Columns computed by the last [`Curve::follow`], one after the other.
    pub fn values(&self) -> &[f64] {
        &self.values
    }
}

/// Derived quantities of a model that are constant in a run, with their derivatives with respect to parameters.
#[derive(Clone, Debug)]
pub(crate) struct Derived {
    /// Indices of the quantities in the model.
    pub quantities: Vec<usize>,
    routine: Routine,
    varied: usize,
    states: usize,
}

impl Derived {
    /// Selects the quantities that depend on any of the `varied` parameters.
    pub fn new(model: &Model, varied: &[usize]) -> Self {
        let depends = |node: NodeId| {
            let mut dependence = model.depends(node);
            for &state in &dependence.initial.clone() {
                let initial = model.states[state as usize].initial;
                dependence.parameters.extend(model.depends(initial).parameters);
            }
            varied.iter().any(|&parameter| dependence.parameters.contains(&(parameter as u32)))
        };
        let quantities: Vec<usize> = (0..model.quantities.len())
            .filter(|&number| {
                let quantity = &model.quantities[number];
                quantity.value.kind == Kind::Number && !quantity.varies && depends(quantity.value.node)
            })
            .collect();
        let mut graph = model.graph.clone();
        let states = model.states.len();
        // In a quantity constant in a run, an initial value is replaced by its expression.
        let initial: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
        let nodes: Vec<NodeId> = quantities.iter().map(|&number| model.quantities[number].value.node).collect();
        let nodes = graph.substitute(&nodes, |_, node| match node {
            Node::Initial(state) => initial.get(state as usize).copied(),
            _ => None,
        });
        let mut roots = nodes.clone();
        for &parameter in varied {
            let variable = program::Variable::Parameter(parameter as u32);
            roots.extend(program::differentiate_all(&mut graph, &nodes, variable));
        }
        let routine = Routine::from_graph(&graph, states, &roots);
        Self { quantities, routine, varied: varied.len(), states }
    }

    /// Values, SI, and for each its derivatives with respect to the varied parameters.
    pub fn evaluate(&mut self, parameters: &[f64]) -> (Vec<f64>, Vec<Vec<f64>>) {
        let zeros = vec![0.0; self.states];
        let count = self.quantities.len();
        let mut all = vec![0.0; count * (1 + self.varied)];
        self.routine.prepare(parameters, &zeros);
        self.routine.evaluate(0.0, &zeros, &mut all);
        let slopes =
            (0..count).map(|number| (1..=self.varied).map(|place| all[place * count + number]).collect()).collect();
        (all[..count].to_vec(), slopes)
    }
}

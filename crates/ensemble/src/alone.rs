//! Runs that continue alone, with the engine's stepper, where something happens.

use engine::{Progress, Reached, Record, Routine, RunError, Setup, Stepper};
use program::{Model, NodeId};
use std::borrow::Cow;

/// The stepper to which lanes are given, made when it is first needed.
#[derive(Debug)]
pub struct Alone<'a> {
    model: Cow<'a, Model>,
    setup: &'a Setup,
    /// Values that are read at each row.
    nodes: &'a [NodeId],
    made: Option<Made>,
}

#[derive(Debug)]
struct Made {
    stepper: Stepper,
    readings: Routine,
    values: Vec<f64>,
}

/// Last row of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LastRow {
    /// The independent variable, SI units.
    pub time: f64,
    /// One value per state, SI units.
    pub state: Vec<f64>,
}

impl LastRow {
    /// Replaces the row.
    pub fn set(&mut self, time: f64, state: &[f64]) {
        self.time = time;
        self.state.clear();
        self.state.extend_from_slice(state);
    }
}

/// Reads and takes rows.
struct Rows<'a, 'b> {
    readings: &'a mut Routine,
    values: &'a mut Vec<f64>,
    taking: &'a mut Taking<'b>,
}

impl Record for Rows<'_, '_> {
    fn row(&mut self, time: f64, state: &[f64], _jumped: bool) {
        if time > self.taking.until {
            return;
        }
        self.taking.last.set(time, state);
        if !self.values.is_empty() {
            self.readings.evaluate(time, state, self.values);
            (self.taking.take)(time, self.values);
        }
    }
}

/// Rows are taken up to this time (SI units) and kept in `last`; `take` gets the time and what is read.
pub struct Taking<'a> {
    /// Last time at which rows are taken.
    pub until: f64,
    /// The last row taken.
    pub last: &'a mut LastRow,
    /// Gets each row.
    pub take: &'a mut dyn FnMut(f64, &[f64]),
}

impl<'a> Alone<'a> {
    /// For runs of `model` with this setup but other parameters; `nodes` are read at each row.
    pub fn new(model: &'a Model, setup: &'a Setup, nodes: &'a [NodeId]) -> Self {
        let drawn = model.with_drawings(&setup.drawings);
        Self { model: drawn.map_or(Cow::Borrowed(model), Cow::Owned), setup, nodes, made: None }
    }

    /// Makes the stepper for a run with these parameters, if there is none yet.
    fn made(&mut self, parameters: &[f64]) -> Result<&mut Made, RunError> {
        let made = match self.made.take() {
            Some(made) => made,
            None => {
                let setup = Setup { parameters: parameters.to_vec(), ..self.setup.clone() };
                let readings = Routine::compile(&self.model, self.nodes);
                Made { stepper: Stepper::new(&self.model, &setup)?, readings, values: vec![0.0; self.nodes.len()] }
            }
        };
        Ok(self.made.insert(made))
    }

    /// The error of a run that cannot begin with these parameters; `None` if it can.
    pub fn refusal(&self, parameters: &[f64]) -> Option<RunError> {
        let setup = Setup { parameters: parameters.to_vec(), ..self.setup.clone() };
        Stepper::new(&self.model, &setup).err()
    }

    /// Continues a run from a moment, or from its beginning if `reached` is `None`, by this number of rows. `begun`: its parameters
    /// and initial values, SI units. Returns the stepper there; `None` if an event has ended the run.
    ///
    /// # Errors
    /// The error of the run.
    pub fn go_on(
        &mut self,
        begun: [&[f64]; 2],
        reached: Option<&Reached>,
        rows: u64,
        mut taking: Taking,
    ) -> Result<Option<&Stepper>, RunError> {
        let Made { stepper, readings, values } = self.at(begun, reached)?;
        let mut record = Rows { readings, values, taking: &mut taking };
        let mut made = 0;
        while made < rows {
            match stepper.advance_within(u64::MAX, &mut record) {
                Ok(Progress::Partial) => {}
                Ok(Progress::Row { .. }) => made += 1,
                Err(error) if error.is_end() => return Ok(None),
                Err(error) => return Err(error),
            }
        }
        Ok(Some(stepper))
    }

    /// Lets events act up to `end` (SI units) in a run that has reached its last row before.
    ///
    /// # Errors
    /// The error of the run.
    pub fn finish(
        &mut self,
        begun: [&[f64]; 2],
        reached: &Reached,
        end: f64,
        mut taking: Taking,
    ) -> Result<(), RunError> {
        let Made { stepper, readings, values } = self.at(begun, Some(reached))?;
        match stepper.finish(end, &mut Rows { readings, values, taking: &mut taking }) {
            Err(error) if !error.is_end() => Err(error),
            _ => Ok(()),
        }
    }

    /// The stepper at a moment of a run, or at its beginning.
    fn at(&mut self, [parameters, initial]: [&[f64]; 2], reached: Option<&Reached>) -> Result<&mut Made, RunError> {
        let made = self.made(parameters)?;
        made.stepper.begin(parameters.to_vec(), initial);
        if let Some(reached) = reached {
            made.stepper.continue_at(reached);
        }
        made.readings.prepare(parameters, initial);
        Ok(made)
    }
}

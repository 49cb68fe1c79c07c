//! Parameters whose values are expressions of others: the model and the task in which they are replaced.

use super::{FitError, Record, Target, Task, TiedParameter};
use engine::Readings;
use program::{Binary, Choices, Compiled, Kind, Model, Node, NodeId, Parameter, Quantity};
use std::borrow::Cow;
use units::Unit;

/// Values of the tied parameters in terms of the free ones.
#[derive(Clone, Debug, Default)]
pub(in crate::fit) struct Ties {
    /// Index of each tied parameter and its value in the model of the fit.
    values: Vec<(usize, NodeId)>,
    /// Number of parameters of the model of the caller.
    parameters: usize,
}

impl Ties {
    /// True if no parameter is tied.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Values of all parameters of the caller's model in a record, SI, from those of the model of the fit.
    pub fn complete(&self, model: &Model, mut parameters: Vec<f64>) -> Vec<f64> {
        if self.is_empty() {
            return parameters;
        }
        let nodes: Vec<NodeId> = self.values.iter().map(|(_, node)| *node).collect();
        let zeros = vec![0.0; model.states.len()];
        let values = Readings::new(model, &nodes).at(&parameters, &zeros, 0.0, &zeros).to_vec();
        for ((index, _), value) in self.values.iter().zip(values) {
            parameters[*index] = value;
        }
        parameters.truncate(self.parameters);
        parameters
    }
}

/// Replaces the tied parameters of a task in its observations and in a copy of the model. Each becomes a quantity of its
/// name, whose value and error are found like those of any other quantity.
///
/// # Errors
/// A parameter is varied and tied, tied twice, tied to itself by way of others, or not tied to parameters alone.
pub(in crate::fit) fn replace<'a>(model: &'a Model, task: &mut Task) -> Result<(Cow<'a, Model>, Ties), FitError> {
    if task.tied.is_empty() {
        return Ok((Cow::Borrowed(model), Ties::default()));
    }
    let mut model = model.clone();
    check(&model, task)?;
    let parameters = model.parameters.len();
    let records = task.tied.iter().any(|tied| tied.values.len() > 1).then(|| number_records(&mut model, task));
    let tied: Vec<usize> = task.tied.iter().map(|tied| tied.parameter).collect();
    let values: Vec<NodeId> = task.tied.iter().map(|tied| value(&mut model, tied, records)).collect();
    let mut free = values.clone();
    // Each pass replaces what the one before has brought in: a chain of ties is at most as long as their list.
    for _ in 0..tied.len() {
        free = substituted(&mut model, &free, (&tied, &values));
    }
    for &node in &free {
        let dependence = model.depends(node).parameters;
        if let Some(&index) = tied.iter().find(|&&index| dependence.contains(&(index as u32))) {
            return Err(FitError::TiedInCircle(index));
        }
    }
    replace_in_model(&mut model, (&tied, &free));
    for record in &mut task.records {
        for observation in &mut record.observations {
            let node = &mut observation.observed.node;
            *node = substituted(&mut model, &[*node], (&tied, &free))[0];
        }
    }
    // The value in one record of a parameter that is tied in each is shown as the value of that parameter.
    let own: Vec<usize> = task
        .tied
        .iter()
        .filter(|tied| tied.values.len() > 1)
        .flat_map(|tied| &tied.values)
        .filter_map(|value| match model.graph.node(value.node) {
            Node::Parameter(index) => Some(index as usize),
            _ => None,
        })
        .collect();
    for (&index, &node) in tied.iter().zip(&free).filter(|(index, _)| !own.contains(index)) {
        let Parameter { name, label, unit, hidden, .. } = model.parameters[index].clone();
        let value = Compiled { node, kind: Kind::Number, unit };
        model.quantities.push(Quantity { name, label, value, varies: false, hidden, remembered: false });
    }
    Ok((Cow::Owned(model), Ties { values: tied.into_iter().zip(free).collect(), parameters }))
}

fn check(model: &Model, task: &Task) -> Result<(), FitError> {
    for (place, tied) in task.tied.iter().enumerate() {
        let index = tied.parameter;
        if let Some(varied) = task.varied.iter().position(|varied| varied.target == Target::Parameter(index)) {
            return Err(FitError::VariedTwice(varied));
        }
        let known = model.parameters.get(index).is_some_and(|parameter| parameter.choices == Choices::Numbers);
        let count = tied.values.len();
        let constant = |value: &Compiled| {
            let dependence = model.depends(value.node);
            value.kind == Kind::Number && !dependence.varies() && dependence.initial.is_empty()
        };
        let again = task.tied[..place].iter().any(|other| other.parameter == index);
        if !known || again || !(count == 1 || count == task.records.len()) || !tied.values.iter().all(constant) {
            return Err(FitError::BadTie(index));
        }
    }
    Ok(())
}

/// Adds a parameter whose value is the index of the record. Returns its index.
fn number_records(model: &mut Model, task: &mut Task) -> u32 {
    let index = model.parameters.len();
    model.parameters.push(Parameter {
        name: "record".to_owned(),
        label: None,
        group: None,
        unit: Unit::dimensionless(),
        value: 0.0,
        range: None,
        step: None,
        restarts: false,
        choices: Choices::Numbers,
        hidden: true,
        assigned: None,
    });
    task.parameters.resize(index + 1, 0.0);
    let of_record = |(number, record): (usize, &mut Record)| record.fixed.push((index, number as f64));
    task.records.iter_mut().enumerate().for_each(of_record);
    index as u32
}

/// Value of a tied parameter as one expression. `records`: index of the parameter that numbers the records.
fn value(model: &mut Model, tied: &TiedParameter, records: Option<u32>) -> NodeId {
    let mut values = tied.values.iter().map(|value| value.node).enumerate();
    let graph = &mut model.graph;
    let (Some((_, first)), Some(records)) = (values.next(), records) else { return tied.values[0].node };
    let number = graph.insert(Node::Parameter(records));
    values.fold(first, |others, (record, own)| {
        let record = graph.constant(record as f64);
        let is_own = graph.binary(Binary::Equal, number, record);
        graph.select(is_own, own, others)
    })
}

/// Copies of `roots` in which the parameters `tied` are replaced by `values`.
fn substituted(model: &mut Model, roots: &[NodeId], (tied, values): (&[usize], &[NodeId])) -> Vec<NodeId> {
    model.graph.substitute(roots, |_, node| match node {
        Node::Parameter(index) => tied.iter().position(|&own| own == index as usize).map(|place| values[place]),
        _ => None,
    })
}

/// Replaces the parameters `tied` by `values` in the equations, the definitions and the events of a model.
fn replace_in_model(model: &mut Model, ties: (&[usize], &[NodeId])) {
    let states = model.states.iter().flat_map(|state| [state.initial, state.derivative]);
    let quantities = model.quantities.iter().map(|quantity| quantity.value.node);
    let events = model
        .events
        .iter()
        .flat_map(|event| std::iter::once(event.condition).chain(event.actions.iter().map(|(_, value)| *value)));
    let roots: Vec<NodeId> = states.chain(quantities).chain(events).collect();
    let mut replaced = substituted(model, &roots, ties).into_iter();
    let mut next = |node: &mut NodeId| *node = replaced.next().unwrap_or(*node);
    for state in &mut model.states {
        next(&mut state.initial);
        next(&mut state.derivative);
    }
    model.quantities.iter_mut().for_each(|quantity| next(&mut quantity.value.node));
    for event in &mut model.events {
        next(&mut event.condition);
        event.actions.iter_mut().for_each(|(_, value)| next(value));
    }
}

//! What fits are asked for, as a person has chosen it.

use crate::records::record::Record;
use analysis::fit::{Loss, Target, Varied};
use program::Model;
use std::collections::{BTreeMap, BTreeSet};

/// What fits are asked for.
#[derive(Debug, Default)]
pub(crate) struct Setup {
    /// Whether each parameter of the document is varied.
    pub varied: Vec<bool>,
    /// Whether the zero of the clock and that of the scale are, where a person has said so.
    pub zeros: [Option<bool>; 2],
    /// By name of a parameter or of a zero, where a person has said so: whether it is one number for all records.
    pub same: BTreeMap<String, bool>,
    /// The record that is looked at; the last one where it does not exist.
    pub chosen: Option<u32>,
    /// The records that take part besides it.
    pub others: BTreeSet<u32>,
    /// What part of the records is fitted: readings of their clocks, SI.
    pub window: [Option<f64>; 2],
    /// What residuals cost.
    pub loss: Loss,
}

impl Setup {
    /// Whether something is one number for all records. Varied numbers are each record's own unless a person has set
    /// otherwise, as on the command line; fixed ones have the value of the slider.
    pub fn is_same(&self, name: &str, varied: bool) -> bool {
        self.same.get(name).copied().unwrap_or(!varied)
    }

    /// The values that are held at a record's own, by the parameters of a model; those that are varied are not.
    pub fn fixed(&self, model: &Model, varied: &[Varied], record: &Record) -> Vec<(usize, f64)> {
        let own = |(index, parameter): (usize, &program::Parameter)| {
            let held = varied.iter().all(|varied| varied.target != Target::Parameter(index));
            let value = record.known.get(&parameter.name).filter(|_| held && !self.is_same(&parameter.name, false))?;
            Some((index, *value))
        };
        model.parameters.iter().enumerate().filter_map(own).collect()
    }
}
